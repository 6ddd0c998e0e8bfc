// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchStreams.h"

#include "vtkDataArray.h"
#include "vtkMTGraph.h"
#include "vtkMTOpenGL.h"
#include "vtkMTPatchAttributes.h"

#include <algorithm>
#include <cstring>
#include <iterator>

namespace
{
using Format = vtkMTPatchArena::Format;

Format MakeVertexFormat(int components, GLenum type, std::size_t bytes, bool integer = false)
{
  Format format;
  format.Domain = vtkMTPatchArena::Vertices;
  format.Components = components;
  format.Type = type;
  format.Bytes = bytes;
  format.Integer = integer;
  return format;
}

Format MakeTriangleFormat(std::size_t bytes)
{
  Format format;
  format.Domain = vtkMTPatchArena::Triangles;
  format.Bytes = bytes;
  return format;
}

template <typename T>
std::vector<unsigned char> ToBytes(const std::vector<T>& values)
{
  std::vector<unsigned char> bytes(values.size() * sizeof(T));
  if (!bytes.empty())
  {
    std::memcpy(bytes.data(), values.data(), bytes.size());
  }
  return bytes;
}

// What a stream holds, as a number: the same attribute may come from another array than before, or from colours.
std::uint64_t GetRevision(const vtkMTPatchStreams::Floats& floats)
{
  return (static_cast<std::uint64_t>(floats.Component + 1) << 32) + static_cast<std::uint64_t>(floats.Array) + 1;
}

std::uint64_t GetPackingRevision(const vtkMTPatchStreams::Plan& plan)
{
  std::uint64_t revision = static_cast<std::uint64_t>(plan.PackedNormals) + 1;
  for (const std::int32_t value : { plan.Packing.Corner[0], plan.Packing.Corner[1], plan.Packing.Corner[2],
         static_cast<std::int32_t>(plan.Packing.Shift) })
  {
    revision = 31 * revision + static_cast<std::uint32_t>(value);
  }
  return std::max<std::uint64_t>(revision, 1);
}

std::uint64_t GetRevision(std::uint64_t colorRevision)
{
  return (std::uint64_t(1) << 63) + colorRevision;
}
}

std::string vtkMTPatchStreams::GetIndexStream(const Plan& plan)
{
  return plan.Edges ? "edges" : "triangles";
}

std::string vtkMTPatchStreams::GetCellStream(const char* stream, const Plan& plan)
{
  return plan.PrimitivesPerTriangle == 1 ? stream : stream + std::to_string(plan.PrimitivesPerTriangle);
}

void vtkMTPatchStreams::Apply(const Plan& plan, const void* user, vtkMTPatchArena& arena)
{
  this->Current = plan;
  this->Streams.clear();
  std::vector<std::string> names;
  const Declaration declare =
    [&](const std::string& name, const Format& format, std::uint64_t revision, Stream::KindType kind, std::size_t which)
  {
    Stream stream;
    stream.Number = arena.Declare(name, format, revision);
    stream.Kind = kind;
    stream.Which = which;
    this->Streams.push_back(stream);
    names.push_back(name);
  };
  vtkMTPatchStreams::DeclareVertices(plan, declare);
  vtkMTPatchStreams::DeclareTriangles(plan, declare);
  vtkMTPatchStreams::DeclareColors(plan, declare);
  this->Note(plan, user, names);
  this->RemoveUnused(arena);
}

void vtkMTPatchStreams::DeclareVertices(const Plan& plan, const Declaration& declare)
{
  if (plan.PackedNormals >= 0)
  {
    declare(PackedPositions, MakeVertexFormat(3, GL_UNSIGNED_INT, 12, true), GetPackingRevision(plan),
      Stream::PackedPoints, 0);
  }
  else
  {
    declare(Positions, MakeVertexFormat(3, GL_INT, 12, true), 1, Stream::Points, 0);
  }
  for (std::size_t i = 0; i < plan.Attributes.size(); ++i)
  {
    const Floats& floats = plan.Attributes[i];
    const Format format =
      MakeVertexFormat(floats.Components, GL_FLOAT, sizeof(float) * static_cast<std::size_t>(floats.Components));
    declare(floats.Attribute, format, GetRevision(floats), Stream::Attribute, i);
  }
}

