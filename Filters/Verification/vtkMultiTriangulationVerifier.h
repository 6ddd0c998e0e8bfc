// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationVerifier
 * @brief checks a Multi-Triangulation, and its certified errors against the mesh that it was built from
 *
 * The checks of the model by itself are: "checksums" (every block of the file is read), "graph" (the DAG), "patches"
 * (each patch against its record), "nesting" (errors and spheres fall along every arc, and spheres hold their patches),
 * "pasting" (each fragment meets its surroundings along the same edges as its floor; BMT, section 3.2) and "conformity"
 * (of random cuts, at least half of which span three levels or more). When all of them pass and the input mesh is
 * given, the certified errors are tested by sampling: "certified_patch_to_input" (every point of a patch is within the
 * patch's error of the input) and "certified_input_to_cut" (every point of the input is no farther from a cut than the
 * largest error in that cut), for all vertices and for area-weighted samples, for the patches of every level, for one
 * cut for every level and for up to eight random cuts. The only allowance is 1e-12 of the model's size for the rounding
 * of coordinates. Where the model has certified angles between shading normals, "certified_normals" tests them in the
 * same cuts: every sampled point has one of the finest level within the error whose normal is within the angle, and the
 * other way round (1e-6 radians are allowed for single precision). Likewise "certified_values", for all arrays whose
 * values were certified: with a point whose value differs by no more than is certified (and 1e-12 of the largest
 * value).
 *
 * It is independent of the builder: it has its own surface, sampling and closest point search, its own readers of the
 * input's files, and knows the model through vtkMTPatchSource alone. Files (AddInputFileName) are read by VTK's readers
 * of VTK's formats and by small ones that follow the formats' specifications; "input_reading" says by which. Then, and
 * for a mesh on port 1, the finest level is held against the input: "input_triangles" (their number, with what the
 * input report counts as dropped), "input_bounds", "input_area", "input_volume" (signed), "input_orientation" (each
 * triangle has its counterpart, turned the same way) "input_arrays" (names, values, ranges, sets of labels) and
 * "labels" (coarse levels hold no others). What may differ follows from the lattice (GetCoordinateAllowance). Files
 * that cannot be read another way than the builder's are not checked so: "input_reading" has tested nothing and says
 * why, GetInputChecked is false, and IsValid says no more than that nothing wrong was found.
 *
 * As a filter it takes a vtkMultiTriangulation on port 0 and, optionally, the input mesh as vtkPolyData on port 1, and
 * gives a vtkTable with a row for each check and the columns "name" (string), "tested" and "violations" (counts),
 * "worst" (the largest of what was measured over what is allowed: at most 1 when all is well, 0 where nothing is
 * measured) and "message" (the first violation, for a person; empty when there is none). A check that finds violations
 * is a result and no error; ask IsValid. Verify is the same without a pipeline.
 *
 * The result depends on model, input and settings alone, not on threads. Memory: the input mesh is copied, 24 bytes per
 * point and 12 per triangle; a search structure is built over it, and over one cut at a time, of 20 to 36 bytes per
 * triangle, up to 340 where triangles are long and thin.
 */
#ifndef vtkMultiTriangulationVerifier_h
#define vtkMultiTriangulationVerifier_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkSmartPointer.h"         // For members
#include "vtkTableAlgorithm.h"

#include <functional> // For the input's opener
#include <memory>     // For members
#include <string>     // For members
#include <vector>     // For members

class vtkMTPatchSource;
class vtkMTTriangleStream;
class vtkPolyData;
class vtkTable;

