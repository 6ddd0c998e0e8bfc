// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPlane
 * @brief a flat square as a triangle stream of small memory
 *
 * n * n squares on [0, 1] x [0, 1] at z = 0, each of two triangles that face +z, n being the whole number whose 2 n^2
 * is nearest to the number of triangles asked for (at least 1, at most MaximumSquares). Positions are rounded to single
 * precision.
 */
#ifndef vtkMTPlane_h
#define vtkMTPlane_h

#include "vtkMTSourcesModule.h" // For export macro
#include "vtkMTTriangleStream.h"

class VTKMTSOURCES_EXPORT vtkMTPlane : public vtkMTTriangleStream
{
public:
  static constexpr std::uint64_t MaximumSquares = 60000;

  explicit vtkMTPlane(std::uint64_t triangles);
  ~vtkMTPlane() override;

  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Arrays; }
  std::uint64_t GetNumberOfPoints() const override { return (this->Squares + 1) * (this->Squares + 1); }
  std::uint64_t GetNumberOfTriangles() const override { return 2 * this->Squares * this->Squares; }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }
  bool Rewind() override;
  bool NextPoints(PointBlock& block) override;
  bool NextTriangles(TriangleBlock& block) override;

private:
  std::uint64_t Squares; // along each side
  std::uint64_t PointRow = 0;
  std::uint64_t SquareRow = 0;
  std::vector<vtkMTArrayInfo> Arrays;
  std::map<std::string, std::int64_t> Report;
};

#endif
