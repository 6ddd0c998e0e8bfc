// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyStream.h"

#include "vtkMTFieldNames.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTPieceStream.h"
#include "vtkMTPlyHeader.h"
#include "vtkMTPlyReader.h"
#include "vtkMTTextFormat.h"

#include "vtkType.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace
{
using Bytes = std::vector<unsigned char>;

void Append(Bytes& bytes, std::string_view text)
{
  bytes.insert(bytes.end(), text.begin(), text.end());
}

//------------------------------------------------------------------------------
// An integer of a binary file.
class IntegerFormat
{
public:
  IntegerFormat(int type, bool isBigEndian)
    : Size(vtkMTPlyHeader::GetSize(type))
    , IsSigned(type == VTK_SIGNED_CHAR || type == VTK_SHORT || type == VTK_INT)
    , IsBigEndian(isBigEndian)
  {
  }
  std::size_t GetSize() const { return this->Size; }

  std::int64_t Load(const unsigned char* bytes) const
  {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      value |= std::uint64_t(bytes[this->IsBigEndian ? this->Size - 1 - i : i]) << (8 * i);
    }
    const int unused = 64 - 8 * static_cast<int>(this->Size);
    return this->IsSigned ? static_cast<std::int64_t>(value << unused) >> unused : static_cast<std::int64_t>(value);
  }
  // A number below 128.
  void Append(Bytes& bytes, unsigned char value) const
  {
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      const bool isLowest = this->IsBigEndian ? i + 1 == this->Size : i == 0;
      bytes.push_back(isLowest ? value : 0);
    }
  }

private:
  std::size_t Size;
  bool IsSigned;
  bool IsBigEndian;
};

//------------------------------------------------------------------------------
class Stream : public vtkMTPieceStream
{
public:
  Stream(std::unique_ptr<vtkMTFileByteSource> bytes, vtkMTSpoolStore* store, std::size_t memory)
    : vtkMTPieceStream(store, memory)
    , File(std::move(bytes))
  {
  }
  const std::vector<std::string>& GetTextureFiles() const { return this->Header.TextureFiles; }

  // Whether this file can be streamed: looks at its header and at every face.
  bool Open()
  {
    if (!this->ReadHeader() || !this->LookAtFaces() || !this->FinishCells())
    {
      return false;
    }
    // All arrays follow from the header: any piece has them.
    vtkNew<vtkPolyData> piece;
    const bool isRead = this->Rewind() && this->ReadPoints(1, piece);
    this->Arrays = GetArraysOf(piece, piece);
    return isRead;
  }

private:
  bool ReadHeader()
  {
    std::string error;
    vtkMTTextFormat::Stream stream(*this->File);
    if (!this->Header.Parse(stream, error) || this->Header.Elements.size() != 2 ||
      this->Header.Elements[0].Name != "vertex" || this->Header.Elements[1].Name != "face")
    {
      return false;
    }
    this->Points = this->Header.Elements[0].Count;
    this->Faces = this->Header.Elements[1].Count;
    const auto& ofVertex = this->Header.Elements[0].Properties;
    const auto& ofFace = this->Header.Elements[1].Properties;
    const auto isList = [](const vtkMTPlyProperty& property) { return property.IsList(); };
    this->List = static_cast<std::size_t>(std::find_if(ofFace.begin(), ofFace.end(), isList) - ofFace.begin());
    if (this->Points < 1 || this->Faces < 1 || std::any_of(ofVertex.begin(), ofVertex.end(), isList) ||
      std::count_if(ofFace.begin(), ofFace.end(), isList) != 1)
    {
      return false;
    }
    const vtkMTPlyProperty& list = ofFace[this->List];
    if ((list.Name != "vertex_indices" && list.Name != "vertex_index") || list.Type == VTK_FLOAT ||
      list.Type == VTK_DOUBLE)
    {
      return false;
    }
    for (const vtkMTPlyProperty& property : ofVertex)
    {
      this->VertexSize += vtkMTPlyHeader::GetSize(property.Type);
    }
    for (std::size_t i = 0; i < ofFace.size(); ++i)
    {
      (i < this->List ? this->BeforeList : this->AfterList) +=
        i == this->List ? 0 : vtkMTPlyHeader::GetSize(ofFace[i].Type);
    }
    constexpr std::size_t largest = vtkMTTextFormat::Stream::LargestPeek;
    return std::max({ this->VertexSize, this->BeforeList, this->AfterList }) <= largest;
  }

