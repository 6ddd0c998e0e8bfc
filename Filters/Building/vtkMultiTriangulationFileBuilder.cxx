// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationFileBuilder.h"
#include "Interpreter/vtkMTLongWork.h"
#include "vtkMultiTriangulationFileBuilderInternals.h"

#include "vtkMTBuildError.h"
#include "vtkMTBuildWorkspace.h"
#include "vtkMTCompatibility.h"
#include "vtkMTFileAccess.h"
#include "vtkMTFileBuildReport.h"
#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTFileSpoolStore.h"
#include "vtkMTInputFiles.h"
#include "vtkMTLatticeChoice.h"
#include "vtkMTModelSink.h"
#include "vtkMTOutputFile.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTSelectedInput.h"
#include "vtkMTSimplifier.h"

#include "vtkCommand.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <new>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMultiTriangulationFileBuilder);

namespace
{
// Whether a model's made normals are split where this build would split them. Which angle was asked for is no part of a
// file, so that normals that are the same make the same file.
bool HasFeatureAngle(const std::map<std::string, std::string>& settings, double wanted)
{
  const auto used = settings.find("feature_angle");
  const auto automatic = settings.find("feature_angle_auto");
  if (used == settings.end() || automatic == settings.end())
  {
    return true; // none were made
  }
  return wanted < 0.0 ? used->second == automatic->second : std::abs(std::stod(used->second) - wanted) < 1e-4 * wanted;
}

// Terrain and isosurfaces are not designed, whatever their angles look like: a cliff is no crease.
double GetAngle(double wanted, const std::vector<std::string>& paths)
{
  return wanted < 0.0 && vtkMTBuildInput::AreSampled(paths) ? 180.0 : wanted;
}

// The builder has another feature angle while this is there.
class FeatureAngleScope
{
public:
  FeatureAngleScope(vtkMultiTriangulationBuilder* builder, double angle)
    : Builder(builder)
    , Before(builder->GetFeatureAngle())
  {
    this->Builder->SetFeatureAngle(angle);
  }
  ~FeatureAngleScope() { this->Builder->SetFeatureAngle(this->Before); }
  FeatureAngleScope(const FeatureAngleScope&) = delete;
  void operator=(const FeatureAngleScope&) = delete;

private:
  vtkMultiTriangulationBuilder* const Builder;
  const double Before;
};

// CPU seconds of all threads, and seconds by the clock.
class Stopwatch
{
public:
  void Read(double& cpu, double& wall) const
  {
    cpu = static_cast<double>(std::clock() - this->Cpu) / CLOCKS_PER_SEC;
    wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Wall).count();
  }

private:
  const std::clock_t Cpu = std::clock();
  const std::chrono::steady_clock::time_point Wall = std::chrono::steady_clock::now();
};
}

vtkMultiTriangulationFileBuilder::vtkMultiTriangulationFileBuilder()
  : Implementation(std::make_unique<Internals>())
  , Report(std::make_unique<vtkMTFileBuildReport>())
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(0);
  vtkMultiTriangulationBuilder* builder = this->Implementation->Builder;
  builder->AddObserver(vtkCommand::ProgressEvent, this, &vtkMultiTriangulationFileBuilder::OnProgress);
  builder->AddObserver(vtkCommand::WarningEvent, this, &vtkMultiTriangulationFileBuilder::OnWarning);
}

vtkMultiTriangulationFileBuilder::~vtkMultiTriangulationFileBuilder() = default;

//------------------------------------------------------------------------------
// Progress

// Whether the work goes on.
bool vtkMultiTriangulationFileBuilder::Advance(double fraction, const char* text)
{
  this->SetProgressText(text);
  this->UpdateProgress(fraction);
  return !vtkMTIsAborted(this);
}

void vtkMultiTriangulationFileBuilder::OnProgress(vtkObject*, unsigned long, void* data)
{
  vtkMultiTriangulationBuilder* builder = this->Implementation->Builder;
  if (!this->Advance(*static_cast<double*>(data), builder->GetProgressText()))
  {
    builder->AbortExecuteOn();
  }
}

