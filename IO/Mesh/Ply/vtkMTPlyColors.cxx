// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyColors.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
const vtkMTPlyProperty* FindChannel(const vtkMTPlyElement& element, const std::string& name)
{
  const auto found = std::find_if(element.Properties.begin(), element.Properties.end(),
    [&name](const vtkMTPlyProperty& property)
    { return !property.IsList() && vtkMTTextFormat::ToLower(property.Name) == name; });
  return found == element.Properties.end() ? nullptr : &*found;
}

double ToValue(double value, int type)
{
  return type == VTK_SIGNED_CHAR && value < 0.0 ? value + 256.0 : value;
}
}

//------------------------------------------------------------------------------
bool vtkMTPlyColors::Group::AreBytes() const
{
  return std::all_of(this->Channels.begin(), this->Channels.end(),
    [](const vtkMTPlyProperty* channel) { return channel->Type == VTK_UNSIGNED_CHAR; });
}

int vtkMTPlyColors::Group::GetType() const
{
  const int type = this->Channels.front()->Type;
  return std::all_of(this->Channels.begin(), this->Channels.end(),
           [type](const vtkMTPlyProperty* channel) { return channel->Type == type; })
    ? type
    : VTK_DOUBLE;
}

std::vector<std::string> vtkMTPlyColors::Group::GetNames() const
{
  std::vector<std::string> names;
  std::transform(this->Channels.begin(), this->Channels.end(), std::back_inserter(names),
    [](const vtkMTPlyProperty* channel) { return channel->Name; });
  return names;
}

double vtkMTPlyColors::Group::GetScale(int type) const
{
  const auto found = this->Largest.find(type);
  const double largest = found == this->Largest.end() ? 0.0 : found->second;
  if (type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    return largest < 2.0 ? 255.0 : largest <= 255.0 ? 1.0 : 255.0 / largest;
  }
  if (largest <= 255.0)
  {
    return 1.0;
  }
  return 255.0 /
    (type == VTK_SHORT       ? VTK_SHORT_MAX
        : largest <= 65535.0 ? 65535.0
        : type == VTK_INT    ? static_cast<double>(VTK_INT_MAX)
                             : static_cast<double>(VTK_UNSIGNED_INT_MAX));
}

//------------------------------------------------------------------------------
vtkMTPlyColors::vtkMTPlyColors(const vtkMTPlyElement& element)
{
  this->FindGroup(element, { "red", "green", "blue", "alpha" }, "RGB");
  this->FindGroup(element, { "diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha", "alpha" },
    this->Groups.empty() ? "RGB" : "DiffuseRGB");
  this->FindGroup(element, { "r", "g", "b", "a" }, this->Groups.empty() ? "RGB" : "OtherRGB");
  this->FindGroup(element, { "ambient_red", "ambient_green", "ambient_blue", "ambient_alpha" }, "AmbientRGB");
  this->FindGroup(element, { "specular_red", "specular_green", "specular_blue", "specular_alpha" }, "SpecularRGB");
}

// names: three that must be there, and any number for what may be the fourth.
void vtkMTPlyColors::FindGroup(
  const vtkMTPlyElement& element, const std::vector<std::string>& names, const std::string& array)
{
  Group group;
  for (std::size_t i = 0; i < names.size() && group.Channels.size() < 4; ++i)
  {
    const vtkMTPlyProperty* channel = FindChannel(element, names[i]);
    const auto isIn = [channel](const Group& other)
    { return std::find(other.Channels.begin(), other.Channels.end(), channel) != other.Channels.end(); };
    if (channel && std::none_of(this->Groups.begin(), this->Groups.end(), isIn))
    {
      group.Channels.push_back(channel);
    }
    else if (i < 3)
    {
      return;
    }
  }
  group.Array = array + (group.Channels.size() > 3 ? "A" : "");
  this->Groups.push_back(group);
}

bool vtkMTPlyColors::AreAllBytes() const
{
  return std::all_of(this->Groups.begin(), this->Groups.end(), [](const Group& group) { return group.AreBytes(); });
}

void vtkMTPlyColors::Look(vtkDataSetAttributes* attributes)
{
  for (Group& group : this->Groups)
  {
    vtkDataArray* array = group.AreBytes() ? nullptr : attributes->GetArray(group.Array.c_str());
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      for (std::size_t c = 0; c < group.Channels.size(); ++c)
      {
        const int type = group.Channels[c]->Type;
        const double value = ToValue(array->GetComponent(i, static_cast<int>(c)), type);
        double& largest = group.Largest[type];
        largest = std::isfinite(value) && value > largest ? value : largest;
        this->NotNumbers += std::isnan(value) ? 1 : 0;
      }
    }
  }
}

void vtkMTPlyColors::Convert(vtkDataSetAttributes* attributes) const
{
  for (const Group& group : this->Groups)
  {
    vtkDataArray* array = group.AreBytes() ? nullptr : attributes->GetArray(group.Array.c_str());
    if (!array)
    {
      continue;
    }
    const vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetName(group.Array.c_str());
    bytes->SetNumberOfComponents(static_cast<int>(group.Channels.size()));
    bytes->SetNumberOfTuples(array->GetNumberOfTuples());
    for (int c = 0; c < bytes->GetNumberOfComponents(); ++c)
    {
      const int type = group.Channels[static_cast<std::size_t>(c)]->Type;
      const double scale = group.GetScale(type);
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        const double value = scale * ToValue(array->GetComponent(i, c), type);
        const double byte = value > 0.0 ? std::min(value, 255.0) : 0.0; // also of NaN
        bytes->SetTypedComponent(i, c, static_cast<unsigned char>(std::lround(byte)));
      }
    }
    attributes->AddArray(bytes); // replaces the array of that name
  }
}

void vtkMTPlyColors::Count(std::uint64_t rows, vtkMTInputReport& report) const
{
  vtkMTInputReports::Add("colors_scaled_to_bytes", this->AreAllBytes() ? 0 : rows, report);
  vtkMTInputReports::Add("colors_not_finite", this->NotNumbers, report);
}
