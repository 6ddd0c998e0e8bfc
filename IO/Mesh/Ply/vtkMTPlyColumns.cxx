// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyColumns.h"

#include "vtkMTPlyColors.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkType.h"

#include <cstring>
#include <limits>

namespace
{
template <typename Number>
void StoreAs(unsigned char* to, double value)
{
  const Number number = static_cast<Number>(value);
  std::memcpy(to, &number, sizeof(number));
}

template <std::size_t Size>
void CopyValues(
  const unsigned char* from, std::size_t fromStride, std::uint64_t count, unsigned char* to, std::size_t toStride)
{
  for (std::uint64_t i = 0; i < count; ++i)
  {
    std::memcpy(to + i * toStride, from + i * fromStride, Size);
  }
}
}

vtkMTPlyColumns::vtkMTPlyColumns(const vtkMTPlyElement& element, std::uint64_t count)
  : Element(element)
  , Count(count)
  , Targets(element.Properties.size())
{
}

vtkSmartPointer<vtkDataArray> vtkMTPlyColumns::Group(
  const std::vector<std::string>& properties, const char* name, int type)
{
  std::vector<std::size_t> places;
  for (const std::string& property : properties)
  {
    const vtkMTPlyProperty* found = this->Element.Find(property);
    if (!found || found->IsList() || this->Targets[this->IndexOf(found)].Values)
    {
      return nullptr;
    }
    places.push_back(this->IndexOf(found));
  }
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(properties.size()));
  array->SetNumberOfTuples(static_cast<vtkIdType>(this->Count));
  const std::size_t size = vtkMTPlyHeader::GetSize(type);
  // An array without rows may have no address; a target must have one, though nothing will be written there.
  static unsigned char nowhere;
  unsigned char* first = this->Count > 0 ? static_cast<unsigned char*>(array->GetVoidPointer(0)) : nullptr;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    this->Targets[places[i]] = { first ? first + i * size : &nowhere, properties.size() * size, type };
  }
  return array;
}

int vtkMTPlyColumns::FindRealType(const std::vector<std::string>& properties) const
{
  int type = VTK_FLOAT;
  for (const std::string& property : properties)
  {
    const vtkMTPlyProperty* found = this->Element.Find(property);
    const bool isWide =
      found && (found->Type == VTK_DOUBLE || found->Type == VTK_INT || found->Type == VTK_UNSIGNED_INT);
    type = isWide ? VTK_DOUBLE : type;
  }
  return type;
}

void vtkMTPlyColumns::AddColors(const vtkMTPlyColors& colors, vtkDataSetAttributes* attributes)
{
  for (const vtkMTPlyColors::Group& group : colors.GetGroups())
  {
    attributes->AddArray(this->Group(group.GetNames(), group.Array.c_str(), group.GetType()));
  }
  if (!colors.GetGroups().empty())
  {
    attributes->SetActiveScalars(colors.GetGroups().front().Array.c_str());
  }
}

void vtkMTPlyColumns::AddOthers(vtkDataSetAttributes* attributes)
{
  for (std::size_t i = 0; i < this->Targets.size(); ++i)
  {
    const vtkMTPlyProperty& property = this->Element.Properties[i];
    if (property.IsList() || this->Targets[i].Values)
    {
      continue;
    }
    // AddArray would replace, and free, an array of the same name whose values are still to come.
    // VTK's names end at a zero byte, also where a file's go on behind it.
    std::string name = property.Name.c_str();
    while (attributes->HasArray(name.c_str()))
    {
      name += "_";
    }
    attributes->AddArray(this->Group({ property.Name }, name.c_str(), property.Type));
  }
}

void vtkMTPlyColumns::Store(std::size_t property, std::uint64_t row, double value)
{
  const Target& target = this->Targets[property];
  unsigned char* to = target.Values + row * target.Stride;
  switch (target.Type)
  {
    case VTK_SIGNED_CHAR:
      return StoreAs<std::int8_t>(to, value);
    case VTK_UNSIGNED_CHAR:
      return StoreAs<std::uint8_t>(to, value);
    case VTK_SHORT:
      return StoreAs<std::int16_t>(to, value);
    case VTK_UNSIGNED_SHORT:
      return StoreAs<std::uint16_t>(to, value);
    case VTK_INT:
      return StoreAs<std::int32_t>(to, value);
    case VTK_UNSIGNED_INT:
      return StoreAs<std::uint32_t>(to, value);
    case VTK_FLOAT:
      return StoreAs<float>(to, value);
    default:
      return StoreAs<double>(to, value);
  }
}

bool vtkMTPlyColumns::AreAsInFile() const
{
  for (std::size_t i = 0; i < this->Targets.size(); ++i)
  {
    const vtkMTPlyProperty& property = this->Element.Properties[i];
    if (property.IsList() || !this->Targets[i].Values || this->Targets[i].Type != property.Type)
    {
      return false;
    }
  }
  return true;
}

void vtkMTPlyColumns::Copy(const unsigned char* rows, std::uint64_t first, std::uint64_t count)
{
  std::size_t rowSize = 0;
  for (const Target& target : this->Targets)
  {
    rowSize += vtkMTPlyHeader::GetSize(target.Type);
  }
  const unsigned char* from = rows;
  for (const Target& target : this->Targets)
  {
    unsigned char* to = target.Values + first * target.Stride;
    const std::size_t size = vtkMTPlyHeader::GetSize(target.Type);
    switch (size)
    {
      case 1:
        CopyValues<1>(from, rowSize, count, to, target.Stride);
        break;
      case 2:
        CopyValues<2>(from, rowSize, count, to, target.Stride);
        break;
      case 4:
        CopyValues<4>(from, rowSize, count, to, target.Stride);
        break;
      default:
        CopyValues<8>(from, rowSize, count, to, target.Stride);
    }
    from += size;
  }
}

void vtkMTPlyColumns::Blank(std::uint64_t row)
{
  for (std::size_t i = 0; i < this->Targets.size(); ++i)
  {
    const Target& target = this->Targets[i];
    if (target.Values)
    {
      const bool isReal = target.Type == VTK_FLOAT || target.Type == VTK_DOUBLE;
      this->Store(i, row, isReal ? std::numeric_limits<double>::quiet_NaN() : 0.0);
    }
  }
}
