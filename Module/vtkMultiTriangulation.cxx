// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulation.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTAssembler.h"
#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTMeshToPolyData.h"
#include "vtkMTPatchSource.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <utility>

vtkStandardNewMacro(vtkMultiTriangulation);

//------------------------------------------------------------------------------
vtkMultiTriangulation::vtkMultiTriangulation() = default;

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
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulation::SetSource(std::shared_ptr<const vtkMTPatchSource> source)
{
  this->Initialize();
  if (!source)
  {
    return true;
  }
  std::string error;
  if (!vtkMultiTriangulation::CutToPolyData(*source, vtkMTCut(source->GetKnownGraph()), this, error))
  {
    this->Initialize();
    vtkErrorMacro("The coarsest patches of " << source->GetName() << " cannot be read: " << error);
    return false;
  }
  this->Source = std::move(source);
  this->SourcePoints = this->Points;
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
  const vtkMTGraph& graph = source.GetKnownGraph();
  vtkMTAssembler assembler(graph.Arrays);
  vtkMTPatch patch;
  for (std::uint32_t arc : cut.GetArcs())
  {
    if (!source.ReadPatch(arc, nullptr, patch, error))
    {
      return false;
    }
    if (!assembler.Add(patch))
    {
      error = "patch " + std::to_string(arc) + ": " + assembler.GetError();
      return false;
    }
  }
  if (!vtkMTMeshToPolyData::Convert(assembler.GetMesh(), graph.Lattice, graph.Arrays, output))
  {
    error = source.GetName() + ": the exact points are farther from the lattice than the model's largest shift";
    return false;
  }
  return true;
}
