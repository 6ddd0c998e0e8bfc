// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: what vtkHardwareSelector asks for.
#include "vtkActor.h"
#include "vtkHardwareSelector.h"
#include "vtkMTCompatibility.h"
#include "vtkMTOpenGL.h"
#include "vtkMTPatchAttributes.h"
#include "vtkMTSelectionIds.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace
{
// The array whose values the selector's ids of points or cells are, or -1.
int FindIds(const vtkMTGraph& graph, bool points, const char* pointIds, const char* cellIds)
{
  if (points)
  {
    return pointIds ? vtkMTPatchAttributes::FindArray(graph, pointIds, vtkMTArrayInfo::Point)
                    : vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputPointIds);
  }
  return cellIds ? vtkMTPatchAttributes::FindArray(graph, cellIds, vtkMTArrayInfo::Cell)
                 : vtkMTPatchAttributes::FindRole(graph, vtkMTArrayInfo::InputCellIds);
}

// The largest value of the array, where there is one that is an id.
std::uint64_t FindLargestId(const vtkMTGraph& graph, int array)
{
  constexpr double most = 281474976710655.0; // of 48 bits
  const bool isKnown = array >= 0 && static_cast<std::size_t>(array) < graph.ArrayRanges.size();
  const double largest = isKnown ? graph.ArrayRanges[array][0].Maximum : 0.0;
  return largest > 0.0 && largest <= most ? static_cast<std::uint64_t>(largest) : 0;
}
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::UpdateMaximumPointCellIds(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->HasPatches())
  {
    this->Superclass::UpdateMaximumPointCellIds(renderer, actor);
    return;
  }
  // What the shader writes, and what is put in its place.
  const Internals& self = *this->Implementation;
  const vtkMTPatchArena& arena = self.Painter->GetArena();
  const std::uint64_t triangles = arena.GetTriangleCapacity() * self.Painter->GetIndicesPerTriangle();
  const auto getLargest = [&](bool points)
  { return FindLargestId(self.Graph(), FindIds(self.Graph(), points, this->PointIdArrayName, this->CellIdArrayName)); };
  renderer->GetSelector()->UpdateMaximumPointId(
    static_cast<vtkIdType>(std::max<std::uint64_t>(arena.GetVertexCapacity(), getLargest(true))));
  renderer->GetSelector()->UpdateMaximumCellId(
    static_cast<vtkIdType>(std::max({ triangles, self.Graph().InputCounts.Triangles, getLargest(false) })));
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixelOffsets, vtkProp* prop)
{
  if (!this->HasPatches())
  {
    this->Superclass::ProcessSelectorPixelBuffers(selector, pixelOffsets, prop);
    return;
  }
  Internals& self = *this->Implementation;
  const int pass = selector->GetCurrentPass();
  const bool points = pass == vtkHardwareSelector::POINT_ID_LOW24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  const bool cells = pass == vtkHardwareSelector::CELL_ID_LOW24 || pass == vtkHardwareSelector::CELL_ID_HIGH24;
  if (!this->PopulateSelectionSettings || !(points || cells))
  {
    return;
  }
  const int lowPass = points ? vtkHardwareSelector::POINT_ID_LOW24 : vtkHardwareSelector::CELL_ID_LOW24;
  const int highPass = points ? vtkHardwareSelector::POINT_ID_HIGH24 : vtkHardwareSelector::CELL_ID_HIGH24;
  vtkMTSelectionIds::Pictures pictures;
  pictures.Low = selector->GetRawPixelBuffer(lowPass);
  pictures.High = selector->GetRawPixelBuffer(highPass);
  unsigned char* target = selector->GetPixelBuffer(pass);
  unsigned char* actors = selector->GetPixelBuffer(vtkHardwareSelector::ACTOR_PASS);
  if (!pictures.Low || !target || !actors)
  {
    return;
  }
  if (cells)
  {
    const int representation = static_cast<vtkActor*>(prop)->GetProperty()->GetRepresentation();
    pictures.Primitives = self.Painter->GetPrimitivesPerTriangle(
      this->PointPicking ? GL_POINTS : static_cast<GLenum>(this->GetOpenGLMode(representation, PrimitiveTris)));
  }
  const int array = FindIds(self.Graph(), points, this->PointIdArrayName, this->CellIdArrayName);
  if (array < 0)
  {
    return; // the shader's ids stay
  }
  vtkMTSelectionIds ids(
    self.Frame.GetSource(), *self.Frame.GetCache(), array, self.Painter->GetArrays(), self.SelectedIds[points ? 0 : 1]);
  ids.SetPlaces(self.Painter->GetArena(), points ? vtkMTPatchArena::Vertices : vtkMTPatchArena::Triangles);
  std::string error;
  if (pass == lowPass)
  {
    vtkMTForgetAbort(this);
    ids.Find(
      pixelOffsets, pictures,
      [this](double fraction)
      {
        this->UpdateProgress(fraction);
        return !vtkMTIsAborted(this);
      },
      error);
  }
  if (!error.empty())
  {
    vtkErrorMacro(<< "Not all ids were found: " << error);
  }
  ids.Translate(pixelOffsets, pictures, pass == highPass, target, actors);
}