class VTKMTVERIFICATION_EXPORT vtkMultiTriangulationVerifier : public vtkTableAlgorithm
{
public:
  static vtkMultiTriangulationVerifier* New();
  vtkTypeMacro(vtkMultiTriangulationVerifier, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Random cuts whose conformity is checked; the first eight of them are also measured against the input. Default 100;
  /// clamped to [0, 100000000].
  vtkSetClampMacro(NumberOfCuts, int, 0, 100000000);
  vtkGetMacro(NumberOfCuts, int);
  ///@}

  ///@{
  /// Area-weighted samples on each surface, beside all its vertices. Default 500000; clamped to [1, 100000000].
  vtkSetClampMacro(NumberOfSamples, int, 1, 100000000);
  vtkGetMacro(NumberOfSamples, int);
  ///@}

  ///@{
  /// Seed of cuts and samples, any number: the same seed gives the same result. Default 1.
  vtkSetMacro(Seed, unsigned int);
  vtkGetMacro(Seed, unsigned int);
  ///@}

  ///@{
  /**
   * The files that the model was built from, in the same order, and how they were to be taken: the iso value of volumes
   * (default: none), the vertical scale (default 1) and degrees (default off) of terrain. Numbers that are not finite
   * are an error and change nothing.
   */
  void AddInputFileName(const char* name);
  void RemoveAllInputFileNames();
  int GetNumberOfInputFileNames() const;
  const char* GetInputFileName(int index) const; ///< null when there is none
  void SetInputIsoValue(double value);
  void ClearInputIsoValue();
  void SetInputVerticalScale(double scale);
  vtkGetMacro(InputVerticalScale, double);
  vtkSetMacro(InputDegrees, bool);
  vtkGetMacro(InputDegrees, bool);
  ///@}

  ///@{
  /// What messages call the input, such as a file name. Default: "the input mesh"; the first input file's name where
  /// there is one.
  vtkSetStdStringFromCharMacro(InputName);
  vtkGetCharFromStdStringMacro(InputName);
  ///@}

#ifndef __VTK_WRAP__
  /// Opens the input when it is needed: not at all when the model is not sound. Null on failure, with the reason in
  /// error.
  using InputOpener = std::function<std::unique_ptr<vtkMTTriangleStream>(std::string& error)>;

  /**
   * Verifies without a pipeline. openInput is asked where there are no input files, and where these cannot be read
   * independently; with neither it verifies without an input. False when the checks could not be made or were
   * aborted; then ErrorCode and ErrorMessage say why, and there are no checks. Progress events and AbortExecute work as
   * in the filter; GetProgressText says what is being done.
   */
  bool Verify(const vtkMTPatchSource& source, const InputOpener& openInput = nullptr);
#endif

  /// Why the last verification could not be made; empty when it could, and when it was aborted.
  vtkGetMacro(ErrorMessage, std::string);

  ///@{
  /// What came of the last verification.
  /// Whether it ran to its end and no check found a violation.
  bool IsValid() const;
  /// The table of checks, the same as the filter's output. It has no rows when nothing was verified.
  vtkTable* GetChecks();
  /// How many of the random cuts span how many levels: columns "levels" and "cuts".
  vtkTable* GetSpans();
  /// Whether all of the input was read independently, or given as a mesh, and held against the finest level.
  vtkGetMacro(InputChecked, bool);
  /// How the input's files were read: "scan.ply: read by vtkMTVerifyPlyInput", or "not independently checked" and why.
  vtkGetMacro(InputReading, std::string);
  /// What coordinates, area and signed volume of the finest level may differ by from the input's, model units.
  vtkGetMacro(CoordinateAllowance, double);
  vtkGetMacro(AreaAllowance, double);
  vtkGetMacro(VolumeAllowance, double);
  /// Whether the errors were tested against an input.
  vtkGetMacro(Certified, bool);
  /**
   * How tight the certified errors are, for the nodes of each level: the certified error of a node over the largest
   * distance that was found by sampling, never below 1 when all is well. Columns "level", "median", "worst" and
   * "nodes"; no rows without an input.
   */
  vtkTable* GetTightness();
  /// Cuts that were measured against the input.
  vtkGetMacro(NumberOfMeasuredCuts, vtkIdType);
  /// Samples of certified values that were left out, because the value there is not finite: for each array one.
  vtkGetMacro(NumberOfSkippedValues, vtkIdType);
  /// The allowance for rounding, in the model's units; 0 without an input.
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Triangles of the input that are no surface, or that the model says it lacks, and that were left out: a corner that
  /// is NaN or infinite, an index out of range, two corners at one place, far outliers.
  vtkGetMacro(NumberOfNonFiniteTriangles, vtkIdType);
  vtkGetMacro(NumberOfOutOfRangeTriangles, vtkIdType);
  vtkGetMacro(NumberOfDegenerateTriangles, vtkIdType);
  vtkGetMacro(NumberOfFarOutliers, vtkIdType);
  ///@}

  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* time) override;

protected:
  vtkMultiTriangulationVerifier();
  ~vtkMultiTriangulationVerifier() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMultiTriangulationVerifier(const vtkMultiTriangulationVerifier&) = delete;
  void operator=(const vtkMultiTriangulationVerifier&) = delete;

#ifndef __VTK_WRAP__
  bool Run(const vtkMTPatchSource& source, vtkPolyData* mesh, const InputOpener& openInput);
  bool VerifyInput(const vtkMTPatchSource& source, vtkPolyData* mesh, const InputOpener& openInput);
#endif
  void Clear();

  int NumberOfCuts = 100;
  int NumberOfSamples = 500000;
  unsigned int Seed = 1;
  std::string InputName = "the input mesh";
  std::vector<std::string> InputFileNames;
  double InputIsoValue = 0.0;
  bool HasInputIsoValue = false;
  double InputVerticalScale = 1.0;
  bool InputDegrees = false;
  bool InputChecked = false;
  std::string InputReading;
  double CoordinateAllowance = 0.0;
  double AreaAllowance = 0.0;
  double VolumeAllowance = 0.0;
  std::string ErrorMessage;
  bool Aborted = false;
  vtkSmartPointer<vtkTable> Checks; // never null
  vtkSmartPointer<vtkTable> Spans;
  vtkSmartPointer<vtkTable> Tightness;
  bool Certified = false;
  vtkIdType NumberOfMeasuredCuts = 0;
  vtkIdType NumberOfSkippedValues = 0;
  double Tolerance = 0.0;
  vtkIdType NumberOfNonFiniteTriangles = 0;
  vtkIdType NumberOfOutOfRangeTriangles = 0;
  vtkIdType NumberOfDegenerateTriangles = 0;
  vtkIdType NumberOfFarOutliers = 0;
};

#endif
