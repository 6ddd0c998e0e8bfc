// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyGltfFile.h"

#include "vtkMTVerifyText.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace
{
std::uint64_t ReadLittle(const std::string& bytes, std::size_t at, std::size_t size)
{
  std::uint64_t value = 0;
  for (std::size_t i = size; i-- > 0;)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

std::string DecodePercent(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const std::string digits = uri[i] == '%' ? uri.substr(i + 1, 2) : "";
    const bool isCode = digits.size() == 2 && digits.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
    text += isCode ? static_cast<char>(std::stoi(digits, nullptr, 16)) : uri[i];
    i += isCode ? 2 : 0;
  }
  return text;
}

std::string DecodeBase64(std::string_view text)
{
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (char c : text)
  {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos)
    {
      continue;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>(bits >> count & 255);
    }
  }
  return bytes;
}

// Bytes of a component; 0 for a type that glTF does not have.
std::size_t GetSize(double type)
{
  return type == 5120 || type == 5121 ? 1 : (type == 5122 || type == 5123 ? 2 : (type == 5125 || type == 5126 ? 4 : 0));
}

double Convert(std::uint64_t bits, double type, bool isNormalized)
{
  if (type == 5126)
  {
    const auto low = static_cast<std::uint32_t>(bits);
    float value = 0.0f;
    std::memcpy(&value, &low, sizeof(value));
    return value;
  }
  const int size = static_cast<int>(8 * GetSize(type));
  const bool isSigned = type == 5120 || type == 5122;
  double value = static_cast<double>(bits);
  value -= isSigned && (bits >> (size - 1)) != 0 ? std::ldexp(1.0, size) : 0.0;
  const double largest = std::ldexp(1.0, isSigned ? size - 1 : size) - 1.0;
  return isNormalized ? std::max(value / largest, -1.0) : value;
}

std::size_t GetComponents(const std::string& type)
{
  const std::pair<const char*, std::size_t> types[] = { { "SCALAR", 1 }, { "VEC2", 2 }, { "VEC3", 3 }, { "VEC4", 4 } };
  for (const auto& [name, components] : types)
  {
    if (type == name)
    {
      return components;
    }
  }
  return 0;
}

constexpr double CountLimit = 4e9;
}

bool vtkMTVerifyGltfFile::Open(const std::string& path, std::string& error)
{
  this->Path = path;
  std::string bytes;
  if (!vtkMTVerifyText::Load(path, bytes, error))
  {
    return false;
  }
  std::string text = bytes;
  if (bytes.compare(0, 4, "glTF") == 0 && bytes.size() >= 20)
  {
    std::size_t at = 12;
    for (int chunk = 0; at + 8 <= bytes.size(); ++chunk)
    {
      const std::size_t size = ReadLittle(bytes, at, 4);
      const std::string type = bytes.substr(at + 4, 4);
      if (chunk == 0)
      {
        text = bytes.substr(at + 8, size);
      }
      else if (type.compare(0, 3, "BIN") == 0 && !this->HasBinary)
      {
        this->Binary = bytes.substr(at + 8, size);
        this->HasBinary = true;
      }
      at += 8 + size;
    }
  }
  if (!vtkMTVerifyJson::Parse(text, this->Root) || this->Root.Type != vtkMTVerifyJson::Object)
  {
    error = "its JSON is broken";
    return false;
  }
  this->Buffers.resize(this->Root.Get("buffers").Items.size());
  this->IsRead.assign(this->Buffers.size(), false);
  return true;
}

const std::string* vtkMTVerifyGltfFile::GetBuffer(double index, std::string& error)
{
  const vtkMTVerifyJson& buffer = this->Root.Get("buffers").At(index);
  if (buffer.Type != vtkMTVerifyJson::Object)
  {
    error = "names a buffer that is not there";
    return nullptr;
  }
  const auto i = static_cast<std::size_t>(index);
  if (this->IsRead[i])
  {
    return &this->Buffers[i];
  }
  const std::string& uri = buffer.Get("uri").String;
  if (uri.compare(0, 5, "data:") == 0)
  {
    this->Buffers[i] = DecodeBase64(std::string_view(uri).substr(std::min(uri.find(',') + 1, uri.size())));
  }
  else if (!uri.empty())
  {
    if (!vtkMTVerifyText::Load(vtkMTVerifyText::GetFolder(this->Path) + DecodePercent(uri), this->Buffers[i], error))
    {
      return nullptr;
    }
  }
  else if (i == 0 && this->HasBinary)
  {
    this->Buffers[i] = this->Binary;
  }
  else
  {
    error = "has a buffer without bytes";
    return nullptr;
  }
  this->IsRead[i] = true;
  return &this->Buffers[i];
}

