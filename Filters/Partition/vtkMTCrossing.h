// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCrossing
 * @brief numbers the elements of the crossing of two partitions
 *
 * The crossing of two partitions is the set of the non-empty intersections of their regions (Cignoni et al., "Batched
 * Multi Triangulation", 2005, section 4): cells with the same pair (a, b) of regions are one element. In a
 * Multi-Triangulation the elements of the crossing of two successive partitions are the patches.
 *
 * Input: a vtkPolyData with two cell arrays of whole numbers, one component each, as vtkMTPartitionSequence makes them;
 * any labels will do. Output: the input with one more cell array, PatchArrayName, vtkIdType, one component, elements 0
 * to GetNumberOfPatches() - 1 in the order of (a, b); it becomes the active cell scalars. A missing or unsuitable array
 * is an error. When the filter is aborted the output is empty.
 *
 * About a fifth of the elements have less than a tenth of the mean number of cells. With MergeSlivers, these are
 * dissolved into other elements of the same first region (vtkMTSliverMerge); a region of the second partition is then
 * represented by the mean of its cells' barycentres.
 */
#ifndef vtkMTCrossing_h
#define vtkMTCrossing_h

#include "vtkMTPartitionModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // For members

class VTKMTPARTITION_EXPORT vtkMTCrossing : public vtkPolyDataAlgorithm
{
public:
  static vtkMTCrossing* New();
  vtkTypeMacro(vtkMTCrossing, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Name of the first partition's cell array. Default "Region_0".
  vtkSetStdStringFromCharMacro(FirstArrayName);
  vtkGetCharFromStdStringMacro(FirstArrayName);
  ///@}

  ///@{
  /// Name of the second partition's cell array. Default "Region_1".
  vtkSetStdStringFromCharMacro(SecondArrayName);
  vtkGetCharFromStdStringMacro(SecondArrayName);
  ///@}

  ///@{
  /// Name of the cell array that is made. Default "Patch".
  vtkSetStdStringFromCharMacro(PatchArrayName);
  vtkGetCharFromStdStringMacro(PatchArrayName);
  ///@}

  ///@{
  /// Whether small elements are dissolved into others of the same first region. Default off.
  vtkSetMacro(MergeSlivers, bool);
  vtkGetMacro(MergeSlivers, bool);
  vtkBooleanMacro(MergeSlivers, bool);
  ///@}

  ///@{
  /// Elements with less than this share of the mean number of cells in an element are small. Default 0.1; clamped to
  /// [0, 1].
  vtkSetClampMacro(SliverShare, double, 0.0, 1.0);
  vtkGetMacro(SliverShare, double);
  ///@}

  ///@{
  /// Elements of the last execution, and how many slivers were dissolved.
  vtkGetMacro(NumberOfPatches, vtkIdType);
  vtkGetMacro(NumberOfSlivers, vtkIdType);
  ///@}

protected:
  vtkMTCrossing();
  ~vtkMTCrossing() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMTCrossing(const vtkMTCrossing&) = delete;
  void operator=(const vtkMTCrossing&) = delete;

  int Cross(vtkPolyData* output);

  std::string FirstArrayName = "Region_0";
  std::string SecondArrayName = "Region_1";
  std::string PatchArrayName = "Patch";
  bool MergeSlivers = false;
  double SliverShare = 0.1;
  vtkIdType NumberOfPatches = 0;
  vtkIdType NumberOfSlivers = 0;
};

#endif
