// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTJointSampling
 * @brief tests by sampling what a model certifies jointly with distance
 *
 * For every sampled point of a cut's patch there must be a point of the finest level that is within the patch's error
 * and whose data are within what the patch's node says, one and the same point; and for every sampled point of the
 * finest level there must be such a point of some patch of the cut, within that patch's error and what its node says.
 * (How the finest level lies to the input is tested elsewhere.) What data are, and whether a triangle has such a point,
 * is up to derived classes.
 *
 * The triangle of the nearest point is tried first, then all triangles within reach. One sample of four lies at a
 * corner of its triangle, where what is linear over triangles is largest.
 *
 * Independent of the builder: own data, own search.
 */
#ifndef vtkMTJointSampling_h
#define vtkMTJointSampling_h

#include "vtkMTClosestPoint.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationCheck.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkMTCut;
class vtkMTPatchSource;
struct vtkMTArrayInfo;

class VTKMTVERIFICATION_EXPORT vtkMTJointSampling
{
public:
  virtual ~vtkMTJointSampling();
  vtkMTJointSampling(const vtkMTJointSampling&) = delete;
  vtkMTJointSampling& operator=(const vtkMTJointSampling&) = delete;

  /// Whether the model has what is to be tested.
  virtual bool HasMeasure() const = 0;

  ///@{
  /// False when a patch cannot be read, which error says, and when progress stopped it; then error is as it was.
  /// First the finest level, then cuts.
  bool Begin(const vtkMTVerificationProgress& progress, std::string& error);
  bool TestCut(
    const vtkMTCut& cut, const std::string& name, const vtkMTVerificationProgress& progress, std::string& error);
  ///@}

  const vtkMTVerificationCheck& GetCheck() const { return this->Check; }
  /// Samples that have no data, and that were left out for that.
  std::uint64_t GetNumberOfSkipped() const { return this->Skipped; }

protected:
  using Corners = std::array<vtkMTRealPoint, 3>;
  /// A surface with some numbers for each corner of each triangle, and the node whose error counts for each triangle.
  struct Side
  {
    vtkMTSampledSurface Surface;
    std::vector<double> Data; ///< [triangles][3][Width]
    std::vector<std::uint32_t> Nodes;
    std::size_t Width = 1;

    Corners GetCorners(std::uint32_t triangle) const;
    const double* GetData(std::uint32_t triangle, std::size_t corner) const
    {
      return this->Data.data() + (3 * std::size_t(triangle) + corner) * this->Width;
    }
  };
  /// A place on a triangle, by the weights of its second and third corner.
  struct Place
  {
    std::uint32_t Triangle = 0;
    std::array<double, 2> Weights{ 0.0, 0.0 };
  };
  /// What is to be found on the other side.
  struct Wanted
  {
    vtkMTRealPoint X;
    std::array<double, 3> Data{ 0.0, 0.0, 0.0 };
    std::size_t Part = 0; ///< of what is tested
  };
  /// An array of the graph, and which of its association's columns it is.
  struct Column
  {
    int Array = -1; ///< none
    std::size_t Index = 0;
  };

  /// samples: points on each surface. noun: what is tested, "normals". The source must outlive this object.
  vtkMTJointSampling(const vtkMTPatchSource& source, std::size_t samples, std::uint64_t seed, const std::string& noun);

  /// Appends the numbers of the corners of one of the patch's triangles, the side's latest.
  virtual void AddData(const vtkMTPatch& patch, std::size_t triangle, Side& side) = 0;
  /// How many things are tested of each sample.
  virtual std::size_t GetNumberOfParts() const { return 1; }
  /// Fills in the data of a place; false where it has none.
  virtual bool Take(const Side& from, const Place& place, Wanted& wanted) const = 0;
  /// Whether the triangle has a point within the reach, in local units, of what is wanted, by what the node says.
  virtual bool HasPoint(
    const Side& to, std::uint32_t triangle, const Wanted& wanted, std::uint32_t node, double reach) const = 0;
  /// What was not found: "a normal within 0.1 radians of the one there".
  virtual std::string Describe(const Wanted& wanted, std::uint32_t node) const = 0;

  ///@{
  /// For derived classes' constructors: the numbers for each corner, and the columns that they are made of.
  void SetWidth(std::size_t width) { this->Width = width; }
  Column AddColumn(std::size_t array);
  ///@}
  /// The components of a tuple that a triangle has at its corner.
  void GetTuple(
    const Column& column, const vtkMTPatch& patch, std::size_t triangle, std::size_t corner, double* values) const;
  /// The place with the weights of the second and third corner, or the like of other data.
  static vtkMTRealPoint Blend(const Corners& corners, double u, double v);

  const vtkMTPatchSource& Source;

private:
  bool Read(
    const std::vector<std::uint32_t>& arcs, const vtkMTVerificationProgress& progress, Side& side, std::string& error);
  bool Test(const Side& from, const Side& to, bool ofFrom, const std::string& name, std::uint64_t seed,
    const vtkMTVerificationProgress& progress);
  bool Find(const vtkMTClosestPoint& search, const Side& to, std::uint32_t nearest, const Wanted& wanted,
    const std::uint32_t* node, double reach) const;
  double GetReach(std::uint32_t node) const;

  const std::size_t Samples;
  const std::uint64_t Seed;
  const std::string Noun; // "normals"
  std::size_t Width = 1;
  std::vector<unsigned char> Arrays; // that are read
  vtkMTMeasuringFrame Frame;
  Side Finest;
  std::uint64_t Skipped = 0;
  vtkMTVerificationCheck Check;
};

#endif
