// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTNormalSampling
 * @brief tests a model's certified angles between shading normals by sampling
 *
 * For every sampled point of a cut's patch there must be a point of the finest level that is within the patch's error
 * and whose shading normal is within the patch's angle, one and the same point; and for every sampled point of the
 * finest level there must be such a point of some patch of the cut, within that patch's error and angle. (How the
 * finest level lies to the input is tested elsewhere.)
 *
 * The nearest point is tried first. Where its normal is too far off, all triangles within reach are asked whether they
 * have such a point: over one triangle the distance from a place is convex, and so is |n| cos(a) - n . m, which is at
 * most zero where the linearly interpolated normal n is within the angle a, at most a right one, of the direction m. So
 * the least of the larger of the two is found by nested searches.
 *
 * Independent of the builder: own normals, own search.
 */
#ifndef vtkMTNormalSampling_h
#define vtkMTNormalSampling_h

#include "vtkMTClosestPoint.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationCheck.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTCut;
class vtkMTPatchSource;
struct vtkMTMeasure;

class VTKMTVERIFICATION_EXPORT vtkMTNormalSampling
{
public:
  /// samples: points on each surface. The source must outlive this object.
  vtkMTNormalSampling(const vtkMTPatchSource& source, std::size_t samples, std::uint64_t seed);
  ~vtkMTNormalSampling();

  /// Whether the model has the measure; otherwise there is nothing to test.
  bool HasMeasure() const { return this->Measure != nullptr; }

  ///@{
  /// False when a patch cannot be read, which error says, and when progress stopped it; then error is as it was.
  /// First the finest level, then cuts.
  bool Begin(const vtkMTVerificationProgress& progress, std::string& error);
  bool TestCut(
    const vtkMTCut& cut, const std::string& name, const vtkMTVerificationProgress& progress, std::string& error);
  ///@}

  const vtkMTVerificationCheck& GetCheck() const { return this->Check; }

private:
  using Corners = std::array<vtkMTRealPoint, 3>;
  // A surface with a normal for each corner, and the node whose error and angle count for each triangle.
  struct Shaded
  {
    vtkMTSampledSurface Surface;
    std::vector<Corners> Normals;
    std::vector<std::uint32_t> Nodes;

    Corners GetCorners(std::uint32_t triangle) const;
    /// Of the second and third corner, where x lies over the triangle; else of a point of it.
    std::array<double, 2> GetWeights(std::uint32_t triangle, const vtkMTRealPoint& x) const;
    /// The interpolated normal at a place on the triangle, of length 1.
    vtkMTRealPoint GetNormal(std::uint32_t triangle, const vtkMTRealPoint& x) const;
  };
  struct Allowed
  {
    double Distance; // local units
    double Cosine;   // of the angle
    double Angle;
  };

  bool Read(const std::vector<std::uint32_t>& arcs, const vtkMTVerificationProgress& progress, Shaded& shaded,
    std::string& error) const;
  void AddNormals(const vtkMTPatch& patch, std::size_t triangle, Shaded& shaded) const;
  Allowed GetAllowed(std::uint32_t node) const;
  bool Test(const Shaded& from, const Shaded& to, bool ofFrom, const std::string& name, std::uint64_t seed,
    const vtkMTVerificationProgress& progress);
  static bool HasPoint(const Shaded& to, std::uint32_t triangle, const vtkMTRealPoint& x, const vtkMTRealPoint& normal,
    const Allowed& allowed);

  const vtkMTPatchSource& Source;
  const vtkMTMeasure* Measure;
  const std::size_t Samples;
  const std::uint64_t Seed;
  vtkMTMeasuringFrame Frame;
  int Array = -1; // of normals
  std::size_t Column = 0;
  Shaded Finest;
  vtkMTVerificationCheck Check;
};

#endif