  // And whether the file is whole.
  bool LookAtFaces()
  {
    if (!this->RewindFile())
    {
      return false;
    }
    std::string_view line;
    for (std::uint64_t i = 0; this->IsText() && i < this->Points; ++i)
    {
      if (!this->Rows->TakeLine(line))
      {
        return false;
      }
    }
    if (!this->IsText() &&
      (this->Points > this->Rows->GetLeft() / std::max<std::size_t>(this->VertexSize, 1) ||
        !this->Rows->Skip(this->Points * this->VertexSize)))
    {
      return false;
    }
    Bytes row;
    std::vector<std::uint64_t> corners;
    for (std::uint64_t i = 0; i < this->Faces;)
    {
      row.clear();
      corners.clear();
      const std::uint64_t triangles = this->TakeTriangles(this->Faces - i, corners);
      for (std::uint64_t t = 0; t < triangles; ++t)
      {
        this->AddCell(corners.data() + 3 * t, 3);
      }
      if (triangles == 0 && (!this->ReadFace(row, corners) || !this->AddCell(corners.data(), corners.size())))
      {
        return false;
      }
      i += std::max<std::uint64_t>(triangles, 1);
    }
    while (this->IsText() && this->Rows->TakeLine(line))
    {
      if (!vtkMTTextFormat::NextToken(line).empty())
      {
        return false;
      }
    }
    return this->Rows->IsAtEnd();
  }

  bool IsText() const { return this->Header.Format == vtkMTPlyHeader::Ascii; }
  bool IsBigEndian() const { return this->Header.Format == vtkMTPlyHeader::BigEndian; }

  bool RewindFile() override
  {
    std::string error;
    this->Rows = std::make_unique<vtkMTTextFormat::Stream>(*this->File);
    vtkMTPlyHeader header;
    return header.Parse(*this->Rows, error) || this->FailAt(error);
  }

  bool FailAt(const std::string& reason)
  {
    const std::string& error = this->Rows->GetError();
    return this->Fail(this->File->GetName() + ": " + (error.empty() ? reason : error) + " (byte " +
      std::to_string(this->Rows->GetPosition()) + ")");
  }

  // A file by itself: the same elements and properties, with other counts.
  Bytes MakeHeader(std::uint64_t vertices, std::uint64_t faces) const
  {
    Bytes bytes;
    const char* formats[] = { "ascii", "binary_little_endian", "binary_big_endian" };
    Append(bytes, "ply\nformat " + std::string(formats[this->Header.Format]) + " 1.0\n");
    for (const vtkMTPlyElement& element : this->Header.Elements)
    {
      const std::uint64_t count = element.Name == "vertex" ? vertices : faces;
      Append(bytes, "element " + element.Name + " " + std::to_string(count) + "\n");
      for (const vtkMTPlyProperty& property : element.Properties)
      {
        Append(bytes, "property ");
        Append(
          bytes, property.IsList() ? "list " + std::string(vtkMTPlyHeader::GetTypeName(property.CountType)) + " " : "");
        Append(bytes, std::string(vtkMTPlyHeader::GetTypeName(property.Type)) + " " + property.Name + "\n");
      }
    }
    Append(bytes, "end_header\n");
    return bytes;
  }

  bool TakeBytes(std::size_t count, Bytes& bytes)
  {
    const unsigned char* taken = count > 0 ? this->Rows->Take(count) : nullptr;
    if (taken)
    {
      bytes.insert(bytes.end(), taken, taken + count);
    }
    return taken || count == 0;
  }

  bool TakeLine(Bytes& bytes)
  {
    std::string_view line;
    const bool taken = this->Rows->TakeLine(line);
    Append(bytes, line);
    bytes.push_back('\n');
    return taken;
  }

  bool ReadPoints(std::uint64_t count, vtkPolyData* piece) override
  {
    // With one face, whose corners are the first point, so that the faces' arrays are there as well.
    Bytes bytes = this->MakeHeader(count, 1);
    for (std::uint64_t i = 0; i < count; ++i)
    {
      if (!(this->IsText() ? this->TakeLine(bytes) : this->TakeBytes(this->VertexSize, bytes)))
      {
        return this->FailAt("the file ends before its points, or has changed");
      }
    }
    this->AppendPlainFace(bytes);
    return this->ReadPiece(std::move(bytes), piece);
  }

