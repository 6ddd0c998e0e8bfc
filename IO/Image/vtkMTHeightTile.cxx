// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTHeightTile.h"

#include "vtkMTTextFormat.h"

#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <regex>

namespace
{
constexpr float Void = std::numeric_limits<float>::quiet_NaN();

std::string GetEnding(const std::string& path)
{
  const std::string ending = vtkMTTextFormat::GetLowerCaseEnding(path);
  return ending == "gz" ? vtkMTTextFormat::GetLowerCaseEnding(path.substr(0, path.size() - 3)) + ".gz" : ending;
}

// The whole file, unpacked where it is packed; no tile is larger than limit.
bool ReadAll(const std::string& path, std::size_t limit, std::vector<unsigned char>& bytes, std::string& error)
{
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file)
  {
    error = "cannot be opened; check the name and its permissions";
    return false;
  }
  std::vector<unsigned char> block(1 << 20);
  int count = 0;
  while ((count = gzread(file.get(), block.data(), static_cast<unsigned>(block.size()))) > 0)
  {
    if (bytes.size() + static_cast<std::size_t>(count) > limit)
    {
      error = "is larger than any tile";
      return false;
    }
    bytes.insert(bytes.end(), block.begin(), block.begin() + count);
  }
  int code = Z_OK;
  gzerror(file.get(), &code);
  if (count < 0 || (code != Z_OK && code != Z_STREAM_END)) // compressed data that are truncated ends with Z_BUF_ERROR
  {
    error = "is damaged or truncated; fetch it again";
    return false;
  }
  return true;
}
}

bool vtkMTHeightTile::CanRead(const std::string& path)
{
  const std::string ending = GetEnding(path);
#ifdef MT_HAS_GDAL
  if (ending == "tif" || ending == "tiff")
  {
    return true;
  }
#endif
  return ending == "hgt" || ending == "hgt.gz" || ending == "dem";
}

bool vtkMTHeightTile::Read(const std::string& path, std::string& error)
{
  *this = vtkMTHeightTile();
  this->Path = path;
  const std::string ending = GetEnding(path);
  if (ending == "hgt" || ending == "hgt.gz")
  {
    return this->ReadSrtm(error);
  }
  return ending == "dem" ? this->ReadDem(error) : this->ReadGdal(error);
}

//------------------------------------------------------------------------------
// SRTM: n rows of n big-endian 16-bit integers over one degree by one degree, the first row in the north; the name is
// the south-west corner.
bool vtkMTHeightTile::ReadSrtm(std::string& error)
{
  static const std::regex corner("([NSns])([0-9]{2})([EWew])([0-9]{3})[^/]*$");
  std::smatch match;
  if (!std::regex_search(this->Path, match, corner))
  {
    error = "the name does not say the south-west corner; rename it as in N36W005.hgt";
    return false;
  }
  this->Crs = "EPSG:4326";
  this->South = std::stoi(match[2]) * (std::toupper(match[1].str()[0]) == 'S' ? -1 : 1);
  this->West = std::stoi(match[4]) * (std::toupper(match[3].str()[0]) == 'W' ? -1 : 1);
  constexpr std::size_t largest = 10801; // a third of an arc second
  std::vector<unsigned char> bytes;
  if (!ReadAll(this->Path, 2 * largest * largest, bytes, error))
  {
    return false;
  }
  const std::size_t samples = bytes.size() / 2;
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(samples))));
  if (size < 2 || 2 * size * size != bytes.size())
  {
    error = "its " + std::to_string(bytes.size()) + " bytes are no square tile of 16-bit heights (1201 x 1201 or " +
      "3601 x 3601 as a rule); fetch it again";
    return false;
  }
  this->Columns = this->Rows = size;
  this->StepX = this->StepY = 1.0 / static_cast<double>(size - 1);
  this->Heights.resize(size * size);
  for (std::size_t i = 0; i < this->Heights.size(); ++i)
  {
    const auto height = static_cast<std::int16_t>(static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]));
    this->Heights[(size - 1 - i / size) * size + i % size] = height == -32768 ? Void : static_cast<float>(height);
  }
  return true;
}

//------------------------------------------------------------------------------
namespace
{
constexpr double MetresPerFoot = 0.3048;

// Numbers of fixed width, in Fortran's notation: 0.5D+02.
class DemText
{
public:
  explicit DemText(std::vector<unsigned char> bytes)
    : Bytes(std::move(bytes))
  {
  }

  // An empty field or one past the end is no number.
  double Take(std::size_t at, std::size_t width) const
  {
    std::string field;
    for (std::size_t i = at; i < std::min(at + width, this->Bytes.size()); ++i)
    {
      const char c = static_cast<char>(this->Bytes[i]);
      field += c == 'D' || c == 'd' ? 'e' : c;
    }
    std::string_view rest(field);
    std::string_view token = vtkMTTextFormat::NextToken(rest);
    token.remove_prefix(!token.empty() && token[0] == '+' ? 1 : 0);
    double value = 0.0;
    return vtkMTTextFormat::ToNumber(token, value) ? value : std::numeric_limits<double>::quiet_NaN();
  }

