// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfFile.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTGltfMeshopt.h"
#include "vtkMTGltfUri.h"
#include "vtkMTMemoryByteSource.h"

#include <algorithm>
#include <filesystem>

using namespace vtkMTGltfJson;

namespace
{
constexpr std::uint32_t Magic = 0x46546c67;
constexpr std::uint32_t JsonChunk = 0x4e4f534a;
constexpr std::uint32_t BinaryChunk = 0x004e4942;
constexpr std::size_t DecodedViewsLimit = 8;

std::string Name(const char* kind, std::size_t index)
{
  return std::string(kind) + " " + std::to_string(index);
}

std::uint64_t GetEnd(const Json& object, const std::string& where, std::uint64_t size)
{
  const std::uint64_t offset = GetCount(object, "byteOffset", where, 0);
  const std::uint64_t length = GetCount(object, "byteLength", where);
  if (offset > size || length > size - offset)
  {
    Fail(where,
      "bytes " + std::to_string(offset) + " to " + std::to_string(offset + length) + " of a buffer of " +
        std::to_string(size));
  }
  return offset + length;
}

// The file belongs to the caller.
std::shared_ptr<const vtkMTByteSource> Share(const vtkMTByteSource& source)
{
  return std::shared_ptr<const vtkMTByteSource>(std::shared_ptr<const vtkMTByteSource>(), &source);
}
}

//------------------------------------------------------------------------------
void vtkMTGltfFile::Range::Read(std::uint64_t offset, std::size_t count, void* to, const std::string& where) const
{
  std::string error;
  if (offset > this->Length || count > this->Length - offset)
  {
    Fail(where, "lies beyond its bytes");
  }
  if (count > 0 && !this->Source->Read(this->Begin + offset, count, to, error))
  {
    Fail(where, error);
  }
}

std::vector<unsigned char> vtkMTGltfFile::Range::ReadAll(const std::string& where) const
{
  std::vector<unsigned char> bytes(static_cast<std::size_t>(this->Length));
  this->Read(0, bytes.size(), bytes.data(), where);
  return bytes;
}

//------------------------------------------------------------------------------
vtkMTGltfFile::vtkMTGltfFile(const vtkMTByteSource& source)
  : Source(Share(source))
{
  const std::uint64_t size = source.GetSize();
  Range json{ this->Source, 0, size };
  std::uint32_t magic = 0;
  if (size >= sizeof(magic))
  {
    json.Read(0, sizeof(magic), &magic, "the file");
  }
  if (magic == Magic)
  {
    this->ReadBinary(size, json);
  }
  this->Parse(json);
}

// Magic, version and length of all; then chunks: length, type, bytes. Types that are not known are skipped.
void vtkMTGltfFile::ReadBinary(std::uint64_t size, Range& json)
{
  std::uint32_t head[3] = { 0, 0, 0 };
  const Range all{ this->Source, 0, size };
  if (size < sizeof(head))
  {
    throw Error("is truncated");
  }
  all.Read(0, sizeof(head), head, "its head");
  if (head[1] != 2)
  {
    throw Error("is of glTF version " + std::to_string(head[1]) + "; version 2 is read");
  }
  if (head[2] > size)
  {
    throw Error(
      "has " + std::to_string(size) + " bytes and should have " + std::to_string(head[2]) + ": it is truncated");
  }
  std::uint64_t next = sizeof(head);
  for (std::size_t i = 0; next + 8 <= head[2]; ++i)
  {
    std::uint32_t chunk[2];
    all.Read(next, sizeof(chunk), chunk, Name("chunk", i));
    const Range range{ this->Source, next + 8, chunk[0] };
    if (range.Length > head[2] - range.Begin)
    {
      Fail(Name("chunk", i), std::to_string(chunk[0]) + " bytes, more than the file has: it is truncated");
    }
    if (i == 0 && chunk[1] != JsonChunk)
    {
      Fail("chunk 0", "is not the JSON");
    }
    json = i == 0 ? range : json;
    this->Chunk = chunk[1] == BinaryChunk && !this->Chunk.Source ? range : this->Chunk;
    next = range.Begin + range.Length;
  }
  if (next == sizeof(head))
  {
    throw Error("has no chunks: it is truncated");
  }
}

void vtkMTGltfFile::Parse(const Range& json)
{
  try
  {
    const std::vector<unsigned char> text = json.ReadAll("the JSON");
    this->Document = Json::parse(text.begin(), text.end());
  }
  catch (const Json::exception& exception)
  {
    const std::string message = exception.what(); // "[json.exception...] parse error at line 1, ..."
    const std::size_t mark = message.find("] ");
    Fail("the JSON", message.substr(mark == std::string::npos ? 0 : mark + 2));
  }
  const std::string where = "the JSON"; // by its name: to g++ 14 a reference made with a temporary dangles
  const Json& asset = vtkMTGltfJson::GetObject(this->Document, "asset", where);
  const std::string version = GetText(asset, "version");
  const std::string least = GetText(asset, "minVersion", "2.0");
  if (version.empty())
  {
    throw Error("is no glTF: its JSON has no asset with a version");
  }
  if (version.rfind("2.", 0) != 0 || least != "2.0")
  {
    throw Error("is of glTF version " + (least != "2.0" ? least : version) + "; version 2.0 is read");
  }
}

const Json& vtkMTGltfFile::GetItem(const char* list, std::size_t index) const
{
  const Json& items = this->GetList(list);
  if (index >= items.size() || !items[index].is_object())
  {
    Fail("the JSON", Name(list, index) + (index >= items.size() ? " does not exist" : " is no object"));
  }
  return items[index];
}

//------------------------------------------------------------------------------
std::string vtkMTGltfFile::GetPath(const std::string& uri) const
{
  return (std::filesystem::path(this->Source->GetName()).parent_path() / uri).string();
}

