// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationBuilder.h"

#include "Interpreter/vtkMTLongWork.h"
#include "vtkMTBuildProgress.h"
#include "vtkMTCheckpoint.h"
#include "vtkMTCompatibility.h"
#include "vtkMTEdgeCollapse.h"
#include "vtkMTInputMesh.h"
#include "vtkMTLevelLoop.h"
#include "vtkMTMemorySpoolStore.h"
#include "vtkMTMeshMemory.h"
#include "vtkMTPatchSink.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTSequenceState.h"
#include "vtkMTStageTimes.h"
#include "vtkMTTrimHeap.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkMultiTriangulation.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

#include <omp.h>

vtkStandardNewMacro(vtkMultiTriangulationBuilder);

namespace
{
/// The threads of the calling thread's parallel loops, while this lives: partitions have no number of their own.
class ThreadCount
{
public:
  explicit ThreadCount(int threads)
    : Before(omp_get_max_threads())
  {
    omp_set_num_threads(threads);
  }
  ~ThreadCount() { omp_set_num_threads(this->Before); }
  ThreadCount(const ThreadCount&) = delete;
  ThreadCount& operator=(const ThreadCount&) = delete;

private:
  int Before;
};

// The shares of the input's steps in the whole, measured on fractal spheres.
vtkMTBuildProgress MakeProgress()
{
  return vtkMTBuildProgress(
    { { "reading points", 0.0 }, { "reading triangles", 0.02 }, { "sorting points", 0.04 },
      { "checking triangles", 0.06 }, { "looking for far outliers", 0.07 }, { "finding barycentres", 0.08 },
      { "placing regions", 0.11 }, { "sorting into regions", 0.13 }, { "making fragments", 0.17 },
      { "finishing fragments", 0.2 } },
    0.22);
}
}

vtkMultiTriangulationBuilder::vtkMultiTriangulationBuilder()
  : PartitionStrategy(vtkSmartPointer<vtkMTVoronoiPartition>::New())
  , Simplifier(vtkSmartPointer<vtkMTEdgeCollapse>::New())
  , StageTimes(std::make_unique<vtkMTStageTimes>())
{
}

vtkMultiTriangulationBuilder::~vtkMultiTriangulationBuilder() = default;

void vtkMultiTriangulationBuilder::SetPartitionStrategy(vtkMTPartitionStrategy* strategy)
{
  if (strategy && strategy != this->PartitionStrategy)
  {
    this->PartitionStrategy = strategy;
    this->Modified();
  }
}

vtkMTPartitionStrategy* vtkMultiTriangulationBuilder::GetPartitionStrategy()
{
  return this->PartitionStrategy;
}

void vtkMultiTriangulationBuilder::SetSimplifier(vtkMTSimplifier* simplifier)
{
  if (simplifier && simplifier != this->Simplifier)
  {
    this->Simplifier = simplifier;
    this->Modified();
  }
}

vtkMTSimplifier* vtkMultiTriangulationBuilder::GetSimplifier()
{
  return this->Simplifier;
}

void vtkMultiTriangulationBuilder::AddArrayName(
  const char* name, std::vector<std::string>& to, std::vector<std::string>& from)
{
  if (name)
  {
    from.erase(std::remove(from.begin(), from.end(), name), from.end());
    to.emplace_back(name);
    this->Modified();
  }
}

void vtkMultiTriangulationBuilder::AddLabelArrayName(const char* name)
{
  this->AddArrayName(name, this->LabelArrays, this->ValueArrays);
}

void vtkMultiTriangulationBuilder::AddValueArrayName(const char* name)
{
  this->AddArrayName(name, this->ValueArrays, this->LabelArrays);
}

void vtkMultiTriangulationBuilder::AddCertifiedArrayName(const char* name)
{
  std::vector<std::string>& names = this->CertifiedArrays;
  if (name && std::find(names.begin(), names.end(), name) == names.end())
  {
    names.emplace_back(name);
    this->Modified();
  }
}

