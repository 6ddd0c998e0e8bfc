// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationBuilder
 * @brief makes a Multi-Triangulation from a triangle mesh
 *
 * The level loop of Cignoni et al., "Batched Multi Triangulation" (2005), section 4, over a partition sequence
 * Psi_0, Psi_1 ... coarser and coarser. The input's positions are snapped to one lattice, its seams stitched, and its
 * triangles sorted into the patches of the crossing of Psi_0 and Psi_1. Then, level by level, the patches of each
 * region are assembled by identity (the floor), simplified to half their triangles without touching the vertices
 * that triangles outside the region use, certified (two-sided distance between floor and fragment, rounded up), given
 * the floor's attributes, and split into the patches of the next crossing; a triangle's region is asked once, by its
 * barycentre, for the next partition only and inherited for the present one. Errors and spheres are saturated at the
 * end. Every region is independent of the others of its level, so regions run in parallel and the result does not
 * depend on the number of threads.
 *
 * As a filter it takes vtkPolyData and gives a vtkMultiTriangulation in memory. Build is the same without a pipeline:
 * any triangle stream in, any patch sink out.
 *
 * Out of core: the mesh, its fragments and its patches live in spools, and everything that needs all of them goes
 * through sequential passes and external sorts (BMT sections 4.2.2 and 6). With a spool store on disk and a memory
 * limit, meshes of any size are built; the result is the same, bit for bit. When store and sink outlive the process, a
 * checkpoint is kept after each half of a level, from which a later Build with Resume goes on.
 */