vtkMTGltfFile::Range vtkMTGltfFile::OpenUri(const std::string& uri, const std::string& where) const
{
  if (vtkMTGltfUri::HasData(uri))
  {
    std::vector<unsigned char> bytes;
    if (!vtkMTGltfUri::DecodeData(uri, bytes))
    {
      Fail(where, "its data are no base64");
    }
    const std::uint64_t size = bytes.size();
    return { std::make_shared<vtkMTMemoryByteSource>(std::move(bytes)), 0, size };
  }
  const std::string name = vtkMTGltfUri::FromPercent(uri);
  if (name.find("://") != std::string::npos || std::filesystem::path(name).is_absolute())
  {
    Fail(where, "its uri " + uri + " leads elsewhere than to a file beside this one");
  }
  std::string error;
  std::shared_ptr<vtkMTFileByteSource> file = vtkMTFileByteSource::Open(this->GetPath(name), error);
  if (!file && name != uri) // some programs do not encode
  {
    std::string ignored;
    file = vtkMTFileByteSource::Open(this->GetPath(uri), ignored);
  }
  if (!file)
  {
    Fail(where, error);
  }
  return { file, 0, file->GetSize() };
}

vtkMTGltfFile::Range vtkMTGltfFile::OpenBuffer(std::size_t index)
{
  const auto opened = this->Buffers.find(index);
  if (opened != this->Buffers.end())
  {
    return opened->second;
  }
  const std::string where = Name("buffer", index);
  const Json& buffer = this->GetItem("buffers", index);
  const std::uint64_t length = GetCount(buffer, "byteLength", where);
  const std::string uri = GetText(buffer, "uri");
  Range range;
  if (!uri.empty())
  {
    range = this->OpenUri(uri, where);
  }
  else if (index == 0 && this->Chunk.Source)
  {
    range = this->Chunk;
  }
  else
  {
    Fail(where,
      vtkMTGltfMeshopt::FindExtension(buffer)
        ? "has no data, as a fallback of EXT_meshopt_compression, and what is read from it is not compressed"
        : "has neither a uri nor a binary chunk");
  }
  if (range.Length < length)
  {
    const std::string name = uri.empty() ? "the binary chunk" : vtkMTGltfUri::HasData(uri) ? "its uri" : uri;
    Fail(where, name + " has " + std::to_string(range.Length) + " bytes and should have " + std::to_string(length));
  }
  range.Length = length;
  this->Buffers[index] = range;
  return range;
}

vtkMTGltfFile::Range vtkMTGltfFile::OpenView(std::size_t index)
{
  const std::string where = Name("bufferView", index);
  const Json& view = this->GetItem("bufferViews", index);
  const std::size_t buffer = GetIndex(view, "buffer", this->GetSize("buffers"), where);
  const Json* compressed = vtkMTGltfMeshopt::FindExtension(view);
  const bool isFallback = vtkMTGltfMeshopt::FindExtension(this->GetItem("buffers", buffer)) != nullptr;
  if (compressed && (isFallback || vtkMTGltfMeshopt::IsAvailable()))
  {
    GetEnd(view, where, GetCount(this->GetItem("buffers", buffer), "byteLength", Name("buffer", buffer)));
    return this->OpenCompressed(index, *compressed);
  }
  Range range = this->OpenBuffer(buffer);
  const std::uint64_t end = GetEnd(view, where, range.Length);
  range.Length = GetCount(view, "byteLength", where);
  range.Begin += end - range.Length;
  return range;
}

vtkMTGltfFile::Range vtkMTGltfFile::OpenCompressed(std::size_t view, const Json& extension)
{
  const auto found = std::find_if(
    this->Decoded.begin(), this->Decoded.end(), [view](const auto& decoded) { return decoded.first == view; });
  if (found != this->Decoded.end())
  {
    return found->second;
  }
  const std::string where = Name("bufferView", view) + ", EXT_meshopt_compression";
  Range range = this->OpenBuffer(GetIndex(extension, "buffer", this->GetSize("buffers"), where));
  const std::uint64_t end = GetEnd(extension, where, range.Length);
  range.Length = GetCount(extension, "byteLength", where);
  range.Begin += end - range.Length;
  const std::uint64_t length = GetCount(this->GetItem("bufferViews", view), "byteLength", where);
  std::vector<unsigned char> bytes = vtkMTGltfMeshopt::Decode(extension, range.ReadAll(where), length, where);
  const std::uint64_t size = bytes.size();
  this->Decoded.emplace_back(view, Range{ std::make_shared<vtkMTMemoryByteSource>(std::move(bytes)), 0, size });
  Range decoded = this->Decoded.back().second;
  if (this->Decoded.size() > DecodedViewsLimit)
  {
    this->Decoded.pop_front();
  }
  return decoded;
}

std::uint64_t vtkMTGltfFile::GetStride(std::size_t view) const
{
  const std::string where = Name("bufferView", view);
  const Json& object = this->GetItem("bufferViews", view);
  const Json* compressed = vtkMTGltfMeshopt::FindExtension(object);
  const bool isVertices = compressed && GetText(*compressed, "mode") == "ATTRIBUTES";
  return GetCount(isVertices ? *compressed : object, "byteStride", where, 0);
}

std::uint64_t vtkMTGltfFile::GetNumberOfBytes() const
{
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < this->GetSize("buffers"); ++i)
  {
    const Json& buffer = this->GetItem("buffers", i);
    const bool hasBytes = Find(buffer, "uri") || (i == 0 && this->Chunk.Source);
    sum += hasBytes ? std::min<std::uint64_t>(GetCount(buffer, "byteLength", Name("buffer", i)), 1ull << 40) : 0;
  }
  return sum;
}