void vtkMultiTriangulationBuilder::RemoveAllCertifiedArrayNames()
{
  this->CertifiedArrays.clear();
  this->Modified();
}

void vtkMultiTriangulationBuilder::RemoveAllLabelArrayNames()
{
  this->LabelArrays.clear();
  this->Modified();
}

void vtkMultiTriangulationBuilder::RemoveAllValueArrayNames()
{
  this->ValueArrays.clear();
  this->Modified();
}

vtkMTimeType vtkMultiTriangulationBuilder::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->PartitionStrategy->GetMTime(), this->Simplifier->GetMTime() });
}

void vtkMultiTriangulationBuilder::SetFeatureAngle(double degrees)
{
  if (std::isnan(degrees))
  {
    vtkErrorMacro("SetFeatureAngle: the value is not a number; FeatureAngle stays " << this->FeatureAngle << ".");
    return;
  }
  degrees = degrees < 0.0 ? AutomaticFeatureAngle : std::min(degrees, 180.0);
  if (this->FeatureAngle != degrees)
  {
    this->FeatureAngle = degrees;
    this->Modified();
  }
}

void vtkMultiTriangulationBuilder::SetSpoolStore(std::shared_ptr<vtkMTSpoolStore> store)
{
  this->SpoolStore = std::move(store);
}

bool vtkMultiTriangulationBuilder::Build(vtkMTTriangleStream& input, vtkMTPatchSink& output)
{
  const vtkMTLongWork work;
  this->SetErrorCode(vtkErrorCode::NoError);
  this->ErrorMessage.clear();
  this->Aborted = false;
  this->StageTimes = std::make_unique<vtkMTStageTimes>();
  this->UpdateProgress(0.0);
  this->HasCheckpoint = false;
  const vtkMTTrimHeap trim(vtkMTTrimHeap::Always);
  vtkMTMemorySpoolStore memory;
  vtkMTSpoolStore& store = this->SpoolStore ? *this->SpoolStore : memory;
  bool built = false;
  try
  {
    built = this->BuildLevels(input, output, store);
  }
  catch (const std::exception& e)
  {
    this->ErrorMessage = std::string("out of memory or an internal fault: ") + e.what();
  }
  if (!built)
  {
    if (!this->HasCheckpoint)
    {
      output.Abandon();
    }
    this->SetErrorCode(this->Aborted ? vtkErrorCode::UserError : vtkErrorCode::UnknownError);
    return false;
  }
  this->HasCheckpoint = false;
  store.Clear();
  this->UpdateProgress(1.0);
  return true;
}

