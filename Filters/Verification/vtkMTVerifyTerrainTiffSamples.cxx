// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyTerrainTiffSamples.h"

#include "vtkMTVerifyTerrainTiff.h"
#include "vtkMTVerifyTerrainTile.h"
#include "vtkMTVerifyVolumeBytes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace vtkMTVerifyVolumeBytes;

namespace
{
constexpr int NoCompression = 1, Lzw = 5, Deflate = 8, PackBits = 32773, OldDeflate = 32946;

void UnpackBits(const unsigned char* data, std::size_t size, Bytes& block, std::size_t limit)
{
  for (std::size_t i = 0; i < size && block.size() < limit;)
  {
    const int n = static_cast<signed char>(data[i++]);
    if (n >= 0)
    {
      const std::size_t count = std::min<std::size_t>(static_cast<std::size_t>(n) + 1, size - i);
      block.insert(block.end(), data + i, data + i + count);
      i += count;
    }
    else if (n != -128 && i < size)
    {
      block.insert(block.end(), static_cast<std::size_t>(1 - n), data[i++]);
    }
  }
}

/// TIFF's LZW: codes of 9 to 12 bits, the highest bit first; their length grows one code early.
class LzwDecoder
{
public:
  LzwDecoder(const unsigned char* data, std::size_t size, Bytes& block)
    : Data(data)
    , Size(size)
    , Block(block)
  {
  }

  /// False where a code is none, or the data ends before its last code and before limit bytes.
  bool Decode(std::size_t limit)
  {
    while (this->Block.size() < limit)
    {
      const unsigned int code = this->ReadCode();
      if (code == End)
      {
        return true;
      }
      if (code == Clear)
      {
        this->Next = First;
        this->LastLength = 0;
      }
      else if (!this->Append(code))
      {
        return false;
      }
    }
    return true;
  }

private:
  static constexpr unsigned int Clear = 256, End = 257, First = 258, None = 4096;

  unsigned int ReadCode()
  {
    const unsigned int bits = this->Next >= 2047 ? 12 : this->Next >= 1023 ? 11 : this->Next >= 511 ? 10 : 9;
    for (; this->There < bits && this->At < this->Size; this->There += 8)
    {
      this->Window = this->Window << 8 | this->Data[this->At++];
    }
    if (this->There < bits)
    {
      return None;
    }
    this->There -= bits;
    return this->Window >> this->There & ((1U << bits) - 1);
  }

  bool Append(unsigned int code)
  {
    const std::size_t start = this->Block.size();
    // The code that is made just now stands for the last text and its own first letter.
    const bool isNew = code == this->Next && this->LastLength > 0;
    if (code >= None || (code >= this->Next && !isNew))
    {
      return false;
    }
    const std::size_t from = isNew ? this->LastStart : this->Starts[code];
    const std::size_t length = code < Clear ? 1 : isNew ? this->LastLength + 1 : this->Lengths[code];
    for (std::size_t k = 0; k < length; ++k)
    {
      const unsigned char letter = code < Clear ? static_cast<unsigned char>(code) : this->Block[from + k];
      this->Block.push_back(letter);
    }
    if (this->LastLength > 0 && this->Next < None)
    {
      // The last text and the first letter of this one follow each other in the block.
      this->Starts[this->Next] = this->LastStart;
      this->Lengths[this->Next++] = this->LastLength + 1;
    }
    this->LastStart = start;
    this->LastLength = length;
    return true;
  }

  const unsigned char* Data;
  std::size_t Size;
  Bytes& Block;
  std::size_t At = 0;
  unsigned int Window = 0;
  unsigned int There = 0; ///< bits of Window that are not used yet
  unsigned int Next = First;
  std::size_t LastStart = 0;
  std::size_t LastLength = 0; ///< 0: no text since the table was cleared
  /// Where each code's text is in the block.
  std::vector<std::size_t> Starts = std::vector<std::size_t>(None, 0);
  std::vector<std::size_t> Lengths = std::vector<std::size_t>(None, 0);
};
}

vtkMTVerifyTerrainTiffSamples::vtkMTVerifyTerrainTiffSamples(
  const vtkMTVerifyTerrainTiff& tiff, vtkMTVerifyTerrainTile& tile)
  : Tiff(tiff)
  , Tile(tile)
{
}

bool vtkMTVerifyTerrainTiffSamples::Read(std::string& error)
{
  if (!this->ReadLayout(error) || !this->IsKnown(error))
  {
    return false;
  }
  const std::size_t blocks = this->BlocksAcross * this->BlocksDown;
  if (this->Offsets.size() < blocks || this->Sizes.size() < blocks)
  {
    error = "it names too few strips or tiles";
    return false;
  }
  const std::int64_t samples = this->Tile.Columns * this->Tile.Rows;
  this->Tile.Heights.assign(static_cast<std::size_t>(samples), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < blocks; ++i)
  {
    if (!this->ReadBlock(i, error))
    {
      return false;
    }
  }
  return true;
}

