// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlStream.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTPieceStream.h"
#include "vtkMTStlReader.h"
#include "vtkMTTextFormat.h"

#include <cstring>
#include <utility>

namespace
{
constexpr std::uint64_t HeadSize = 84; // a text of 80 bytes and the number of triangles
constexpr std::uint64_t RecordSize = 50;

// Each triangle has three points of its own.
class Stream : public vtkMTPieceStream
{
public:
  Stream(std::unique_ptr<vtkMTFileByteSource> bytes, std::uint64_t triangles)
    : Bytes(std::move(bytes))
  {
    this->Triangles = triangles;
    this->Points = 3 * triangles;
  }

private:
  bool RewindFile() override
  {
    this->NextPoint = 0;
    this->NextTriangle = 0;
    return true;
  }

  bool ReadPoints(std::uint64_t count, vtkPolyData* piece) override
  {
    // Triangles are not cut.
    static_assert(PieceSize % 3 == 0, "a piece of points is one of triangles");
    const std::uint64_t first = this->NextPoint / 3;
    this->NextPoint += count;
    return this->Read(first, count / 3, piece);
  }

  bool ReadTriangles(std::uint64_t count, vtkPolyData* piece, std::vector<Corners>& corners) override
  {
    const std::uint64_t first = this->NextTriangle;
    this->NextTriangle += count;
    for (std::uint64_t t = first; t < first + count; ++t)
    {
      corners.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
    }
    return this->Read(first, count, piece);
  }

  bool Read(std::uint64_t first, std::uint64_t count, vtkPolyData* piece)
  {
    std::vector<unsigned char> bytes(static_cast<std::size_t>(HeadSize + count * RecordSize), 0);
    const auto number = static_cast<std::uint32_t>(count);
    std::memcpy(bytes.data() + 80, &number, sizeof(number));
    return this->Bytes->Read(
             HeadSize + first * RecordSize, bytes.size() - HeadSize, bytes.data() + HeadSize, this->Error) &&
      vtkMTStlReader::Read(vtkMTMemoryByteSource(std::move(bytes)), piece, this->Error);
  }

  std::unique_ptr<vtkMTFileByteSource> Bytes;
  std::uint64_t NextPoint = 0;
  std::uint64_t NextTriangle = 0;
};
}

std::unique_ptr<vtkMTTriangleStream> vtkMTStlStream::Open(const std::string& path)
{
  std::string error;
  std::unique_ptr<vtkMTFileByteSource> bytes = vtkMTFileByteSource::Open(path, error);
  unsigned char head[HeadSize];
  std::uint32_t count = 0;
  if (vtkMTTextFormat::GetLowerCaseEnding(path) != "stl" || !bytes || bytes->GetSize() < HeadSize ||
    !bytes->Read(0, HeadSize, head, error))
  {
    return nullptr;
  }
  std::memcpy(&count, head + 80, sizeof(count));
  if (count == 0 || bytes->GetSize() != HeadSize + count * RecordSize)
  {
    return nullptr;
  }
  return std::make_unique<Stream>(std::move(bytes), count);
}
