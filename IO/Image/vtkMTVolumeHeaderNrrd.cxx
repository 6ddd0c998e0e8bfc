// SPDX-License-Identifier: BSD-3-Clause
// The header of NRRD: "NRRD000v", lines of "field: value", of "key:=value" or of "#comment", and a blank line.
#include "vtkMTVolumeHeader.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTTextFormat.h"
#include "vtkMTVolumeFormat.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

std::string Trim(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string_view::npos ? ""
                                         : std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

// What lies between quotes.
std::vector<std::string> SplitQuoted(const std::string& text)
{
  std::vector<std::string> parts;
  for (std::size_t open = text.find('"'); open != std::string::npos; open = text.find('"', open))
  {
    const std::size_t close = std::min(text.find('"', open + 1), text.size());
    parts.push_back(text.substr(open + 1, close - open - 1));
    open = std::min(close + 1, text.size());
  }
  return parts;
}

int GetType(const std::string& name)
{
  static const std::pair<const char*, int> types[] = { { "signed char", VTK_SIGNED_CHAR }, { "int8", VTK_SIGNED_CHAR },
    { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR }, { "unsigned char", VTK_UNSIGNED_CHAR },
    { "uint8", VTK_UNSIGNED_CHAR }, { "uint8_t", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT },
    { "short int", VTK_SHORT }, { "signed short", VTK_SHORT }, { "signed short int", VTK_SHORT },
    { "int16", VTK_SHORT }, { "int16_t", VTK_SHORT }, { "ushort", VTK_UNSIGNED_SHORT },
    { "unsigned short", VTK_UNSIGNED_SHORT }, { "unsigned short int", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT }, { "signed int", VTK_INT },
    { "int32", VTK_INT }, { "int32_t", VTK_INT }, { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT }, { "longlong", VTK_LONG_LONG },
    { "long long", VTK_LONG_LONG }, { "long long int", VTK_LONG_LONG }, { "signed long long", VTK_LONG_LONG },
    { "signed long long int", VTK_LONG_LONG }, { "int64", VTK_LONG_LONG }, { "int64_t", VTK_LONG_LONG },
    { "ulonglong", VTK_UNSIGNED_LONG_LONG }, { "unsigned long long", VTK_UNSIGNED_LONG_LONG },
    { "unsigned long long int", VTK_UNSIGNED_LONG_LONG }, { "uint64", VTK_UNSIGNED_LONG_LONG },
    { "uint64_t", VTK_UNSIGNED_LONG_LONG }, { "float", VTK_FLOAT }, { "double", VTK_DOUBLE } };
  const auto* const found =
    std::find_if(std::begin(types), std::end(types), [&name](const auto& type) { return name == type.first; });
  return found == std::end(types) ? VTK_VOID : found->second;
}

// The declared space, by the short name where it has one.
std::string GetSpaceName(const std::string& space)
{
  static const std::pair<const char*, const char*> names[] = { { "right-anterior-superior", "RAS" },
    { "left-anterior-superior", "LAS" }, { "left-posterior-superior", "LPS" },
    { "right-anterior-superior-time", "RAST" }, { "left-anterior-superior-time", "LAST" },
    { "left-posterior-superior-time", "LPST" } };
  const std::string lower = vtkMTTextFormat::ToLower(space);
  for (const auto& [full, brief] : names)
  {
    if (lower == full || lower == vtkMTTextFormat::ToLower(brief))
    {
      return brief;
    }
  }
  return space;
}
}

struct vtkMTVolumeHeader::Nrrd
{
  std::map<std::string, std::string> Fields; // by name in lower case, without blanks
  std::vector<std::string> List;
  std::uint64_t EndOfHeader = 0;
  std::vector<double> Sizes;
  std::vector<std::array<double, 3>> Directions; // empty: none are given; 0 0 0 where an axis has none

  bool Parse(const std::string& text, bool isDetached, std::string& error)
  {
    bool good = text.rfind("NRRD", 0) == 0;
    int number = 1;
    bool isList = false;
    std::size_t line = std::min(text.find('\n'), text.size() - 1) + 1;
    while (good && line < text.size())
    {
      ++number;
      const std::size_t end = text.find('\n', line);
      const std::string field = Trim(std::string_view(text).substr(line, end == std::string::npos ? end : end - line));
      line = end == std::string::npos ? text.size() : end + 1;
      if (field.empty() && !isList)
      {
        this->EndOfHeader = line;
        return isDetached || end != std::string::npos;
      }
      const std::size_t colon = field.find(':');
      if (isList)
      {
        this->List.push_back(field);
      }
      else if (field[0] != '#')
      {
        good = colon != std::string::npos && colon > 0;
        isList = good && this->TakeField(field, colon);
      }
    }
    if (good && (isDetached || isList))
    {
      return true;
    }
    error = "line " + std::to_string(number) + ": is no line of a NRRD header, or the header does not end";
    return false;
  }

