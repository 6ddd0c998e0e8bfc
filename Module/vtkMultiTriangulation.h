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
 * GetDataObjectType stays VTK_POLY_DATA, so everything that asks for polydata takes it. A filter that does not know
 * this class works on the points and cells, which are those of the coarsest cut unless SetSource was asked for a finer
 * one (SetOutputError of vtkMultiTriangulationReader); a vtkMultiTriangulationCutFilter before it gives it any other
 * cut. The algorithm that made the object warns of the first such filter that takes the coarsest cut from its output.
 *
 * Placement: the patches lie on the lattice and stay there. The object has an affine map from the lattice's coordinates
 * to its own, the frame: that of the model, the identity where it has none, and what ApplyTransform adds. Points and
 * cells of the object, its bounds, and what the toolkit's mapper, locator and filters make of it are in the object's
 * coordinates. Errors in those are the model's times GetStretch.
 */
#ifndef vtkMultiTriangulation_h
#define vtkMultiTriangulation_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <limits>
#include <memory>
#include <string>

class vtkAlgorithm;
class vtkMTCut;
class vtkMTPatchSource;

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
   * The patches. SetSource also fills the points and cells, with all arrays, from the coarsest cut whose certified
   * distance to the input is at most `error`, in model units, or from the finest level where that is not enough;
   * infinity, the default, is the coarsest cut of all, and NaN is taken for it. It returns false, with an error event,
   * when a patch cannot be read or the model's frame is no affine map with an inverse, and is then empty. The frame is
   * the model's, or the identity where it has none.
   */
  bool SetSource(
    std::shared_ptr<const vtkMTPatchSource> source, double error = std::numeric_limits<double>::infinity());
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
  /**
   * Moves the object: its points, its active point normals and the frame. The matrix is row-major, in the coordinates
   * that the object has now, so calls add up. Nothing is read, and the patches are shared as before. A matrix that
   * mirrors turns the triangles. False, with an error event and nothing done, unless the matrix is finite, affine and
   * has an inverse. Other arrays, vectors too, stay as they are.
   */
  bool ApplyTransform(const double matrix[16]);
  /// From the coordinates of the lattice to those of the object, row-major.
  void GetFrame(double matrix[16]) const;
  /// The largest factor by which the frame lengthens a distance: the largest singular value of its linear part.
  double GetStretch() const;
  ///@}

  /**
   * Empties points, cells and arrays and keeps the patches: what is asked for by GetSource and GetModelBounds stays.
   * For all but one of the processes of a parallel program, which each have a handle, lest each have the same mesh.
   */
  void RemoveMesh();

  /**
   * Bounds that hold every cut, in the object's coordinates; from the DAG, nothing is read. The frame turns the box of
   * the lattice's axes, so under a rotation they are not the tightest. Uninitialised bounds where there are no patches.
   */
  void GetModelBounds(double bounds[6]) const;

  /**
   * The least and the largest value of an array in the finest level of the model, from the DAG, nothing is read: what a
   * colour table should span, also while coarser patches are drawn. association is vtkDataObject::POINT or CELL,
   * component counts from 0, and -1 is the magnitude of the tuples: then the range is a bound, from those of the
   * components, which the tuples need not reach. NaN is left out; 64-bit integers are rounded. Values are as they are
   * stored: a frame does not turn them. False, and the range is left alone, where there is no such array or component,
   * or no value that is a number.
   */
  bool GetArrayRange(const char* name, int association, int component, double range[2]) const;

  ///@{
  /// From an information object, as in every VTK data class.
  static vtkMultiTriangulation* GetData(vtkInformation* info);
  static vtkMultiTriangulation* GetData(vtkInformationVector* v, int i = 0);
  ///@}

#ifndef __VTK_WRAP__
  /**
   * The welded mesh of any cut of the source's known graph as polydata, with all arrays of the model, in the
   * coordinates of the lattice. Returns false, with the reason in error, when a patch cannot be read.
   */
  static bool CutToPolyData(
    const vtkMTPatchSource& source, const vtkMTCut& cut, vtkPolyData* output, std::string& error);

  ///@{
  /**
   * How a producer finds out whether a filter behind it knows the patches. VTK does not tell it who takes its output;
   * but whenever a consumer updates, ComputePipelineMTime is called on the consumer first and on the producer then. So
   * a filter that uses the patches of its first input leaves a mark on it (AnnounceUse), and the producer takes it away
   * (CheckUse, with the port that its ComputePipelineMTime is called for): where there is none, the consumer does not
   * know them. Nothing is kept of the consumer, which may be gone at any time. WarnOfUse is for the end of a producer's
   * RequestData: it warns, once for each output, where such a consumer asked and the output's own mesh is the coarsest
   * of several cuts.
   */
  static void AnnounceUse(vtkInformationVector** inputs);
  static void CheckUse(vtkAlgorithm* producer, vtkInformationVector* outputs, int port);
  static void WarnOfUse(vtkAlgorithm* producer, vtkInformationVector* outputs);
  ///@}
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
  std::array<double, 16> Frame;
};

#endif
