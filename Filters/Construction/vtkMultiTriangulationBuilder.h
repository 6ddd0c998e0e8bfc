// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationBuilder
 * @brief makes a Multi-Triangulation from a triangle mesh
 *
 * The level loop of Cignoni et al., "Batched Multi Triangulation" (2005), section 4, over a partition sequence
 * Psi_0, Psi_1 ... coarser and coarser. The input's positions are snapped to one lattice, its seams stitched, and its
 * triangles sorted into the patches of the crossing of Psi_0 and Psi_1. Then, level by level, the patches of each
 * region are put together by identity (the floor), simplified to half their triangles without touching the vertices
 * that triangles outside the region use, certified (two-sided distance between floor and fragment, rounded up), given
 * the floor's attributes, and cut into the patches of the next crossing; a triangle's region is asked once, by its
 * barycentre, for the next partition only and inherited for the present one. Errors and spheres are saturated at the
 * end. Every region is independent of the others of its level, so regions run in parallel and the result does not
 * depend on the number of threads.
 *
 * As a filter it takes vtkPolyData and gives a vtkMultiTriangulation in memory. Build is the same without a pipeline:
 * any triangle stream in, any patch sink out.
 */
#ifndef vtkMultiTriangulationBuilder_h
#define vtkMultiTriangulationBuilder_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkMTPartitionStrategy;
class vtkMTPatchSink;
class vtkMTSimplifier;
class vtkMTTriangleStream;

class VTKMTCONSTRUCTION_EXPORT vtkMultiTriangulationBuilder : public vtkPolyDataAlgorithm
{
public:
  static vtkMultiTriangulationBuilder* New();
  vtkTypeMacro(vtkMultiTriangulationBuilder, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The wanted mean number of triangles in a patch (one element of a crossing). Default 1000; clamped to [16, 16384].
  vtkSetClampMacro(PatchTriangles, int, 16, 16384);
  vtkGetMacro(PatchTriangles, int);
  ///@}

  ///@{
  /// Bits of the lattice: the longest side of the model has at most 2^bits steps. Default 24; clamped to [10, 31].
  vtkSetClampMacro(LatticeBits, int, 10, 31);
  vtkGetMacro(LatticeBits, int);
  ///@}

  ///@{
  /// Threads for the regions of a level. Default 0: as many as the machine has. Clamped to [0, 1024]. Has no influence
  /// on the result.
  vtkSetClampMacro(NumberOfThreads, int, 0, 1024);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /// Whether smooth normals are made when the input has no point normals. Default on.
  vtkSetMacro(MakeNormals, bool);
  vtkGetMacro(MakeNormals, bool);
  vtkBooleanMacro(MakeNormals, bool);
  ///@}

  ///@{
  /**
   * Whether triangles that lie so far away that they coarsen the lattice for all others are kept. Default off: a few of
   * them (at most 16 or 1/1000) are left out, with a warning and counted as "dropped_far_outlier"; more of them are an
   * error (vtkMTFarOutliers says when exactly).
   */
  vtkSetMacro(KeepFarOutliers, bool);
  vtkGetMacro(KeepFarOutliers, bool);
  vtkBooleanMacro(KeepFarOutliers, bool);
  ///@}

  ///@{
  /// How regions are placed. Default: vtkMTVoronoiPartition.
  void SetPartitionStrategy(vtkMTPartitionStrategy* strategy);
  vtkMTPartitionStrategy* GetPartitionStrategy();
  ///@}

  ///@{
  /// How a floor is made into a fragment. Default: vtkMTEdgeCollapse in mode fast.
  void SetSimplifier(vtkMTSimplifier* simplifier);
  vtkMTSimplifier* GetSimplifier();
  ///@}

  /**
   * Builds without a pipeline. False on failure or abort; then ErrorCode and ErrorMessage say why, the sink has been
   * abandoned and nothing is published. Progress events and AbortExecute work as in the filter.
   */
  bool Build(vtkMTTriangleStream& input, vtkMTPatchSink& output);

  /// Why the last Build failed; empty after success.
  vtkGetMacro(ErrorMessage, std::string);

  /// Of the settings, strategy and simplifier included.
  vtkMTimeType GetMTime() override;

  /// Makes the output a vtkMultiTriangulation.
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

protected:
  vtkMultiTriangulationBuilder();
  ~vtkMultiTriangulationBuilder() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMultiTriangulationBuilder(const vtkMultiTriangulationBuilder&) = delete;
  void operator=(const vtkMultiTriangulationBuilder&) = delete;

  bool BuildLevels(vtkMTTriangleStream& input, vtkMTPatchSink& output);

  int PatchTriangles = 1000;
  int LatticeBits = 24;
  int NumberOfThreads = 0;
  bool MakeNormals = true;
  bool KeepFarOutliers = false;
  vtkSmartPointer<vtkMTPartitionStrategy> PartitionStrategy;
  vtkSmartPointer<vtkMTSimplifier> Simplifier;
  std::string ErrorMessage;
  bool Aborted = false;
};

#endif