bool vtkMTVerifyTerrainTiffSamples::ReadLayout(std::string& error)
{
  const double columns = this->Tiff.GetNumber(256, 0);
  const double rows = this->Tiff.GetNumber(257, 0);
  const bool isTiled = this->Tiff.Has(322);
  const double blockColumns = isTiled ? this->Tiff.GetNumber(322, 0) : columns;
  const double blockRows = isTiled ? this->Tiff.GetNumber(323, 0) : std::min(this->Tiff.GetNumber(278, rows), rows);
  // Before memory is taken: a directory may promise anything, and no compression here gains more than this.
  const double most = 4096.0 * static_cast<double>(this->Tiff.GetBytes().size());
  if (!(columns >= 1 && rows >= 1 && blockColumns >= 1 && blockRows >= 1) || columns * rows > most ||
    blockColumns * blockRows > most)
  {
    error = "its numbers of columns and rows are out of range";
    return false;
  }
  this->Tile.Columns = static_cast<std::int64_t>(columns);
  this->Tile.Rows = static_cast<std::int64_t>(rows);
  this->BlockColumns = static_cast<std::size_t>(blockColumns);
  this->BlockRows = static_cast<std::size_t>(blockRows);
  this->BlocksAcross = (static_cast<std::size_t>(columns) + this->BlockColumns - 1) / this->BlockColumns;
  this->BlocksDown = (static_cast<std::size_t>(rows) + this->BlockRows - 1) / this->BlockRows;
  this->Offsets = this->Tiff.GetNumbers(isTiled ? 324 : 273);
  this->Sizes = this->Tiff.GetNumbers(isTiled ? 325 : 279);
  this->IsBig = this->Tiff.IsBigEndian();
  return true;
}

bool vtkMTVerifyTerrainTiffSamples::IsKnown(std::string& error)
{
  const double bits = this->Tiff.GetNumber(258, 1);
  const double bands = this->Tiff.GetNumber(277, 1);
  this->Format = static_cast<int>(this->Tiff.GetNumber(339, 1));
  this->Compression = static_cast<int>(this->Tiff.GetNumber(259, 1));
  this->Predictor = static_cast<int>(this->Tiff.GetNumber(317, 1));
  const bool isWhole =
    (this->Format == 1 || this->Format == 2) && (bits == 8 || bits == 16 || bits == 32 || bits == 64);
  if (!isWhole && !(this->Format == 3 && (bits == 32 || bits == 64)))
  {
    return this->Tile.Refuse("TIFF with samples of " + std::to_string(static_cast<int>(bits)) + " bits, format " +
        std::to_string(this->Format) + ",",
      error);
  }
  const int known[] = { NoCompression, Lzw, Deflate, PackBits, OldDeflate };
  if (std::find(std::begin(known), std::end(known), this->Compression) == std::end(known))
  {
    return this->Tile.Refuse("TIFF's compression " + std::to_string(this->Compression), error);
  }
  const bool isPredicted = this->Compression != NoCompression && this->Compression != PackBits;
  this->Predictor = isPredicted ? this->Predictor : 1;
  if (this->Predictor < 1 || this->Predictor > 3 || (this->Predictor == 3 && this->Format != 3) ||
    this->Tiff.GetNumber(266, 1) != 1)
  {
    return this->Tile.Refuse("TIFF's predictor " + std::to_string(this->Predictor) + " or fill order", error);
  }
  if (!(bands >= 1 && bands <= 65535))
  {
    error = "its number of samples per pixel is out of range";
    return false;
  }
  if (bands > 1)
  {
    this->Tile.Notes.emplace_back("The first of " + std::to_string(static_cast<int>(bands)) + " bands is taken.");
  }
  this->SampleBytes = static_cast<std::size_t>(bits / 8);
  this->Bands = this->Tiff.GetNumber(284, 1) == 2 ? 1 : static_cast<std::size_t>(bands);
  return true;
}