#ifndef vtkMultiTriangulationBuilder_h
#define vtkMultiTriangulationBuilder_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkMTSequenceState;
class vtkMTMemoryPlan;
class vtkMTPartitionStrategy;
class vtkMTPatchSink;
class vtkMTSimplifier;
class vtkMTSpoolStore;
class vtkMTStageTimes;
class vtkMTTriangleStream;
struct vtkMTBuildSettings;

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
  /// Whether normals are made when the input has no point normals. Default on.
  vtkSetMacro(MakeNormals, bool);
  vtkGetMacro(MakeNormals, bool);
  vtkBooleanMacro(MakeNormals, bool);
  ///@}

  ///@{
  /**
   * Bits of each of the two coordinates in which made normals are kept: with b bits they are rounded by less than 250 /
   * 2^b degrees. Default 12 (0.06 degrees); clamped to [6, 16]. They follow from the triangles, so a bit costs little:
   * about 0.06 bytes for each input triangle. Normals of the input are kept as they are.
   */
  vtkSetClampMacro(NormalBits, int, 6, 16);
  vtkGetMacro(NormalBits, int);
  ///@}

  ///@{
  /**
   * Made normals are split along edges whose triangles' normals are farther apart than this, in degrees: points stay
   * shared, only their normals differ. 180 makes all normals smooth, 0 all triangles flat; half a degree is allowed for
   * what the lattice rounds. Negative values are AutomaticFeatureAngle, the default: 30 where the angles of the mesh's
   * edges say that it is CAD (vtkMTDihedralAngles has the rule), 180 otherwise. Values above 180 are 180; NaN is
   * refused with an error. The model's settings "feature_angle" and "feature_angle_auto" say what was taken, and what
   * the mesh would choose.
   */
  void SetFeatureAngle(double degrees);
  vtkGetMacro(FeatureAngle, double);
  static constexpr double AutomaticFeatureAngle = -1.0;
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
  /**
   * Whether level 0 keeps the input's coordinates bit for bit, as residuals against the lattice in an array of its own
   * (vtkMTExactPoints) that is read only when it is asked for. What is drawn stays on the lattice, within the largest
   * shift that the model reports; a cut that is all of level 0 gives the input's own coordinates as data, with no error
   * at all. Default off. Costs about one to three bytes per input triangle at the default lattice.
   */
  vtkSetMacro(ExactPoints, bool);
  vtkGetMacro(ExactPoints, bool);
  vtkBooleanMacro(ExactPoints, bool);
  ///@}

  ///@{
  /**
   * Which triangles keep the id of the input's cell that they are, or that is nearest to them, in the cell array
   * vtkMTInputCellIds: none; those of the finest level (FinestInputIds, the default), from where a pick or a selection
   * on a coarse triangle takes the nearest one's (vtkMTInputIdFinder), while the array is -1 there; or those of all
   * levels (AllInputIds), for which the array takes three times the bytes. Clamped.
   */
  enum InputIdsType
  {
    NoInputIds,
    FinestInputIds,
    AllInputIds
  };
  vtkSetClampMacro(InputIds, int, NoInputIds, AllInputIds);
  vtkGetMacro(InputIds, int);
  ///@}

  ///@{
  /// Whether the points of the finest level keep the input's point ids in the point array vtkMTInputPointIds; of points
  /// of the input that are one point of the model (a soup's), the least. Default off. Takes about 0.5 bytes for each of
  /// the input's triangles.
  vtkSetMacro(InputPointIds, bool);
  vtkGetMacro(InputPointIds, bool);
  vtkBooleanMacro(InputPointIds, bool);
  ///@}

  ///@{
  /**
   * How many levels below a fragment the mesh is that its certified errors are held against, where the sums over the
   * steps in between are loose (vtkMTDirectDeviation). With 1 sums stand: a build then takes 0.7 of the
   * time, and certified errors of coarse levels are about twice the true ones where they are 1.3 to 1.5 times with 5.
   * Errors hold either way. Default 5; clamped to [1, 8]. Has no effect where CertifyNormals is on or values are
   * certified: angles and values are certified together with sums of distances.
   */
  vtkSetClampMacro(DirectLevels, int, 1, 8);
  vtkGetMacro(DirectLevels, int);
  ///@}

  ///@{
  /**
   * Whether the angles between the shading normals of fragments and input are bounded as well as the distances
   * (vtkMTNormalDeviation): the model then has the measures that the mapper's error metric NORMAL_DEVIATION goes by
   * (vtkMTMeasure::NormalDeviation). Default off: it takes about a fifth of the build's time.
   */
  vtkSetMacro(CertifyNormals, bool);
  vtkGetMacro(CertifyNormals, bool);
  vtkBooleanMacro(CertifyNormals, bool);
  ///@}

  ///@{
  /**
   * Arrays whose values are certified jointly with the distance (vtkMTValueDeviation): for every point of a fragment
   * there is one of the input within the distance whose value differs by at most so much, and the other way round. The
   * model then has the measure vtkMTMeasure::GetValueDeviationName for each of them. Arrays of points or cells, of one
   * component; others, and names of which there is no array, are an error of the build. nullptr, and a name that was
   * added before, are ignored. Default: none.
   */
  void AddCertifiedArrayName(const char* name);
  void RemoveAllCertifiedArrayNames();
#ifndef __VTK_WRAP__
  const std::vector<std::string>& GetCertifiedArrayNames() const
  {
    return this->CertifiedArrays;
  }
#endif
  ///@}

  ///@{
  /**
   * Which point arrays are labels, of which every value of a coarser level is one of the finer, and which are values,
   * which have a mean; in place of what their types and names say: real numbers are values; integers are labels, unless
   * they are colours (bytes of several components, or integers named as colours are, "red", "intensity", "COLOR_0").
   * Cell arrays are never mixed, so that it makes no difference there. Of a name that is added to both the last holds.
   * nullptr is ignored; a name of which there is no array is an error of the build. Default: none.
   */
  void AddLabelArrayName(const char* name);
  void AddValueArrayName(const char* name);
  void RemoveAllLabelArrayNames();
  void RemoveAllValueArrayNames();
#ifndef __VTK_WRAP__
  const std::vector<std::string>& GetLabelArrayNames() const
  {
    return this->LabelArrays;
  }
  const std::vector<std::string>& GetValueArrayNames() const
  {
    return this->ValueArrays;
  }
