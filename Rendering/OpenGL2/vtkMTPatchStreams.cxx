// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchStreams.h"

#include "vtkDataArray.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchAttributes.h"

#include "vtk_glew.h"

#include <algorithm>
#include <cstring>

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

std::uint64_t GetRevision(std::uint64_t colorRevision)
{
  return (std::uint64_t(1) << 63) + colorRevision;
}
}

void vtkMTPatchStreams::Apply(const Plan& plan, vtkMTPatchArena& arena)
{
  this->Current = plan;
  this->Streams.clear();
  std::vector<std::string> names;
  const auto declare = [&](const std::string& name, const Format& format, std::uint64_t revision, Stream::KindType kind,
                         std::size_t which = 0)
  {
    Stream stream;
    stream.Number = arena.Declare(name, format, revision);
    stream.Kind = kind;
    stream.Which = which;
    this->Streams.push_back(stream);
    names.push_back(name);
  };

  declare(Positions, MakeVertexFormat(3, GL_INT, 12, true), 1, Stream::Points);
  const std::size_t index = plan.ShortIndices ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
  declare(Indices, MakeTriangleFormat((plan.Edges ? 6 : 3) * index), plan.ShortIndices ? 2 : 1, Stream::Connectivity);
  for (std::size_t i = 0; i < plan.Attributes.size(); ++i)
  {
    const Floats& floats = plan.Attributes[i];
    const Format format =
      MakeVertexFormat(floats.Components, GL_FLOAT, sizeof(float) * static_cast<std::size_t>(floats.Components));
    declare(floats.Attribute, format, GetRevision(floats), Stream::Attribute, i);
  }
  const auto times = static_cast<std::size_t>(plan.PrimitivesPerTriangle);
  if (plan.CellNormals >= 0)
  {
    declare(CellNormalStream, MakeTriangleFormat(16 * times), 1 + static_cast<std::uint64_t>(plan.CellNormals),
      Stream::CellNormal);
  }
  switch (plan.Coloring)
  {
    case PointColors:
      declare("scalarColor", MakeVertexFormat(4, GL_UNSIGNED_BYTE, 4), GetRevision(plan.ColorRevision), Stream::Color);
      break;
    case PointCoordinates:
      declare("tcoord", MakeVertexFormat(2, GL_FLOAT, 8), GetRevision(plan.ColorRevision), Stream::Color);
      break;
    case CellColors:
      declare(CellColorStream, MakeTriangleFormat(4 * times), GetRevision(plan.ColorRevision), Stream::Color);
      break;
    case NoColors:
    case OneColor:
      break;
  }
  for (const std::string& old : this->Names)
  {
    if (std::find(names.begin(), names.end(), old) == names.end())
    {
      arena.Remove(old);
    }
  }
  this->Names = names;
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
  for (const Floats& floats : this->Current.Attributes)
  {
    want(floats.Array);
  }
  want(this->Current.CellNormals);
  if (this->Current.Coloring != NoColors)
  {
    want(this->Current.Scalars);
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

std::vector<unsigned char> vtkMTPatchStreams::Make(
  const Stream& stream, const vtkMTGraph& graph, const vtkMTPatch& patch, const Mapping& mapping) const
{
  std::vector<unsigned char> bytes;
  switch (stream.Kind)
  {
    case Stream::Points:
      bytes = ToBytes(vtkMTPatchAttributes::GetPositions(patch));
      break;
    case Stream::Connectivity:
      bytes = this->Current.ShortIndices
        ? ToBytes(vtkMTPatchAttributes::GetIndices<std::uint16_t>(patch, this->Current.Edges))
        : ToBytes(vtkMTPatchAttributes::GetIndices<std::uint32_t>(patch, this->Current.Edges));
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
    case Stream::Color:
      mapping(this->Current.Scalars, patch, bytes);
      break;
  }
  return bytes;
}
