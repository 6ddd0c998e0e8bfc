// SPDX-License-Identifier: BSD-3-Clause
#include "MTVerifyTiff.h"

#include "MTVerifyFiles.h"

namespace MTVerifyFiles
{
namespace
{
constexpr std::size_t SampleBytes[10] = { 1, 1, 2, 2, 4, 4, 8, 8, 4, 8 };
constexpr int SampleFormats[10] = { 2, 1, 2, 1, 2, 1, 2, 1, 3, 3 };

/// Literals only, and one run where the block begins with three equal bytes.
std::string PackBits(const std::string& bytes)
{
  std::string packed;
  std::size_t at = 0;
  if (bytes.size() > 2 && bytes[0] == bytes[1] && bytes[0] == bytes[2])
  {
    packed = { static_cast<char>(-2), bytes[0] };
    at = 3;
  }
  for (std::size_t count = 0; at < bytes.size(); at += count)
  {
    count = std::min<std::size_t>(128, bytes.size() - at);
    packed += static_cast<char>(count - 1);
    packed += bytes.substr(at, count);
  }
  return packed;
}

/// TIFF 6.0, section 13: a table of texts; codes grow to the next length one code early; cleared at 4094.
std::string PackLzw(const std::string& bytes)
{
  std::string packed;
  std::uint64_t window = 0;
  unsigned int there = 0, bits = 9, next = 258;
  std::map<std::string, unsigned int> table;
  const auto put = [&](unsigned int code)
  {
    window = window << bits | code;
    for (there += bits; there >= 8; there -= 8)
    {
      packed += static_cast<char>(window >> (there - 8) & 255);
    }
  };
  const auto getCode = [&](const std::string& text)
  { return text.size() == 1 ? static_cast<unsigned char>(text[0]) : table.at(text); };
  put(256);
  std::string text;
  for (const char letter : bytes)
  {
    if (text.empty() || table.count(text + letter))
    {
      text += letter;
      continue;
    }
    put(getCode(text));
    table[text + letter] = next++;
    bits = next > 2047 ? 12 : next > 1023 ? 11 : next > 511 ? 10 : 9;
    if (next == 4095)
    {
      put(256);
      table.clear();
      next = 258;
      bits = 9;
    }
    text = letter;
  }
  put(getCode(text));
  ++next;
  bits = next > 2047 ? 12 : next > 1023 ? 11 : next > 511 ? 10 : 9;
  put(257);
  packed += there > 0 ? std::string(1, static_cast<char>(window << (8 - there) & 255)) : std::string();
  return packed;
}
}

std::string Tiff::Whole(std::uint64_t value, std::size_t size) const
{
  std::string bytes;
  size == 2     ? Put(bytes, static_cast<std::uint16_t>(value), this->IsBigEndian)
    : size == 4 ? Put(bytes, static_cast<std::uint32_t>(value), this->IsBigEndian)
                : Put(bytes, value, this->IsBigEndian);
  return bytes;
}

void Tiff::Predict(std::string& row, std::size_t columns) const
{
  const std::size_t size = SampleBytes[this->Type];
  if (this->Predictor == 3)
  {
    // The highest bytes of all samples, then the next ones; then differences of bytes.
    std::string planes(row.size(), '\0');
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      const std::size_t byte = this->IsBigEndian ? i % size : size - 1 - i % size;
      planes[byte * columns + i / size] = row[i];
    }
    row = planes;
    for (std::size_t i = row.size(); i-- > 1;)
    {
      row[i] = static_cast<char>(row[i] - row[i - 1]);
    }
  }
  else if (this->Predictor == 2)
  {
    for (std::size_t i = columns; i-- > 1;)
    {
      std::uint64_t values[2] = { 0, 0 };
      for (std::size_t b = 0; b < size; ++b)
      {
        const std::size_t byte = this->IsBigEndian ? b : size - 1 - b;
        values[0] = values[0] << 8 | static_cast<unsigned char>(row[(i - 1) * size + byte]);
        values[1] = values[1] << 8 | static_cast<unsigned char>(row[i * size + byte]);
      }
      const std::uint64_t difference = values[1] - values[0];
      for (std::size_t b = 0; b < size; ++b)
      {
        row[i * size + (this->IsBigEndian ? size - 1 - b : b)] = static_cast<char>(difference >> (8 * b) & 255);
      }
    }
  }
}

std::string Tiff::Encode(const std::vector<double>& block, std::size_t columns) const
{
  std::string bytes;
  for (std::size_t at = 0; at < block.size(); at += columns)
  {
    std::string row = GetEncoders()[this->Type](
      { block.begin() + static_cast<std::ptrdiff_t>(at), block.begin() + static_cast<std::ptrdiff_t>(at + columns) },
      this->IsBigEndian);
    this->Predict(row, columns);
    bytes += row;
  }
  return this->Compression == 5  ? PackLzw(bytes)
    : this->Compression == 8     ? Compress(bytes, 15)
    : this->Compression == 32773 ? PackBits(bytes)
                                 : bytes;
}