  // Whether names of data files follow, up to the end.
  bool TakeField(const std::string& field, std::size_t colon)
  {
    if (field.compare(colon, 2, ":=") == 0)
    {
      return false; // a key of the user's
    }
    std::string name = vtkMTTextFormat::ToLower(field.substr(0, colon));
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    name = name == "centerings" ? "centers" : name;
    this->Fields[name] = Trim(std::string_view(field).substr(colon + 1));
    return name == "datafile" && this->Fields[name].rfind("LIST", 0) == 0;
  }

  std::string Get(const char* name) const
  {
    const auto found = this->Fields.find(name);
    return found == this->Fields.end() ? "" : found->second;
  }
  std::vector<std::string> GetTokens(const char* name) const
  {
    const std::string value = this->Get(name);
    std::string_view rest(value);
    std::vector<std::string> tokens;
    for (std::string_view token; !(token = vtkMTTextFormat::NextToken(rest)).empty();)
    {
      tokens.emplace_back(token);
    }
    return tokens;
  }
  /// One for each axis; NaN where there is none.
  std::vector<double> GetNumbers(const char* name) const
  {
    const std::vector<std::string> tokens = this->GetTokens(name);
    std::vector<double> numbers(this->Sizes.size(), Unknown);
    for (std::size_t i = 0; i < std::min(numbers.size(), tokens.size()); ++i)
    {
      numbers[i] = vtkMTTextFormat::ToNumber(tokens[i], numbers[i]) ? numbers[i] : Unknown;
    }
    return numbers;
  }
  double GetNumber(const char* name, double otherwise) const
  {
    double number = otherwise;
    return vtkMTTextFormat::ToNumber(this->Get(name), number) ? number : otherwise;
  }

  // "(1,0,0) none (0,1,0)": of a space of more than three dimensions, time as a rule, the first three.
  static bool ParseVectors(const std::string& text, std::vector<std::array<double, 3>>& vectors)
  {
    for (std::size_t at = text.find_first_not_of(" \t"); at != std::string::npos;
         at = text.find_first_not_of(" \t", at))
    {
      vectors.push_back({ 0.0, 0.0, 0.0 });
      if (text.compare(at, 4, "none") == 0 || text.compare(at, 4, "NONE") == 0)
      {
        at += 4;
        continue;
      }
      const std::size_t close = text.find(')', at);
      if (text[at] != '(' || close == std::string::npos)
      {
        return false;
      }
      std::string inner = text.substr(at + 1, close - at - 1);
      std::replace(inner.begin(), inner.end(), ',', ' ');
      std::string_view rest(inner);
      for (double& number : vectors.back())
      {
        if (!vtkMTTextFormat::ToNumber(vtkMTTextFormat::NextToken(rest), number))
        {
          return false;
        }
      }
      at = close + 1;
    }
    return true;
  }

  bool ParseSizes(std::string& error)
  {
    this->Sizes.resize(this->GetTokens("sizes").size());
    this->Sizes = this->GetNumbers("sizes");
    const std::string directions = this->Get("spacedirections");
    if (this->Sizes.size() > 16 || this->Sizes.size() < 3 ||
      this->GetNumber("dimension", 0.0) != static_cast<double>(this->Sizes.size()))
    {
      error = "is no volume: \"dimension\" and \"sizes\" must give three axes or more";
      return false;
    }
    if (!directions.empty() &&
      (!ParseVectors(directions, this->Directions) || this->Directions.size() != this->Sizes.size()))
    {
      error = "its \"space directions\" are not one vector of three numbers, or none, for each axis";
      return false;
    }
    return true;
  }

