// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationTransform
 * @brief puts a Multi-Triangulation at another place, in another size or direction, without touching its patches
 *
 * The output shares the patches of the input and differs in its frame (vtkMultiTriangulation::ApplyTransform): the map
 * from the lattice, on which the patches lie, to the object's coordinates. Mapper, locator, writer and the toolkit's
 * filters take it into account, so nothing is read, a mapper keeps what it has on the GPU, and filters in a row add up.
 * The points and cells that the object holds itself are moved, with their active normals, for filters that know
 * polydata only; other arrays, vectors too, stay as they are.
 *
 * Certified errors stay certified: in the new coordinates they are the old ones times the largest singular value of the
 * transform's linear part. A transform that mirrors turns the triangles, so that what was the front stays the front.
 *
 * Errors: vtkErrorMacro, an empty output and an error code: vtkErrorCode::UserError when there is no transform, or when
 * its matrix is not finite and affine or has no inverse. Input without patches is moved as the mesh that it is.
 *
 * @sa vtkMultiTriangulation
 */
#ifndef vtkMultiTriangulationTransform_h
#define vtkMultiTriangulationTransform_h

#include "vtkMTFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

class vtkLinearTransform;
class vtkMultiTriangulation;

class VTKMTFILTERS_EXPORT vtkMultiTriangulationTransform : public vtkPolyDataAlgorithm
{
public:
  static vtkMultiTriangulationTransform* New();
  vtkTypeMacro(vtkMultiTriangulationTransform, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// From the coordinates of the input to those of the output, such as a vtkTransform. Default none, which is an error.
  void SetTransform(vtkLinearTransform* transform);
  vtkLinearTransform* GetTransform();
  ///@}

  vtkMultiTriangulation* GetOutput();

  vtkMTimeType GetMTime() override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMultiTriangulationTransform();
  ~vtkMultiTriangulationTransform() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

private:
  vtkMultiTriangulationTransform(const vtkMultiTriangulationTransform&) = delete;
  void operator=(const vtkMultiTriangulationTransform&) = delete;

  vtkSmartPointer<vtkLinearTransform> Transform;
};

#endif
