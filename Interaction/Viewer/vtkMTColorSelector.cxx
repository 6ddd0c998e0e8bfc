// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTColorSelector.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkMTArrayInfo.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <algorithm>

namespace
{
using Mapper = vtkMultiTriangulationMapper;

const std::map<std::string, int>& GetCutColors()
{
  static const std::map<std::string, int> colors{ { "", Mapper::NONE }, { "level", Mapper::LEVEL },
    { "patch", Mapper::PATCH }, { "error", Mapper::ERROR_IN_PIXELS } };
  return colors;
}

vtkMultiTriangulation* GetModel(vtkMultiTriangulationMapper* mapper)
{
  auto* model = vtkMultiTriangulation::SafeDownCast(mapper->GetInput());
  return model && model->GetSource() ? model : nullptr;
}

// Of the model's arrays of that name the first one, of points before cells.
const vtkMTArrayInfo* FindInfo(vtkMultiTriangulation* model, const std::string& name)
{
  const vtkMTArrayInfo* found = nullptr;
  for (const vtkMTArrayInfo& info : model->GetSource()->GetKnownGraph().Arrays)
  {
    if (info.Name == name && (!found || (found->Association != info.Association && info.Association == 0)))
    {
      found = &info;
    }
  }
  return found;
}

int GetAssociation(const vtkMTArrayInfo& info)
{
  return info.Association == vtkMTArrayInfo::Point ? vtkDataObject::POINT : vtkDataObject::CELL;
}

vtkDataArray* FindCoarse(vtkMultiTriangulation* model, const vtkMTArrayInfo& info)
{
  return model->GetAttributes(GetAssociation(info))->GetArray(info.Name.c_str());
}

bool IsForPicking(const vtkMTArrayInfo& info)
{
  return info.Role == vtkMTArrayInfo::InputCellIds || info.Role == vtkMTArrayInfo::InputPointIds ||
    info.Role == vtkMTArrayInfo::ExactPoints;
}
}

vtkMTColorSelector::vtkMTColorSelector() = default;
vtkMTColorSelector::~vtkMTColorSelector() = default;

//------------------------------------------------------------------------------
void vtkMTColorSelector::SetRenderer(vtkRenderer* renderer)
{
  this->Renderer = renderer;
}

