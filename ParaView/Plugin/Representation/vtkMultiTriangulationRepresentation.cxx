// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationRepresentation.h"

#include "vtkAlgorithmOutput.h"
#include "vtkAppendPolyData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTArrayInfo.h"
#include "vtkMTGraph.h"
#include "vtkMTLODActor.h"
#include "vtkMTPatchSource.h"
#include "vtkMTRankBoxes.h"
#include "vtkMTReplica.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutlineSource.h"
#include "vtkPVGeometryFilter.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

vtkStandardNewMacro(vtkMultiTriangulationRepresentation);

namespace
{
// Any data that the mapper can draw.
vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataObject* geometry)
{
  if (auto* polydata = vtkPolyData::SafeDownCast(geometry))
  {
    return polydata;
  }
  vtkNew<vtkAppendPolyData> append;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(geometry))
  {
    vtkSmartPointer<vtkCompositeDataIterator> leaf;
    leaf.TakeReference(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      if (auto* polydata = vtkPolyData::SafeDownCast(leaf->GetCurrentDataObject()))
      {
        append->AddInputData(polydata);
      }
    }
  }
  if (append->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  append->Update();
  return append->GetOutput();
}

// Those that live in this process; ParaView makes and deletes them in one thread.
std::set<vtkMultiTriangulationRepresentation*>& GetRepresentations()
{
  static std::set<vtkMultiTriangulationRepresentation*> all;
  return all;
}

// What the finest level would take on a GPU, in KiB: 12 bytes of indices, and half a point of position and normal.
unsigned long GetSizeOf(vtkMultiTriangulation& model)
{
  return static_cast<unsigned long>(model.GetNumberOfFinestTriangles()) * 24 / 1024;
}
}

//------------------------------------------------------------------------------
vtkMultiTriangulationRepresentation::vtkMultiTriangulationRepresentation()
  : WaitForConvergence(vtkMultiTriangulationMapper::WAIT_WHEN_STILL)
{
  // One mapper draws both faces: what it has loaded serves both.
  this->Mapper->Delete();
  this->Mapper = vtkMultiTriangulationMapper::New();
  this->BackfaceMapper->Delete();
  this->BackfaceMapper = this->Mapper;
  this->BackfaceMapper->Register(this);
  this->Actor->Delete();
  this->Actor = vtkMTLODActor::New();
  this->BackfaceActor->Delete();
  this->BackfaceActor = vtkMTLODActor::New();
  this->SetupDefaults();
  GetRepresentations().insert(this);
}

//------------------------------------------------------------------------------
vtkMultiTriangulationRepresentation::~vtkMultiTriangulationRepresentation()
{
  GetRepresentations().erase(this);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Style: " << this->Style << "\n";
  os << indent << "PointIdArray: " << this->PointIdArray << "\n";
  os << indent << "CellIdArray: " << this->CellIdArray << "\n";
  os << indent << "Mapper:\n";
  this->Mapper->PrintSelf(os, indent.GetNextIndent());
}

//------------------------------------------------------------------------------
vtkMultiTriangulationMapper* vtkMultiTriangulationRepresentation::GetMultiTriangulationMapper()
{
  return static_cast<vtkMultiTriangulationMapper*>(this->Mapper);
}

//------------------------------------------------------------------------------
vtkMultiTriangulation* vtkMultiTriangulationRepresentation::GetModel()
{
  auto* model = vtkMultiTriangulation::SafeDownCast(this->Data);
  return model && model->GetSource() ? model : nullptr;
}

//------------------------------------------------------------------------------
vtkMultiTriangulationRepresentation* vtkMultiTriangulationRepresentation::FindShowing(vtkMultiTriangulation& model)
{
  const std::set<vtkMultiTriangulationRepresentation*>& all = GetRepresentations();
  const auto found = std::find_if(all.begin(), all.end(),
    [&model](vtkMultiTriangulationRepresentation* one)
    { return one->GetVisibility() && one->GetModel() && one->GetModel()->GetSource() == model.GetSource(); });
  return found == all.end() ? nullptr : *found;
}

