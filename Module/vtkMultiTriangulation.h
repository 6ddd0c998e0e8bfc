// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulation
 * @brief a Multi-Triangulation as a VTK data object: its coarsest cut, and a handle to all its patches
 *
 * A vtkMultiTriangulation is a vtkPolyData whose points and cells are the coarsest cut, so every filter, writer and
 * mapper of VTK takes it. It carries a shared handle to the patch source, which the toolkit's own mapper and filters
 * use to reach every other cut. ShallowCopy, DeepCopy and CopyStructure share the handle: patches are immutable and are
 * never copied. The handle ends with the points that it came with: a filter that copies the structure and then gives it
 * new points (a transform, say) has made another surface, and drawing the old patches for it would be wrong.
 *
 * GetDataObjectType stays VTK_POLY_DATA, so everything that asks for polydata takes it.
 */
#ifndef vtkMultiTriangulation_h
#define vtkMultiTriangulation_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>

class vtkMTPatchSource;
class vtkMTCut;

class VTKMTCORE_EXPORT vtkMultiTriangulation : public vtkPolyData
{
public:
  static vtkMultiTriangulation* New();
  vtkTypeMacro(vtkMultiTriangulation, vtkPolyData);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void ShallowCopy(vtkDataObject* source) override;
  void DeepCopy(vtkDataObject* source) override;
  void CopyStructure(vtkDataSet* source) override;
  void Initialize() override;

#ifndef __VTK_WRAP__ // Python has no patch source
  ///@{
  /**
   * The patches. SetSource also fills the points and cells with the coarsest cut and its arrays; it returns false, with
   * an error event, when the coarsest patches cannot be read, and is then empty.
   */
  bool SetSource(std::shared_ptr<const vtkMTPatchSource> source);
  /// Null when there is none, and from the moment when the points have been replaced.
  std::shared_ptr<const vtkMTPatchSource> GetSource() const;
  ///@}
#endif

  ///@{
  /// Figures of the DAG; 0 when there is no source.
  vtkIdType GetNumberOfNodes();
  vtkIdType GetNumberOfPatches();
  vtkIdType GetNumberOfLevels();
  /// Triangles of the finest level.
  vtkIdType GetNumberOfFinestTriangles();
  ///@}

  ///@{
  /// From an information object, as in every VTK data class.
  static vtkMultiTriangulation* GetData(vtkInformation* info);
  static vtkMultiTriangulation* GetData(vtkInformationVector* v, int i = 0);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * The welded mesh of any cut of the source's known graph as polydata, with all arrays of the model. Returns false, with
   * the reason in error, when a patch cannot be read.
   */
  static bool CutToPolyData(
    const vtkMTPatchSource& source, const vtkMTCut& cut, vtkPolyData* output, std::string& error);
#endif

protected:
  vtkMultiTriangulation();
  ~vtkMultiTriangulation() override;

private:
  vtkMultiTriangulation(const vtkMultiTriangulation&) = delete;
  void operator=(const vtkMultiTriangulation&) = delete;

  void CopySource(vtkDataObject* from);

  std::shared_ptr<const vtkMTPatchSource> Source;
  vtkSmartPointer<vtkPoints> SourcePoints; // those which the handle belongs to
};

#endif
