// SPDX-License-Identifier: BSD-3-Clause
// A glTF 2.0 file, .gltf or .glb: its JSON, its buffers and the views into them. Not installed.
//
// The binary form is told by its content. Buffers are files beside the .gltf or below (".." is followed, an absolute
// name or another scheme is not), data in the uri, or the binary chunk; they are opened when they are first wanted, so
// what only an animation needs may be missing. Views that EXT_meshopt_compression holds are decoded in memory; the last
// few are kept, as several accessors share one. All functions throw vtkMTGltfJson::Error.
#ifndef vtkMTGltfFile_h
#define vtkMTGltfFile_h

#include "vtkMTByteSource.h"
#include "vtkMTGltfJson.h"

#include <deque>
#include <map>
#include <memory>

class vtkMTGltfFile
{
public:
  using Json = vtkMTGltfJson::Json;

  /// Bytes in a row.
  struct Range
  {
    std::shared_ptr<const vtkMTByteSource> Source;
    std::uint64_t Begin = 0;
    std::uint64_t Length = 0;

    /// Checked: within the range.
    void Read(std::uint64_t offset, std::size_t count, void* to, const std::string& where) const;
    std::vector<unsigned char> ReadAll(const std::string& where) const;
  };

  /// Reads the JSON; refuses other versions of glTF. The source must outlive the file.
  explicit vtkMTGltfFile(const vtkMTByteSource& source);

  const Json& GetDocument() const { return this->Document; }
  /// document[list][index]
  const Json& GetItem(const char* list, std::size_t index) const;
  std::size_t GetSize(const char* list) const { return this->GetList(list).size(); }
  const Json& GetList(const char* list) const { return vtkMTGltfJson::GetList(this->Document, list, "the JSON"); }

  Range OpenBuffer(std::size_t index);
  Range OpenView(std::size_t index);
  /// The stride that a view gives to its accessors; 0 for none.
  std::uint64_t GetStride(std::size_t view) const;
  /// The sum of what the buffers hold: nothing that has no bytes of its own may be longer.
  std::uint64_t GetNumberOfBytes() const;

  /// Where a uri leads, from the folder of the file.
  std::string GetPath(const std::string& uri) const;

private:
  void ReadBinary(std::uint64_t size, Range& json);
  void Parse(const Range& json);
  Range OpenUri(const std::string& uri, const std::string& where) const;
  Range OpenCompressed(std::size_t view, const Json& extension);

  const std::shared_ptr<const vtkMTByteSource> Source;
  Json Document;
  Range Chunk; // the binary one
  std::map<std::size_t, Range> Buffers;
  std::deque<std::pair<std::size_t, Range>> Decoded;
};

#endif