#endif
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

  ///@{
  /**
   * The most memory that the builder may hold beyond what the process has when Build begins, in bytes; what sinks and
   * streams hold is not in it. Default 0: no limit. A limit that is too small for the mesh is an error that names the
   * least that would do. Has no influence on the result.
   */
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  ///@}

  /// How much memory, and room for spools, a build of that input takes with the present settings.
  vtkMTMemoryPlan MakeMemoryPlan(const vtkMTTriangleStream& input) const;

  /// What spools are made by: nullptr, the default, keeps everything in memory. Has no influence on the result.
  void SetSpoolStore(std::shared_ptr<vtkMTSpoolStore> store);

  ///@{
  /**
   * Whether Build goes on from the store's checkpoint; when there is none it begins at the beginning. A checkpoint of
   * other settings or another input is an error. Default off.
   */
  vtkSetMacro(Resume, bool);
  vtkGetMacro(Resume, bool);
  vtkBooleanMacro(Resume, bool);
  ///@}

  ///@{
  /// What tells the input from any other one: kept in checkpoints, and compared. Default: empty.
  vtkSetStdStringFromCharMacro(InputIdentity);
  vtkGetCharFromStdStringMacro(InputIdentity);
  ///@}

  /**
   * Builds without a pipeline. False on failure or abort; then ErrorCode and ErrorMessage say why, the sink has been
   * abandoned and nothing is published, unless there is a checkpoint to go on from (HasCheckpoint): then store and sink
   * keep what belongs to it. Progress events and AbortExecute work as in the filter; GetProgressText says what is being
   * done.
   */
  bool Build(vtkMTTriangleStream& input, vtkMTPatchSink& output);

  /// Why the last Build failed; empty after success.
  vtkGetMacro(ErrorMessage, std::string);
  /// Whether the last Build failed and a later one can go on.
  vtkGetMacro(HasCheckpoint, bool);

  /// What the last Build spent its time with.
  const vtkMTStageTimes& GetStageTimes() const
  {
    return *this->StageTimes;
  }

  /// Of the settings, strategy and simplifier included.
  vtkMTimeType GetMTime() override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

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

  bool BuildLevels(vtkMTTriangleStream& input, vtkMTPatchSink& output, vtkMTSpoolStore& store);
  vtkMTBuildSettings MakeSettings() const;
  bool Configure(const vtkMTTriangleStream& input, vtkMTSpoolStore& store, vtkMTBuildSettings& settings);
  bool Begin(const vtkMTBuildSettings& settings, vtkMTTriangleStream& input, vtkMTPatchSink& output,
    vtkMTSequenceState& state, std::string& identity);
  std::string GetIdentity(const vtkMTTriangleStream& input) const;
  void AddArrayName(const char* name, std::vector<std::string>& to, std::vector<std::string>& from);

  int PatchTriangles = 1000;
  int LatticeBits = 24;
  int NumberOfThreads = 0;
  bool MakeNormals = true;
  double FeatureAngle = AutomaticFeatureAngle;
  int NormalBits = 12;
  bool KeepFarOutliers = false;
  bool ExactPoints = false;
  int InputIds = FinestInputIds;
  bool InputPointIds = false;
  bool CertifyNormals = false;
  int DirectLevels = 5;
  std::vector<std::string> CertifiedArrays;
  std::vector<std::string> LabelArrays;
  std::vector<std::string> ValueArrays;
  vtkSmartPointer<vtkMTPartitionStrategy> PartitionStrategy;
  vtkSmartPointer<vtkMTSimplifier> Simplifier;
  vtkTypeInt64 MemoryLimit = 0;
  std::shared_ptr<vtkMTSpoolStore> SpoolStore;
  bool Resume = false;
  std::string InputIdentity;
  std::string ErrorMessage;
  std::unique_ptr<vtkMTStageTimes> StageTimes; // never null
  bool HasCheckpoint = false;
  bool Aborted = false;
};

#endif