//------------------------------------------------------------------------------
// The patches are compared: the mesh serves as long as the cut stays, so while the cursor moves over a still picture.
// Where this process draws a part of the cut, the rest may be another one after another search.
vtkPolyData* vtkMultiTriangulationRepresentation::GetDrawnMesh()
{
  vtkMultiTriangulationMapper* mapper = this->GetMultiTriangulationMapper();
  auto* drawn = vtkMultiTriangulation::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const bool part = this->SharesModel || this->Clips;
  std::vector<std::uint32_t> arcs = mapper->GetDrawnArcs();
  if (!this->GetModel() || !drawn || drawn->GetSource() != this->GetModel()->GetSource() || (arcs.empty() && !part))
  {
    return nullptr;
  }
  const vtkIdType search = part ? mapper->GetNumberOfCuts() : 0;
  if (!this->DrawnMesh || arcs != this->DrawnArcs || search != this->DrawnSearch)
  {
    this->DrawnArcs = std::move(arcs);
    this->DrawnSearch = search;
    this->DrawnMesh = vtkSmartPointer<vtkPolyData>::New();
    if (!mapper->GetCut(this->DrawnMesh, true)) // by whose ids what is selected is found again
    {
      this->DrawnMesh = nullptr;
    }
  }
  return this->DrawnMesh;
}

