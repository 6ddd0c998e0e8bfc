// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulation.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMTArrayInfo.h"
#include "vtkMTCut.h"
#include "vtkMTCutMesh.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPlacement.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
enum ConsumerType
{
  Unused = 1, // by some consumer
  Warned = 2
};

vtkInformationIntegerKey* GetUses()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("USES_PATCHES", "vtkMultiTriangulation");
  return key;
}

vtkInformationIntegerKey* GetConsumer()
{
  static vtkInformationIntegerKey* const key = vtkInformationIntegerKey::MakeKey("CONSUMER", "vtkMultiTriangulation");
  return key;
}

bool HoldsCoarsest(vtkMultiTriangulation* model)
{
  const std::shared_ptr<const vtkMTPatchSource> source = model ? model->GetSource() : nullptr;
  return source && model->GetNumberOfLevels() > 1 &&
    static_cast<std::uint64_t>(model->GetNumberOfCells()) == source->GetKnownGraph().GetNumberOfRootTriangles();
}
}

vtkStandardNewMacro(vtkMultiTriangulation);

//------------------------------------------------------------------------------
vtkMultiTriangulation::vtkMultiTriangulation()
  : Frame(vtkMTPlacement().Matrix)
{
}

//------------------------------------------------------------------------------
vtkMultiTriangulation::~vtkMultiTriangulation() = default;