bool vtkMultiTriangulationBuilder::BuildLevels(
  vtkMTTriangleStream& input, vtkMTPatchSink& output, vtkMTSpoolStore& store)
{
  vtkMTBuildSettings settings;
  vtkMTSequenceState state;
  std::string identity;
  if (!this->Configure(input, store, settings))
  {
    return false;
  }
  const ThreadCount threads(settings.Threads);
  if (!this->Begin(settings, input, output, state, identity))
  {
    return false;
  }
  vtkMTLevelLoop loop(settings, output, identity);
  const auto begin = std::chrono::steady_clock::now();
  const bool built = loop.Run(state);
  this->StageTimes->SetLevelSeconds(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  this->HasCheckpoint = this->HasCheckpoint || loop.HasCheckpoint();
  this->ErrorMessage = loop.GetError();
  this->Aborted = loop.WasAborted();
  return built;
}

vtkMTBuildSettings vtkMultiTriangulationBuilder::MakeSettings() const
{
  vtkMTBuildSettings settings;
  settings.PatchTriangles = static_cast<std::size_t>(this->PatchTriangles);
  settings.LatticeBits = this->LatticeBits;
  settings.MakeNormals = this->MakeNormals;
  settings.FeatureAngle = this->FeatureAngle;
  settings.NormalBits = this->NormalBits;
  settings.KeepFarOutliers = this->KeepFarOutliers;
  settings.ExactPoints = this->ExactPoints;
  settings.InputIds = static_cast<vtkMTBuildSettings::Ids>(this->InputIds);
  settings.InputPointIds = this->InputPointIds;
  settings.CertifyNormals = this->CertifyNormals;
  settings.DirectLevels = this->DirectLevels;
  settings.CertifiedArrays = this->CertifiedArrays;
  settings.LabelArrays = this->LabelArrays;
  settings.ValueArrays = this->ValueArrays;
  settings.Partition = this->PartitionStrategy;
  settings.Reduction = this->PartitionStrategy->GetReduction();
  settings.PatchesPerRegion = this->PartitionStrategy->GetPatchesPerRegion();
  settings.Simplifier = this->Simplifier;
  settings.Threads = this->NumberOfThreads > 0 ? this->NumberOfThreads : omp_get_max_threads();
  return settings;
}

vtkMTMemoryPlan vtkMultiTriangulationBuilder::MakeMemoryPlan(const vtkMTTriangleStream& input) const
{
  return vtkMTMemoryPlan(vtkMTMeshMemory(input, this->MakeSettings()).Needs);
}

bool vtkMultiTriangulationBuilder::Configure(
  const vtkMTTriangleStream& input, vtkMTSpoolStore& store, vtkMTBuildSettings& settings)
{
  settings = this->MakeSettings();
  settings.Store = &store;
  settings.Times = this->StageTimes.get();
  settings.Progress = [this, progress = MakeProgress()](const vtkMTWorkSettings::ProgressReport& report) mutable
  {
    progress.Update(report);
    this->SetProgressText(progress.GetText().c_str());
    this->UpdateProgress(progress.GetFraction());
    return !vtkMTIsAborted(this);
  };
  const vtkMTMeshMemory memory(input, settings);
  settings.MemoryPerByteSimplified = memory.PerByteSimplified;
  settings.MemoryPerByteSplit = memory.PerByteSplit;
  return vtkMTMemoryPlan(memory.Needs)
    .Apply(static_cast<std::uint64_t>(this->MemoryLimit), settings, this->ErrorMessage);
}

// The mesh that the level loop goes on from, read or restored.
bool vtkMultiTriangulationBuilder::Begin(const vtkMTBuildSettings& settings, vtkMTTriangleStream& input,
  vtkMTPatchSink& output, vtkMTSequenceState& state, std::string& identity)
{
  identity = this->GetIdentity(input);
  vtkMTCheckpoint checkpoint;
  if (this->Resume && !checkpoint.Read(*settings.Store, this->ErrorMessage))
  {
    return false;
  }
  if (!checkpoint.IsEmpty())
  {
    this->HasCheckpoint = true;
    if (checkpoint.Identity != identity)
    {
      this->ErrorMessage = "the checkpoint is of another input or of other settings: resume with those, or begin anew";
      return false;
    }
    if (!state.Load(*settings.Store, checkpoint.State, this->ErrorMessage))
    {
      return false;
    }
    const bool restored = output.Restore(state.Graph.Arrays, checkpoint.Sink);
    this->ErrorMessage = restored ? "" : output.GetError();
    return restored;
  }
  vtkMTInputMesh mesh(settings);
  if (!mesh.Read(input, state))
  {
    this->ErrorMessage = mesh.GetError();
    this->Aborted = mesh.WasAborted();
    return false;
  }
  if (!mesh.GetWarning().empty())
  {
    vtkWarningMacro(<< mesh.GetWarning());
  }
  const bool begun = output.Begin(state.Graph.Arrays);
  this->ErrorMessage = begun ? "" : output.GetError();
  return begun;
}

std::string vtkMultiTriangulationBuilder::GetIdentity(const vtkMTTriangleStream& input) const
{
  std::string identity = this->InputIdentity + "; " + std::to_string(input.GetNumberOfPoints()) + " points, " +
    std::to_string(input.GetNumberOfTriangles()) + " triangles";
  for (const vtkMTArrayInfo& array : input.GetArrays())
  {
    identity += ", " + array.Name + " " + std::to_string(array.GetTupleSize());
  }
  for (const std::string& name : this->LabelArrays)
  {
    identity += "; labels " + name;
  }
  for (const std::string& name : this->ValueArrays)
  {
    identity += "; values " + name;
  }
  for (const std::string& name : this->CertifiedArrays)
  {
    identity += "; certified " + name;
  }
  return identity + "; patches of " + std::to_string(this->PatchTriangles) + ", " + std::to_string(this->LatticeBits) +
    " bits, normals " +
    (this->MakeNormals ? "made, feature angle " + std::to_string(this->FeatureAngle) + ", " +
          std::to_string(this->NormalBits) + " bits of normals"
                       : "not made") +
    (this->KeepFarOutliers ? ", far outliers kept" : "") + (this->ExactPoints ? ", exact" : "") + ", input ids " +
    std::to_string(this->InputIds) + (this->InputPointIds ? " and of points" : "") +
    (this->CertifyNormals ? ", normals certified" : "") + ", " + std::to_string(this->DirectLevels) +
    " direct levels; " + this->PartitionStrategy->GetSettings() + "; " + this->Simplifier->GetSettings();
}

int vtkMultiTriangulationBuilder::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

vtkTypeBool vtkMultiTriangulationBuilder::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputVector, outputVector);
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (!vtkMultiTriangulation::GetData(info))
  {
    const vtkNew<vtkMultiTriangulation> output;
    info->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

int vtkMultiTriangulationBuilder::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkMultiTriangulation* output = vtkMultiTriangulation::GetData(outputVector);
  vtkMTPolyDataStream stream(input);
  const auto store = std::make_shared<vtkMTPatchStore>();
  if (!this->Build(stream, *store))
  {
    output->Initialize();
    if (this->Aborted)
    {
      return 1; // what the user asked for is no error
    }
    vtkErrorMacro("No Multi-Triangulation was built: " << this->ErrorMessage << ".");
    return 0;
  }
  const bool filled = output->SetSource(store);
  vtkMultiTriangulation::WarnOfUse(this, outputVector);
  return filled ? 1 : 0;
}