//------------------------------------------------------------------------------
std::vector<std::pair<vtkActor*, vtkMultiTriangulationMapper*>> vtkMTColorSelector::FindModels(vtkRenderer* renderer)
{
  std::vector<std::pair<vtkActor*, vtkMultiTriangulationMapper*>> models;
  vtkActorCollection* actors = renderer ? renderer->GetActors() : nullptr;
  for (int i = 0; actors && i < actors->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    auto* mapper = vtkMultiTriangulationMapper::SafeDownCast(actor->GetMapper());
    if (mapper && actor->GetVisibility() && GetModel(mapper))
    {
      models.emplace_back(actor, mapper);
    }
  }
  return models;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkMTColorSelector::GetNames() const
{
  std::vector<std::string> names;
  for (const auto association : { vtkMTArrayInfo::Point, vtkMTArrayInfo::Cell })
  {
    for (const auto& [actor, mapper] : FindModels(this->Renderer))
    {
      for (const vtkMTArrayInfo& info : GetModel(mapper)->GetSource()->GetKnownGraph().Arrays)
      {
        if (info.Association == association && !IsForPicking(info) &&
          std::find(names.begin(), names.end(), info.Name) == names.end())
        {
          names.push_back(info.Name);
        }
      }
    }
  }
  return names;
}

//------------------------------------------------------------------------------
std::string vtkMTColorSelector::DescribeNames() const
{
  std::string text = "level, patch, error";
  for (const std::string& name : this->GetNames())
  {
    text += ", " + name;
  }
  return text;
}

//------------------------------------------------------------------------------
bool vtkMTColorSelector::Select(const std::string& name)
{
  const auto models = FindModels(this->Renderer);
  const bool isThere = GetCutColors().count(name) > 0 ||
    std::any_of(models.begin(), models.end(),
      [&name](const auto& model) { return FindInfo(GetModel(model.second), name) != nullptr; });
  if (isThere)
  {
    this->Selected = name;
    this->Component = -1;
    this->Apply();
  }
  return isThere;
}

//------------------------------------------------------------------------------
void vtkMTColorSelector::SelectNext(int step)
{
  std::vector<std::string> names = this->GetNames();
  names.insert(names.begin(), ""); // the colours of the data
  const auto now = std::find(names.begin(), names.end(), this->Selected);
  const auto count = static_cast<std::ptrdiff_t>(names.size());
  const std::ptrdiff_t place = now == names.end() ? 0 : now - names.begin();
  this->Select(names[(place + step + count) % count]);
}

//------------------------------------------------------------------------------
int vtkMTColorSelector::GetNumberOfComponents() const
{
  int components = 0;
  for (const auto& [actor, mapper] : FindModels(this->Renderer))
  {
    const vtkMTArrayInfo* info = FindInfo(GetModel(mapper), this->Selected);
    components = std::max(components, info ? info->Components : 0);
  }
  return components;
}

//------------------------------------------------------------------------------
void vtkMTColorSelector::SelectNextComponent()
{
  const int components = this->GetNumberOfComponents();
  this->Component = components > 1 && this->Component + 1 < components ? this->Component + 1 : -1;
  this->Apply();
}

//------------------------------------------------------------------------------
void vtkMTColorSelector::SetShowTextures(bool on)
{
  this->ShowTextures = on;
  this->Apply();
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkMTColorSelector::FindRange() const
{
  vtkMTRange range;
  for (const auto& [actor, mapper] : FindModels(this->Renderer))
  {
    vtkMultiTriangulation* model = GetModel(mapper);
    const vtkMTArrayInfo* info = FindInfo(model, this->Selected);
    if (!info)
    {
      continue;
    }
    const int component = info->Components == 1 ? 0 : this->Component;
    double found[2] = { 1.0, 0.0 };
    vtkDataArray* coarse = FindCoarse(model, *info);
    if ((component < 0 || !model->GetArrayRange(info->Name.c_str(), GetAssociation(*info), component, found)) && coarse)
    {
      coarse->GetRange(found, component);
    }
    range.Add({ found[0], found[1] });
  }
  return range.IsEmpty() ? std::array<double, 2>{ 0.0, 1.0 } : std::array<double, 2>{ range.Minimum, range.Maximum };
}

//------------------------------------------------------------------------------
void vtkMTColorSelector::Apply()
{
  const bool isArray = GetCutColors().count(this->Selected) == 0;
  this->Table = nullptr;
  this->Named = nullptr;
  this->IsDirect = false;
  if (isArray)
  {
    const std::array<double, 2> range = this->FindRange();
    this->Table = vtkSmartPointer<vtkLookupTable>::New();
    this->Table->SetHueRange(0.667, 0.0); // blue is low
    this->Table->SetVectorMode(this->Component < 0 ? vtkScalarsToColors::MAGNITUDE : vtkScalarsToColors::COMPONENT);
    this->Table->SetVectorComponent(std::max(this->Component, 0));
    this->Table->SetTableRange(range[0], range[1]);
    this->Table->Build();
  }
  for (const auto& [actor, mapper] : FindModels(this->Renderer))
  {
    this->ApplyTo(actor, mapper);
  }
}

//------------------------------------------------------------------------------
void vtkMTColorSelector::ApplyTo(vtkActor* actor, vtkMultiTriangulationMapper* mapper)
{
  const auto cut = GetCutColors().find(this->Selected);
  mapper->SetColorBy(cut == GetCutColors().end() ? Mapper::NONE : cut->second);
  mapper->ScalarVisibilityOff();
  mapper->SetColorModeToDefault();
  this->HideTextures(actor->GetProperty());
  if (cut == GetCutColors().end())
  {
    this->ApplyArray(mapper);
  }
  else if (this->Selected.empty())
  {
    mapper->SelectColors(); // those of the mesh; other values only when they are asked for
    if (this->ShowTextures)
    {
      this->RestoreTextures(actor->GetProperty());
    }
  }
}

//------------------------------------------------------------------------------
void vtkMTColorSelector::ApplyArray(vtkMultiTriangulationMapper* mapper)
{
  vtkMultiTriangulation* model = GetModel(mapper);
  const vtkMTArrayInfo* info = FindInfo(model, this->Selected);
  if (!info)
  {
    return;
  }
  mapper->SetScalarMode(info->Association == vtkMTArrayInfo::Point ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
                                                                   : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SelectColorArray(info->Name.c_str());
  mapper->SetLookupTable(this->Table);
  mapper->SetScalarRange(this->Table->GetTableRange());
  mapper->ScalarVisibilityOn();
  if (this->Component >= 0)
  {
    mapper->SetColorModeToMapScalars();
  }
  vtkDataArray* coarse = FindCoarse(model, *info);
  vtkScalarsToColors* own = coarse ? coarse->GetLookupTable() : nullptr;
  if (own && own->GetIndexedLookup() && own->GetNumberOfAnnotatedValues() > 0)
  {
    this->Named = own; // which the mapper uses too
  }
  this->IsDirect = this->IsDirect || (this->Component < 0 && info->Components >= 3 && info->IsColor());
}

//------------------------------------------------------------------------------
void vtkMTColorSelector::HideTextures(vtkProperty* property)
{
  for (const auto& [name, texture] : property->GetAllTextures())
  {
    this->Hidden[property][name] = texture;
  }
  property->RemoveAllTextures();
}

//------------------------------------------------------------------------------
void vtkMTColorSelector::RestoreTextures(vtkProperty* property)
{
  for (const auto& [name, texture] : this->Hidden[property])
  {
    property->SetTexture(name.c_str(), texture);
  }
  this->Hidden.erase(property);
}

//------------------------------------------------------------------------------
vtkScalarsToColors* vtkMTColorSelector::GetTable() const
{
  return this->IsDirect ? nullptr : this->Named ? this->Named.Get() : this->Table.Get();
}

//------------------------------------------------------------------------------
std::string vtkMTColorSelector::GetTitle() const
{
  std::string title = this->Selected;
  for (const auto& [actor, mapper] : FindModels(this->Renderer))
  {
    const vtkMTArrayInfo* info = FindInfo(GetModel(mapper), this->Selected);
    if (!info || info->Components < 2)
    {
      continue;
    }
    const auto component = static_cast<std::size_t>(std::max(this->Component, 0));
    const bool hasName = component < info->ComponentNames.size() && !info->ComponentNames[component].empty();
    return title +
      (this->Component < 0 ? " magnitude"
                           : " " + (hasName ? info->ComponentNames[component] : std::to_string(this->Component)));
  }
  return title;
}
