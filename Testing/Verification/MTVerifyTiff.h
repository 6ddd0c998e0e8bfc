// SPDX-License-Identifier: BSD-3-Clause
// Writes small GeoTIFF files in every form that the checker reads, after TIFF's and GeoTIFF's specifications.
#ifndef MTVerifyTiff_h
#define MTVerifyTiff_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace MTVerifyFiles
{
struct Tiff
{
  std::size_t Columns = 0, Rows = 0;
  std::vector<double> Heights; ///< row after row, the northernmost first
  bool IsBigEndian = false;
  bool IsBigTiff = false;
  std::size_t Type = 8; ///< of the samples: a place in GetEncoders
  int Compression = 1;  ///< 1 none, 5 LZW, 8 Deflate, 32773 PackBits
  int Predictor = 1;
  std::size_t TileColumns = 0, TileRows = 0; ///< 0: one strip
  std::string NoData;
  std::vector<double> Scale{ 1, 1, 0 };
  std::vector<double> Tie{ 0, 0, 0, 0, 0, 0 };
  std::vector<double> Matrix; ///< instead of the two before
  int RasterType = 1;         ///< 1: pixel is area, 2: pixel is point, 0: no key
  bool IsGeographic = false;

  std::string ToBytes() const;

private:
  std::vector<std::string> MakeBlocks() const;
  std::string Encode(const std::vector<double>& block, std::size_t columns) const;
  void Predict(std::string& row, std::size_t columns) const;
  /// What a tag's values are in the file, with their type and number.
  struct Tag
  {
    int Type;
    std::size_t Count;
    std::string Bytes;
  };
  Tag MakeTag(int type, const std::vector<double>& values) const;
  std::map<int, Tag> MakeTags() const;
  /// A whole number of 2, 4 or 8 bytes.
  std::string Whole(std::uint64_t value, std::size_t size) const;
};
}

#endif
