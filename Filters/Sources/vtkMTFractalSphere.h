// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFractalSphere
 * @brief a sphere with a fractal surface, of any size, as a triangle stream of small memory
 *
 * A unit icosphere: the icosahedron's 20 faces, each edge halved k times, every midpoint moved to the sphere at once,
 * so there are 20 * 4^k triangles and 10 * 4^k + 2 points. Each point p of it is then moved along its radius by the
 * factor
 *
 *   1 + sum over o = 0..7 of 0.25 * 0.47^o * noise(1.7 * 2.03^o * p)
 *
 * with improved Perlin noise (vtkMTPerlinNoise) and rounded to single precision. The surface is a closed manifold of
 * genus 0, outward oriented, with detail at every scale down to 1/140 of the radius.
 *
 * Points are numbered corners first (12), then edges (30, 2^k - 1 each), then the insides of the faces row by row, so
 * every index is known in closed form, and a row of points is made from two rows of the next coarser subdivision: only
 * two rows per level are kept, 2^k points each. The result depends on k and the seed alone.
 */
#ifndef vtkMTFractalSphere_h
#define vtkMTFractalSphere_h

#include "vtkMTSourcesModule.h" // For export macro
#include "vtkMTTriangleStream.h"

#include <memory>

class VTKMTSOURCES_EXPORT vtkMTFractalSphere : public vtkMTTriangleStream
{
public:
  static constexpr int MaximumSubdivisions = 14;

  /// The 20 * 4^k nearest to triangles (the smaller of two equally near), k from 0 to MaximumSubdivisions.
  static int ChooseSubdivisions(std::uint64_t triangles);

  /// About so many triangles. The seed chooses the noise; 0 is the paper's permutation.
  explicit vtkMTFractalSphere(std::uint64_t triangles, std::uint64_t seed = 0);
  ~vtkMTFractalSphere() override;

  const std::vector<vtkMTArrayInfo>& GetArrays() const override;
  std::uint64_t GetNumberOfPoints() const override;
  std::uint64_t GetNumberOfTriangles() const override;
  const std::map<std::string, std::int64_t>& GetReport() const override;
  bool Rewind() override;
  bool NextPoints(PointBlock& block) override;
  bool NextTriangles(TriangleBlock& block) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Implementation;
};

#endif