bool vtkMTVerifyTerrainTiffSamples::ReadBlock(std::size_t index, std::string& error)
{
  const Bytes& file = this->Tiff.GetBytes();
  const double offset = this->Offsets[index];
  const double size = this->Sizes[index];
  if (offset == 0.0 || size == 0.0)
  {
    return true;
  }
  if (!(offset > 0.0 && size > 0.0 && offset + size <= static_cast<double>(file.size())))
  {
    error = "strip or tile " + std::to_string(index) + " is not within the file";
    return false;
  }
  const std::size_t firstColumn = index % this->BlocksAcross * this->BlockColumns;
  const std::size_t firstRow = index / this->BlocksAcross * this->BlockRows;
  const std::size_t columns = std::min(this->BlockColumns, static_cast<std::size_t>(this->Tile.Columns) - firstColumn);
  const std::size_t rows = std::min(this->BlockRows, static_cast<std::size_t>(this->Tile.Rows) - firstRow);
  Bytes block;
  if (!this->Decompress(file.data() + static_cast<std::size_t>(offset), static_cast<std::size_t>(size), block, error))
  {
    error = "strip or tile " + std::to_string(index) + ": " + error;
    return false;
  }
  const std::size_t pixel = this->Bands * this->SampleBytes;
  if (block.size() < rows * this->BlockColumns * pixel)
  {
    error = "strip or tile " + std::to_string(index) + " has too few bytes";
    return false;
  }
  this->Integrate(block);
  for (std::size_t row = 0; row < rows; ++row)
  {
    const unsigned char* from = block.data() + row * this->BlockColumns * pixel;
    double* to = &this->Tile.Heights[(firstRow + row) * static_cast<std::size_t>(this->Tile.Columns) + firstColumn];
    for (std::size_t column = 0; column < columns; ++column)
    {
      to[column] = this->GetSample(from + column * pixel);
    }
  }
  return true;
}

bool vtkMTVerifyTerrainTiffSamples::Decompress(
  const unsigned char* data, std::size_t size, Bytes& block, std::string& error) const
{
  const std::size_t limit = this->BlockRows * this->BlockColumns * this->Bands * this->SampleBytes;
  switch (this->Compression)
  {
    case Lzw:
      if (!LzwDecoder(data, size, block).Decode(limit))
      {
        error = "its LZW data is damaged";
        return false;
      }
      return true;
    case PackBits:
      UnpackBits(data, size, block, limit);
      return true;
    case Deflate:
    case OldDeflate:
      return Inflate(data, size, limit, block, error);
    default:
      block.assign(data, data + size);
      return true;
  }
}

void vtkMTVerifyTerrainTiffSamples::Integrate(Bytes& block)
{
  const std::size_t row = this->BlockColumns * this->Bands * this->SampleBytes;
  for (std::size_t at = 0; this->Predictor > 1 && at + row <= block.size(); at += row)
  {
    this->Predictor == 2 ? this->IntegrateWhole(block.data() + at) : this->IntegrateReal(block.data() + at);
  }
  this->IsBig = this->Predictor == 3 || this->Tiff.IsBigEndian();
}

void vtkMTVerifyTerrainTiffSamples::IntegrateWhole(unsigned char* row) const
{
  // Differences of whole samples, as bytes with carries from the lowest one up: that suits every width.
  const std::size_t pixel = this->Bands * this->SampleBytes;
  const bool isBig = this->Tiff.IsBigEndian();
  for (std::size_t i = this->Bands; i < this->BlockColumns * this->Bands; ++i)
  {
    unsigned char* sample = row + i * this->SampleBytes;
    unsigned int carry = 0;
    for (std::size_t b = 0; b < this->SampleBytes; ++b)
    {
      unsigned char& byte = sample[isBig ? this->SampleBytes - 1 - b : b];
      const unsigned int sum = byte + *(&byte - pixel) + carry;
      byte = static_cast<unsigned char>(sum);
      carry = sum >> 8;
    }
  }
}

void vtkMTVerifyTerrainTiffSamples::IntegrateReal(unsigned char* row) const
{
  const std::size_t samples = this->BlockColumns * this->Bands;
  for (std::size_t i = this->Bands; i < samples * this->SampleBytes; ++i)
  {
    row[i] = static_cast<unsigned char>(row[i] + row[i - this->Bands]);
  }
  // The highest bytes of all samples come first, then the next ones.
  const Bytes planes(row, row + samples * this->SampleBytes);
  for (std::size_t i = 0; i < samples; ++i)
  {
    for (std::size_t b = 0; b < this->SampleBytes; ++b)
    {
      row[i * this->SampleBytes + b] = planes[b * samples + i];
    }
  }
}

double vtkMTVerifyTerrainTiffSamples::GetSample(const unsigned char* place) const
{
  if (this->Format == 3)
  {
    return this->SampleBytes == 4 ? Get<float>(place, this->IsBig) : Get<double>(place, this->IsBig);
  }
  const bool isSigned = this->Format == 2;
  switch (this->SampleBytes)
  {
    case 1:
      return isSigned ? Get<std::int8_t>(place, this->IsBig) : *place;
    case 2:
      return isSigned ? Get<std::int16_t>(place, this->IsBig) : Get<std::uint16_t>(place, this->IsBig);
    case 4:
      return isSigned ? static_cast<double>(Get<std::int32_t>(place, this->IsBig))
                      : Get<std::uint32_t>(place, this->IsBig);
    default:
      return isSigned ? static_cast<double>(Get<std::int64_t>(place, this->IsBig))
                      : static_cast<double>(Get<std::uint64_t>(place, this->IsBig));
  }
}
