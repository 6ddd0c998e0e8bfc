// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchAttributes.h"

#include "vtkDataArray.h"
#include "vtkMTGraph.h"
#include "vtkMTPackedVertices.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace
{
template <typename Predicate>
int FindIf(const vtkMTGraph& graph, Predicate predicate)
{
  const auto found = std::find_if(graph.Arrays.begin(), graph.Arrays.end(), predicate);
  return found != graph.Arrays.end() ? static_cast<int>(found - graph.Arrays.begin()) : -1;
}

template <typename Index, std::size_t Each, typename Arrange>
std::vector<unsigned char> MakeIndices(const vtkMTPatch& patch, Arrange arrange)
{
  using Indices = std::array<Index, Each>;
  std::vector<unsigned char> bytes(sizeof(Indices) * patch.Triangles.size());
  unsigned char* to = bytes.data();
  for (const vtkMTTriangle& t : patch.Triangles)
  {
    const Indices indices = arrange({ static_cast<Index>(t[0]), static_cast<Index>(t[1]), static_cast<Index>(t[2]) });
    std::memcpy(to, indices.data(), sizeof(Indices));
    to += sizeof(Indices);
  }
  return bytes;
}
}

int vtkMTPatchAttributes::FindArray(
  const vtkMTGraph& graph, const std::string& name, vtkMTArrayInfo::AssociationType association)
{
  return FindIf(graph,
    [&name, association](const vtkMTArrayInfo& info) { return info.Name == name && info.Association == association; });
}

int vtkMTPatchAttributes::FindAttribute(
  const vtkMTGraph& graph, int attribute, vtkMTArrayInfo::AssociationType association)
{
  return FindIf(graph,
    [attribute, association](const vtkMTArrayInfo& info)
    { return info.Attribute == attribute && info.Association == association; });
}

int vtkMTPatchAttributes::FindRole(const vtkMTGraph& graph, vtkMTArrayInfo::RoleType role)
{
  return FindIf(graph, [role](const vtkMTArrayInfo& info) { return info.Role == role; });
}

const vtkMTColumn& vtkMTPatchAttributes::GetColumn(const vtkMTGraph& graph, int array, const vtkMTPatch& patch)
{
  // Columns are kept by association, in the order of the graph's arrays.
  const vtkMTArrayInfo::AssociationType association = graph.Arrays[array].Association;
  const auto column = static_cast<std::size_t>(std::count_if(graph.Arrays.begin(), graph.Arrays.begin() + array,
    [association](const vtkMTArrayInfo& info) { return info.Association == association; }));
  return association == vtkMTArrayInfo::Point ? patch.PointColumns[column] : patch.CellColumns[column];
}

vtkSmartPointer<vtkDataArray> vtkMTPatchAttributes::GetArray(
  const vtkMTGraph& graph, int array, const vtkMTPatch& patch)
{
  const vtkMTArrayInfo& info = graph.Arrays[array];
  const vtkMTColumn& column = vtkMTPatchAttributes::GetColumn(graph, array, patch);
  auto result = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(info.Type));
  result->SetName(info.Name.c_str());
  result->SetNumberOfComponents(info.Components);
  const std::size_t tuples =
    info.Association == vtkMTArrayInfo::Point ? patch.GetNumberOfWedges() : patch.Triangles.size();
  if (column.empty() && info.IsFinestOnly() && tuples > 0)
  {
    const vtkMTColumn unknown = info.MakeUnknown(tuples);
    result->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
    std::copy(unknown.begin(), unknown.end(), static_cast<unsigned char*>(result->GetVoidPointer(0)));
    return result;
  }
  const auto values = static_cast<vtkIdType>(column.size() / info.GetTupleSize()) * info.Components;
  result->SetVoidArray(const_cast<unsigned char*>(column.data()), values, 1);
  return result;
}

