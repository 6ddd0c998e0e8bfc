// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMultiTriangulationFileBuilder
 * @brief makes a Multi-Triangulation file from files, out of core
 *
 * Names of files in, one .bmt file out; meshes of any size, within a memory limit. Inputs are told apart by what is in
 * them, or else by the ending of the name:
 *
 * - meshes: PLY, STL, OBJ, OFF, VTP, VTK's legacy polydata, surfaces of VTK's grids, multi-block data, glTF and GLB,
 *   also compressed by gzip, with the textures that they refer to;
 * - volumes, of which an isosurface is taken (SetIsoValue): VTI, MHD, MHA, NRRD, NHDR, NIfTI, legacy structured points;
 * - tiles of terrain, all of one call being one terrain: SRTM (.hgt, .hgt.gz), USGS DEM and, where GDAL is built in,
 *   GeoTIFF;
 * - Multi-Triangulation files: their finest level.
 *
 * Several inputs become one model with a cell array "PartId" (0, 1, 2 ... in the order of the names); parts that touch
 * stay apart. Arrays of one name, type and number of components become one.
 *
 * The class opens the input, block by block where the format can be read so, and gives it to
 * vtkMultiTriangulationBuilder, whose algorithm and settings are described there (Cignoni et al., "Batched Multi
 * Triangulation", 2005). The bytes of the file depend on the input and on the settings that say so, but not on threads,
 * memory or interruptions. The file is written whole or not at all: an earlier one of that name stays as it is until
 * then.
 *
 * Update builds when a setting has changed since the last build, Write in any case: also when that one failed, or when
 * files have changed. Both report progress with a text (ProgressEvent, GetProgressText) and can be aborted
 * (AbortExecute, which Write takes back before it begins). When that, an error or the end of the process interrupts a
 * build that uses temporary files, these stay in the folder GetWorkFolder as far as they are a checkpoint, from which a
 * build with Resume goes on to the same bytes. On failure ErrorEvent is invoked, nothing is thrown, and GetErrorCode
 * and GetErrorMessage say why.
 *
 * @code
 * vtkNew<vtkMultiTriangulationFileBuilder> builder;
 * builder->AddFileName("scan.ply");
 * builder->SetOutputFileName("scan.bmt");
 * builder->SetMemoryLimit(vtkTypeInt64(1) << 30);
 * if (!builder->Write()) { std::cerr << builder->GetErrorMessage() << "\n"; }
 * @endcode
 */
#ifndef vtkMultiTriangulationFileBuilder_h
#define vtkMultiTriangulationFileBuilder_h

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"        // For ErrorType
#include "vtkMTBuildingModule.h" // For export macro

#include <memory>
#include <string>

class vtkMTBuildWorkspace;
class vtkMTInputFiles;
class vtkMTPartitionStrategy;
class vtkMTSimplifier;
class vtkMTStageTimes;
class vtkMTTriangleStream;
struct vtkMTBuildError;
struct vtkMTFileBuildReport;

class VTKMTBUILDING_EXPORT vtkMultiTriangulationFileBuilder : public vtkAlgorithm
{
public:
  static vtkMultiTriangulationFileBuilder* New();
  vtkTypeMacro(vtkMultiTriangulationFileBuilder, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Error codes beside those of vtkErrorCode (NoFileNameError, FileNotFoundError, CannotOpenFileError for files that
  /// cannot be read or made, FileFormatError, OutOfDiskSpaceError, UnknownError).
  enum ErrorType : unsigned long
  {
    AbortError = vtkErrorCode::UserError, ///< AbortExecute ended the build; no ErrorEvent is invoked
    MemoryLimitError,                     ///< the limit is too small for the mesh; the message names the least
    UnfinishedBuildError,                 ///< there is a checkpoint, and Resume is off
    IsoValueError,                        ///< there is a volume, and no iso value
    ArrayError,                           ///< the input has no array of a name that was added
    PrecisionError                        ///< finer than a lattice can be; the message names the least
  };

  ///@{
  /// The inputs. Empty names are ignored. SetFileName is for a single one. Default: none, which is an error.
  void AddFileName(const char* name);
  void SetFileName(const char* name);
  void RemoveAllFileNames();
  int GetNumberOfFileNames() const;
  /// nullptr where there is none of that index.
  const char* GetFileName(int index) const;
  ///@}

  ///@{
  /// The file to write, as a rule with the ending .bmt; its folder must exist. Default: empty, which is an error.
  vtkSetStdStringFromCharMacro(OutputFileName);
  vtkGetCharFromStdStringMacro(OutputFileName);
  ///@}

  /// Builds, also when nothing has changed. 1 on success, or else 0.
  int Write();

  ///@{
  /// Of volumes: the value of the isosurface. Any finite number; others are an error and change nothing. Default: none;
  /// then volumes are an error (IsoValueError).
  void SetIsoValue(double value);
  void ClearIsoValue();
  bool HasIsoValue() const;
  /// 0 where there is none.
  double GetIsoValue() const;
  ///@}

  ///@{
  /// Of volumes: whether normals come from the volume's gradient and not from the triangles. Default off. The volume is
  /// then read whole.
  void SetGradientNormals(bool on);
  bool GetGradientNormals() const;
  vtkBooleanMacro(GradientNormals, bool);
  ///@}

  ///@{
  /// Of terrain: what heights are multiplied by. Any finite number but 0; others are an error and change nothing.
  /// Default 1.
  void SetVerticalScale(double scale);
  double GetVerticalScale() const;
  ///@}

  ///@{
  /// Of terrain: whether longitude and latitude stay in degrees, instead of metres in a local frame. Default off.
  void SetDegrees(bool on);
  bool GetDegrees() const;
  vtkBooleanMacro(Degrees, bool);
  ///@}

  ///@{
  /// Which of the input's arrays are kept. Default: all. AddArrayName turns KeepAllArrays off; then those that were
  /// named are kept, and none when none was named. A name of which there is no array is an error (ArrayError).
  vtkSetMacro(KeepAllArrays, bool);
  vtkGetMacro(KeepAllArrays, bool);
  vtkBooleanMacro(KeepAllArrays, bool);
  void AddArrayName(const char* name);
  void RemoveAllArrayNames();
  ///@}

  ///@{
  /// Arrays whose values are certified jointly with the distance; see vtkMultiTriangulationBuilder. A name of which
  /// there is no array that is kept, or none of one component, is an error (ArrayError). Default: none.
  void AddCertifiedArrayName(const char* name);
  void RemoveAllCertifiedArrayNames();
  ///@}

  ///@{
  /// Which arrays are labels and which are values, in place of what their types and names say; see
  /// vtkMultiTriangulationBuilder. A name of which there is no array, or none that is kept, is an error (ArrayError).
  /// Default: none.
  void AddLabelArrayName(const char* name);
  void AddValueArrayName(const char* name);
  void RemoveAllLabelArrayNames();
  void RemoveAllValueArrayNames();
  ///@}

  ///@{
  /// Which triangles keep the input's cell ids, by which picking finds the input's cells: none, those of the finest
  /// level (the default) or all, as vtkMultiTriangulationBuilder::InputIdsType counts them. Clamped.
  void SetInputIds(int ids);
  int GetInputIds() const;
  void SetInputIdsToNone() { this->SetInputIds(0); }
  void SetInputIdsToFinest() { this->SetInputIds(1); }
  void SetInputIdsToAll() { this->SetInputIds(2); }
  ///@}

  ///@{
  /// Whether points of the finest level keep the input's point ids. Default off.
  void SetInputPointIds(bool on);
  bool GetInputPointIds() const;
  vtkBooleanMacro(InputPointIds, bool);
  ///@}

  ///@{
  /// Whether normals are made where the input has none. Default on.
  void SetMakeNormals(bool on);
  bool GetMakeNormals() const;
  vtkBooleanMacro(MakeNormals, bool);
  ///@}

  ///@{
  /// Bits of each of the two coordinates in which made normals are kept (see vtkMultiTriangulationBuilder). Default 12;
  /// clamped to [6, 16].
  void SetNormalBits(int bits);
  int GetNormalBits() const;
  ///@}

  ///@{
  /// Along which edges made normals are split, in degrees; negative, the default: chosen by the mesh (see
  /// vtkMultiTriangulationBuilder), and none where all inputs are terrain or volumes. 180: none. NaN is refused with an
  /// error.
  void SetFeatureAngle(double degrees);
  double GetFeatureAngle() const;
  ///@}

  ///@{
  /// Whether triangles so far away that they coarsen the lattice for all others are kept. Default off: a few are left
  /// out with a warning, many are an error (see vtkMultiTriangulationBuilder).
  void SetKeepFarOutliers(bool on);
  bool GetKeepFarOutliers() const;
  vtkBooleanMacro(KeepFarOutliers, bool);
  ///@}

  ///@{
  /// Whether the finest level keeps the input's coordinates bit for bit beside those on the lattice. Default off.
  void SetExactPoints(bool on);
  bool GetExactPoints() const;
  vtkBooleanMacro(ExactPoints, bool);
  ///@}

  ///@{
  /// How many levels below a fragment the mesh is that its certified errors are held against; with 1 those of steps add
  /// up, which is faster and about 1.5 times looser on coarse levels. Default 5; clamped to [1, 8].
  void SetDirectLevels(int levels);
  int GetDirectLevels() const;
  ///@}

  ///@{
  /// Whether angles between shading normals are certified as well as distances, for the mapper's error metric
  /// NORMAL_DEVIATION. Default off: it takes about a fifth of the time.
  void SetCertifyNormals(bool on);
  bool GetCertifyNormals() const;
  vtkBooleanMacro(CertifyNormals, bool);
  ///@}

  ///@{
  /// The wanted mean number of triangles in a patch. Default 1000; clamped to [16, 16384].
  void SetPatchTriangles(int triangles);
  int GetPatchTriangles() const;
  ///@}

  ///@{
  /// Bits of the lattice: the longest side of the model has at most 2^bits steps. Default 24; clamped to [10, 31].
  vtkSetClampMacro(LatticeBits, int, 10, 31);
  vtkGetMacro(LatticeBits, int);
  ///@}

  ///@{
  /// The most, in model units, by which a point may move when it is put on the lattice: chooses the bits in place of
  /// LatticeBits, which costs reading all points once more. Any finite number from 0; others are an error and change
  /// nothing. Default 0: LatticeBits holds.
  void SetPrecision(double precision);
  vtkGetMacro(Precision, double);
  ///@}

  ///@{
  /// How geometry and arrays are made smaller: NoCompression, FastCompression (the default: packed, LZ4) or
  /// SmallCompression (packed, zstd: some percent smaller, slower to write and to read). None loses anything. Clamped.
  enum CompressionType
  {
    NoCompression,
    FastCompression,
    SmallCompression
  };
  vtkSetClampMacro(Compression, int, NoCompression, SmallCompression);
  vtkGetMacro(Compression, int);
  ///@}

  ///@{
  /// How regions are placed, vtkMTVoronoiPartition by default, and how their triangles are simplified, by default
  /// vtkMTEdgeCollapse in mode fast. nullptr is ignored.
  void SetPartitionStrategy(vtkMTPartitionStrategy* strategy);
  vtkMTPartitionStrategy* GetPartitionStrategy();
  void SetSimplifier(vtkMTSimplifier* simplifier);
  vtkMTSimplifier* GetSimplifier();
  ///@}

  ///@{
  /// Threads. Default 0: as many as there are processors. Clamped to [0, 1024]. No influence on the file.
  void SetNumberOfThreads(int threads);
  int GetNumberOfThreads() const;
  ///@}

  ///@{
  /**
   * The most memory that the whole process may hold while it builds, in bytes; what it holds already counts. Default 0:
   * a quarter of the machine's, GetDefaultMemoryLimit. A limit that is too small is an error that names the least
   * (MemoryLimitError). While it builds within a limit, the C library gives memory that is freed back to the system, as
   * the process would seem larger than it is otherwise; after that it keeps up to 64 MiB of it (mallopt). Where half of
   * the limit is enough to build in memory, it keeps what is freed until then, and the heap is made of large pages
   * (madvise). No influence on the file.
   */
  vtkSetClampMacro(MemoryLimit, vtkTypeInt64, 0, VTK_TYPE_INT64_MAX);
  vtkGetMacro(MemoryLimit, vtkTypeInt64);
  static vtkTypeInt64 GetDefaultMemoryLimit();
  ///@}

  ///@{
  /// An existing folder for temporary files. Default: empty; what fits in memory is built there, and the folder of the
  /// output is used for everything else. When a folder is named, it is used in any case. No influence on the file.
  vtkSetStdStringFromCharMacro(TemporaryFolder);
  vtkGetCharFromStdStringMacro(TemporaryFolder);
  ///@}

  ///@{
  /// Whether to go on with an earlier build of the same output, input and settings, if there is one, and to leave the
  /// output as it is when it is there already. Default off: then an unfinished build is an error
  /// (UnfinishedBuildError).
  vtkSetMacro(Resume, bool);
  vtkGetMacro(Resume, bool);
  vtkBooleanMacro(Resume, bool);
  ///@}

  /// Why the last build failed, in one sentence; empty after success.
  vtkGetMacro(ErrorMessage, std::string);
  /// Whether the last build failed and one with Resume can go on from where it was.
  vtkGetMacro(HasCheckpoint, bool);
  /// Whether the last build found that the output was there already (with Resume).
  bool GetWasFinished() const;
  /// The folder of the build's temporary files: the name of the output and ".build".
  std::string GetWorkFolder() const;

  /**
   * For a program that must end while another of its threads is in Update, after a signal for example: removes the
   * temporary files that no later build could go on from, and what has been written of the output. Whether there is a
   * checkpoint. The process must end right after it: the build has lost its files.
   */
  bool ReleaseFilesBeforeExit();

#ifndef __VTK_WRAP__
  ///@{
  /// Of the last build: what it found, and what it spent its time with.
  const vtkMTFileBuildReport& GetReport() const
  {
    return *this->Report;
  }
  const vtkMTStageTimes& GetStageTimes() const;
  ///@}
#endif

  /// Of the settings, strategy and simplifier included.
  vtkMTimeType GetMTime() override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector) override;

protected:
  vtkMultiTriangulationFileBuilder();
  ~vtkMultiTriangulationFileBuilder() override;

private:
  vtkMultiTriangulationFileBuilder(const vtkMultiTriangulationFileBuilder&) = delete;
  void operator=(const vtkMultiTriangulationFileBuilder&) = delete;

  struct Internals;
  int BuildFile();
  bool Build(vtkMTBuildError& error);
  bool CheckFiles(vtkMTBuildError& error) const;
  bool MakeIdentity(const vtkMTInputFiles& files, vtkMTBuildError& error);
  bool IsFinished() const;
  bool BuildFromFiles(const vtkMTInputFiles& files, vtkMTBuildWorkspace& workspace, vtkMTBuildError& error);
  std::unique_ptr<vtkMTTriangleStream> OpenInput(
    const vtkMTInputFiles& files, const vtkMTBuildWorkspace& workspace, vtkMTBuildError& error);
  bool ChooseLattice(vtkMTTriangleStream& input, vtkMTBuildError& error);
  bool WriteFile(vtkMTTriangleStream& input, vtkMTBuildWorkspace& workspace, vtkMTBuildError& error);
  bool Advance(double fraction, const char* text);
  void OnProgress(vtkObject* caller, unsigned long event, void* data);
  void OnWarning(vtkObject* caller, unsigned long event, void* data);

  std::string OutputFileName;
  bool KeepAllArrays = true;
  int LatticeBits = 24;
  double Precision = 0.0;
  int Compression = FastCompression;
  vtkTypeInt64 MemoryLimit = 0;
  std::string TemporaryFolder;
  bool Resume = false;
  std::string ErrorMessage;
  bool HasCheckpoint = false;
  std::unique_ptr<Internals> Implementation;
  std::unique_ptr<vtkMTFileBuildReport> Report; // never null
};

#endif
