// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationCutFilter.h"

#include "Interpreter/vtkMTLongWork.h"
#include "vtkMTArraySelection.h"
#include "vtkMTCompatibility.h"
#include "vtkMTCut.h"
#include "vtkMTCutIds.h"
#include "vtkMTCutMesh.h"
#include "vtkMTFunctionSigns.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPlacedGraph.h"
#include "vtkMTRegionCut.h"
#include "vtkMTTargetCut.h"
#include "vtkMTView.h"
#include "vtkMultiTriangulation.h"

#include "vtkCamera.h"
#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkMultiTriangulationCutFilter);

// What the filter works on.
struct vtkMultiTriangulationCutFilter::Model
{
  vtkMTPlacedGraph Placed;
  vtkMTView View;
};

//------------------------------------------------------------------------------
vtkMultiTriangulationCutFilter::vtkMultiTriangulationCutFilter()
  : Error(VTK_DOUBLE_MAX)
  , OutsideError(VTK_DOUBLE_MAX)
{
  for (vtkSmartPointer<vtkDataArraySelection>& selection : this->Selections)
  {
    selection = vtkSmartPointer<vtkDataArraySelection>::New();
  }
}

//------------------------------------------------------------------------------
vtkMultiTriangulationCutFilter::~vtkMultiTriangulationCutFilter() = default;

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const modes[] = { "by error", "by triangles", "by level", "by view" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << modes[this->Mode] << "\n";
  os << indent << "Error: " << this->Error << "\n";
  os << indent << "TriangleLimit: " << this->TriangleLimit << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "Renderer: " << this->Renderer.Get() << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "PixelError: " << this->PixelError << "\n";
  os << indent << "Region: " << this->Region.Get() << "\n";
  os << indent << "OutsideError: " << this->OutsideError << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "GenerateDistances: " << this->GenerateDistances << "\n";
  os << indent << "FindInputIds: " << this->FindInputIds << "\n";
  os << indent << "CutError: " << this->CutError << "\n";
  os << indent << "DistanceToInput: " << this->DistanceToInput << "\n";
  os << indent << "DistanceFromInput: " << this->DistanceFromInput << "\n";
  os << indent << "Exact: " << this->Exact << "\n";
  os << indent << "FinestLevel: " << this->FinestLevel << "\n";
  os << indent << "CoarsestLevel: " << this->CoarsestLevel << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::Choose(int mode)
{
  this->Mode = mode;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::SetError(double error)
{
  if (std::isnan(error))
  {
    vtkWarningMacro("Error stays " << this->Error << ": NaN is no error.");
    return;
  }
  const double clamped = std::clamp(error, 0.0, VTK_DOUBLE_MAX);
  if (this->Error != clamped || this->Mode != BY_ERROR)
  {
    this->Error = clamped;
    this->Choose(BY_ERROR);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::SetTriangleLimit(vtkIdType limit)
{
  const vtkIdType clamped = std::max<vtkIdType>(limit, 0);
  if (this->TriangleLimit != clamped || this->Mode != BY_TRIANGLES)
  {
    this->TriangleLimit = clamped;
    this->Choose(BY_TRIANGLES);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::SetLevel(int level)
{
  const int clamped = std::max(level, 0);
  if (this->Level != clamped || this->Mode != BY_LEVEL)
  {
    this->Level = clamped;
    this->Choose(BY_LEVEL);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer || this->Camera || this->Mode != BY_VIEW)
  {
    this->Renderer = renderer;
    this->Camera = nullptr;
    this->Size = { 0, 0 };
    this->Choose(BY_VIEW);
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkMultiTriangulationCutFilter::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::SetView(vtkCamera* camera, int width, int height)
{
  const std::array<int, 2> size{ width, height };
  if (this->Camera != camera || this->Size != size || this->Renderer || this->Mode != BY_VIEW)
  {
    this->Renderer = nullptr;
    this->Camera = camera;
    this->Size = size;
    this->Choose(BY_VIEW);
  }
}

//------------------------------------------------------------------------------
vtkCamera* vtkMultiTriangulationCutFilter::GetCamera()
{
  return this->Camera;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::SetPixelError(double error)
{
  constexpr double largest = 1e9;
  if (std::isnan(error))
  {
    vtkWarningMacro("PixelError stays " << this->PixelError << ": NaN is no error.");
    return;
  }
  const double clamped = std::clamp(error, 0.0, largest);
  if (this->PixelError != clamped)
  {
    this->PixelError = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::SetRegion(vtkImplicitFunction* region)
{
  if (this->Region != region)
  {
    this->Region = region;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImplicitFunction* vtkMultiTriangulationCutFilter::GetRegion()
{
  return this->Region;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::SetOutsideError(double error)
{
  if (std::isnan(error))
  {
    vtkWarningMacro("OutsideError stays " << this->OutsideError << ": NaN is no error.");
    return;
  }
  const double clamped = std::clamp(error, 0.0, VTK_DOUBLE_MAX);
  if (this->OutsideError != clamped)
  {
    this->OutsideError = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkMultiTriangulationCutFilter::GetPointArraySelection()
{
  return this->Selections[0];
}

//------------------------------------------------------------------------------
vtkDataArraySelection* vtkMultiTriangulationCutFilter::GetCellArraySelection()
{
  return this->Selections[1];
}

//------------------------------------------------------------------------------
vtkMTimeType vtkMultiTriangulationCutFilter::GetMTime()
{
  vtkMTimeType time =
    std::max({ this->Superclass::GetMTime(), this->Selections[0]->GetMTime(), this->Selections[1]->GetMTime() });
  if (this->Region)
  {
    time = std::max(time, this->Region->GetMTime());
  }
  vtkCamera* camera = this->Camera;
  if (this->Mode == BY_VIEW && this->Renderer)
  {
    time = std::max(time, this->Renderer->GetMTime());
    vtkRenderWindow* window = this->Renderer->GetRenderWindow();
    time = window ? std::max(time, window->GetMTime()) : time;
    camera = this->Renderer->IsActiveCameraCreated() ? this->Renderer->GetActiveCamera() : nullptr;
  }
  return this->Mode == BY_VIEW && camera ? std::max(time, camera->GetMTime()) : time;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationCutFilter::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::AnnounceUse(inputVector);
  return this->Superclass::ComputePipelineMTime(request, inputVector, outputVector, port, time);
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationCutFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiTriangulation");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationCutFilter::Fail(unsigned long code, const std::string& message)
{
  this->ErrorMessage = message;
  this->SetErrorCode(code);
  vtkErrorMacro(<< message);
  return 0;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationCutFilter::FindView(Model& model)
{
  vtkCamera* camera = this->Renderer ? this->Renderer->GetActiveCamera() : this->Camera.Get();
  std::array<int, 2> size = this->Size;
  if (this->Renderer && this->Renderer->GetRenderWindow())
  {
    std::copy_n(this->Renderer->GetSize(), 2, size.begin());
  }
  if (!camera || size[0] <= 0 || size[1] <= 0)
  {
    this->ErrorMessage = !camera ? "a view was asked for, and there is no camera"
                                 : "the view has no size: give the renderer a window, or use SetView";
    return false;
  }
  const double aspect = this->Renderer ? this->Renderer->GetTiledAspectRatio() : static_cast<double>(size[0]) / size[1];
  std::array<double, 16> modelToEye;
  vtkMatrix4x4::Multiply4x4(
    camera->GetModelViewTransformMatrix()->GetData(), model.Placed.Placement.Matrix.data(), modelToEye.data());
  model.View = vtkMTView::FromProjection(
    modelToEye, camera->GetProjectionTransformMatrix(aspect, -1, 1)->GetData(), size, camera->GetClippingRange());
  return true;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationCutFilter::FindCut(const Model& model, vtkMTCut& cut)
{
  if (this->Region)
  {
    return this->FindRegionCut(model, cut);
  }
  const vtkMTGraph& graph = *model.Placed.Graph;
  vtkMTTargetCut target;
  switch (this->Mode)
  {
    case BY_TRIANGLES:
      return target.ByTriangles(graph, static_cast<std::uint64_t>(this->TriangleLimit), cut, this->ErrorMessage);
    case BY_LEVEL:
      return vtkMTTargetCut::ByLevel(graph, static_cast<std::uint32_t>(this->Level), cut, this->ErrorMessage);
    case BY_VIEW:
    {
      vtkMTTargetCut::Input input;
      input.Graph = &graph;
      input.Views = { model.View };
      vtkMTTargetCut::Settings settings;
      settings.PixelError = this->PixelError;
      cut = target.Extract(input, settings).Cut;
      return true;
    }
    default:
      return target.ByError(graph, this->Error / model.Placed.Stretch, cut, this->ErrorMessage);
  }
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationCutFilter::FindRegionCut(const Model& model, vtkMTCut& cut)
{
  const vtkMTPlacedGraph& placed = model.Placed;
  const vtkMTGraph& graph = *placed.Graph;
  const auto isInside = [&](std::uint32_t arc)
  {
    double box[6];
    placed.GetReach(arc, box);
    return vtkMTFunctionSigns::Find(this->Region, box).CanBeNegative;
  };
  const auto isFine = [&](std::uint32_t arc)
  {
    switch (this->Mode)
    {
      case BY_TRIANGLES:
        return false;
      case BY_LEVEL:
        return graph.GetLevelOfArc(arc) <= static_cast<std::uint32_t>(this->Level);
      case BY_VIEW:
        return !placed.CanBeSeen(model.View, arc) ||
          vtkMTTargetCut::GetPixelError(graph, model.View, arc, vtkMTTargetCut::Distance) <= this->PixelError;
      default:
        return placed.GetError(arc) <= this->Error;
    }
  };
  const std::uint64_t limit = this->Mode == BY_TRIANGLES ? static_cast<std::uint64_t>(this->TriangleLimit) : 0;
  if (this->Mode == BY_TRIANGLES && limit < graph.GetNumberOfRootTriangles())
  {
    vtkMTTargetCut target;
    return target.ByTriangles(graph, limit, cut, this->ErrorMessage); // which says why not
  }
  if (this->Mode == BY_LEVEL && static_cast<std::uint32_t>(this->Level) >= graph.GetNumberOfLevels())
  {
    return vtkMTTargetCut::ByLevel(graph, static_cast<std::uint32_t>(this->Level), cut, this->ErrorMessage);
  }
  cut = vtkMTRegionCut::Find(
    graph,
    [&](std::uint32_t arc)
    {
      const double error = placed.GetError(arc);
      return error > this->OutsideError || (!isFine(arc) && isInside(arc)) ? error : -1.0;
    },
    limit);
  for (const std::uint32_t arc : cut.GetArcs())
  {
    if (this->Mode == BY_ERROR && !isFine(arc) && isInside(arc))
    {
      std::ostringstream text;
      text << "the finest level has an error of " << placed.GetError(arc) << ", more than the " << this->Error
           << " asked for";
      this->ErrorMessage = text.str();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationCutFilter::Describe(const Model& model, const vtkMTCut& cut)
{
  const vtkMTGraph& graph = *model.Placed.Graph;
  const std::vector<std::uint32_t> arcs = cut.GetArcs();
  this->NumberOfPatches = static_cast<vtkIdType>(arcs.size());
  this->NumberOfTriangles = static_cast<vtkIdType>(cut.GetNumberOfTriangles());
  this->CoarsestLevel = 0;
  this->FinestLevel = arcs.empty() ? 0 : VTK_INT_MAX;
  for (const std::uint32_t arc : arcs)
  {
    this->FinestLevel = std::min(this->FinestLevel, static_cast<int>(graph.GetLevelOfArc(arc)));
    this->CoarsestLevel = std::max(this->CoarsestLevel, static_cast<int>(graph.GetLevelOfArc(arc)));
  }
  // The input's own coordinates have no error.
  this->Exact = this->CoarsestLevel == 0 &&
    std::any_of(graph.Arrays.begin(), graph.Arrays.end(),
      [](const vtkMTArrayInfo& array) { return array.Role == vtkMTArrayInfo::ExactPoints; });
  this->DistanceToInput = this->Exact ? 0.0 : cut.GetDistanceToInput() * model.Placed.Stretch;
  this->DistanceFromInput = this->Exact ? 0.0 : cut.GetDistanceFromInput() * model.Placed.Stretch;
  this->CutError = std::max(this->DistanceToInput, this->DistanceFromInput);
}

//------------------------------------------------------------------------------
// The second half of the work.
static bool FillIds(const vtkMTPatchSource& source, const vtkMTCutMesh& mesh, vtkPolyData* output, std::string& error)
{
  const auto progress = [&mesh](double fraction) { return mesh.Progress(1.0 + fraction); };
  return vtkMTCutIds::Fill(source, mesh.Arcs, mesh.Placement, output, progress, error);
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationCutFilter::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkMTLongWork work;
  vtkMultiTriangulation* input = vtkMultiTriangulation::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  this->ErrorMessage.clear();
  this->NumberOfTriangles = this->NumberOfPatches = 0;
  this->CutError = this->DistanceToInput = this->DistanceFromInput = 0.0;
  this->Exact = false;
  this->FinestLevel = this->CoarsestLevel = 0;
  const std::shared_ptr<const vtkMTPatchSource> source = input ? input->GetSource() : nullptr;
  if (!source)
  {
    return this->Fail(vtkErrorCode::UnknownError, "the input has no patches, only the mesh that it holds itself");
  }
  if (!source->GetGraph().IsWhole())
  {
    return this->Fail(vtkErrorCode::FileFormatError, source->GetGraphError());
  }
  Model model;
  model.Placed = vtkMTPlacedGraph(*input);
  vtkMTCut cut(*model.Placed.Graph);
  if ((this->Mode == BY_VIEW && !this->FindView(model)) || !this->FindCut(model, cut))
  {
    return this->Fail(vtkErrorCode::UserError, this->ErrorMessage);
  }
  vtkMTCutMesh mesh;
  mesh.Arcs = cut.GetArcs();
  mesh.Placement = &model.Placed.Placement;
  const std::vector<unsigned char> arrays =
    vtkMTArraySelection::Choose(model.Placed.Graph->Arrays, this->Selections[0], this->Selections[1]);
  mesh.Arrays = &arrays;
  mesh.GenerateDistances = this->GenerateDistances;
  mesh.Progress = [this](double fraction)
  {
    this->UpdateProgress(this->FindInputIds ? 0.5 * fraction : fraction);
    return !vtkMTIsAborted(this);
  };
  std::string error;
  if (!mesh.Make(*source, output, error) || (this->FindInputIds && !FillIds(*source, mesh, output, error)))
  {
    output->Initialize();
    if (!error.empty())
    {
      return this->Fail(vtkErrorCode::FileFormatError, error);
    }
    this->ErrorMessage = "aborted";
    this->SetErrorCode(vtkErrorCode::UserError);
    return 1; // what the user asked for is no error
  }
  this->Describe(model, cut);
  this->UpdateProgress(1.0);
  return 1;
}
