// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfAccessor.h"

#include <algorithm>
#include <cstring>
#include <limits>

using namespace vtkMTGltfJson;

namespace
{
constexpr std::size_t BlockLength = 4096;
constexpr std::uint64_t BlockBytes = 1 << 20;

template <typename T>
void ConvertValues(const vtkMTGltfAccessor::Layout& layout, const unsigned char* from, std::size_t count, double* to)
{
  const std::size_t columnSize = layout.GetColumnSize();
  for (std::size_t i = 0; i < count; ++i, from += layout.Stride)
  {
    for (std::size_t column = 0; column < layout.Columns; ++column)
    {
      for (std::size_t row = 0; row < layout.Rows; ++row)
      {
        T value;
        std::memcpy(&value, from + column * columnSize + row * sizeof(T), sizeof(T));
        *to++ = layout.IsNormalized
          ? std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0)
          : static_cast<double>(value);
      }
    }
  }
}
}

//------------------------------------------------------------------------------
// A hint, no more: empty where it is damaged.
static std::vector<double> FindBound(const Json& object, const char* key, std::size_t components)
{
  std::vector<double> values;
  const Json* list = Find(object, key);
  for (std::size_t i = 0; list && list->is_array() && list->size() == components && i < components; ++i)
  {
    values.push_back((*list)[i].is_number() ? (*list)[i].get<double>() : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

std::size_t vtkMTGltfAccessor::Layout::GetSize(int type)
{
  return type == Byte || type == UnsignedByte ? 1 : type == Short || type == UnsignedShort ? 2 : 4;
}

std::size_t vtkMTGltfAccessor::Layout::GetColumnSize() const
{
  const std::size_t size = this->Rows * GetSize(this->Type);
  return this->Columns > 1 ? (size + 3) / 4 * 4 : size;
}

// The last column has no padding.
std::size_t vtkMTGltfAccessor::Layout::GetElementSize() const
{
  return (this->Columns - 1) * this->GetColumnSize() + this->Rows * GetSize(this->Type);
}

void vtkMTGltfAccessor::Layout::Convert(const unsigned char* from, std::size_t count, double* to) const
{
  switch (this->Type)
  {
    case Byte:
      ConvertValues<std::int8_t>(*this, from, count, to);
      break;
    case UnsignedByte:
      ConvertValues<std::uint8_t>(*this, from, count, to);
      break;
    case Short:
      ConvertValues<std::int16_t>(*this, from, count, to);
      break;
    case UnsignedShort:
      ConvertValues<std::uint16_t>(*this, from, count, to);
      break;
    case Int:
      ConvertValues<std::int32_t>(*this, from, count, to);
      break;
    case UnsignedInt:
      ConvertValues<std::uint32_t>(*this, from, count, to);
      break;
    default:
      ConvertValues<float>(*this, from, count, to);
  }
}

//------------------------------------------------------------------------------
void vtkMTGltfAccessor::SetType(const Json& object, Layout& layout, const std::string& where)
{
  const std::uint64_t type = vtkMTGltfJson::GetCount(object, "componentType", where);
  if (type < Byte || type > Float || type == Int)
  {
    Fail(where, "componentType " + std::to_string(type) + " is not known");
  }
  layout.Type = static_cast<int>(type);
}

// Where elements are; that all of them are within their view is checked here.
vtkMTGltfAccessor::Elements vtkMTGltfAccessor::FindElements(
  vtkMTGltfFile& file, const Json& object, Layout layout, std::uint64_t count, bool isStrided) const
{
  Elements elements;
  elements.View = GetIndex(object, "bufferView", file.GetSize("bufferViews"), this->Where);
  elements.Offset = vtkMTGltfJson::GetCount(object, "byteOffset", this->Where, 0);
  const std::uint64_t size = layout.GetElementSize();
  const std::uint64_t packed = layout.Columns > 1 ? layout.Columns * layout.GetColumnSize() : size;
  const std::uint64_t stride = isStrided ? file.GetStride(elements.View) : 0;
  layout.Stride = stride > 0 ? stride : packed;
  elements.How = layout;
  if (layout.Stride < size)
  {
    Fail(this->Where, "elements of " + std::to_string(size) + " bytes lie " + std::to_string(stride) + " bytes apart");
  }
  const std::uint64_t length = file.OpenView(elements.View).Length;
  const bool isInside = elements.Offset <= length && size <= length - elements.Offset &&
    (count - 1) <= (length - elements.Offset - size) / layout.Stride;
  if (!isInside)
  {
    Fail(this->Where,
      std::to_string(count) + " elements from byte " + std::to_string(elements.Offset) +
        " on are more than bufferView " + std::to_string(elements.View) + " holds (" + std::to_string(length) +
        " bytes)");
  }
  return elements;
}

vtkMTGltfAccessor::vtkMTGltfAccessor(vtkMTGltfFile& file, std::size_t index)
  : Where("accessor " + std::to_string(index))
{
  static const struct
  {
    const char* Name;
    std::size_t Rows;
    std::size_t Columns;
  } types[] = { { "SCALAR", 1, 1 }, { "VEC2", 2, 1 }, { "VEC3", 3, 1 }, { "VEC4", 4, 1 }, { "MAT2", 2, 2 },
    { "MAT3", 3, 3 }, { "MAT4", 4, 4 } };
  const Json& object = file.GetItem("accessors", index);
  const std::string name = GetText(object, "type");
  const auto* type = std::find_if(std::begin(types), std::end(types), [&](const auto& t) { return name == t.Name; });
  if (type == std::end(types))
  {
    Fail(this->Where, "type \"" + name + "\" is not known");
  }
  Layout layout;
  SetType(object, layout, this->Where);
  layout.Rows = type->Rows;
  layout.Columns = type->Columns;
  const Json* normalized = Find(object, "normalized");
  layout.IsNormalized = layout.Type != Float && normalized && *normalized == Json(true);
  this->Count = vtkMTGltfJson::GetCount(object, "count", this->Where);
  if (this->Count == 0)
  {
    Fail(this->Where, "\"count\" is 0");
  }
  this->Values.How = layout;
  if (Find(object, "bufferView"))
  {
    this->Values = this->FindElements(file, object, layout, this->Count, true);
  }
  const Json* sparse = Find(object, "sparse");
  if (sparse)
  {
    this->AddSparse(file, *sparse);
  }
  this->Least = FindBound(object, "min", layout.GetComponents());
  this->Largest = FindBound(object, "max", layout.GetComponents());
}

void vtkMTGltfAccessor::AddSparse(vtkMTGltfFile& file, const Json& sparse)
{
  this->SparseCount = vtkMTGltfJson::GetCount(sparse, "count", this->Where);
  if (this->SparseCount == 0 || this->SparseCount > this->Count)
  {
    Fail(
      this->Where, "has " + std::to_string(this->SparseCount) + " sparse elements of " + std::to_string(this->Count));
  }
  Layout ofIndices;
  const Json& indices = vtkMTGltfJson::GetObject(sparse, "indices", this->Where);
  SetType(indices, ofIndices, this->Where);
  if (ofIndices.Type == Float || ofIndices.Type == Byte || ofIndices.Type == Short)
  {
    Fail(this->Where, "sparse indices must be unsigned integers");
  }
  this->SparseIndices = this->FindElements(file, indices, ofIndices, this->SparseCount, false);
  const Json& values = vtkMTGltfJson::GetObject(sparse, "values", this->Where);
  this->SparseValues = this->FindElements(file, values, this->Values.How, this->SparseCount, false);
}

// Of normalized values some programs state the integers, some the numbers.
bool vtkMTGltfAccessor::GetBounds(std::vector<double>& least, std::vector<double>& largest) const
{
  least = this->Least;
  largest = this->Largest;
  if (this->Values.How.IsNormalized)
  {
    std::fill(least.begin(), least.end(), -1.0);
    std::fill(largest.begin(), largest.end(), 1.0);
  }
  return !least.empty() && !largest.empty();
}

//------------------------------------------------------------------------------
void vtkMTGltfAccessor::ReadElements(
  vtkMTGltfFile& file, const Elements& elements, std::uint64_t count, const Consumer& consumer) const
{
  const Layout& layout = elements.How;
  const vtkMTGltfFile::Range range = elements.View == None ? vtkMTGltfFile::Range() : file.OpenView(elements.View);
  const std::size_t longest = elements.View == None
    ? BlockLength
    : std::clamp<std::size_t>(static_cast<std::size_t>(BlockBytes / layout.Stride), 1, BlockLength);
  std::vector<unsigned char> bytes;
  std::vector<double> values(longest * layout.GetComponents(), 0.0);
  for (std::uint64_t first = 0; first < count; first += longest)
  {
    const auto length = static_cast<std::size_t>(std::min<std::uint64_t>(longest, count - first));
    if (elements.View != None)
    {
      bytes.resize((length - 1) * static_cast<std::size_t>(layout.Stride) + layout.GetElementSize());
      range.Read(elements.Offset + first * layout.Stride, bytes.size(), bytes.data(), this->Where);
      layout.Convert(bytes.data(), length, values.data());
    }
    else
    {
      std::fill(values.begin(), values.end(), 0.0);
    }
    consumer(first, length, values.data());
  }
}

void vtkMTGltfAccessor::ReadSparse(
  vtkMTGltfFile& file, std::vector<std::uint64_t>& indices, std::vector<double>& values) const
{
  const std::size_t components = this->GetComponents();
  this->ReadElements(file, this->SparseIndices, this->SparseCount,
    [&](std::uint64_t, std::size_t count, const double* block)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        const auto index = static_cast<std::uint64_t>(block[i]);
        if (index >= this->Count || (!indices.empty() && index <= indices.back()))
        {
          Fail(this->Where, "sparse index " + std::to_string(index) + " is too large, or not above the one before");
        }
        indices.push_back(index);
      }
    });
  this->ReadElements(file, this->SparseValues, this->SparseCount,
    [&](std::uint64_t, std::size_t count, const double* block)
    { values.insert(values.end(), block, block + count * components); });
}

void vtkMTGltfAccessor::Read(vtkMTGltfFile& file, const Consumer& consumer) const
{
  const std::size_t components = this->GetComponents();
  if (!this->HasView() && this->Count > file.GetNumberOfBytes())
  {
    Fail(this->Where, "has " + std::to_string(this->Count) + " elements and no bufferView; the file is smaller");
  }
  if (this->SparseCount == 0)
  {
    this->ReadElements(file, this->Values, this->Count, consumer);
    return;
  }
  std::vector<std::uint64_t> indices;
  std::vector<double> values;
  this->ReadSparse(file, indices, values);
  std::vector<double> mixed;
  std::size_t next = 0;
  this->ReadElements(file, this->Values, this->Count,
    [&](std::uint64_t first, std::size_t count, const double* block)
    {
      mixed.assign(block, block + count * components);
      for (; next < indices.size() && indices[next] < first + count; ++next)
      {
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(next * components), components,
          mixed.begin() + static_cast<std::ptrdiff_t>((indices[next] - first) * components));
      }
      consumer(first, count, mixed.data());
    });
}