void vtkMultiTriangulationFileBuilder::OnWarning(vtkObject*, unsigned long event, void* data)
{
  if (this->HasObserver(event))
  {
    this->InvokeEvent(event, data);
  }
  else
  {
    vtkOutputWindowDisplayWarningText(static_cast<const char*>(data));
  }
}

//------------------------------------------------------------------------------
// The build
int vtkMultiTriangulationFileBuilder::Write()
{
  vtkMTForgetAbort(this);
  this->Modified();
  this->Update();
  return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

vtkTypeBool vtkMultiTriangulationFileBuilder::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return request->Has(vtkDemandDrivenPipeline::REQUEST_DATA())
    ? this->BuildFile()
    : this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkMultiTriangulationFileBuilder::BuildFile()
{
  const vtkMTLongWork work;
  this->SetErrorCode(vtkErrorCode::NoError);
  this->ErrorMessage.clear();
  this->HasCheckpoint = false;
  *this->Report = vtkMTFileBuildReport();
  vtkMTBuildError error;
  try
  {
    this->Build(error);
  }
  catch (const std::bad_alloc&)
  {
    error.Fail(vtkErrorCode::UnknownError, "out of memory; use a smaller input or a machine with more memory");
  }
  catch (const std::exception& fault)
  {
    error.Fail(vtkErrorCode::UnknownError, std::string("an internal fault: ") + fault.what());
  }
  this->Implementation->UsesFolder = false;
  this->Implementation->Builder->SetSpoolStore(nullptr);
  this->SetErrorCode(error.Code);
  this->ErrorMessage = error.Message;
  if (error.Code == vtkErrorCode::NoError || error.Code == AbortError)
  {
    return 1; // what the user asked for is no error
  }
  vtkErrorMacro(<< this->ErrorMessage);
  return 0;
}

bool vtkMultiTriangulationFileBuilder::Build(vtkMTBuildError& error)
{
  if (!this->CheckFiles(error))
  {
    return false;
  }
  const vtkMTInputFiles files(vtkMTBuildInput::FindFiles(this->Implementation->Input.Paths));
  vtkMTBuildWorkspace workspace(
    { this->OutputFileName, this->TemporaryFolder, static_cast<std::uint64_t>(this->MemoryLimit), this->Resume });
  if (!this->MakeIdentity(files, error) || !workspace.Open(error))
  {
    return false;
  }
  this->Report->WasFinished = this->Resume && this->IsFinished();
  if (this->Report->WasFinished)
  {
    this->Advance(1.0, "");
    return workspace.RemoveCheckpoint(error);
  }
  const bool built = this->BuildFromFiles(files, workspace, error);
  this->Report->MemoryLimit = workspace.GetLimit();
  this->Report->TemporaryBytes = workspace.GetTemporaryBytes();
  this->Report->TemporaryBytesEstimated = workspace.GetEstimate();
  return built;
}

bool vtkMultiTriangulationFileBuilder::CheckFiles(vtkMTBuildError& error) const
{
  const std::vector<std::string>& paths = this->Implementation->Input.Paths;
  if (paths.empty() || this->OutputFileName.empty())
  {
    return error.Fail(vtkErrorCode::NoFileNameError,
      paths.empty() ? "there is no file to build from; add one (AddFileName)"
                    : "there is no name for the file to write; set it (SetOutputFileName)");
  }
  std::string reason;
  if (!vtkMTFileAccess::CanWrite(this->OutputFileName, reason))
  {
    return error.Fail(vtkErrorCode::CannotOpenFileError, reason);
  }
  for (const std::string& path : paths)
  {
    if (!vtkMTFileAccess::CanRead(path, reason))
    {
      std::error_code code;
      return error.Fail(
        std::filesystem::exists(path, code) ? vtkErrorCode::CannotOpenFileError : vtkErrorCode::FileNotFoundError,
        reason);
    }
  }
  return true;
}

// Of all that has an influence on the file: the input's bytes and the settings, as a hash.
bool vtkMultiTriangulationFileBuilder::MakeIdentity(const vtkMTInputFiles& files, vtkMTBuildError& error)
{
  std::string hash;
  if (!files.GetHash([this] { return this->Advance(0.0, "looking at the input"); }, hash, error))
  {
    return false;
  }
  const char* const compressions[] = { "none", "fast", "small" };
  const vtkMTInputSettings& input = this->Implementation->Input;
  vtkMultiTriangulationBuilder* builder = this->Implementation->Builder;
  std::ostringstream text;
  text.precision(17);
  text << hash;
  for (const std::string& path : input.Paths) // the ending says what a file is, the name of a tile where it lies
  {
    text << ", " << std::filesystem::path(path).filename().string();
  }
  text << "; iso " << input.IsoValue.value_or(0.0) << input.IsoValue.has_value() << input.GradientNormals
       << "; heights by " << input.VerticalScale << input.Degrees << "; patches of " << builder->GetPatchTriangles()
       << ", " << this->LatticeBits << " bits, precision " << this->Precision << ", " << compressions[this->Compression]
       << "; " << !builder->GetMakeNormals() << builder->GetKeepFarOutliers() << "; ids " << builder->GetInputIds()
       << (builder->GetInputPointIds() ? " and of points" : "") << (builder->GetExactPoints() ? " exact" : "")
       << (builder->GetCertifyNormals() ? " normals" : "") << "; " << builder->GetDirectLevels() << " direct levels; "
       << builder->GetPartitionStrategy()->GetSettings() << "; " << builder->GetSimplifier()->GetSettings();
  for (std::size_t i = 0; !this->KeepAllArrays && i < this->Implementation->Arrays.size(); ++i)
  {
    text << "; " << this->Implementation->Arrays[i];
  }
  for (const std::string& name : builder->GetCertifiedArrayNames())
  {
    text << "; certified " << name;
  }
  for (const std::string& name : builder->GetLabelArrayNames())
  {
    text << "; labels " << name;
  }
  for (const std::string& name : builder->GetValueArrayNames())
  {
    text << "; values " << name;
  }
  this->Implementation->Identity = vtkMTInputFiles::GetHash(text.str());
  builder->SetInputIdentity(this->Implementation->Identity.c_str());
  return true;
}

// Whether the output is there already, as this build would make it.
bool vtkMultiTriangulationFileBuilder::IsFinished() const
{
  std::string reason;
  vtkMTFileSource model;
  if (!vtkMTFileSource::CanRead(this->OutputFileName) || !model.Open(this->OutputFileName, reason))
  {
    return false;
  }
  const auto& settings = model.GetGraph().Settings;
  const auto found = settings.find("build");
  return found != settings.end() && found->second == this->Implementation->Identity &&
    HasFeatureAngle(settings, GetAngle(this->GetFeatureAngle(), this->Implementation->Input.Paths));
}

bool vtkMultiTriangulationFileBuilder::BuildFromFiles(
  const vtkMTInputFiles& files, vtkMTBuildWorkspace& workspace, vtkMTBuildError& error)
{
  const Stopwatch watch;
  const FeatureAngleScope angle(
    this->Implementation->Builder, GetAngle(this->GetFeatureAngle(), this->Implementation->Input.Paths));
  const std::unique_ptr<vtkMTTriangleStream> stream = this->OpenInput(files, workspace, error);
  if (!stream || !this->ChooseLattice(*stream, error))
  {
    return false;
  }
  this->Report->InputTriangles = stream->GetNumberOfTriangles();
  watch.Read(this->Report->ReadingCpuSeconds, this->Report->ReadingWallSeconds);
  const bool written = this->WriteFile(*stream, workspace, error);
  watch.Read(this->Report->CpuSeconds, this->Report->WallSeconds);
  return written;
}

std::unique_ptr<vtkMTTriangleStream> vtkMultiTriangulationFileBuilder::OpenInput(
  const vtkMTInputFiles& files, const vtkMTBuildWorkspace& workspace, vtkMTBuildError& error)
{
  const auto goesOn = [this] { return this->Advance(0.0, "opening the input"); };
  if (!goesOn())
  {
    error.Fail(AbortError, "aborted");
    return nullptr;
  }
  vtkMTBuildInput input(this->Implementation->Input, goesOn);
  std::unique_ptr<vtkMTTriangleStream> opened = input.Open(workspace.GetScratch(), workspace.GetLimit(), error);
  this->Report->Input = input.GetResult();
  if (!opened)
  {
    return nullptr;
  }
  auto selected = std::make_unique<vtkMTSelectedInput>(std::move(opened), files, this->Report->Input.Counts);
  std::string missing = this->KeepAllArrays ? "" : selected->KeepArrays(this->Implementation->Arrays);
  std::vector<vtkMTArrayInfo> kept = selected->GetArrays();
  vtkMultiTriangulationBuilder* builder = this->Implementation->Builder;
  missing = missing.empty()
    ? vtkMTArrayInfo::ChooseMeanings(builder->GetLabelArrayNames(), builder->GetValueArrayNames(), kept)
    : missing;
  if (!missing.empty())
  {
    error.Fail(ArrayError, "the input has no array \"" + missing + "\"");
    return nullptr;
  }
  const std::string uncertifiable = vtkMTArrayInfo::FindUncertifiable(builder->GetCertifiedArrayNames(), kept);
  if (!uncertifiable.empty())
  {
    error.Fail(ArrayError, uncertifiable);
    return nullptr;
  }
  return selected;
}

bool vtkMultiTriangulationFileBuilder::ChooseLattice(vtkMTTriangleStream& input, vtkMTBuildError& error)
{
  int bits = this->LatticeBits;
  if (this->Precision > 0.0 && !vtkMTLatticeChoice::FindBits(input, this->Precision, bits, error))
  {
    return false;
  }
  this->Implementation->Builder->SetLatticeBits(bits);
  return true;
}

bool vtkMultiTriangulationFileBuilder::WriteFile(
  vtkMTTriangleStream& input, vtkMTBuildWorkspace& workspace, vtkMTBuildError& error)
{
  vtkMultiTriangulationBuilder* builder = this->Implementation->Builder;
  if (!workspace.Prepare(input, builder, error))
  {
    return false;
  }
  if (!workspace.GetWarning().empty())
  {
    vtkWarningMacro(<< workspace.GetWarning());
  }
  this->Implementation->UsesFolder = workspace.GetStore() != nullptr;
  vtkMTFileSink sink(
    this->OutputFileName, static_cast<vtkMTFileSink::CompressionType>(this->Compression), workspace.GetStore());
  vtkMTModelSink model(sink, this->Report->Input, this->Implementation->Identity);
  vtkMTForgetAbort(builder);
  if (builder->Build(input, model))
  {
    return true;
  }
  this->HasCheckpoint = builder->GetHasCheckpoint() && workspace.HasCheckpoint();
  return vtkMTIsAborted(this)
    ? error.Fail(AbortError, "aborted; " + this->OutputFileName + " is as it was")
    : error.Fail(builder->GetErrorCode(), this->OutputFileName + " was not written: " + builder->GetErrorMessage());
}

bool vtkMultiTriangulationFileBuilder::ReleaseFilesBeforeExit()
{
  vtkMTOutputFile::RemoveStrays(this->OutputFileName, true);
  const std::string folder = this->GetWorkFolder();
  const bool canResume = vtkMTFileSpoolStore::HasState(folder);
  if (!canResume && this->Implementation->UsesFolder)
  {
    vtkMTFileSpoolStore::RemoveFiles(folder);
  }
  return canResume;
}