  // An axis of space has a direction; without directions, a spacing or nothing at all, and no kind but of space.
  bool FindAxes(std::array<std::size_t, 3>& axes) const
  {
    const std::vector<std::string> kinds = this->GetTokens("kinds");
    const std::vector<std::string> spacings = this->GetTokens("spacings");
    const std::array<double, 3> none{ 0.0, 0.0, 0.0 };
    std::size_t count = 0;
    for (std::size_t axis = 0; axis < this->Sizes.size() && count < 3; ++axis)
    {
      const std::string kind = axis < kinds.size() ? vtkMTTextFormat::ToLower(kinds[axis]) : "domain";
      const bool isNan = axis < spacings.size() && vtkMTTextFormat::ToLower(spacings[axis]) == "nan";
      const bool isPlain = kind == "domain" || kind == "space" || kind == "???" || kind == "none";
      if (this->Directions.empty() ? isPlain && !isNan : this->Directions[axis] != none)
      {
        axes[count++] = axis;
      }
    }
    return count == 3;
  }

  // Without directions each axis runs along its own.
  void PlaceBySpacings(vtkMTVolumeHeader& header, const std::array<std::size_t, 3>& axes) const
  {
    const std::vector<double> spacings = this->GetNumbers("spacings");
    const std::vector<double> least = this->GetNumbers("axismins");
    const std::vector<double> largest = this->GetNumbers("axismaxs");
    const std::vector<std::string> centers = this->GetTokens("centers");
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t axis = axes[i];
      const bool isNode = axis < centers.size() && vtkMTTextFormat::ToLower(centers[axis]) == "node";
      const double ofRange = (largest[axis] - least[axis]) / (this->Sizes[axis] - (isNode ? 1.0 : 0.0));
      const double given = std::isnan(spacings[axis]) ? ofRange : spacings[axis];
      const double step = std::isnan(given) ? 1.0 : header.UseSpacing(given);
      header.Place.Axes[i] = { 0.0, 0.0, 0.0 };
      header.Place.Axes[i][i] = step;
      header.Place.Origin[i] = std::isnan(least[axis]) ? 0.0 : least[axis] + (isNode ? 0.0 : 0.5 * step);
    }
  }

  // Those of the space, or else those of the axes: one where all are the same.
  std::string GetUnits(const std::array<std::size_t, 3>& axes) const
  {
    const bool isOfSpace = !this->Get("spaceunits").empty();
    const std::vector<std::string> units = SplitQuoted(this->Get(isOfSpace ? "spaceunits" : "units"));
    std::array<std::string, 3> names;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t place = isOfSpace ? i : axes[i];
      names[i] = place < units.size() ? units[place] : "";
    }
    return names[0] == names[1] && names[0] == names[2] ? names[0] : names[0] + ", " + names[1] + ", " + names[2];
  }

  bool FindPlace(vtkMTVolumeHeader& header, const std::array<std::size_t, 3>& axes) const
  {
    std::vector<std::array<double, 3>> origin;
    const std::string text = this->Get("spaceorigin");
    if (!text.empty() && (!ParseVectors(text, origin) || origin.size() != 1))
    {
      return false;
    }
    if (this->Directions.empty())
    {
      this->PlaceBySpacings(header, axes);
    }
    for (std::size_t i = 0; i < 3 && !this->Directions.empty(); ++i)
    {
      header.Place.Axes[i] = this->Directions[axes[i]];
    }
    header.Place.Origin = origin.empty() ? header.Place.Origin : origin.front();
    header.Place.World.Crs = GetSpaceName(this->Get("space"));
    header.Place.World.Units = this->GetUnits(axes);
    for (const auto& [field, reason] :
      { std::pair("oldmin", "volume_ignored_old_range"), std::pair("oldmax", "volume_ignored_old_range"),
        std::pair("measurementframe", "volume_ignored_measurement_frame") })
    {
      if (!this->Get(field).empty())
      {
        header.Report[reason] = 1;
      }
    }
    return true;
  }

  bool FindFiles(const std::string& path, vtkMTVolumeHeader& header) const
  {
    const std::vector<std::string> tokens = this->GetTokens("datafile");
    if (tokens.empty())
    {
      header.Files.push_back({ path, this->EndOfHeader });
      return vtkMTVolumeFormat::GetEnding(path) != "nhdr" || this->EndOfHeader > 0;
    }
    if (tokens[0] == "LIST")
    {
      for (const std::string& name : this->List)
      {
        if (!name.empty())
        {
          header.Files.push_back({ GetPathBeside(path, name) });
        }
      }
      return true;
    }
    double numbers[3];
    const bool isPattern = tokens.size() >= 4 && tokens[0].find('%') != std::string::npos &&
      vtkMTTextFormat::ToNumber(tokens[1], numbers[0]) && vtkMTTextFormat::ToNumber(tokens[2], numbers[1]) &&
      vtkMTTextFormat::ToNumber(tokens[3], numbers[2]);
    if (!isPattern)
    {
      header.Files.push_back({ GetPathBeside(path, this->Get("datafile")) });
      return true;
    }
    return numbers[2] != 0.0 && ListNumbered(path, tokens[0], { numbers[0], numbers[1], numbers[2] }, header.Files);
  }

  bool FindEncoding(vtkMTVolumeHeader& header, std::string& error) const
  {
    static const std::pair<const char*, EncodingType> encodings[] = { { "raw", Raw }, { "gzip", Deflated },
      { "gz", Deflated }, { "txt", Text }, { "text", Text }, { "ascii", Text }, { "hex", Hexadecimal } };
    const std::string name = vtkMTTextFormat::ToLower(this->Get("encoding"));
    const auto* const found = std::find_if(
      std::begin(encodings), std::end(encodings), [&name](const auto& encoding) { return name == encoding.first; });
    const double skip = this->GetNumber("byteskip", 0.0);
    if (found == std::end(encodings) || !(skip >= -1.0 && skip < 1e15))
    {
      error =
        "its encoding or its byte skip is none that is read: \"" + name + "\"; 'unu save -f nrrd -e gzip' changes it";
      return false;
    }
    header.Encoding = found->second;
    header.IsBigEndian = vtkMTTextFormat::ToLower(this->Get("endian")) == "big";
    header.DecodedSkip = header.Encoding == Deflated && skip > 0.0 ? static_cast<std::uint64_t>(skip) : 0;
    for (File& file : header.Files)
    {
      file.IsAtEnd = skip == -1.0;
      file.Offset += skip > 0.0 && header.Encoding != Deflated ? static_cast<std::uint64_t>(skip) : 0;
    }
    return true;
  }
};