int vtkMultiTriangulationBuilder::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::CheckUse(this, outputVector, port);
  return this->Superclass::ComputePipelineMTime(request, inputVector, outputVector, port, time);
}

void vtkMultiTriangulationBuilder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PatchTriangles: " << this->PatchTriangles << "\n";
  os << indent << "LatticeBits: " << this->LatticeBits << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "MakeNormals: " << (this->MakeNormals ? "on" : "off") << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "NormalBits: " << this->NormalBits << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "SpoolStore: " << (this->SpoolStore ? "given" : "in memory") << "\n";
  os << indent << "Resume: " << (this->Resume ? "on" : "off") << "\n";
  os << indent << "InputIdentity: " << this->InputIdentity << "\n";
  os << indent << "HasCheckpoint: " << (this->HasCheckpoint ? "yes" : "no") << "\n";
  os << indent << "KeepFarOutliers: " << (this->KeepFarOutliers ? "on" : "off") << "\n";
  os << indent << "ExactPoints: " << (this->ExactPoints ? "on" : "off") << "\n";
  os << indent << "InputIds: " << this->InputIds << "\n";
  os << indent << "InputPointIds: " << (this->InputPointIds ? "on" : "off") << "\n";
  os << indent << "DirectLevels: " << this->DirectLevels << "\n";
  os << indent << "CertifyNormals: " << (this->CertifyNormals ? "on" : "off") << "\n";
  for (const std::string& name : this->CertifiedArrays)
  {
    os << indent << "CertifiedArrayName: " << name << "\n";
  }
  for (const std::string& name : this->LabelArrays)
  {
    os << indent << "LabelArrayName: " << name << "\n";
  }
  for (const std::string& name : this->ValueArrays)
  {
    os << indent << "ValueArrayName: " << name << "\n";
  }
  os << indent << "PartitionStrategy: " << this->PartitionStrategy->GetSettings() << "\n";
  os << indent << "Simplifier: " << this->Simplifier->GetSettings() << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
