// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSelectionEncoder.h"

#include "vtkAbstractArray.h"
#include "vtkCompositeRepresentation.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkMultiTriangulationRepresentation.h"
#include "vtkObjectFactory.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataRepresentation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMRenderViewProxy.h"
#include "vtkSMSourceProxy.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkMTSelectionEncoder);

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkMTSelectionEncoder);

class EncoderFactory : public vtkObjectFactory
{
public:
  static EncoderFactory* New();
  vtkTypeMacro(EncoderFactory, vtkObjectFactory);
  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override { return "selections of Multi-Triangulations"; }

protected:
  EncoderFactory()
  {
    this->RegisterOverride("vtkPVEncodeSelectionForServer", "vtkMTSelectionEncoder",
      "selections of Multi-Triangulations", 1, vtkObjectFactoryCreatevtkMTSelectionEncoder);
  }
};
vtkStandardNewMacro(EncoderFactory);

// The library is loaded with the plugin, and stays.
const bool IsRegistered = []
{
  EncoderFactory* factory = EncoderFactory::New();
  vtkObjectFactory::RegisterFactory(factory);
  factory->Delete();
  return true;
}();

// The name where the data is in a server, and this process has the proxies only.
std::string FindInServer(vtkSMProxy* view, vtkMultiTriangulationRepresentation* representation, bool points)
{
  vtkSMPropertyHelper all(view, "Representations");
  for (unsigned int i = 0; i < all.GetNumberOfElements(); ++i)
  {
    vtkSMProxy* proxy = all.GetAsProxy(i);
    auto* shown = proxy ? vtkCompositeRepresentation::SafeDownCast(proxy->GetClientSideObject()) : nullptr;
    if (!shown || shown->GetActiveRepresentation() != representation)
    {
      continue;
    }
    vtkSMPropertyHelper input(proxy, "Input");
    auto* source = vtkSMSourceProxy::SafeDownCast(input.GetAsProxy());
    const std::string named = points ? representation->GetPointIdArray() : representation->GetCellIdArray();
    const std::string name = !named.empty() ? named : points ? "vtkMTInputPointIds" : "vtkMTInputCellIds";
    const int association = points ? vtkDataObject::POINT : vtkDataObject::CELL;
    const bool there = source && !name.empty() &&
      source->GetDataInformation(input.GetOutputPort())->GetArrayInformation(name.c_str(), association);
    return there ? name : std::string();
  }
  return {};
}

// Indices of what is drawn are ids already; only their meaning is told. The rank that drew them does not matter. False
// where they mean nothing.
bool NameIds(vtkSelectionNode* node, vtkSMProxy* view)
{
  vtkInformation* properties = node->GetProperties();
  vtkAbstractArray* ids = node->GetSelectionList();
  auto* representation = vtkMultiTriangulationRepresentation::SafeDownCast(properties->Get(vtkSelectionNode::SOURCE()));
  if (!representation || !ids || node->GetContentType() != vtkSelectionNode::INDICES)
  {
    return true;
  }
  const bool points = node->GetFieldType() == vtkSelectionNode::POINT;
  const bool here = representation->ShowsModel();
  const std::string name = here ? representation->GetIdArrayName(points ? vtkDataObject::POINT : vtkDataObject::CELL)
                                : FindInServer(view, representation, points);
  if (name.empty())
  {
    return !here; // data without patches is selected by its indices
  }
  node->SetContentType(vtkSelectionNode::VALUES);
  ids->SetName(name.c_str());
  properties->Remove(vtkSelectionNode::PROCESS_ID());
  return true;
}
}

//------------------------------------------------------------------------------
vtkMTSelectionEncoder::vtkMTSelectionEncoder() = default;

//------------------------------------------------------------------------------
vtkMTSelectionEncoder::~vtkMTSelectionEncoder() = default;

//------------------------------------------------------------------------------
void vtkMTSelectionEncoder::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Registered: " << IsRegistered << "\n";
}

//------------------------------------------------------------------------------
bool vtkMTSelectionEncoder::ProcessSelection(vtkSelection* rawSelection, vtkSMRenderViewProxy* viewProxy,
  bool multipleSelectionsAllowed, vtkCollection* selectedRepresentations, vtkCollection* selectionSources, int modifier,
  bool selectBlocks)
{
  std::vector<vtkSmartPointer<vtkSelectionNode>> meaningless;
  for (unsigned int i = 0; rawSelection && i < rawSelection->GetNumberOfNodes(); ++i)
  {
    if (!NameIds(rawSelection->GetNode(i), viewProxy))
    {
      meaningless.emplace_back(rawSelection->GetNode(i));
    }
  }
  bool warns = false;
  for (vtkSelectionNode* node : meaningless)
  {
    const bool points = node->GetFieldType() == vtkSelectionNode::POINT;
    auto* of =
      vtkMultiTriangulationRepresentation::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::SOURCE()));
    warns = !of || of->IsFirstWarning(points ? vtkDataObject::POINT : vtkDataObject::CELL) || warns;
    rawSelection->RemoveNode(node);
  }
  if (warns)
  {
    vtkWarningMacro("Nothing is selected: the model keeps no ids of what was to be selected. Name an array of it in "
                    "PointIdArray or CellIdArray of the representation, or build it with its input's ids.");
  }
  return this->Superclass::ProcessSelection(rawSelection, viewProxy, multipleSelectionsAllowed, selectedRepresentations,
    selectionSources, modifier, selectBlocks);
}