std::vector<unsigned char> vtkMTPatchAttributes::GetPositions(const vtkMTPatch& patch)
{
  const std::size_t wedges = patch.GetNumberOfWedges();
  std::vector<unsigned char> bytes(wedges * sizeof(vtkMTPoint));
  if (patch.WedgePoints.empty())
  {
    std::memcpy(bytes.data(), patch.Points.data(), bytes.size());
    return bytes;
  }
  for (std::size_t wedge = 0; wedge < wedges; ++wedge)
  {
    std::memcpy(&bytes[wedge * sizeof(vtkMTPoint)], &patch.Points[patch.WedgePoints[wedge]], sizeof(vtkMTPoint));
  }
  return bytes;
}

std::vector<unsigned char> vtkMTPatchAttributes::GetPackedVertices(
  const vtkMTPackedVertices& packing, vtkDataArray* normals, const vtkMTPatch& patch)
{
  std::vector<float> converted;
  const auto* floats = static_cast<const float*>(normals->GetVoidPointer(0));
  if (normals->GetDataType() != VTK_FLOAT || normals->GetNumberOfComponents() != 3)
  {
    converted = vtkMTPatchAttributes::GetFloats(normals, 3);
    floats = converted.data();
  }
  std::vector<unsigned char> bytes(patch.GetNumberOfWedges() * vtkMTPackedVertices::Bytes);
  const bool fits = static_cast<std::size_t>(normals->GetNumberOfTuples()) == patch.GetNumberOfWedges() &&
    packing.Pack(patch, floats, bytes.data());
  return fits ? bytes : std::vector<unsigned char>();
}

template <typename Index>
std::vector<unsigned char> vtkMTPatchAttributes::GetIndices(const vtkMTPatch& patch, bool edges)
{
  return edges ? MakeIndices<Index, 6>(patch,
                   [](const std::array<Index, 3>& t) {
                     return std::array<Index, 6>{ t[0], t[1], t[1], t[2], t[2], t[0] };
                   })
               : MakeIndices<Index, 3>(patch, [](const std::array<Index, 3>& t) { return t; });
}

template std::vector<unsigned char> vtkMTPatchAttributes::GetIndices<std::uint16_t>(const vtkMTPatch&, bool);
template std::vector<unsigned char> vtkMTPatchAttributes::GetIndices<std::uint32_t>(const vtkMTPatch&, bool);

std::vector<float> vtkMTPatchAttributes::GetFloats(vtkDataArray* array, int components, int component)
{
  const int given = array->GetNumberOfComponents();
  const vtkIdType tuples = array->GetNumberOfTuples();
  std::vector<float> values(static_cast<std::size_t>(tuples) * components, 0.0f);
  const int first = std::max(component, 0);
  const int last = std::min(given, first + components);
  if (array->GetDataType() == VTK_FLOAT && array->HasStandardMemoryLayout() && given == components && first == 0)
  {
    const auto* from = static_cast<const float*>(array->GetVoidPointer(0));
    std::copy(from, from + values.size(), values.begin());
    return values;
  }
  for (vtkIdType tuple = 0; tuple < tuples; ++tuple)
  {
    for (int c = first; c < last; ++c)
    {
      values[static_cast<std::size_t>(tuple) * components + (c - first)] =
        static_cast<float>(array->GetComponent(tuple, c));
    }
  }
  return values;
}

std::vector<unsigned char> vtkMTPatchAttributes::GetColors(vtkUnsignedCharArray* colors, int times)
{
  std::vector<unsigned char> values;
  const vtkIdType tuples = colors->GetNumberOfTuples();
  values.reserve(static_cast<std::size_t>(tuples) * 4 * times);
  for (vtkIdType tuple = 0; tuple < tuples; ++tuple)
  {
    const unsigned char* color = colors->GetPointer(4 * tuple);
    for (int i = 0; i < times; ++i)
    {
      values.insert(values.end(), color, color + 4);
    }
  }
  return values;
}

std::vector<float> vtkMTPatchAttributes::Repeat(const std::vector<float>& values, int components, int times)
{
  std::vector<float> repeated;
  repeated.reserve(values.size() * times);
  for (std::size_t i = 0; i < values.size(); i += components)
  {
    for (int k = 0; k < times; ++k)
    {
      repeated.insert(repeated.end(), values.begin() + i, values.begin() + i + components);
    }
  }
  return repeated;
}
