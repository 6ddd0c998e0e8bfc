// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationBuilder.h"

#include "vtkMTCompatibility.h"
#include "vtkMTEdgeCollapse.h"
#include "vtkMTInputMesh.h"
#include "vtkMTLevelLoop.h"
#include "vtkMTMemorySpool.h"
#include "vtkMTPatchStore.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMTVoronoiPartition.h"
#include "vtkMultiTriangulation.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkMultiTriangulationBuilder);

vtkMultiTriangulationBuilder::vtkMultiTriangulationBuilder()
  : PartitionStrategy(vtkSmartPointer<vtkMTVoronoiPartition>::New())
  , Simplifier(vtkSmartPointer<vtkMTEdgeCollapse>::New())
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

vtkMTimeType vtkMultiTriangulationBuilder::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->PartitionStrategy->GetMTime(), this->Simplifier->GetMTime() });
}

bool vtkMultiTriangulationBuilder::Build(vtkMTTriangleStream& input, vtkMTPatchSink& output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->ErrorMessage.clear();
  this->Aborted = false;
  this->UpdateProgress(0.0);
  bool built = false;
  try
  {
    built = this->BuildLevels(input, output);
  }
  catch (const std::exception& e)
  {
    this->ErrorMessage = std::string("out of memory or an internal fault: ") + e.what();
  }
  if (!built)
  {
    output.Abandon();
    this->SetErrorCode(this->Aborted ? vtkErrorCode::UserError : vtkErrorCode::UnknownError);
    return false;
  }
  this->UpdateProgress(1.0);
  return true;
}

bool vtkMultiTriangulationBuilder::BuildLevels(vtkMTTriangleStream& input, vtkMTPatchSink& output)
{
  vtkMTInputMesh mesh;
  if (!mesh.Read(input, this->LatticeBits, this->MakeNormals, this->ErrorMessage, this->KeepFarOutliers))
  {
    return false;
  }
  if (!mesh.Warning.empty())
  {
    vtkWarningMacro(<< mesh.Warning);
  }
  vtkMTLevelLoop::Settings settings;
  settings.PatchTriangles = static_cast<std::size_t>(this->PatchTriangles);
  settings.NumberOfThreads = this->NumberOfThreads;
  settings.Partition = this->PartitionStrategy;
  settings.Simplifier = this->Simplifier;
  settings.Progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !vtkMTIsAborted(this);
  };
  vtkMTMemorySpool fragments;
  vtkMTMemorySpool patches;
  vtkMTLevelLoop loop(settings, output, fragments, patches);
  if (!loop.Run(std::move(mesh)))
  {
    this->ErrorMessage = loop.GetError();
    this->Aborted = loop.WasAborted();
    return false;
  }
  return true;
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
  return output->SetSource(store) ? 1 : 0;
}

void vtkMultiTriangulationBuilder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PatchTriangles: " << this->PatchTriangles << "\n";
  os << indent << "LatticeBits: " << this->LatticeBits << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "MakeNormals: " << (this->MakeNormals ? "on" : "off") << "\n";
  os << indent << "KeepFarOutliers: " << (this->KeepFarOutliers ? "on" : "off") << "\n";
  os << indent << "PartitionStrategy: " << this->PartitionStrategy->GetSettings() << "\n";
  os << indent << "Simplifier: " << this->Simplifier->GetSettings() << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