void vtkMTPatchStreams::DeclareTriangles(const Plan& plan, const Declaration& declare)
{
  const std::size_t index = plan.ShortIndices ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
  declare(GetIndexStream(plan), MakeTriangleFormat((plan.Edges ? 6 : 3) * index), plan.ShortIndices ? 2 : 1,
    Stream::Connectivity, 0);
  const auto times = static_cast<std::size_t>(plan.PrimitivesPerTriangle);
  if (plan.CellNormals >= 0)
  {
    declare(GetCellStream(CellNormalStream, plan), MakeTriangleFormat(16 * times),
      1 + static_cast<std::uint64_t>(plan.CellNormals), Stream::CellNormal, 0);
  }
  if (!plan.CellTextures.empty())
  {
    declare(GetCellStream(CellTextureStream, plan), MakeTriangleFormat(sizeof(float) * times),
      plan.CellTexturesRevision, Stream::Texture, 0);
  }
}

void vtkMTPatchStreams::DeclareColors(const Plan& plan, const Declaration& declare)
{
  const auto times = static_cast<std::size_t>(plan.PrimitivesPerTriangle);
  switch (plan.Coloring)
  {
    case PointColors:
      declare(
        "scalarColor", MakeVertexFormat(4, GL_UNSIGNED_BYTE, 4), GetRevision(plan.ColorRevision), Stream::Color, 0);
      break;
    case PointCoordinates:
      declare(
        vtkMTColorCoordinates, MakeVertexFormat(2, GL_FLOAT, 8), GetRevision(plan.ColorRevision), Stream::Color, 0);
      break;
    case CellColors:
      declare(GetCellStream(CellColorStream, plan), MakeTriangleFormat(4 * times), GetRevision(plan.ColorRevision),
        Stream::Color, 0);
      break;
    case NoColors:
    case OneColor:
      break;
  }
}

void vtkMTPatchStreams::Note(const Plan& plan, const void* user, const std::vector<std::string>& names)
{
  this->Uses[user] = { plan, names, ++this->Time };
  std::copy_if(names.begin(), names.end(), std::back_inserter(this->Names),
    [this](const std::string& name)
    { return std::find(this->Names.begin(), this->Names.end(), name) == this->Names.end(); });
  // A frame applies each user's plan once for each pass. One that has not come for so many of them draws no more.
  constexpr std::uint64_t passes = 64;
  const std::uint64_t patience = passes * this->Uses.size();
  for (auto use = this->Uses.begin(); use != this->Uses.end();)
  {
    use = this->Time - use->second.Time > patience ? this->Uses.erase(use) : std::next(use);
  }
}

void vtkMTPatchStreams::RemoveUnused(vtkMTPatchArena& arena)
{
  const auto isUsed = [this](const std::string& name)
  {
    return std::any_of(this->Uses.begin(), this->Uses.end(),
      [&name](const auto& use)
      { return std::find(use.second.Names.begin(), use.second.Names.end(), name) != use.second.Names.end(); });
  };
  const auto unused = std::stable_partition(this->Names.begin(), this->Names.end(), isUsed);
  std::for_each(unused, this->Names.end(), [&arena](const std::string& name) { arena.Remove(name); });
  this->Names.erase(unused, this->Names.end());
}

std::vector<unsigned char> vtkMTPatchStreams::GetArrays(const vtkMTGraph& graph) const
{
  std::vector<unsigned char> arrays(graph.Arrays.size(), 0);
  const auto want = [&arrays](int array)
  {
    if (array >= 0)
    {
      arrays[array] = 1;
    }
  };
  for (const auto& use : this->Uses)
  {
    const Plan& plan = use.second.Wanted;
    for (const Floats& floats : plan.Attributes)
    {
      want(floats.Array);
    }
    want(plan.PackedNormals);
    want(plan.CellNormals);
    if (!plan.CellTextures.empty())
    {
      want(plan.Materials);
      want(plan.Parts);
    }
    if (plan.Coloring != NoColors)
    {
      want(plan.Scalars);
    }
  }
  return arrays;
}