std::vector<std::string> Tiff::MakeBlocks() const
{
  const std::size_t columns = this->TileColumns ? this->TileColumns : this->Columns;
  const std::size_t rows = this->TileColumns ? this->TileRows : this->Rows;
  std::vector<std::string> blocks;
  for (std::size_t top = 0; top < this->Rows; top += rows)
  {
    for (std::size_t left = 0; left < this->Columns; left += columns)
    {
      std::vector<double> block(columns * rows, 77.0); // beyond the image
      for (std::size_t i = 0; i < columns * rows; ++i)
      {
        const std::size_t row = top + i / columns;
        const std::size_t column = left + i % columns;
        if (row < this->Rows && column < this->Columns)
        {
          block[i] = this->Heights[row * this->Columns + column];
        }
      }
      blocks.push_back(this->Encode(block, columns));
    }
  }
  return blocks;
}

Tiff::Tag Tiff::MakeTag(int type, const std::vector<double>& values) const
{
  Tag tag{ type, values.size(), std::string() };
  for (const double value : values)
  {
    type == 12 ? Put(tag.Bytes, value, this->IsBigEndian)
               : void(tag.Bytes += this->Whole(static_cast<std::uint64_t>(value),
                        type == 3     ? 2
                          : type == 4 ? 4
                                      : 8));
  }
  return tag;
}

std::map<int, Tiff::Tag> Tiff::MakeTags() const
{
  std::map<int, Tag> tags;
  const auto set = [&](int tag, int type, const std::vector<double>& values)
  { tags[tag] = this->MakeTag(type, values); };
  const double size = static_cast<double>(SampleBytes[this->Type]);
  set(256, 3, { static_cast<double>(this->Columns) });
  set(257, 4, { static_cast<double>(this->Rows) });
  set(258, 3, { 8 * size });
  set(259, 3, { static_cast<double>(this->Compression) });
  set(277, 3, { 1 });
  set(317, 3, { static_cast<double>(this->Predictor) });
  set(339, 3, { static_cast<double>(SampleFormats[this->Type]) });
  if (this->TileColumns)
  {
    set(322, 3, { static_cast<double>(this->TileColumns) });
    set(323, 3, { static_cast<double>(this->TileRows) });
  }
  else
  {
    set(278, 3, { static_cast<double>(this->Rows) });
  }
  this->Matrix.empty() ? set(33550, 12, this->Scale) : set(34264, 12, this->Matrix);
  if (this->Matrix.empty())
  {
    set(33922, 12, this->Tie);
  }
  std::vector<double> keys{ 1, 1, 0, this->RasterType ? 2.0 : 1.0, 1024, 0, 1, this->IsGeographic ? 2.0 : 1.0 };
  if (this->RasterType)
  {
    keys.insert(keys.end(), { 1025, 0, 1, static_cast<double>(this->RasterType) });
  }
  set(34735, 3, keys);
  if (!this->NoData.empty())
  {
    tags[42113] = { 2, this->NoData.size() + 1, this->NoData + '\0' };
  }
  return tags;
}

std::string Tiff::ToBytes() const
{
  const std::vector<std::string> blocks = this->MakeBlocks();
  const std::size_t word = this->IsBigTiff ? 8 : 4;
  std::string file = this->IsBigEndian ? "MM" : "II";
  file += this->Whole(this->IsBigTiff ? 43 : 42, 2);
  file += this->IsBigTiff ? this->Whole(8, 2) + this->Whole(0, 2) : "";
  const std::size_t firstBlock = file.size() + word;
  std::string body;
  std::vector<double> offsets, sizes;
  for (const std::string& block : blocks)
  {
    offsets.push_back(static_cast<double>(firstBlock + body.size()));
    sizes.push_back(static_cast<double>(block.size()));
    body += block;
  }
  std::map<int, Tag> tags = this->MakeTags();
  tags[this->TileColumns ? 324 : 273] = this->MakeTag(this->IsBigTiff ? 16 : 4, offsets);
  tags[this->TileColumns ? 325 : 279] = this->MakeTag(4, sizes);
  for (auto& [number, tag] : tags)
  {
    // Longer values lie before the directory, which names their place.
    if (tag.Bytes.size() > word)
    {
      const std::size_t place = firstBlock + body.size();
      body += tag.Bytes;
      tag.Bytes = this->Whole(place, word);
    }
    tag.Bytes.resize(word, '\0');
  }
  file += this->Whole(firstBlock + body.size(), word) + body + this->Whole(tags.size(), this->IsBigTiff ? 8 : 2);
  for (const auto& [number, tag] : tags)
  {
    file += this->Whole(static_cast<std::uint64_t>(number), 2) + this->Whole(static_cast<std::uint64_t>(tag.Type), 2) +
      this->Whole(tag.Count, word) + tag.Bytes;
  }
  return file + this->Whole(0, word);
}
}
