// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlStream.h"

#include "vtkMTChunkStream.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTStlText.h"

#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <utility>

namespace
{
constexpr std::uint64_t HeadSize = 84; // a text of 80 bytes and the number of triangles
constexpr std::uint64_t RecordSize = 50;

// Each triangle has three points of its own, and nothing else.
class Stream : public vtkMTChunkStream
{
public:
  explicit Stream(std::unique_ptr<vtkMTFileByteSource> bytes)
    : Bytes(std::move(bytes))
  {
  }

protected:
  bool AddTriangles(std::uint64_t count)
  {
    bool good = true;
    for (std::uint64_t t = 0; good && t < count; ++t)
    {
      const std::uint64_t corners[3] = { 3 * t, 3 * t + 1, 3 * t + 2 };
      good = this->AddCell(corners, 3);
    }
    this->Points = 3 * count;
    return good && count > 0;
  }

  bool RewindFile() override
  {
    this->NextCorner = 0;
    return true;
  }

  bool ReadCells(std::uint64_t count, vtkPolyData*, vtkMTCellCorners& corners) override
  {
    for (std::uint64_t t = 0; t < count; ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        corners.Points.push_back(this->NextCorner++);
      }
      corners.Ends.push_back(corners.Points.size());
    }
    return true;
  }

  static void Fill(const float* values, std::uint64_t count, vtkPolyData* chunk)
  {
    vtkNew<vtkFloatArray> coordinates;
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(count));
    std::copy_n(values, 3 * count, coordinates->GetPointer(0));
    vtkNew<vtkPoints> points;
    points->SetData(coordinates);
    chunk->SetPoints(points);
  }

  std::unique_ptr<vtkMTFileByteSource> Bytes;

private:
  std::uint64_t NextCorner = 0;
};

//------------------------------------------------------------------------------
class BinaryStream : public Stream
{
public:
  using Stream::Stream;

  // Whether the file has the size that it says.
  bool Open()
  {
    unsigned char head[HeadSize];
    std::uint32_t count = 0;
    if (this->Bytes->GetSize() < HeadSize || !this->Bytes->Read(0, HeadSize, head, this->Error))
    {
      return false;
    }
    std::memcpy(&count, head + 80, sizeof(count));
    return this->Bytes->GetSize() == HeadSize + count * RecordSize && this->AddTriangles(count);
  }

private:
  bool RewindFile() override
  {
    this->NextTriangle = 0;
    return Stream::RewindFile();
  }

  bool ReadPoints(std::uint64_t count, vtkPolyData* chunk) override
  {
    // Triangles are not cut.
    static_assert(ChunkSize % 3 == 0, "a chunk of points is one of triangles");
    std::vector<unsigned char> records(static_cast<std::size_t>(count / 3 * RecordSize));
    if (!this->Bytes->Read(HeadSize + this->NextTriangle * RecordSize, records.size(), records.data(), this->Error))
    {
      return false;
    }
    this->NextTriangle += count / 3;
    std::vector<float> values(static_cast<std::size_t>(3 * count));
    for (std::size_t t = 0; t < count / 3; ++t)
    {
      std::memcpy(values.data() + 9 * t, records.data() + t * RecordSize + 12, 36); // after the normal
    }
    Fill(values.data(), count, chunk);
    return true;
  }

  std::uint64_t NextTriangle = 0;
};

//------------------------------------------------------------------------------
class TextStream : public Stream
{
public:
  using Stream::Stream;

  // Reads the whole file once.
  bool Open()
  {
    std::vector<float> values;
    std::uint64_t count = 0;
    this->RewindFile();
    do
    {
      values.clear();
      if (!this->Text->Read(static_cast<std::size_t>(ChunkSize), values))
      {
        return false;
      }
      count += values.size() / 9;
    } while (!values.empty());
    return this->AddTriangles(count);
  }

private:
  bool RewindFile() override
  {
    this->Lines = std::make_unique<vtkMTTextFormat::Stream>(*this->Bytes);
    this->Text = std::make_unique<vtkMTStlText>(*this->Lines);
    return Stream::RewindFile();
  }

  bool ReadPoints(std::uint64_t count, vtkPolyData* chunk) override
  {
    std::vector<float> values;
    if (!this->Text->Read(static_cast<std::size_t>(count), values) || values.size() != 3 * count)
    {
      return this->Fail(this->Bytes->GetName() + ": " +
        (this->Text->GetError().empty() ? "ends before its triangles: it has changed" : this->Text->GetError()));
    }
    Fill(values.data(), count, chunk);
    return true;
  }

  std::unique_ptr<vtkMTTextFormat::Stream> Lines;
  std::unique_ptr<vtkMTStlText> Text;
};

template <typename Kind>
std::unique_ptr<vtkMTTriangleStream> OpenAs(std::unique_ptr<vtkMTFileByteSource> bytes)
{
  auto stream = std::make_unique<Kind>(std::move(bytes));
  return stream->Open() && stream->Rewind() ? std::move(stream) : nullptr;
}
}

std::unique_ptr<vtkMTTriangleStream> vtkMTStlStream::Open(
  const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData*)
{
  std::string error;
  auto bytes = vtkMTFileByteSource::Open(path, error);
  char head[HeadSize] = {};
  if (!bytes || bytes->GetSize() < 6 ||
    !bytes->Read(0, static_cast<std::size_t>(std::min(bytes->GetSize(), HeadSize)), head, error))
  {
    return nullptr;
  }
  const bool isLarge = bytes->GetSize() >= settings.LeastSize;
  std::unique_ptr<vtkMTTriangleStream> stream = OpenAs<BinaryStream>(std::move(bytes));
  if (!stream && isLarge && vtkMTStlText::IsText(std::string_view(head, HeadSize)))
  {
    bytes = vtkMTFileByteSource::Open(path, error);
    stream = bytes ? OpenAs<TextStream>(std::move(bytes)) : nullptr;
  }
  return stream;
}
