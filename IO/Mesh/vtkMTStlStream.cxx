// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlStream.h"

#include "vtkMTChunkStream.h"
#include "vtkMTGzipByteSource.h"
#include "vtkMTStlBinary.h"
#include "vtkMTStlText.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace
{
// Each triangle has three points of its own.
class Stream : public vtkMTChunkStream
{
public:
  explicit Stream(std::unique_ptr<vtkMTByteSource> bytes)
    : Bytes(std::move(bytes))
  {
  }

protected:
  // The arrays of some triangles.
  virtual bool ReadCellArrays(std::uint64_t first, std::uint64_t count, vtkPolyData* chunk) = 0;

  bool AddTriangles(std::uint64_t count)
  {
    bool good = true;
    for (std::uint64_t t = 0; good && t < count; ++t)
    {
      const std::uint64_t corners[3] = { 3 * t, 3 * t + 1, 3 * t + 2 };
      good = this->AddCell(corners, 3);
    }
    this->Points = 3 * count;
    const vtkNew<vtkPolyData> one;
    good = good && count > 0 && this->ReadCellArrays(0, 1, one);
    this->Arrays = GetArraysOf(one, one);
    return good;
  }

  bool RewindFile() override
  {
    this->NextCorner = 0;
    return true;
  }

  bool ReadCells(std::uint64_t count, vtkPolyData* chunk, vtkMTCellCorners& corners) override
  {
    const std::uint64_t first = this->NextCorner / 3;
    for (std::uint64_t t = 0; t < count; ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        corners.Points.push_back(this->NextCorner++);
      }
      corners.Ends.push_back(corners.Points.size());
    }
    return this->ReadCellArrays(first, count, chunk);
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

  std::unique_ptr<vtkMTByteSource> Bytes;

private:
  std::uint64_t NextCorner = 0;
};

//------------------------------------------------------------------------------
class BinaryStream : public Stream
{
public:
  explicit BinaryStream(std::unique_ptr<vtkMTByteSource> bytes)
    : Stream(std::move(bytes))
    , File(*this->Bytes)
  {
  }

  bool HasSize() const { return this->File.HasSize(); }

  bool Open()
  {
    const bool isOpen = this->File.Open(this->Error);
    this->Report = this->File.GetReport();
    return isOpen && this->AddTriangles(this->File.GetNumberOfTriangles());
  }

private:
  bool RewindFile() override
  {
    this->NextTriangle = 0;
    return Stream::RewindFile();
  }

  bool ReadPoints(std::uint64_t count, vtkPolyData* chunk) override
  {
    // Triangles are not divided.
    static_assert(ChunkSize % 3 == 0, "a chunk of points is one of triangles");
    std::vector<float> values(static_cast<std::size_t>(3 * count));
    if (!this->File.ReadCoordinates(this->NextTriangle, count / 3, values.data(), this->Error))
    {
      return false;
    }
    this->NextTriangle += count / 3;
    Fill(values.data(), count, chunk);
    return true;
  }

  bool ReadCellArrays(std::uint64_t first, std::uint64_t count, vtkPolyData* chunk) override
  {
    return this->File.ReadCells(first, count, chunk, this->Error);
  }

  vtkMTStlBinary File;
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
    this->Solids = this->Text->GetSolids();
    this->Report = this->Text->GetReport();
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

  bool ReadCellArrays(std::uint64_t first, std::uint64_t count, vtkPolyData* chunk) override
  {
    this->Solids.AddIds(first, count, chunk->GetCellData());
    return true;
  }

  std::unique_ptr<vtkMTTextFormat::Stream> Lines;
  std::unique_ptr<vtkMTStlText> Text;
  vtkMTStlSolids Solids; // of the whole file
};

template <typename Kind>
std::unique_ptr<vtkMTTriangleStream> Finish(std::unique_ptr<Kind> stream)
{
  return stream->Open() && stream->Rewind() ? std::move(stream) : nullptr;
}
}

std::unique_ptr<vtkMTTriangleStream> vtkMTStlStream::Open(
  const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData*)
{
  std::string error;
  std::unique_ptr<vtkMTByteSource> bytes = vtkMTGzipByteSource::OpenFile(path, error);
  char head[512] = {};
  const std::size_t size =
    bytes ? static_cast<std::size_t>(std::min<std::uint64_t>(bytes->GetSize(), sizeof(head))) : 0;
  if (size < 6 || !bytes->Read(0, size, head, error))
  {
    return nullptr;
  }
  const bool isLarge = bytes->GetSize() >= settings.LeastSize;
  auto binary = std::make_unique<BinaryStream>(std::move(bytes));
  if (binary->HasSize() || !vtkMTStlText::IsText(std::string_view(head, size)))
  {
    return Finish(std::move(binary));
  }
  bytes = isLarge ? vtkMTGzipByteSource::OpenFile(path, error) : nullptr;
  return bytes ? Finish(std::make_unique<TextStream>(std::move(bytes))) : nullptr;
}
