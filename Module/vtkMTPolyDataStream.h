// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPolyDataStream
 * @brief a vtkPolyData as a triangle stream
 *
 * Triangles pass as they are; strips are taken apart with alternating winding. Convex quads are split along the shorter
 * diagonal, all other polygons by clipping the best shaped ears (vtkMTPolygonTriangulation), with exact signs: concave
 * ones, ones with holes by bridge edges and ones that touch themselves are covered exactly once. One that crosses
 * itself cannot be; it is counted ("crossed_polygons") when its triangles are read. A polygon with a corner that does
 * not exist or is not finite becomes triangles that all have that corner. Vertices and lines are counted in the report
 * and left out, and so are arrays of strings, variants and bits. The polydata must not change while the stream lives.
 */
#ifndef vtkMTPolyDataStream_h
#define vtkMTPolyDataStream_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTTriangleStream.h"
#include "vtkSmartPointer.h"

#include <memory>

class vtkPolyData;

class VTKMTCORE_EXPORT vtkMTPolyDataStream : public vtkMTTriangleStream
{
public:
  /// In the report, the number of polygons that cross themselves.
  static const char* GetCrossedPolygonsName() { return "crossed_polygons"; }

  explicit vtkMTPolyDataStream(vtkPolyData* input);
  ~vtkMTPolyDataStream() override;

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
