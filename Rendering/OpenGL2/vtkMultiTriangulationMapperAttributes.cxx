// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: which data the shader needs.
#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkMTOpenGL.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <string>

//------------------------------------------------------------------------------
// A filter that does not know the model has added them to its coarsest cut, and finer patches have no such values.
void vtkMultiTriangulationMapper::WarnOfForeignArrays()
{
  Internals& self = *this->Implementation;
  std::string names;
  for (const auto association : { vtkMTArrayInfo::Point, vtkMTArrayInfo::Cell })
  {
    vtkDataSetAttributes* data = this->GetInput()->GetAttributes(
      association == vtkMTArrayInfo::Point ? vtkDataObject::POINT : vtkDataObject::CELL);
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const char* name = data->GetArrayName(i);
      if (name && vtkMTPatchAttributes::FindArray(self.Graph(), name, association) < 0)
      {
        names += (names.empty() ? "" : ", ") + std::string(name);
      }
    }
  }
  if (names != self.ForeignArrays && !names.empty())
  {
    vtkWarningMacro("The input has arrays that its model has not, so they are known on its coarsest cut alone and are "
                    "not drawn: "
      << names << ". Build the model with them; for elevations there is SetColorByElevation.");
  }
  self.ForeignArrays = names;
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
  // Vertices that have been packed stay so, lest positions be uploaded again.
  const bool isPacked = smooth || plan.PackedNormals == normals;
  plan.Packing = vtkMTPackedVertices::ForBox(graph.GetFigures().Box);
  plan.PackedNormals = isPacked && plan.Packing.Shift > 0 ? normals : -1;
  plan.ShowsNormals = smooth;
  if (smooth && plan.PackedNormals < 0)
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
void vtkMultiTriangulationMapper::MapTextureToMaterial(const char* texture, int material, int part)
{
  if (!texture || !*texture)
  {
    return;
  }
  auto& textures = this->Implementation->CellTextures;
  auto found = std::find_if(textures.begin(), textures.end(),
    [texture](const vtkMTPatchStreams::CellTexture& each) { return each.Name == texture; });
  found = found == textures.end() ? textures.insert(found, { texture, -1, -1 }) : found;
  found->Material = std::max(material, -1);
  found->Part = std::max(part, -1);
  ++this->Implementation->Plan.CellTexturesRevision;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::RemoveTextureMappings()
{
  if (!this->Implementation->CellTextures.empty())
  {
    this->Implementation->CellTextures.clear();
    ++this->Implementation->Plan.CellTexturesRevision;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::PlanCellTextures(vtkActor* actor)
{
  Internals& self = *this->Implementation;
  vtkMTPatchStreams::Plan& plan = self.Plan;
  const bool isUsed = std::any_of(self.CellTextures.begin(), self.CellTextures.end(),
    [actor](const vtkMTPatchStreams::CellTexture& each)
    { return actor->GetProperty()->GetTexture(each.Name.c_str()) != nullptr; });
  plan.CellTextures = isUsed ? self.CellTextures : std::vector<vtkMTPatchStreams::CellTexture>();
  plan.Materials = vtkMTPatchAttributes::FindArray(self.Graph(), "MaterialIds", vtkMTArrayInfo::Cell);
  plan.Parts = vtkMTPatchAttributes::FindArray(self.Graph(), "PartId", vtkMTArrayInfo::Cell);
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
  const auto declareFloats = [&declare](const std::string& attribute, int components)
  {
    vtkNew<vtkFloatArray> one;
    one->SetNumberOfComponents(components);
    one->SetNumberOfTuples(1);
    one->Fill(0.0);
    declare(attribute, one);
  };
  for (const vtkMTPatchStreams::Floats& floats : plan.Attributes)
  {
    declareFloats(floats.Attribute, floats.Components);
  }
  if (plan.PackedNormals >= 0 && plan.ShowsNormals)
  {
    declareFloats("normalMC", 3);
  }
  if (plan.Coloring == vtkMTPatchStreams::PointColors || plan.Coloring == vtkMTPatchStreams::OneColor ||
    this->ShowsCut())
  {
    vtkNew<vtkUnsignedCharArray> one;
    one->SetNumberOfComponents(4);
    one->SetNumberOfTuples(1);
    one->Fill(255);
    declare("scalarColor", one);
  }
  if (plan.Coloring == vtkMTPatchStreams::PointCoordinates)
  {
    declareFloats(vtkMTColorCoordinates, 2);
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
void vtkMultiTriangulationMapper::UpdateCellTextures(vtkRenderer* renderer)
{
  Internals& self = *this->Implementation;
  const auto values = static_cast<unsigned int>(
    self.Painter->GetArena().GetTriangleCapacity() * static_cast<std::uint64_t>(self.Plan.PrimitivesPerTriangle));
  const auto fill = [&](vtkTextureObject* texture, const char* stream, int type, int components)
  {
    vtkOpenGLBufferObject* buffer =
      self.Painter->GetArena().GetBuffer(vtkMTPatchStreams::GetCellStream(stream, self.Plan));
    if (!buffer || buffer->GetHandle() == 0)
    {
      return false;
    }
    texture->SetContext(vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()));
    return texture->CreateTextureBuffer(values, components, type, buffer);
  };
  const auto update = [&fill](vtkTextureObject*& texture, const char* stream, int type)
  {
    texture = texture ? texture : vtkTextureObject::New();
    return fill(texture, stream, type, 4);
  };
  this->HaveCellScalars = self.Plan.Coloring == vtkMTPatchStreams::CellColors &&
    update(this->CellScalarTexture, vtkMTPatchStreams::CellColorStream, VTK_UNSIGNED_CHAR);
  this->HaveCellNormals =
    self.Plan.CellNormals >= 0 && update(this->CellNormalTexture, vtkMTPatchStreams::CellNormalStream, VTK_FLOAT);
  self.HasCellTextures =
    !self.Plan.CellTextures.empty() && fill(self.CellTextureBuffer, vtkMTPatchStreams::CellTextureStream, VTK_FLOAT, 1);
}