  void AppendPlainFace(Bytes& bytes) const
  {
    const auto& properties = this->Header.Elements[1].Properties;
    if (!this->IsText())
    {
      bytes.insert(bytes.end(), this->BeforeList, 0);
      this->AppendCorners(bytes, { 0, 0, 0 });
      bytes.insert(bytes.end(), this->AfterList, 0);
      return;
    }
    for (std::size_t i = 0; i < properties.size(); ++i)
    {
      Append(bytes, i == this->List ? "3 0 0 0 " : "0 ");
    }
    Append(bytes, "\n");
  }

  void AppendCorners(Bytes& bytes, const std::array<unsigned char, 3>& corners) const
  {
    const vtkMTPlyProperty& list = this->Header.Elements[1].Properties[this->List];
    IntegerFormat(list.CountType, this->IsBigEndian()).Append(bytes, 3);
    for (const unsigned char corner : corners)
    {
      IntegerFormat(list.Type, this->IsBigEndian()).Append(bytes, corner);
    }
  }

  bool ReadCells(std::uint64_t count, vtkPolyData* piece, CellCorners& corners) override
  {
    if (this->Header.Elements[1].Properties.size() == 1)
    {
      return this->ReadCorners(count, corners);
    }
    Bytes bytes = this->MakeHeader(3, count);
    for (int i = 0; i < 3; ++i)
    {
      bytes.insert(bytes.end(), this->IsText() ? 0 : this->VertexSize, 0);
      for (std::size_t p = 0; this->IsText() && p < this->Header.Elements[0].Properties.size(); ++p)
      {
        Append(bytes, "0 ");
      }
      Append(bytes, this->IsText() ? "\n" : "");
    }
    for (std::uint64_t i = 0; i < count; ++i)
    {
      if (!this->ReadFace(bytes, corners.Points))
      {
        return this->FailAt(FacesEnd);
      }
      corners.Ends.push_back(corners.Points.size());
    }
    return this->ReadPiece(std::move(bytes), piece);
  }

  // Of faces that have nothing but corners.
  bool ReadCorners(std::uint64_t count, CellCorners& corners)
  {
    corners.Points.reserve(3 * static_cast<std::size_t>(count));
    corners.Ends.reserve(static_cast<std::size_t>(count));
    for (Bytes row; corners.Ends.size() < count; row.clear())
    {
      const std::size_t before = corners.Points.size();
      const std::uint64_t triangles = this->TakeTriangles(count - corners.Ends.size(), corners.Points);
      for (std::size_t t = 1; t <= triangles; ++t)
      {
        corners.Ends.push_back(before + 3 * t);
      }
      if (triangles == 0 && !this->ReadFace(row, corners.Points))
      {
        return this->FailAt(FacesEnd);
      }
      if (triangles == 0)
      {
        corners.Ends.push_back(corners.Points.size());
      }
    }
    return true;
  }

  // What most files consist of, read at once as far as it is in memory: triangles with their number of corners in one
  // byte, the corners in four each, and nothing else. Gives how many it took; any other face is left to ReadFace.
  std::uint64_t TakeTriangles(std::uint64_t most, std::vector<std::uint64_t>& corners)
  {
    const vtkMTPlyProperty& list = this->Header.Elements[1].Properties[this->List];
    if (this->Header.Format != vtkMTPlyHeader::LittleEndian || this->BeforeList + this->AfterList > 0 ||
      vtkMTPlyHeader::GetSize(list.CountType) != 1 || vtkMTPlyHeader::GetSize(list.Type) != 4)
    {
      return 0;
    }
    constexpr std::size_t rowSize = 13;
    const std::uint64_t range = std::uint64_t(1) << (list.Type == VTK_INT ? 31 : 32);
    const std::uint64_t end = std::min(this->Points, range);
    const auto [bytes, size] = this->Rows->GetBuffered();
    const std::uint64_t rows = std::min<std::uint64_t>(most, size / rowSize);
    std::uint64_t taken = 0;
    for (; taken < rows; ++taken)
    {
      const unsigned char* row = bytes + rowSize * taken;
      const std::array<std::uint64_t, 3> points{ Load32(row + 1), Load32(row + 5), Load32(row + 9) };
      if (row[0] != 3 || points[0] >= end || points[1] >= end || points[2] >= end)
      {
        break;
      }
      corners.insert(corners.end(), points.begin(), points.end());
    }
    this->Rows->Skip(rowSize * taken);
    return taken;
  }

  static std::uint32_t Load32(const unsigned char* bytes)
  {
    return std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8 | std::uint32_t(bytes[2]) << 16 |
      std::uint32_t(bytes[3]) << 24;
  }

