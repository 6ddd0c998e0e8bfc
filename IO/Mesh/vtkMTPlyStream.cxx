// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyStream.h"

#include "vtkMTChunkStream.h"
#include "vtkMTFieldNames.h"
#include "vtkMTGzipByteSource.h"
#include "vtkMTPlyColors.h"
#include "vtkMTPlyFaces.h"
#include "vtkMTPlyHeader.h"
#include "vtkMTPlyRows.h"
#include "vtkMTPlyVertices.h"
#include "vtkMTTextFormat.h"

#include "vtkCellData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace
{
class Stream : public vtkMTChunkStream
{
public:
  Stream(std::unique_ptr<vtkMTByteSource> bytes, vtkMTSpoolStore* store, std::size_t memory)
    : vtkMTChunkStream(store, memory)
    , File(std::move(bytes))
  {
  }
  const std::vector<std::string>& GetTextureFiles() const { return this->Header.TextureFiles; }

  // Whether this file can be read in parts: looks at its header and at every face.
  bool Open()
  {
    if (!this->ReadHeader() || !this->LookAtVertices() || !this->LookAtFaces() || !this->FinishCells())
    {
      return false;
    }
    // All arrays follow from the header.
    const vtkNew<vtkPolyData> one;
    const vtkMTPlyVertices vertices(*this->Vertex, *this->VertexColors, 1, one);
    const vtkMTPlyFaces faces(*this->Face, *this->FaceColors, 1, this->Points, one->GetCellData());
    this->VertexColors->Convert(one->GetPointData());
    this->FaceColors->Convert(one->GetCellData());
    this->Arrays = GetArraysOf(one, one);
    return true;
  }

private:
  bool ReadHeader()
  {
    std::string error;
    vtkMTTextFormat::Stream stream(*this->File);
    if (!this->Header.Parse(stream, error) || !this->Header.CheckIsMesh(error) || this->Header.Elements.size() != 2 ||
      this->Header.Elements[0].Name != "vertex" || this->Header.Elements[1].Name != "face")
    {
      return false;
    }
    this->Vertex = &this->Header.Elements[0];
    this->Face = &this->Header.Elements[1];
    this->Points = this->Vertex->Count;
    this->VertexColors = std::make_unique<vtkMTPlyColors>(*this->Vertex);
    this->FaceColors = std::make_unique<vtkMTPlyColors>(*this->Face);
    const auto countLists = [](const vtkMTPlyElement& element)
    {
      return std::count_if(element.Properties.begin(), element.Properties.end(),
        [](const vtkMTPlyProperty& property) { return property.IsList(); });
    };
    return this->Points > 0 && this->Face->Count > 0 && countLists(*this->Vertex) == 0 && countLists(*this->Face) == 1;
  }

  // In binary there is nothing to see, but where colours must be scaled.
  bool LookAtVertices()
  {
    if (!this->RewindFile())
    {
      return false;
    }
    if (this->Header.Format != vtkMTPlyHeader::Ascii && this->VertexColors->AreAllBytes())
    {
      return this->Rows->SkipRows(this->Points);
    }
    const vtkNew<vtkPolyData> values;
    for (std::uint64_t read = 0; read < this->Points; read += ChunkSize)
    {
      values->Initialize();
      if (!this->ReadVertices(std::min(ChunkSize, this->Points - read), values))
      {
        return false;
      }
      this->VertexColors->Look(values->GetPointData());
    }
    this->VertexColors->Count(this->Points, this->Report);
    return true;
  }

  // And whether the file is whole.
  bool LookAtFaces()
  {
    const vtkNew<vtkPolyData> values;
    vtkMTCellCorners corners;
    for (std::uint64_t read = 0; read < this->Face->Count; read += ChunkSize)
    {
      corners.Points.clear();
      corners.Ends.clear();
      values->Initialize();
      if (!this->ReadFaces(std::min(ChunkSize, this->Face->Count - read), values, corners))
      {
        return false;
      }
      this->FaceColors->Look(values->GetCellData());
      std::size_t begin = 0;
      for (const std::size_t end : corners.Ends)
      {
        if (!this->AddCell(corners.Points.data() + begin, end - begin))
        {
          return false;
        }
        begin = end;
      }
    }
    this->FaceColors->Count(this->Face->Count, this->Report);
    vtkMTInputReports::Add(this->Header.GetReport(), this->Report);
    vtkMTInputReports::Add(this->Rows->GetReport(), this->Report);
    std::string error;
    return this->Rows->CheckIsAtEnd(error);
  }

  bool RewindFile() override
  {
    std::string error;
    this->Bytes = std::make_unique<vtkMTTextFormat::Stream>(*this->File);
    this->Rows = std::make_unique<vtkMTPlyRows>(*this->Bytes, this->Header);
    this->IsAtFaces = false;
    vtkMTPlyHeader header; // steps over it; that of the first time is the one to go by
    return header.Parse(*this->Bytes, error) ? this->Rows->BeginElement(*this->Vertex) || this->FailInRow()
                                             : this->Fail(this->File->GetName() + ": " + error);
  }

  bool FailInRow() { return this->Fail(this->File->GetName() + ": " + this->Rows->GetError()); }

  // Colours as the file has them.
  bool ReadVertices(std::uint64_t count, vtkPolyData* chunk)
  {
    return vtkMTPlyVertices(*this->Vertex, *this->VertexColors, count, chunk).Read(*this->Rows) || this->FailInRow();
  }

  bool ReadFaces(std::uint64_t count, vtkPolyData* chunk, vtkMTCellCorners& corners)
  {
    this->IsAtFaces = this->IsAtFaces || this->Rows->BeginElement(*this->Face);
    return (this->IsAtFaces &&
             vtkMTPlyFaces(*this->Face, *this->FaceColors, count, this->Points, chunk->GetCellData())
               .Read(*this->Rows, corners)) ||
      this->FailInRow();
  }

  bool ReadPoints(std::uint64_t count, vtkPolyData* chunk) override
  {
    const bool isRead = this->ReadVertices(count, chunk);
    this->VertexColors->Convert(chunk->GetPointData());
    return isRead;
  }

  bool ReadCells(std::uint64_t count, vtkPolyData* chunk, vtkMTCellCorners& corners) override
  {
    const bool isRead = this->ReadFaces(count, chunk, corners);
    this->FaceColors->Convert(chunk->GetCellData());
    return isRead;
  }

  std::unique_ptr<vtkMTByteSource> File;
  vtkMTPlyHeader Header;
  const vtkMTPlyElement* Vertex = nullptr;
  const vtkMTPlyElement* Face = nullptr;
  std::unique_ptr<vtkMTPlyColors> VertexColors;
  std::unique_ptr<vtkMTPlyColors> FaceColors;
  std::unique_ptr<vtkMTTextFormat::Stream> Bytes;
  std::unique_ptr<vtkMTPlyRows> Rows; // at the next row
  bool IsAtFaces = false;
};
}

std::unique_ptr<vtkMTTriangleStream> vtkMTPlyStream::Open(
  const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData* names)
{
  std::string error;
  std::unique_ptr<vtkMTByteSource> bytes = vtkMTGzipByteSource::OpenFile(path, error);
  char begin[6] = {};
  if (!bytes || bytes->GetSize() < sizeof(begin) || !bytes->Read(0, sizeof(begin), begin, error) ||
    std::memcmp(begin + vtkMTTextFormat::GetByteOrderMarkSize({ begin, sizeof(begin) }), "ply", 3) != 0)
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
