// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTColorArray.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMTGraph.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace
{
std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool HasNamesOfColors(const std::vector<std::string>& names)
{
  static const std::array<const char*, 3> colors{ "red", "green", "blue" };
  if (names.size() < colors.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < colors.size(); ++i)
  {
    const std::string name = ToLower(names[i]);
    if (name != colors[i] && name != std::string(1, colors[i][0]))
    {
      return false;
    }
  }
  return true;
}
}

bool vtkMTColorArray::IsColors(const vtkMTArrayInfo& info)
{
  const bool isOther = info.Attribute >= 0 && info.Attribute != vtkDataSetAttributes::SCALARS;
  if (isOther || (info.Components != 3 && info.Components != 4) || info.Role == vtkMTArrayInfo::ExactPoints)
  {
    return false;
  }
  const std::string name = ToLower(info.Name);
  const auto has = [&name](const char* word) { return name.find(word) != std::string::npos; };
  return info.Type == VTK_UNSIGNED_CHAR || has("rgb") || has("color") || has("colour") ||
    HasNamesOfColors(info.ComponentNames);
}

int vtkMTColorArray::Find(const vtkMTGraph& graph)
{
  for (const auto association : { vtkMTArrayInfo::Point, vtkMTArrayInfo::Cell })
  {
    const auto found = std::find_if(graph.Arrays.begin(), graph.Arrays.end(),
      [association](const vtkMTArrayInfo& info)
      { return info.Association == association && vtkMTColorArray::IsColors(info); });
    if (found != graph.Arrays.end())
    {
      return static_cast<int>(found - graph.Arrays.begin());
    }
  }
  return -1;
}

double vtkMTColorArray::GetFullValue(int type, double largest)
{
  constexpr double byte = 255.0;
  constexpr double word = 65535.0;
  const bool isReal = type == VTK_FLOAT || type == VTK_DOUBLE;
  if (isReal && largest <= 1.0)
  {
    return 1.0;
  }
  if (largest <= byte)
  {
    return byte;
  }
  return largest <= word || isReal ? word : vtkDataArray::GetDataTypeMax(type);
}

vtkSmartPointer<vtkUnsignedCharArray> vtkMTColorArray::ToBytes(vtkDataArray* values, double fullValue)
{
  const int components = values->GetNumberOfComponents();
  const vtkIdType tuples = values->GetNumberOfTuples();
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  bytes->SetNumberOfComponents(components);
  bytes->SetNumberOfTuples(tuples);
  const double scale = 255.0 / fullValue;
  for (vtkIdType tuple = 0; tuple < tuples; ++tuple)
  {
    for (int c = 0; c < components; ++c)
    {
      const double value = scale * values->GetComponent(tuple, c);
      // Comparisons that NaN fails.
      bytes->SetTypedComponent(tuple, c, value > 0.0 ? static_cast<unsigned char>(std::min(value, 255.0) + 0.5) : 0);
    }
  }
  return bytes;
}