bool vtkMTPatchStreams::IsStale(const vtkMTPatchArena& arena, const vtkMTPatchArena::Slot& slot) const
{
  return std::any_of(this->Streams.begin(), this->Streams.end(),
    [&](const Stream& stream) { return arena.IsStale(slot, stream.Number); });
}

bool vtkMTPatchStreams::Upload(vtkMTPatchArena& arena, vtkMTPatchArena::Slot& slot, const vtkMTGraph& graph,
  const vtkMTPatch& patch, const Mapping& mapping) const
{
  return std::all_of(this->Streams.begin(), this->Streams.end(),
    [&](const Stream& stream)
    {
      return !arena.IsStale(slot, stream.Number) ||
        arena.Upload(slot, stream.Number, this->Make(stream, graph, patch, mapping));
    });
}

// The number of the texture that each triangle has, or -1.
std::vector<float> vtkMTPatchStreams::GetCellTextures(const vtkMTGraph& graph, const vtkMTPatch& patch) const
{
  const auto getValues = [&](int array)
  { return array >= 0 ? vtkMTPatchAttributes::GetArray(graph, array, patch) : vtkSmartPointer<vtkDataArray>(); };
  const vtkSmartPointer<vtkDataArray> materials = getValues(this->Current.Materials);
  const vtkSmartPointer<vtkDataArray> parts = getValues(this->Current.Parts);
  const auto has = [](vtkDataArray* values, std::size_t cell, int wanted)
  { return wanted < 0 || (values && values->GetComponent(static_cast<vtkIdType>(cell), 0) == wanted); };
  std::vector<float> numbers(patch.Triangles.size());
  const std::vector<CellTexture>& textures = this->Current.CellTextures;
  for (std::size_t cell = 0; cell < numbers.size(); ++cell)
  {
    const auto found = std::find_if(textures.begin(), textures.end(),
      [&](const CellTexture& texture)
      { return has(materials, cell, texture.Material) && has(parts, cell, texture.Part); });
    numbers[cell] = found == textures.end() ? -1.0f : static_cast<float>(found - textures.begin());
  }
  return numbers;
}

std::vector<unsigned char> vtkMTPatchStreams::Make(
  const Stream& stream, const vtkMTGraph& graph, const vtkMTPatch& patch, const Mapping& mapping) const
{
  std::vector<unsigned char> bytes;
  switch (stream.Kind)
  {
    case Stream::Points:
      bytes = vtkMTPatchAttributes::GetPositions(patch);
      break;
    case Stream::PackedPoints:
    {
      const auto array = vtkMTPatchAttributes::GetArray(graph, this->Current.PackedNormals, patch);
      bytes = vtkMTPatchAttributes::GetPackedVertices(this->Current.Packing, array, patch);
      break;
    }
    case Stream::Connectivity:
      bytes = this->Current.ShortIndices ? vtkMTPatchAttributes::GetIndices<std::uint16_t>(patch, this->Current.Edges)
                                         : vtkMTPatchAttributes::GetIndices<std::uint32_t>(patch, this->Current.Edges);
      break;
    case Stream::Attribute:
    {
      const Floats& floats = this->Current.Attributes[stream.Which];
      const auto array = vtkMTPatchAttributes::GetArray(graph, floats.Array, patch);
      bytes = ToBytes(vtkMTPatchAttributes::GetFloats(array, floats.Components, floats.Component));
      break;
    }
    case Stream::CellNormal:
    {
      const auto array = vtkMTPatchAttributes::GetArray(graph, this->Current.CellNormals, patch);
      bytes = ToBytes(vtkMTPatchAttributes::Repeat(
        vtkMTPatchAttributes::GetFloats(array, 4), 4, this->Current.PrimitivesPerTriangle));
      break;
    }
    case Stream::Texture:
      bytes = ToBytes(
        vtkMTPatchAttributes::Repeat(this->GetCellTextures(graph, patch), 1, this->Current.PrimitivesPerTriangle));
      break;
    case Stream::Color:
      mapping(this->Current.Scalars, patch, bytes);
      break;
  }
  return bytes;
}