  // Appends the next face's corners; to bytes, its values with the corners 0 1 2 in place of its own.
  bool ReadFace(Bytes& bytes, std::vector<std::uint64_t>& corners)
  {
    const std::size_t first = corners.size();
    return (this->IsText() ? this->ReadTextFace(bytes, corners) : this->ReadBinaryFace(bytes, corners)) &&
      std::all_of(corners.begin() + static_cast<std::ptrdiff_t>(first), corners.end(),
        [this](std::uint64_t corner) { return corner < this->Points; }); // negative ones are very large
  }

  bool ReadBinaryFace(Bytes& bytes, std::vector<std::uint64_t>& corners)
  {
    const vtkMTPlyProperty& list = this->Header.Elements[1].Properties[this->List];
    const IntegerFormat countFormat(list.CountType, this->IsBigEndian());
    const IntegerFormat format(list.Type, this->IsBigEndian());
    if (!this->TakeBytes(this->BeforeList, bytes))
    {
      return false;
    }
    const unsigned char* taken = this->Rows->Take(countFormat.GetSize());
    const std::int64_t count = taken ? countFormat.Load(taken) : -1;
    if (count < 0 || static_cast<std::uint64_t>(count) > this->Rows->GetLeft() / format.GetSize())
    {
      return false;
    }
    for (std::int64_t i = 0; i < count; ++i)
    {
      taken = this->Rows->Take(format.GetSize());
      if (!taken)
      {
        return false;
      }
      corners.push_back(static_cast<std::uint64_t>(format.Load(taken)));
    }
    this->AppendCorners(bytes, { 0, 1, 2 });
    return this->TakeBytes(this->AfterList, bytes);
  }

  bool ReadTextFace(Bytes& bytes, std::vector<std::uint64_t>& corners)
  {
    std::string_view line;
    if (!this->Rows->TakeLine(line))
    {
      return false;
    }
    const std::size_t properties = this->Header.Elements[1].Properties.size();
    for (std::size_t i = 0; i < properties; ++i)
    {
      const std::string_view token = vtkMTTextFormat::NextToken(line);
      if (i != this->List)
      {
        Append(bytes, token);
        Append(bytes, " ");
        continue;
      }
      std::int64_t count = 0;
      if (!vtkMTTextFormat::ToNumber(token, count) || count < 0 || static_cast<std::uint64_t>(count) > line.size())
      {
        return false;
      }
      for (std::int64_t c = 0; c < count; ++c)
      {
        std::int64_t corner = 0;
        if (!vtkMTTextFormat::ToNumber(vtkMTTextFormat::NextToken(line), corner))
        {
          return false;
        }
        corners.push_back(static_cast<std::uint64_t>(corner));
      }
      Append(bytes, "3 0 1 2 ");
    }
    Append(bytes, "\n");
    return vtkMTTextFormat::NextToken(line).empty();
  }

  bool ReadPiece(Bytes&& bytes, vtkPolyData* piece)
  {
    std::string reason;
    if (vtkMTPlyReader::Read(vtkMTMemoryByteSource(std::move(bytes)), piece, reason))
    {
      return true;
    }
    return this->FailAt("a piece of it cannot be read: " + reason + ";");
  }

  static constexpr const char* FacesEnd =
    "the file ends before its faces, has a corner that does not exist, or has changed";

  std::unique_ptr<vtkMTFileByteSource> File;
  vtkMTPlyHeader Header;
  std::unique_ptr<vtkMTTextFormat::Stream> Rows; // at the next row
  std::uint64_t Faces = 0;
  std::size_t List = 0;       // which of a face's properties holds its corners
  std::size_t VertexSize = 0; // bytes of a row, where it is binary
  std::size_t BeforeList = 0;
  std::size_t AfterList = 0;
};
}

std::unique_ptr<vtkMTTriangleStream> vtkMTPlyStream::Open(
  const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData* names)
{
  std::string error;
  std::unique_ptr<vtkMTFileByteSource> bytes = vtkMTFileByteSource::Open(path, error);
  char begin[4] = {};
  if (!bytes || bytes->GetSize() < sizeof(begin) || !bytes->Read(0, sizeof(begin), begin, error) ||
    std::memcmp(begin, "ply", 3) != 0)
  {
    return nullptr;
  }
  auto stream = std::make_unique<Stream>(std::move(bytes), settings.Store, settings.Memory);
  if (!stream->Open() || !stream->Rewind() || (!names && !stream->GetTextureFiles().empty()))
  {
    return nullptr;
  }
  vtkMTFieldNames::Add(names, "TextureFiles", stream->GetTextureFiles());
  return stream;
}