// "line skip": lines of every file before its samples, encoded or not.
bool vtkMTVolumeHeader::SkipLines(double lines, std::string& error)
{
  for (File& file : this->Files)
  {
    if (!(lines >= 1.0) || file.IsAtEnd)
    {
      continue;
    }
    const auto source = vtkMTFileByteSource::Open(file.Path, error);
    char block[4096];
    std::uint64_t left = source ? source->GetSize() - std::min(source->GetSize(), file.Offset) : 0;
    for (double found = 0.0; found < lines;)
    {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(sizeof(block), left));
      if (count == 0 || !source->Read(file.Offset, count, block, error))
      {
        error = error.empty() ? "its data file ends within the lines that are to be skipped" : error;
        return false;
      }
      const char* at = block;
      while (found < lines && at < block + count)
      {
        found += *at++ == '\n' ? 1.0 : 0.0;
      }
      file.Offset += static_cast<std::uint64_t>(at - block);
      left -= static_cast<std::uint64_t>(at - block);
    }
  }
  return true;
}

bool vtkMTVolumeHeader::ReadNrrd(const std::string& path, const vtkMTByteSource& source, std::string& error)
{
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(source.GetSize(), 1 << 20)), ' ');
  if (!source.Read(0, text.size(), text.data(), error))
  {
    return false;
  }
  Nrrd fields;
  if (!fields.Parse(text, vtkMTVolumeFormat::GetEnding(path) == "nhdr", error) || !fields.ParseSizes(error))
  {
    return false;
  }
  this->Type = GetType(vtkMTTextFormat::ToLower(fields.Get("type")));
  std::array<std::size_t, 3> axes{};
  if (this->Type == VTK_VOID || !fields.FindAxes(axes))
  {
    error = this->Type == VTK_VOID ? "its type is none that is read: \"" + fields.Get("type") + '"'
                                   : "is no volume: fewer than three of its axes are axes of space";
    return false;
  }
  if (!this->SetAxes(fields.Sizes, axes, error))
  {
    return false;
  }
  if (!fields.FindPlace(*this, axes) || !fields.FindFiles(path, *this))
  {
    error = "its header has a \"space origin\" or a \"data file\" that is none";
    return false;
  }
  return this->SkipLines(fields.GetNumber("lineskip", 0.0), error) && fields.FindEncoding(*this, error);
}