//------------------------------------------------------------------------------
vtkDataObject* vtkMultiTriangulationRepresentation::GetRenderedDataObject(int)
{
  return this->GetNumberOfInputConnections(0) > 0 ? this->Data.Get() : nullptr;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationRepresentation::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = inputVector[0]->GetNumberOfInformationObjects() == 1
    ? vtkDataObject::GetData(inputVector[0]->GetInformationObject(0))
    : nullptr;
  auto* model = vtkMultiTriangulation::SafeDownCast(input);
  if (model)
  {
    // ParaView compares time stamps and keeps what it got: a copy, as cheap as a handle.
    vtkNew<vtkMultiTriangulation> copy;
    copy->ShallowCopy(model);
    this->Data = copy;
  }
  else if (input)
  {
    this->GeometryFilter->SetInputConnection(this->GetInternalOutputPort());
    this->GeometryFilter->Modified();
    this->GeometryFilter->Update();
    vtkNew<vtkPolyData> copy;
    copy->ShallowCopy(MakeSurface(this->GeometryFilter->GetOutputDataObject(0)));
    this->Data = copy;
  }
  else
  {
    this->Data = vtkSmartPointer<vtkPolyData>::New();
  }
  return this->vtkPVDataRepresentation::RequestData( // NOLINT(bugprone-parent-virtual-call)
    request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
// Not the superclass's: it decimates, and hands all blocks to a mapper for blocks.
int vtkMultiTriangulationRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo)
{
  if (!this->vtkPVDataRepresentation::ProcessViewRequest( // NOLINT(bugprone-parent-virtual-call)
        request, inInfo, outInfo))
  {
    return 0;
  }
  if (request == vtkPVView::REQUEST_UPDATE())
  {
    this->RequestUpdate(inInfo, outInfo);
  }
  else if (request == vtkPVView::REQUEST_UPDATE_LOD())
  {
    this->RequestLod(inInfo);
  }
  else if (request == vtkPVView::REQUEST_RENDER())
  {
    this->RequestRender(inInfo);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::RequestUpdate(vtkInformation* inInfo, vtkInformation* outInfo)
{
  vtkMultiTriangulation* model = this->GetModel();
  double bounds[6];
  vtkMath::UninitializeBounds(bounds);
  if (model)
  {
    vtkPVView::SetPiece(inInfo, this, this->Data, GetSizeOf(*model));
    model->GetModelBounds(bounds);
  }
  else
  {
    vtkPVView::SetPiece(inInfo, this, this->Data);
    vtkGeometryRepresentation::GetBounds(this->Data, bounds, nullptr);
  }
  // All processes must say the same, and those without input do not know what it is.
  vtkPVRenderView::SetRequiresDistributedRendering(inInfo, this, true);
  vtkPVRenderView::SetRequiresDistributedRenderingLOD(inInfo, this, true);
  // A model cannot be moved to other ranks, but the ranks' places are to be found from something.
  const int movable = model ? 0 : vtkPVRenderView::DATA_IS_REDISTRIBUTABLE;
  vtkPVRenderView::SetOrderedCompositingConfiguration(
    inInfo, this, movable | vtkPVRenderView::USE_DATA_FOR_LOAD_BALANCING);
  this->CountReplicas();
  outInfo->Set(vtkPVRenderView::NEED_ORDERED_COMPOSITING(), this->NeedsOrderedCompositing() ? 1 : 0);

  vtkNew<vtkMatrix4x4> matrix;
  this->Actor->GetMatrix(matrix);
  vtkPVRenderView::SetGeometryBounds(inInfo, this, bounds, matrix);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::RequestLod(vtkInformation* inInfo)
{
  if (this->SuppressLOD)
  {
    return;
  }
  const bool knows = inInfo->Has(vtkPVRenderView::LOD_RESOLUTION()) != 0;
  const double resolution = knows ? inInfo->Get(vtkPVRenderView::LOD_RESOLUTION()) : 0.5;
  this->LodFactor = std::pow(16.0, 1.0 - std::clamp(resolution, 0.0, 1.0));
  vtkMultiTriangulation* model = this->GetModel();
  double bounds[6];
  vtkMath::UninitializeBounds(bounds);
  if (model)
  {
    model->GetModelBounds(bounds);
  }
  this->LodIsOutline = inInfo->Has(vtkPVRenderView::USE_OUTLINE_FOR_LOD()) && vtkMath::AreBoundsInitialized(bounds);
  if (!this->LodIsOutline)
  {
    vtkPVView::SetPieceLOD(inInfo, this, this->Data, 1);
    return;
  }
  vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(bounds);
  outline->Update();
  vtkPVView::SetPieceLOD(inInfo, this, outline->GetOutput());
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::RequestRender(vtkInformation* inInfo)
{
  // What is delivered has been made anew by its type, which is that of polydata, and so has no patches.
  vtkDataObject* data = this->GetModel() ? this->Data.Get() : vtkPVView::GetDeliveredPiece(inInfo, this);
  if (data != this->Mapper->GetInputDataObject(0, 0))
  {
    this->Mapper->SetInputDataObject(data);
  }
  const bool lod = !this->SuppressLOD && inInfo->Has(vtkPVRenderView::USE_LOD()) == 1;
  const bool outline = lod && this->LodIsOutline;
  if (outline)
  {
    this->LODMapper->SetInputDataObject(vtkPVView::GetDeliveredPieceLOD(inInfo, this));
  }
  this->Actor->SetEnableLOD(outline ? 1 : 0);
  this->GetMultiTriangulationMapper()->SetPixelError(lod ? this->LodFactor * this->PixelError : this->PixelError);
  this->SetShare();
  this->SetArrayIdNames(nullptr, nullptr);
  this->UpdateColoringParameters();
}

//------------------------------------------------------------------------------
// Ranks share a model where all of them have it and one has its mesh. Where each has its own, as from a builder, each
// draws what it has.
void vtkMultiTriangulationRepresentation::CountReplicas()
{
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  const int count = ranks ? ranks->GetNumberOfProcesses() : 1;
  this->SharesModel = false;
  if (count > 1)
  {
    const int own = vtkMTReplica::Is(this->Data) ? 1 : 0;
    int all = 0;
    ranks->AllReduce(&own, &all, 1, vtkCommunicator::SUM_OP);
    this->SharesModel = all == count - 1;
  }
}

//------------------------------------------------------------------------------
// A share is a set of patches where the nearest of all ranks' fragments is seen. Where the ranks' pictures are put over
// each other in an order, it is all that lies in the rank's box; and where no boxes say an order, the first rank draws.
void vtkMultiTriangulationRepresentation::SetShare()
{
  vtkMultiTriangulationMapper* mapper = this->GetMultiTriangulationMapper();
  vtkMultiProcessController* ranks = vtkMultiProcessController::GetGlobalController();
  const int rank = this->SharesModel ? ranks->GetLocalProcessId() : 0;
  const int count = this->SharesModel ? ranks->GetNumberOfProcesses() : 1;
  std::vector<vtkMTRankBoxes::Plane> planes;
  if (this->SharesModel && (this->NeedsOrderedCompositing() || vtkMTRankBoxes::AreOrdered(this->GetView())))
  {
    constexpr int most = 6; // of a mapper
    const std::vector<vtkBoundingBox> boxes = vtkMTRankBoxes::Get(this->GetView());
    const bool boxed = static_cast<int>(boxes.size()) == count && vtkMTRankBoxes::AreApart(boxes) &&
      vtkMTRankBoxes::GetMostPlanes(boxes) + (this->Clips ? 1 : 0) <= most;
    mapper->SetDrawnShare(boxed || rank == 0 ? 0 : 1, 1);
    planes = boxed ? vtkMTRankBoxes::GetPlanes(boxes, rank) : planes;
  }
  else
  {
    mapper->SetDrawnShare(rank, count);
  }
  if (planes != this->RankPlanes)
  {
    this->RankPlanes = std::move(planes);
    this->SetPlanes();
  }
  mapper->SetWaitForConvergence(
    this->SharesModel ? static_cast<int>(vtkMultiTriangulationMapper::WAIT_ALWAYS) : this->WaitForConvergence);
  mapper->SetDrawingRate(this->SharesModel ? 1e15 : this->DrawingRate);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetPlanes()
{
  vtkMultiTriangulationMapper* mapper = this->GetMultiTriangulationMapper();
  mapper->RemoveAllClippingPlanes();
  if (this->Clips)
  {
    mapper->AddClippingPlane(this->ClippingPlane);
  }
  for (vtkMTRankBoxes::Plane& values : this->RankPlanes)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(values.data());
    plane->SetNormal(values.data() + 3);
    mapper->AddClippingPlane(plane);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::UpdateColoringParameters()
{
  this->Representation = this->Style;
  this->Superclass::UpdateColoringParameters();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationRepresentation::SetArrayIdNames(const char* pointArray, const char* cellArray)
{
  const std::string points = this->GetIdArrayName(vtkDataObject::POINT);
  this->GetMultiTriangulationMapper()->SetPointIdArrayName(pointArray && *pointArray ? pointArray
      : points.empty()                                                               ? nullptr
                                                                                     : points.c_str());
  this->GetMultiTriangulationMapper()->SetCellIdArrayName(cellArray && *cellArray ? cellArray : nullptr);
}

//------------------------------------------------------------------------------
std::string vtkMultiTriangulationRepresentation::GetIdArrayName(int association)
{
  vtkMultiTriangulation* model = this->GetModel();
  if (!model)
  {
    return {};
  }
  const bool points = association == vtkDataObject::POINT;
  const vtkMTArrayInfo::RoleType role = points ? vtkMTArrayInfo::InputPointIds : vtkMTArrayInfo::InputCellIds;
  const std::string& named = points ? this->PointIdArray : this->CellIdArray;
  for (const vtkMTArrayInfo& array : model->GetSource()->GetKnownGraph().Arrays)
  {
    const bool associated = (array.Association == vtkMTArrayInfo::Point) == points;
    if (associated && (named.empty() ? array.Role == role : array.Name == named))
    {
      return array.Name;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationRepresentation::IsFirstWarning(int association)
{
  bool& has = this->HasWarned[association == vtkDataObject::POINT ? 0 : 1];
  const bool isFirst = !has;
  has = true;
  return isFirst;
}
