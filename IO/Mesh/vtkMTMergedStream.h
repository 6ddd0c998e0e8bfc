// SPDX-License-Identifier: BSD-3-Clause
// Several streamed files as one triangle stream. Not installed.
#ifndef vtkMTMergedStream_h
#define vtkMTMergedStream_h

#include "vtkMTChunkStream.h"

#include <memory>
#include <vector>

/**
 * The points, and then the triangles, of one file after the other, with the cell array "PartId", as vtkMTMeshMerge
 * would merge them. A part is read on when those before it have ended, so that each holds no more than a chunk.
 */
class vtkMTMergedStream : public vtkMTTriangleStream
{
public:
  /// Null unless all have the same arrays, none of them "PartId", and no cells but polygons: others need the whole.
  static std::unique_ptr<vtkMTTriangleStream> Make(std::vector<std::unique_ptr<vtkMTChunkStream>> parts);

  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Arrays; }
  std::uint64_t GetNumberOfPoints() const override { return this->Points; }
  std::uint64_t GetNumberOfTriangles() const override { return this->Triangles; }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }
  bool Rewind() override;
  bool NextPoints(PointBlock& block) override;
  bool NextTriangles(TriangleBlock& block) override;

private:
  explicit vtkMTMergedStream(std::vector<std::unique_ptr<vtkMTChunkStream>> parts);
  bool Fail(std::size_t part);
  void AddUpReports();

  std::vector<std::unique_ptr<vtkMTChunkStream>> Parts;
  std::vector<vtkMTArrayInfo> Arrays;
  std::map<std::string, std::int64_t> Report;
  std::uint64_t Points = 0;
  std::uint64_t Triangles = 0;
  std::size_t PointPart = 0;    // whose points are next
  std::size_t TrianglePart = 0; // whose triangles are next
  std::uint64_t FirstPoint = 0; // of that part
  std::uint64_t FirstCell = 0;
};

#endif
