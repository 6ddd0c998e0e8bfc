// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTriangleStream
 * @brief an input mesh, read block by block: first all points, then all triangles, as often as wanted
 *
 * What the builder eats. A stream gives indexed triangles in model units with their arrays; polygons and strips are
 * triangulated by the stream. Nothing is repaired or dropped here: that is the builder's task, and it is counted.
 */
#ifndef vtkMTTriangleStream_h
#define vtkMTTriangleStream_h

#include "vtkMTArrayInfo.h"
#include "vtkMTCoreModule.h" // For export macro

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

class VTKMTCORE_EXPORT vtkMTTriangleStream
{
public:
  virtual ~vtkMTTriangleStream() = default;

  struct PointBlock
  {
    std::vector<std::array<double, 3>> Points;
    std::vector<vtkMTColumn> Columns; ///< arrays of association Point, in order of GetArrays
  };
  struct TriangleBlock
  {
    std::vector<std::array<std::uint64_t, 3>> Triangles; ///< point indices; may be out of range in a bad input
    std::vector<std::int64_t> CellIds;                   ///< the input's cell of each triangle
    std::vector<vtkMTColumn> Columns;                    ///< arrays of association Cell, in order of GetArrays
  };

  /// The arrays that the blocks carry. InputCellIds and made normals are the builder's and are not among them.
  virtual const std::vector<vtkMTArrayInfo>& GetArrays() const = 0;
  virtual std::uint64_t GetNumberOfPoints() const = 0;
  virtual std::uint64_t GetNumberOfTriangles() const = 0;
  /// What the stream itself left out, by reason, such as "lines" or "arrays_of_strings". Complete when all triangles
  /// have been read once: polygons that cross themselves are only found then.
  virtual const std::map<std::string, std::int64_t>& GetReport() const = 0;

  /// Start again, at the first point and at the first triangle.
  virtual bool Rewind() = 0;
  /// The next block; an empty block at the end. False on failure, with a message in GetError.
  virtual bool NextPoints(PointBlock& block) = 0;
  virtual bool NextTriangles(TriangleBlock& block) = 0;

  const std::string& GetError() const { return this->Error; }

protected:
  std::string Error;
};

#endif
