// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationSection.h"

#include "Interpreter/vtkMTLongWork.h"
#include "vtkMTArraySelection.h"
#include "vtkMTCompatibility.h"
#include "vtkMTCutMesh.h"
#include "vtkMTFunctionSigns.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPlacedGraph.h"
#include "vtkMTRegionCut.h"
#include "vtkMTSectionLines.h"
#include "vtkMultiTriangulation.h"

#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMultiTriangulationSection);

namespace
{
constexpr double ReadingShare = 0.9; // of the progress

//------------------------------------------------------------------------------
bool CanBeZero(vtkImplicitFunction* function, const double box[6])
{
  const vtkMTFunctionSigns signs = vtkMTFunctionSigns::Find(function, box);
  return signs.CanBeNegative && signs.CanBePositive;
}

//------------------------------------------------------------------------------
// The arcs whose patches the section needs; ascending.
std::vector<std::uint32_t> FindArcs(const vtkMTPlacedGraph& placed, vtkImplicitFunction* function, double error)
{
  const vtkMTCut cut = vtkMTRegionCut::Find(*placed.Graph,
    [&](std::uint32_t arc)
    {
      double box[6];
      placed.GetReach(arc, box);
      return placed.GetError(arc) > error && CanBeZero(function, box) ? placed.GetError(arc) : -1.0;
    });
  std::vector<std::uint32_t> arcs = cut.GetArcs();
  const auto isMissed = [&](std::uint32_t arc)
  {
    double box[6];
    placed.GetBox(arc, box);
    return !CanBeZero(function, box);
  };
  arcs.erase(std::remove_if(arcs.begin(), arcs.end(), isMissed), arcs.end());
  return arcs;
}

//------------------------------------------------------------------------------
double GetLargestDistance(const vtkMTPlacedGraph& placed, const std::vector<std::uint32_t>& arcs)
{
  double largest = 0.0;
  for (const std::uint32_t arc : arcs)
  {
    largest = std::max(largest, placed.GetDistanceToInput(arc));
  }
  return largest;
}
}

//------------------------------------------------------------------------------
vtkMultiTriangulationSection::vtkMultiTriangulationSection()
{
  for (vtkSmartPointer<vtkDataArraySelection>& selection : this->Selections)
  {
    selection = vtkSmartPointer<vtkDataArraySelection>::New();
  }
}

//------------------------------------------------------------------------------
vtkMultiTriangulationSection::~vtkMultiTriangulationSection() = default;

//------------------------------------------------------------------------------
void vtkMultiTriangulationSection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImplicitFunction: " << this->ImplicitFunction.Get() << "\n";
  os << indent << "Error: " << this->Error << "\n";
  os << indent << "GenerateDistances: " << this->GenerateDistances << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "SectionError: " << this->SectionError << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationSection::SetImplicitFunction(vtkImplicitFunction* function)
{
  if (this->ImplicitFunction != function)
  {
    this->ImplicitFunction = function;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImplicitFunction* vtkMultiTriangulationSection::GetImplicitFunction()
{
  return this->ImplicitFunction;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationSection::SetError(double error)
{
  if (std::isnan(error))
  {
    vtkWarningMacro("Error stays " << this->Error << ": NaN is no error.");
    return;
  }
  const double clamped = std::clamp(error, 0.0, VTK_DOUBLE_MAX);
  if (this->Error != clamped)
  {
    this->Error = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkMultiTriangulationSection::GetPointArraySelection()
{
  return this->Selections[0];
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkMultiTriangulationSection::GetCellArraySelection()
{
  return this->Selections[1];
}

//------------------------------------------------------------------------------
vtkMTimeType vtkMultiTriangulationSection::GetMTime()
{
  const vtkMTimeType function = this->ImplicitFunction ? this->ImplicitFunction->GetMTime() : 0;
  return std::max(
    { this->Superclass::GetMTime(), function, this->Selections[0]->GetMTime(), this->Selections[1]->GetMTime() });
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationSection::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::AnnounceUse(inputVector);
  return this->Superclass::ComputePipelineMTime(request, inputVector, outputVector, port, time);
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationSection::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiTriangulation");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationSection::Fail(unsigned long code, const std::string& message)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< message);
  return 0;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationSection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkMTLongWork work;
  vtkMultiTriangulation* input = vtkMultiTriangulation::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  this->NumberOfPatches = 0;
  this->SectionError = 0.0;
  const std::shared_ptr<const vtkMTPatchSource> source = input ? input->GetSource() : nullptr;
  if (!source)
  {
    return this->Fail(vtkErrorCode::UnknownError, "the input has no patches, only the mesh that it holds itself");
  }
  if (!source->GetGraph().IsWhole())
  {
    return this->Fail(vtkErrorCode::FileFormatError, source->GetGraphError());
  }
  if (!this->ImplicitFunction)
  {
    return this->Fail(vtkErrorCode::UserError, "there is no implicit function");
  }
  const vtkMTPlacedGraph placed(*input);
  const auto progress = [this](double fraction)
  {
    this->UpdateProgress(fraction);
    return !vtkMTIsAborted(this);
  };
  vtkMTCutMesh patches;
  patches.Arcs = FindArcs(placed, this->ImplicitFunction, this->Error);
  patches.Placement = &placed.Placement;
  const std::vector<unsigned char> arrays =
    vtkMTArraySelection::Choose(placed.Graph->Arrays, this->Selections[0], this->Selections[1]);
  patches.Arrays = &arrays;
  patches.GenerateDistances = this->GenerateDistances;
  patches.Progress = [&](double fraction) { return progress(ReadingShare * fraction); };
  vtkNew<vtkPolyData> mesh;
  std::string error;
  if (!patches.Make(*source, mesh, error) && !error.empty())
  {
    return this->Fail(vtkErrorCode::FileFormatError, error);
  }
  vtkMTSectionLines lines;
  lines.Function = this->ImplicitFunction;
  lines.Arrays = &placed.Graph->Arrays;
  lines.Progress = [&](double fraction) { return progress(ReadingShare + (1.0 - ReadingShare) * fraction); };
  if (vtkMTIsAborted(this) || !lines.Make(mesh, output))
  {
    output->Initialize();
    this->SetErrorCode(vtkErrorCode::UserError);
    return 1; // what the user asked for is no error
  }
  this->NumberOfPatches = static_cast<vtkIdType>(patches.Arcs.size());
  this->SectionError = GetLargestDistance(placed, patches.Arcs);
  this->UpdateProgress(1.0);
  return 1;
}