//------------------------------------------------------------------------------
void vtkMultiTriangulation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto source = this->GetSource();
  os << indent << "Source: " << (source ? source->GetName() : std::string("(none)")) << "\n";
  os << indent << "NumberOfNodes: " << this->GetNumberOfNodes() << "\n";
  os << indent << "NumberOfPatches: " << this->GetNumberOfPatches() << "\n";
  os << indent << "NumberOfLevels: " << this->GetNumberOfLevels() << "\n";
  os << indent << "NumberOfFinestTriangles: " << this->GetNumberOfFinestTriangles() << "\n";
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::CopySource(vtkDataObject* from)
{
  vtkMultiTriangulation* other = vtkMultiTriangulation::SafeDownCast(from);
  this->Source = other ? other->GetSource() : nullptr;
  this->SourcePoints = this->Source ? this->Points : nullptr;
  this->Frame = this->Source ? other->Frame : vtkMTPlacement().Matrix;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::ShallowCopy(vtkDataObject* source)
{
  if (source != this)
  {
    this->Superclass::ShallowCopy(source);
    this->CopySource(source);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::DeepCopy(vtkDataObject* source)
{
  if (source != this)
  {
    this->Superclass::DeepCopy(source);
    this->CopySource(source);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::CopyStructure(vtkDataSet* source)
{
  if (source != this)
  {
    this->Superclass::CopyStructure(source);
    this->CopySource(source);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::Initialize()
{
  this->Superclass::Initialize();
  this->Source.reset();
  this->SourcePoints = nullptr;
  this->Frame = vtkMTPlacement().Matrix;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulation::SetSource(std::shared_ptr<const vtkMTPatchSource> source, double error)
{
  this->Initialize();
  if (!source)
  {
    return true;
  }
  const bool isChosen = error < std::numeric_limits<double>::infinity();
  const vtkMTGraph& graph = isChosen ? source->GetGraph() : source->GetKnownGraph();
  if (isChosen && !graph.IsWhole())
  {
    vtkErrorMacro(<< source->GetGraphError());
    return false;
  }
  vtkMTCut cut(graph);
  for (std::uint32_t node = 1; isChosen && node < graph.Nodes.size(); ++node)
  {
    if (graph.Nodes[node].Error > error)
    {
      cut.RefineWithDependencies(node);
    }
  }
  std::string reason;
  if (!vtkMultiTriangulation::CutToPolyData(*source, cut, this, reason))
  {
    this->Initialize();
    vtkErrorMacro("The patches of " << source->GetName() << " cannot be read: " << reason);
    return false;
  }
  vtkMTPlacement placement;
  placement.Matrix = graph.Frame.value_or(placement.Matrix);
  if (!vtkMTPlacement::IsSound(placement.Matrix.data()))
  {
    this->Initialize();
    vtkErrorMacro("The frame of " << source->GetName() << " is no affine map that has an inverse.");
    return false;
  }
  placement.Apply(this);
  this->Frame = placement.Matrix;
  this->Source = std::move(source);
  this->SourcePoints = this->Points;
  return true;
}

//------------------------------------------------------------------------------
// The arrays stay, with no tuples: what has no arrays at all cannot be told from a model without any.
void vtkMultiTriangulation::RemoveMesh()
{
  const std::shared_ptr<const vtkMTPatchSource> source = this->GetSource();
  const std::array<double, 16> frame = this->Frame;
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkPoints> points;
  points->SetDataType(this->Points ? this->Points->GetDataType() : VTK_FLOAT);
  empty->SetPoints(points);
  empty->GetPointData()->CopyAllocate(this->PointData);
  empty->GetCellData()->CopyAllocate(this->CellData);
  this->Superclass::ShallowCopy(empty);
  this->Source = source;
  this->SourcePoints = source ? this->Points : nullptr;
  this->Frame = source ? frame : vtkMTPlacement().Matrix;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulation::ApplyTransform(const double matrix[16])
{
  vtkMTPlacement step;
  std::copy(matrix, matrix + 16, step.Matrix.begin());
  vtkMTPlacement sum;
  sum.Matrix = this->Frame;
  sum.Append(matrix);
  if (!vtkMTPlacement::IsSound(matrix) || !vtkMTPlacement::IsSound(sum.Matrix.data()))
  {
    vtkErrorMacro("A matrix that is not finite and affine, or has no inverse, cannot place a Multi-Triangulation.");
    return false;
  }
  const std::shared_ptr<const vtkMTPatchSource> source = this->GetSource();
  step.Apply(this);
  this->Source = source;
  this->SourcePoints = source ? this->Points : nullptr;
  this->Frame = source ? sum.Matrix : vtkMTPlacement().Matrix;
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::GetFrame(double matrix[16]) const
{
  const vtkMTPlacement identity;
  const std::array<double, 16>& frame = this->GetSource() ? this->Frame : identity.Matrix;
  std::copy(frame.begin(), frame.end(), matrix);
}

//------------------------------------------------------------------------------
double vtkMultiTriangulation::GetStretch() const
{
  vtkMTPlacement placement;
  this->GetFrame(placement.Matrix.data());
  return placement.GetStretch();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::GetModelBounds(double bounds[6]) const
{
  const std::shared_ptr<const vtkMTPatchSource> source = this->GetSource();
  double box[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 }; // as vtkMath::UninitializeBounds
  if (source)
  {
    source->GetKnownGraph().GetBounds(box);
  }
  vtkMTPlacement placement;
  this->GetFrame(placement.Matrix.data());
  placement.ToObject(box, bounds);
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulation::GetArrayRange(const char* name, int association, int component, double range[2]) const
{
  const std::shared_ptr<const vtkMTPatchSource> source = this->GetSource();
  const int wanted = association == vtkDataObject::CELL ? vtkMTArrayInfo::Cell : vtkMTArrayInfo::Point;
  if (!source || !name || (association != vtkDataObject::POINT && association != vtkDataObject::CELL))
  {
    return false;
  }
  const vtkMTGraph& graph = source->GetKnownGraph();
  const auto found = std::find_if(graph.Arrays.begin(), graph.Arrays.end(),
    [&](const vtkMTArrayInfo& array) { return array.Name == name && array.Association == wanted; });
  const auto index = static_cast<std::size_t>(found - graph.Arrays.begin());
  if (index >= graph.ArrayRanges.size() || component < -1 || component >= found->Components)
  {
    return false;
  }
  const std::vector<vtkMTRange>& ranges = graph.ArrayRanges[index];
  double least = component < 0 ? 0.0 : ranges[component].Minimum;
  double largest = component < 0 ? 0.0 : ranges[component].Maximum;
  for (const vtkMTRange& each : ranges)
  {
    if (component < 0 && each.IsEmpty())
    {
      return false;
    }
    if (component < 0)
    {
      least = std::hypot(least, std::max({ each.Minimum, -each.Maximum, 0.0 }));
      largest = std::hypot(largest, std::max(std::abs(each.Minimum), std::abs(each.Maximum)));
    }
  }
  if (!(least <= largest))
  {
    return false;
  }
  range[0] = least;
  range[1] = largest;
  return true;
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkMTPatchSource> vtkMultiTriangulation::GetSource() const
{
  return this->SourcePoints == this->Points ? this->Source : nullptr;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulation::GetNumberOfNodes()
{
  const auto source = this->GetSource();
  return source ? static_cast<vtkIdType>(source->GetKnownGraph().Nodes.size()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulation::GetNumberOfPatches()
{
  const auto source = this->GetSource();
  return source ? static_cast<vtkIdType>(source->GetKnownGraph().Arcs.size()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulation::GetNumberOfLevels()
{
  const auto source = this->GetSource();
  return source ? static_cast<vtkIdType>(source->GetKnownGraph().GetNumberOfLevels()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkMultiTriangulation::GetNumberOfFinestTriangles()
{
  const auto source = this->GetSource();
  return source ? static_cast<vtkIdType>(source->GetKnownGraph().GetNumberOfFinestTriangles()) : 0;
}

//------------------------------------------------------------------------------
vtkMultiTriangulation* vtkMultiTriangulation::GetData(vtkInformation* info)
{
  return info ? vtkMultiTriangulation::SafeDownCast(info->Get(vtkDataObject::DATA_OBJECT())) : nullptr;
}

//------------------------------------------------------------------------------
vtkMultiTriangulation* vtkMultiTriangulation::GetData(vtkInformationVector* v, int i)
{
  return vtkMultiTriangulation::GetData(v->GetInformationObject(i));
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulation::CutToPolyData(
  const vtkMTPatchSource& source, const vtkMTCut& cut, vtkPolyData* output, std::string& error)
{
  vtkMTCutMesh mesh;
  mesh.Arcs = cut.GetArcs();
  return mesh.Make(source, output, error);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::AnnounceUse(vtkInformationVector** inputs)
{
  if (vtkInformation* info = inputs[0]->GetInformationObject(0))
  {
    info->Set(GetUses(), 1);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::CheckUse(vtkAlgorithm* producer, vtkInformationVector* outputs, int port)
{
  vtkInformation* info = port >= 0 ? outputs->GetInformationObject(port) : nullptr;
  if (!info)
  {
    return;
  }
  if (info->Has(GetUses()))
  {
    info->Remove(GetUses());
    return;
  }
  if (!info->Has(GetConsumer()))
  {
    info->Set(GetConsumer(), Unused);
  }
  vtkMultiTriangulation::WarnOfUse(producer, outputs);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulation::WarnOfUse(vtkAlgorithm* producer, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkMultiTriangulation* model = vtkMultiTriangulation::GetData(outputs);
  if (!info->Has(GetConsumer()) || info->Get(GetConsumer()) == Warned || !HoldsCoarsest(model))
  {
    return;
  }
  info->Set(GetConsumer(), Warned);
  vtkWarningWithObjectMacro(producer,
    "A filter that knows polydata alone works on the coarsest cut, of "
      << model->GetNumberOfCells() << " triangles, where the finest level has " << model->GetNumberOfFinestTriangles()
      << ". A vtkMultiTriangulationCutFilter before it gives it a finer one; so does "
         "vtkMultiTriangulationReader::SetOutputError.");
}
