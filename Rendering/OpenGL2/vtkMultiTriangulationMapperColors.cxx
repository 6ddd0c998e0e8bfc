// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: how scalars, colours of the data and places become colours of patches.
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMTColorArray.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkOpenGLTexture.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace
{
// A table whose entries are those of single values, as ids of groups and materials have.
bool HasNamedValues(vtkScalarsToColors* table)
{
  return table && table->GetIndexedLookup() && table->GetNumberOfAnnotatedValues() > 0;
}

int GetAssociation(const vtkMTArrayInfo& info)
{
  return info.Association == vtkMTArrayInfo::Point ? vtkDataObject::POINT : vtkDataObject::CELL;
}

vtkDataArray* FindOnCoarsestCut(vtkPolyData* input, const vtkMTArrayInfo& info)
{
  return input->GetAttributes(GetAssociation(info))->GetArray(info.Name.c_str());
}

// Of a component in the whole model, as far as that is known.
std::array<double, 2> GetRange(vtkPolyData* input, const vtkMTArrayInfo& info, int component)
{
  std::array<double, 2> range{ 0.0, 0.0 };
  auto* model = vtkMultiTriangulation::SafeDownCast(input);
  vtkDataArray* coarse = FindOnCoarsestCut(input, info);
  if (!model->GetArrayRange(info.Name.c_str(), GetAssociation(info), component, range.data()) && coarse)
  {
    coarse->GetRange(range.data(), component);
  }
  return range;
}
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::ShowsCut() const
{
  return this->ColorBy != NONE && this->ColorBy != ELEVATION;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::SetColorByElevation(
  const double lowPoint[3], const double highPoint[3], const double range[2])
{
  const auto isFinite = [](const double* values, int count)
  { return std::all_of(values, values + count, [](double value) { return std::isfinite(value); }); };
  if (!isFinite(lowPoint, 3) || !isFinite(highPoint, 3) || !isFinite(range, 2) ||
    std::equal(lowPoint, lowPoint + 3, highPoint))
  {
    vtkErrorMacro("SetColorByElevation: two different points and a range, all of them finite, are needed.");
    return;
  }
  std::copy(lowPoint, lowPoint + 3, this->ElevationLowPoint);
  std::copy(highPoint, highPoint + 3, this->ElevationHighPoint);
  std::copy(range, range + 2, this->ElevationRange);
  this->SetScalarRange(range);
  this->ColorBy = ELEVATION;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::SelectColors()
{
  auto* model = vtkMultiTriangulation::SafeDownCast(this->GetInput());
  const std::shared_ptr<const vtkMTPatchSource> source = model ? model->GetSource() : nullptr;
  if (!source)
  {
    return false;
  }
  const vtkMTGraph& graph = source->GetKnownGraph();
  int array = vtkMTColorArray::Find(graph);
  const int materials = vtkMTPatchAttributes::FindArray(graph, "MaterialIds", vtkMTArrayInfo::Cell);
  if (array < 0 && materials >= 0)
  {
    vtkDataArray* ids = FindOnCoarsestCut(model, graph.Arrays[materials]);
    array = ids && HasNamedValues(ids->GetLookupTable()) ? materials : -1;
  }
  if (array < 0)
  {
    return false;
  }
  const vtkMTArrayInfo& info = graph.Arrays[array];
  this->SetScalarMode(info.Association == vtkMTArrayInfo::Point ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
                                                                : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  this->SelectColorArray(info.Name.c_str());
  this->ScalarVisibilityOn();
  return true;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ForgetColors()
{
  if (this->Colors)
  {
    this->Colors->UnRegister(this);
    this->Colors = nullptr;
  }
  if (this->ColorCoordinates)
  {
    this->ColorCoordinates->UnRegister(this);
    this->ColorCoordinates = nullptr;
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::PlanColors()
{
  Internals& self = *this->Implementation;
  vtkMTPatchStreams::Plan& plan = self.Plan;
  plan.Coloring = vtkMTPatchStreams::NoColors;
  plan.Scalars = -1;
  self.Conversion = Internals::Mapped;
  if (this->ColorBy == ELEVATION)
  {
    this->PlanElevation();
  }
  else if (this->ColorBy == NONE && this->ScalarVisibility)
  {
    this->PlanScalars();
  }
  if (plan.Coloring == vtkMTPatchStreams::PointCoordinates)
  {
    if (!this->InternalColorTexture)
    {
      this->InternalColorTexture = vtkOpenGLTexture::New();
      this->InternalColorTexture->RepeatOff();
    }
    this->InternalColorTexture->SetInputData(this->ColorTextureMap);
    return;
  }
  this->ForgetColors();
  if (this->ColorTextureMap)
  {
    this->ColorTextureMap->UnRegister(this);
    this->ColorTextureMap = nullptr;
  }
}

//------------------------------------------------------------------------------
// The array of the graph that gives colours, or -1. cellFlag: VTK's; 2 means the input's field data.
int vtkMultiTriangulationMapper::FindScalars(const vtkMTGraph& graph, int& cellFlag)
{
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(
    this->GetInput(), this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
  if (!scalars && this->ScalarMode == VTK_SCALAR_MODE_DEFAULT)
  {
    return vtkMTColorArray::Find(graph);
  }
  return scalars && scalars->GetName() && cellFlag < 2 ? vtkMTPatchAttributes::FindArray(graph, scalars->GetName(),
                                                           cellFlag == 0 ? vtkMTArrayInfo::Point : vtkMTArrayInfo::Cell)
                                                       : -1;
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::IsDirect(const vtkMTArrayInfo& info) const
{
  return this->ColorMode != VTK_COLOR_MODE_MAP_SCALARS && vtkMTColorArray::IsColors(info);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::PlanScalars()
{
  Internals& self = *this->Implementation;
  vtkMTPatchStreams::Plan& plan = self.Plan;
  const vtkMTGraph& graph = self.Graph();
  int cellFlag = 0;
  plan.Scalars = this->FindScalars(graph, cellFlag);
  if (cellFlag == 2)
  {
    this->PlanFieldColor();
  }
  if (plan.Scalars < 0)
  {
    return;
  }
  const vtkMTArrayInfo& info = graph.Arrays[plan.Scalars];
  const auto kind =
    info.Association == vtkMTArrayInfo::Point ? vtkMTPatchStreams::PointColors : vtkMTPatchStreams::CellColors;
  plan.Coloring = kind;
  if (this->IsDirect(info))
  {
    self.Conversion = Internals::Direct;
    self.FullColor = this->GetFullColor(info);
    this->ForgetColors();
    if (!this->LookupTable)
    {
      this->CreateDefaultLookupTable();
    }
    return;
  }
  vtkDataArray* scalars = FindOnCoarsestCut(this->GetInput(), info);
  self.Conversion = scalars && HasNamedValues(scalars->GetLookupTable()) ? Internals::Named : Internals::Mapped;
  // On the coarsest cut: this sets up table and range, and decides between colours and a texture, as VTK does.
  this->ForgetColors();
  const int mode = std::exchange(this->ColorMode, this->GetMappingMode());
  this->MapScalars(1.0);
  this->ColorMode = mode;
  plan.Coloring = this->ColorTextureMap ? vtkMTPatchStreams::PointCoordinates : kind;
}

//------------------------------------------------------------------------------
// Elevations, and values that have names and colours of their own, are looked up also where VTK would not.
int vtkMultiTriangulationMapper::GetMappingMode() const
{
  const auto conversion = this->Implementation->Conversion;
  const bool isLookedUp = conversion == Internals::Named || conversion == Internals::ByPlace;
  return isLookedUp ? VTK_COLOR_MODE_MAP_SCALARS : this->ColorMode;
}

//------------------------------------------------------------------------------
// Of the model's range, so that all patches are converted alike.
double vtkMultiTriangulationMapper::GetFullColor(const vtkMTArrayInfo& info)
{
  double largest = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    largest = std::max(largest, GetRange(this->GetInput(), info, c)[1]);
  }
  return vtkMTColorArray::GetFullValue(info.Type, largest);
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::HasTranslucentColors()
{
  const vtkMTGraph& graph = vtkMultiTriangulation::SafeDownCast(this->GetInput())->GetSource()->GetKnownGraph();
  int cellFlag = 0;
  const int array = this->FindScalars(graph, cellFlag);
  if (array < 0)
  {
    return false;
  }
  const vtkMTArrayInfo& info = graph.Arrays[array];
  if (this->IsDirect(info))
  {
    return info.Components == 4 && GetRange(this->GetInput(), info, 3)[0] < this->GetFullColor(info);
  }
  vtkDataArray* scalars = FindOnCoarsestCut(this->GetInput(), info);
  vtkScalarsToColors* table = scalars ? scalars->GetLookupTable() : nullptr;
  return HasNamedValues(table) && !table->IsOpaque();
}

//------------------------------------------------------------------------------
bool vtkMultiTriangulationMapper::HasTranslucentPolygonalGeometry()
{
  if (!this->HasPatches())
  {
    return this->Superclass::HasTranslucentPolygonalGeometry();
  }
  if (this->ColorBy == ELEVATION)
  {
    return this->LookupTable && !this->LookupTable->IsOpaque();
  }
  return this->ColorBy == NONE &&
    ((this->ScalarVisibility && this->HasTranslucentColors()) || this->Superclass::HasTranslucentPolygonalGeometry());
}

//------------------------------------------------------------------------------
// VTK makes table and texture for an array of the input: here for one of a point.
void vtkMultiTriangulationMapper::PlanElevation()
{
  Internals& self = *this->Implementation;
  vtkNew<vtkFloatArray> scalars;
  scalars->InsertNextValue(static_cast<float>(this->ElevationRange[0]));
  vtkNew<vtkPolyData> one;
  one->SetPoints(self.Template->GetPoints());
  one->GetPointData()->SetScalars(scalars);
  this->ForgetColors();
  self.Conversion = Internals::ByPlace;
  const int mode = std::exchange(this->ScalarMode, VTK_SCALAR_MODE_USE_POINT_DATA);
  const int colorMode = std::exchange(this->ColorMode, this->GetMappingMode());
  const auto isVisible = std::exchange(this->ScalarVisibility, 1);
  this->MapScalars(one, 1.0);
  this->ScalarMode = mode;
  this->ColorMode = colorMode;
  this->ScalarVisibility = isVisible;
  self.Plan.Coloring = this->ColorTextureMap ? vtkMTPatchStreams::PointCoordinates : vtkMTPatchStreams::PointColors;
}

//------------------------------------------------------------------------------
// A tuple of an array in the input's field data colours everything.
void vtkMultiTriangulationMapper::PlanFieldColor()
{
  this->ForgetColors();
  this->MapScalars(1.0);
  if (this->Colors && this->FieldDataTupleId >= 0 && this->FieldDataTupleId < this->Colors->GetNumberOfTuples())
  {
    this->Colors->GetTypedTuple(this->FieldDataTupleId, this->Implementation->FieldColor.data());
    this->Implementation->Plan.Coloring = vtkMTPatchStreams::OneColor;
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateColorRevision()
{
  Internals& self = *this->Implementation;
  vtkStateStorage& state = self.NewColorState;
  state.Clear();
  state.Append(self.Plan.Coloring, "coloring");
  state.Append(self.Plan.Scalars, "array");
  state.Append(self.Conversion, "conversion");
  state.Append(this->ArrayComponent, "component");
  state.Append(this->ColorMode, "color mode");
  state.Append(this->LookupTable, "table");
  state.Append(this->LookupTable ? this->LookupTable->GetMTime() : 0, "table mtime");
  if (self.Conversion == Internals::ByPlace)
  {
    state.Append(self.Placement.Matrix, "frame");
    state.Append(this->ElevationRange, "elevations");
    state.Append(this->ElevationLowPoint, "low point");
    state.Append(this->ElevationHighPoint, "high point");
  }
  if (self.ColorState != self.NewColorState)
  {
    self.ColorState = self.NewColorState;
    ++self.Plan.ColorRevision;
  }
}

//------------------------------------------------------------------------------
// As vtkElevationFilter computes them, in the coordinates of the input.
vtkSmartPointer<vtkDataArray> vtkMultiTriangulationMapper::GetElevations(const vtkMTPatch& patch)
{
  const Internals& self = *this->Implementation;
  double way[3];
  double square = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    way[i] = this->ElevationHighPoint[i] - this->ElevationLowPoint[i];
    square += way[i] * way[i];
  }
  const auto wedges = static_cast<vtkIdType>(patch.GetNumberOfWedges());
  auto elevations = vtkSmartPointer<vtkFloatArray>::New();
  elevations->SetNumberOfValues(wedges);
  for (vtkIdType wedge = 0; wedge < wedges; ++wedge)
  {
    const vtkMTPoint& point = patch.Points[patch.GetPointOfWedge(static_cast<std::uint32_t>(wedge))];
    const std::array<double, 3> place = self.Placement.ToObject(self.Graph().Lattice.ToWorld(point));
    double share = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      share += (place[i] - this->ElevationLowPoint[i]) * way[i] / square;
    }
    elevations->SetValue(wedge,
      static_cast<float>(
        this->ElevationRange[0] + std::clamp(share, 0.0, 1.0) * (this->ElevationRange[1] - this->ElevationRange[0])));
  }
  return elevations;
}

//------------------------------------------------------------------------------
// What is mapped to colours: values of the array, or bytes where they are colours.
vtkSmartPointer<vtkDataArray> vtkMultiTriangulationMapper::GetPatchScalars(int array, const vtkMTPatch& patch)
{
  const Internals& self = *this->Implementation;
  if (self.Conversion == Internals::ByPlace)
  {
    return this->GetElevations(patch);
  }
  const auto values = vtkMTPatchAttributes::GetArray(self.Graph(), array, patch);
  if (self.Conversion == Internals::Direct)
  {
    return vtkMTColorArray::ToBytes(values, self.FullColor);
  }
  return values;
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::MapPatchScalars(int array, const vtkMTPatch& patch, std::vector<unsigned char>& bytes)
{
  const vtkMTPatchStreams::Plan& plan = this->Implementation->Plan;
  const vtkSmartPointer<vtkDataArray> scalars = this->GetPatchScalars(array, patch);
  // Both are kept from the patch before, whose values these are not.
  this->ForgetColors();
  if (plan.Coloring == vtkMTPatchStreams::PointCoordinates)
  {
    this->MapScalarsToTexture(scalars, 1.0);
    const auto* values = reinterpret_cast<const unsigned char*>(this->ColorCoordinates->GetPointer(0));
    bytes.assign(values, values + sizeof(float) * 2 * static_cast<std::size_t>(scalars->GetNumberOfTuples()));
    return;
  }
  const double alpha = this->LookupTable->GetAlpha();
  this->LookupTable->SetAlpha(1.0);
  const auto colors = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    this->LookupTable->MapScalars(scalars, this->GetMappingMode(), this->ArrayComponent));
  this->LookupTable->SetAlpha(alpha);
  bytes = vtkMTPatchAttributes::GetColors(
    colors, plan.Coloring == vtkMTPatchStreams::CellColors ? plan.PrimitivesPerTriangle : 1);
}
