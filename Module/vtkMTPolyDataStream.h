// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPolyDataStream
 * @brief a vtkPolyData as a triangle stream
 *
 * Triangles pass as they are; polygons are triangulated by vtkPolygon's ear cut (a fan where that fails), strips are
 * taken apart with alternating winding. Vertices and lines are counted in the report and left out, and so are arrays
 * of strings, variants and bits. The polydata must not change while the stream lives.
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
