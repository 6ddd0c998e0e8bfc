// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: which data the shader needs, and how scalars become colours.
#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLTexture.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

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
  vtkMTPatchStreams::Plan& plan = this->Implementation->Plan;
  plan.Coloring = vtkMTPatchStreams::NoColors;
  plan.Scalars = -1;
  if (this->ColorBy == NONE && this->ScalarVisibility)
  {
    int cellFlag = 0;
    vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(
      this->GetInput(), this->ScalarMode, this->ArrayAccessMode, this->ArrayId, this->ArrayName, cellFlag);
    if (cellFlag == 2)
    {
      this->PlanFieldColor();
    }
    if (scalars && scalars->GetName() && cellFlag < 2)
    {
      plan.Scalars = vtkMTPatchAttributes::FindArray(this->Implementation->Graph(), scalars->GetName(),
        cellFlag == 0 ? vtkMTArrayInfo::Point : vtkMTArrayInfo::Cell);
    }
    if (plan.Scalars >= 0)
    {
      // On the coarsest cut: this sets up table and range, and decides between colours and a texture, as VTK does.
      this->ForgetColors();
      this->MapScalars(1.0);
      plan.Coloring = this->ColorTextureMap ? vtkMTPatchStreams::PointCoordinates
        : cellFlag == 0                     ? vtkMTPatchStreams::PointColors
                                            : vtkMTPatchStreams::CellColors;
    }
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
void vtkMultiTriangulationMapper::PlanAttributes(vtkActor* actor)
{
  const vtkMTGraph& graph = this->Implementation->Graph();
  vtkMTPatchStreams::Plan& plan = this->Implementation->Plan;
  plan.Attributes.clear();
  const auto add = [&plan](const std::string& attribute, int array, int components) {
    plan.Attributes.push_back({ attribute, array, components, -1 });
  };

  const int interpolation = actor->GetProperty()->GetInterpolation();
  const int normals = vtkMTPatchAttributes::FindAttribute(graph, vtkDataSetAttributes::NORMALS, vtkMTArrayInfo::Point);
  const bool smooth = normals >= 0 && interpolation != VTK_FLAT;
  if (smooth)
  {
    add("normalMC", normals, 3);
  }
  plan.CellNormals =
    smooth ? -1 : vtkMTPatchAttributes::FindAttribute(graph, vtkDataSetAttributes::NORMALS, vtkMTArrayInfo::Cell);

  const int tcoords = vtkMTPatchAttributes::FindAttribute(graph, vtkDataSetAttributes::TCOORDS, vtkMTArrayInfo::Point);
  if (tcoords >= 0 && plan.Coloring != vtkMTPatchStreams::PointCoordinates && this->HaveTextures(actor))
  {
    add("tcoord", tcoords, std::min(graph.Arrays[tcoords].Components, 3));
  }
  const int tangents =
    vtkMTPatchAttributes::FindAttribute(graph, vtkDataSetAttributes::TANGENTS, vtkMTArrayInfo::Point);
  if (tangents >= 0 && interpolation == VTK_PBR)
  {
    add("tangentMC", tangents, 3);
  }
  for (const auto& extra : this->ExtraAttributes)
  {
    const int array = vtkMTPatchAttributes::FindArray(graph, extra.second.DataArrayName, vtkMTArrayInfo::Point);
    if (array >= 0)
    {
      add(extra.first, array, std::min(graph.Arrays[array].Components, 4));
    }
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateColorRevision()
{
  Internals& self = *this->Implementation;
  self.NewColorState.Clear();
  self.NewColorState.Append(self.Plan.Coloring, "coloring");
  self.NewColorState.Append(self.Plan.Scalars, "array");
  self.NewColorState.Append(this->ArrayComponent, "component");
  self.NewColorState.Append(this->ColorMode, "color mode");
  self.NewColorState.Append(this->LookupTable, "table");
  self.NewColorState.Append(this->LookupTable ? this->LookupTable->GetMTime() : 0, "table mtime");
  if (self.ColorState != self.NewColorState)
  {
    self.ColorState = self.NewColorState;
    ++self.Plan.ColorRevision;
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::BuildTemplate(vtkRenderer* renderer)
{
  const vtkMTPatchStreams::Plan& plan = this->Implementation->Plan;
  vtkPointData* attributes = this->Implementation->Template->GetPointData();
  attributes->Initialize();
  this->VBOs->ClearAllVBOs();
  this->EdgeValues.clear();

  // The superclass asks its buffers which attributes there are, and the polydata whether there are normals and texture
  // coordinates.
  const auto declare = [this, renderer](const std::string& attribute, vtkDataArray* one)
  { this->VBOs->CacheDataArray(attribute.c_str(), one, renderer, one->GetDataType()); };
  for (const vtkMTPatchStreams::Floats& floats : plan.Attributes)
  {
    vtkNew<vtkFloatArray> one;
    one->SetNumberOfComponents(floats.Components);
    one->SetNumberOfTuples(1);
    one->Fill(0.0);
    declare(floats.Attribute, one);
  }
  if (plan.Coloring == vtkMTPatchStreams::PointColors || plan.Coloring == vtkMTPatchStreams::OneColor ||
    this->ColorBy != NONE)
  {
    vtkNew<vtkUnsignedCharArray> one;
    one->SetNumberOfComponents(4);
    one->SetNumberOfTuples(1);
    one->Fill(255);
    declare("scalarColor", one);
  }
  if (plan.Coloring == vtkMTPatchStreams::PointCoordinates)
  {
    vtkNew<vtkFloatArray> one;
    one->SetNumberOfComponents(2);
    one->SetNumberOfTuples(1);
    one->Fill(0.0);
    declare("tcoord", one);
  }
  this->VBOs->BuildAllVBOs(renderer);

  const vtkMTGraph& graph = this->Implementation->Graph();
  for (const int attribute : { vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TCOORDS })
  {
    if (vtkMTPatchAttributes::FindAttribute(graph, attribute, vtkMTArrayInfo::Point) >= 0)
    {
      vtkNew<vtkFloatArray> one;
      one->SetNumberOfComponents(attribute == vtkDataSetAttributes::NORMALS ? 3 : 2);
      one->SetNumberOfTuples(1);
      one->Fill(0.0);
      attributes->SetAttribute(one, attribute);
    }
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::MapPatchScalars(int array, const vtkMTPatch& patch, std::vector<unsigned char>& bytes)
{
  const vtkMTPatchStreams::Plan& plan = this->Implementation->Plan;
  const auto scalars = vtkMTPatchAttributes::GetArray(this->Implementation->Graph(), array, patch);
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
    this->LookupTable->MapScalars(scalars, this->ColorMode, this->ArrayComponent));
  this->LookupTable->SetAlpha(alpha);
  bytes = vtkMTPatchAttributes::GetColors(
    colors, plan.Coloring == vtkMTPatchStreams::CellColors ? plan.PrimitivesPerTriangle : 1);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateCellTextures(vtkRenderer* renderer)
{
  Internals& self = *this->Implementation;
  const auto values = static_cast<unsigned int>(
    self.Painter->GetArena().GetTriangleCapacity() * static_cast<std::uint64_t>(self.Plan.PrimitivesPerTriangle));
  const auto update = [&](vtkTextureObject*& texture, const char* stream, int type)
  {
    vtkOpenGLBufferObject* buffer =
      self.Painter->GetArena().GetBuffer(vtkMTPatchStreams::GetCellStream(stream, self.Plan));
    if (!buffer || buffer->GetHandle() == 0)
    {
      return false;
    }
    if (!texture)
    {
      texture = vtkTextureObject::New();
    }
    texture->SetContext(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
    return texture->CreateTextureBuffer(values, 4, type, buffer);
  };
  this->HaveCellScalars = self.Plan.Coloring == vtkMTPatchStreams::CellColors &&
    update(this->CellScalarTexture, vtkMTPatchStreams::CellColorStream, VTK_UNSIGNED_CHAR);
  this->HaveCellNormals =
    self.Plan.CellNormals >= 0 && update(this->CellNormalTexture, vtkMTPatchStreams::CellNormalStream, VTK_FLOAT);
}