bool vtkMTVerifyGltfFile::ReadNumbers(const vtkMTVerifyJson& where, double componentType, std::size_t components,
  std::size_t count, bool isNormalized, std::vector<double>& values, std::string& error)
{
  const vtkMTVerifyJson& view = this->Root.Get("bufferViews").At(where.GetNumber("bufferView", -1.0));
  for (const auto& extension : view.Get("extensions").Members)
  {
    if (extension.first.find("compression") != std::string::npos)
    {
      error = "is compressed by " + extension.first;
      return false;
    }
  }
  const std::string* const bytes = this->GetBuffer(view.GetNumber("buffer", -1.0), error);
  if (!bytes)
  {
    return false;
  }
  const std::size_t size = GetSize(componentType);
  const double start = view.GetNumber("byteOffset", 0.0) + where.GetNumber("byteOffset", 0.0);
  const double stride = view.GetNumber("byteStride", static_cast<double>(size * components));
  const double end = start + stride * (static_cast<double>(count) - 1.0) + static_cast<double>(size * components);
  if (size == 0 || start < 0.0 || stride < 0.0 || (count > 0 && end > static_cast<double>(bytes->size())))
  {
    error = "has an accessor beyond its buffer";
    return false;
  }
  values.resize(count * components);
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto at = static_cast<std::size_t>(start + stride * static_cast<double>(i));
    for (std::size_t c = 0; c < components; ++c)
    {
      values[i * components + c] = Convert(ReadLittle(*bytes, at + c * size, size), componentType, isNormalized);
    }
  }
  return true;
}

bool vtkMTVerifyGltfFile::Substitute(
  const vtkMTVerifyJson& sparse, double componentType, bool isNormalized, Accessor& accessor, std::string& error)
{
  const double count = sparse.GetNumber("count", 0.0);
  if (!(count >= 0.0) || count > static_cast<double>(accessor.Count))
  {
    error = "has a sparse accessor of too many values";
    return false;
  }
  const auto components = static_cast<std::size_t>(accessor.Components);
  const vtkMTVerifyJson& indices = sparse.Get("indices");
  std::vector<double> where, values;
  if (!this->ReadNumbers(
        indices, indices.GetNumber("componentType", 0.0), 1, static_cast<std::size_t>(count), false, where, error) ||
    !this->ReadNumbers(
      sparse.Get("values"), componentType, components, static_cast<std::size_t>(count), isNormalized, values, error))
  {
    return false;
  }
  for (std::size_t i = 0; i < where.size(); ++i)
  {
    if (where[i] >= static_cast<double>(accessor.Count))
    {
      error = "has a sparse accessor with an index out of range";
      return false;
    }
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
      accessor.Values.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(where[i]) * components));
  }
  return true;
}

bool vtkMTVerifyGltfFile::Read(double index, Accessor& accessor, std::string& error)
{
  const vtkMTVerifyJson& json = this->Root.Get("accessors").At(index);
  const double type = json.GetNumber("componentType", 0.0);
  const std::size_t components = GetComponents(json.Get("type").String);
  const double count = json.GetNumber("count", -1.0);
  if (components == 0 || GetSize(type) == 0 || !(count >= 0.0) || count > CountLimit)
  {
    error = "has an accessor that is none";
    return false;
  }
  const bool isNormalized = json.GetNumber("normalized", 0.0) != 0.0;
  accessor.Components = static_cast<int>(components);
  accessor.Count = static_cast<std::size_t>(count);
  if (json.Has("bufferView"))
  {
    if (!this->ReadNumbers(json, type, components, accessor.Count, isNormalized, accessor.Values, error))
    {
      return false;
    }
  }
  else
  {
    accessor.Values.assign(accessor.Count * components, 0.0);
  }
  return !json.Has("sparse") || this->Substitute(json.Get("sparse"), type, isNormalized, accessor, error);
}