  std::size_t GetSize() const { return this->Bytes.size(); }

private:
  std::vector<unsigned char> Bytes;
};

// Logical records of 1024 bytes. A profile's first one has a head of 144 bytes and 146 heights, the others 170; a
// height has six digits.
constexpr std::size_t Record = 1024;
constexpr std::size_t HeadSize = 144;
constexpr std::size_t FirstHeights = 146;
constexpr std::size_t NextHeights = 170;

std::size_t GetPlaceOfHeight(std::size_t profile, std::size_t i)
{
  return i < FirstHeights
    ? profile + HeadSize + 6 * i
    : profile + Record * (1 + (i - FirstHeights) / NextHeights) + 6 * ((i - FirstHeights) % NextHeights);
}

struct DemHead
{
  double Unit = 1.0; // of places, in degrees or metres
  double HeightUnit = 1.0;
  double Steps[3] = { 1.0, 1.0, 1.0 };
  std::size_t Profiles = 0;
  double Bounds[4] = { 0.0, 0.0, 0.0, 0.0 }; // west, east, south, north

  bool Read(const DemText& text, bool& isGeographic, std::string& error)
  {
    const double planeUnit = text.Take(528, 6);
    const double heightUnit = text.Take(534, 6);
    isGeographic = planeUnit == 3.0;
    this->Unit = isGeographic ? 1.0 / 3600.0 : planeUnit == 1.0 ? MetresPerFoot : 1.0;
    this->HeightUnit = heightUnit == 1.0 ? MetresPerFoot : 1.0;
    for (int i = 0; i < 3; ++i)
    {
      this->Steps[i] = text.Take(816 + 12 * static_cast<std::size_t>(i), 12);
    }
    for (int i = 0; i < 4; ++i)
    {
      const double x = text.Take(546 + 48 * static_cast<std::size_t>(i), 24);
      const double y = text.Take(570 + 48 * static_cast<std::size_t>(i), 24);
      this->Bounds[0] = i == 0 ? x : std::min(this->Bounds[0], x);
      this->Bounds[1] = i == 0 ? x : std::max(this->Bounds[1], x);
      this->Bounds[2] = i == 0 ? y : std::min(this->Bounds[2], y);
      this->Bounds[3] = i == 0 ? y : std::max(this->Bounds[3], y);
    }
    const double profiles = text.Take(858, 6);
    this->Profiles = profiles >= 1.0 && profiles < 1e6 ? static_cast<std::size_t>(profiles) : 0;
    const bool isKnown = planeUnit >= 1.0 && planeUnit <= 3.0 && (heightUnit == 1.0 || heightUnit == 2.0);
    const bool isSound = this->Profiles > 1 && this->Steps[0] > 0.0 && this->Steps[1] > 0.0 && this->Steps[2] > 0.0 &&
      this->Bounds[1] - this->Bounds[0] > 0.0 && this->Bounds[3] - this->Bounds[2] > 0.0;
    error = isKnown && isSound ? "" : "its header is no USGS DEM record of type A with metres, feet or arc seconds";
    return error.empty();
  }
};
}

// USGS DEM, ASCII: one record of type A, then a profile from south to north for each column. Profiles of a projected
// quadrangle begin at different rows: their own coordinates say where.
bool vtkMTHeightTile::ReadDem(std::string& error)
{
  std::vector<unsigned char> bytes;
  if (!ReadAll(this->Path, std::size_t(1) << 30, bytes, error))
  {
    return false;
  }
  const DemText text(std::move(bytes));
  DemHead head;
  if (!head.Read(text, this->IsGeographic, error))
  {
    return false;
  }
  // The corners need not lie on samples; the samples lie on multiples of the step.
  const double firstRow = std::ceil(head.Bounds[2] / head.Steps[1] - 1e-6);
  const double rows = std::floor(head.Bounds[3] / head.Steps[1] + 1e-6) - firstRow + 1.0;
  const double firstX = text.Take(Record + 24, 24);
  if (!(rows >= 2.0) || rows * static_cast<double>(head.Profiles) * 6.0 > 8.0 * static_cast<double>(text.GetSize()) ||
    !std::isfinite(firstX))
  {
    error = "its header and its size do not agree: it is damaged or truncated";
    return false;
  }
  this->Columns = head.Profiles;
  this->Rows = static_cast<std::size_t>(rows);
  this->Heights.assign(this->Columns * this->Rows, Void);
  std::size_t profile = Record;
  for (std::size_t column = 0; column < this->Columns; ++column)
  {
    const double count = text.Take(profile + 12, 6);
    const double x = text.Take(profile + 24, 24);
    const double first = std::round(text.Take(profile + 48, 24) / head.Steps[1]) - firstRow;
    const double datum = text.Take(profile + 72, 24);
    const bool isInPlace = std::abs(x - firstX - static_cast<double>(column) * head.Steps[0]) < 0.5 * head.Steps[0];
    const std::size_t last = count >= 1.0 && count < 1e6
      ? GetPlaceOfHeight(profile, static_cast<std::size_t>(count) - 1)
      : std::numeric_limits<std::size_t>::max();
    if (!isInPlace || !(first >= 0.0 && first + count <= rows) || last >= text.GetSize())
    {
      error = "profile " + std::to_string(column + 1) + " of " + std::to_string(this->Columns) +
        " is damaged or truncated, near byte " + std::to_string(profile);
      return false;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
      const double raw = text.Take(GetPlaceOfHeight(profile, i), 6);
      const std::size_t row = static_cast<std::size_t>(first) + i;
      this->Heights[row * this->Columns + column] = raw <= -32767.0 || std::isnan(raw)
        ? Void
        : static_cast<float>((raw * head.Steps[2] + (std::isfinite(datum) ? datum : 0.0)) * head.HeightUnit);
    }
    profile += Record * ((last - profile) / Record + 1);
  }
  this->West = firstX * head.Unit;
  this->South = firstRow * head.Steps[1] * head.Unit;
  this->StepX = head.Steps[0] * head.Unit;
  this->StepY = head.Steps[1] * head.Unit;
  return true;
}
