// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPlaneSource
 * @brief a flat square of any number of triangles, for tests and demonstrations
 *
 * n * n squares on [0, 1] x [0, 1] at z = 0, each of two triangles that face +z. Its points are shared, where
 * vtkPlaneSource makes quadrilaterals with texture coordinates and normals.
 *
 * The points are single precision and shared by their triangles; there are no other arrays. The source reports progress
 * and can be aborted; then, and when memory runs out (an error event with an error code), its output is empty.
 */
#ifndef vtkMTPlaneSource_h
#define vtkMTPlaneSource_h

#include "vtkMTSourcesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKMTSOURCES_EXPORT vtkMTPlaneSource : public vtkPolyDataAlgorithm
{
public:
  static vtkMTPlaneSource* New();
  vtkTypeMacro(vtkMTPlaneSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// How many triangles are wanted; there are 2 * n^2, with the n from 1 to 60000 whose number is nearest. Default
  /// 20000; clamped to [1, 4294967295].
  vtkSetClampMacro(NumberOfTriangles, vtkIdType, 1, 4294967295);
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  ///@}

protected:
  vtkMTPlaneSource();
  ~vtkMTPlaneSource() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMTPlaneSource(const vtkMTPlaneSource&) = delete;
  void operator=(const vtkMTPlaneSource&) = delete;

  vtkIdType NumberOfTriangles = 20000;
};

#endif
