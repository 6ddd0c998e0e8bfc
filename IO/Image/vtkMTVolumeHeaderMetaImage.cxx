// SPDX-License-Identifier: BSD-3-Clause
// The header of MetaImage: lines of "key = value", of which the last one names the data.
#include "vtkMTVolumeHeader.h"

#include "vtkMTByteSource.h"
#include "vtkMTTextFormat.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

struct vtkMTVolumeHeader::MetaImage
{
  std::map<std::string, std::string> Fields; // by key in lower case
  std::vector<std::string> List;             // what follows "ElementDataFile = LIST"
  std::uint64_t EndOfHeader = 0;

  static std::string Trim(const std::string& text)
  {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
  }

  bool Parse(const std::string& text)
  {
    bool hasData = false;
    for (std::size_t line = 0; line < text.size();)
    {
      const std::size_t end = std::min(text.find('\n', line), text.size());
      const std::string field = text.substr(line, end - line);
      line = end + 1;
      if (hasData)
      {
        this->List.push_back(Trim(field));
        continue;
      }
      const std::size_t equals = field.find('=');
      const std::size_t sign = equals == std::string::npos ? field.find(':') : equals;
      if (sign == std::string::npos)
      {
        continue; // MetaIO passes over such lines, too
      }
      const std::string key = vtkMTTextFormat::ToLower(Trim(field.substr(0, sign)));
      this->Fields[key] = Trim(field.substr(sign + 1));
      hasData = key == "elementdatafile";
      this->EndOfHeader = line;
      if (hasData && this->Fields[key].rfind("LIST", 0) != 0)
      {
        return true;
      }
    }
    return hasData;
  }

  // Of the first key that is there.
  std::string Get(std::initializer_list<const char*> keys) const
  {
    for (const char* key : keys)
    {
      const auto found = this->Fields.find(key);
      if (found != this->Fields.end())
      {
        return found->second;
      }
    }
    return "";
  }
  bool IsTrue(std::initializer_list<const char*> keys) const
  {
    const std::string value = this->Get(keys);
    return !value.empty() && (value[0] == 'T' || value[0] == 't' || value[0] == '1');
  }
  /// Empty, too, where one of them is no number.
  std::vector<double> GetNumbers(std::initializer_list<const char*> keys) const
  {
    const std::string value = this->Get(keys);
    std::string_view rest(value);
    std::vector<double> numbers;
    double number = 0.0;
    for (std::string_view token; !(token = vtkMTTextFormat::NextToken(rest)).empty(); numbers.push_back(number))
    {
      if (!vtkMTTextFormat::ToNumber(token, number))
      {
        return {};
      }
    }
    return numbers;
  }
  double GetNumber(const char* key, double otherwise) const
  {
    const std::vector<double> numbers = this->GetNumbers({ key });
    return numbers.empty() ? otherwise : numbers.front();
  }

  int GetType() const
  {
    static const std::pair<const char*, int> types[] = { { "met_char", VTK_SIGNED_CHAR },
      { "met_ascii_char", VTK_CHAR }, { "met_uchar", VTK_UNSIGNED_CHAR }, { "met_short", VTK_SHORT },
      { "met_ushort", VTK_UNSIGNED_SHORT }, { "met_int", VTK_INT }, { "met_uint", VTK_UNSIGNED_INT },
      { "met_long", VTK_INT }, { "met_ulong", VTK_UNSIGNED_INT }, { "met_long_long", VTK_LONG_LONG },
      { "met_ulong_long", VTK_UNSIGNED_LONG_LONG }, { "met_float", VTK_FLOAT }, { "met_double", VTK_DOUBLE } };
    std::string name = vtkMTTextFormat::ToLower(this->Get({ "elementtype" }));
    const std::size_t suffix = name.find("_array");
    name = name.substr(0, suffix);
    for (const auto& [known, type] : types)
    {
      if (name == known)
      {
        return type;
      }
    }
    return VTK_VOID;
  }

  // An array of n or n x n numbers for n axes; false where it is there with other numbers.
  bool Find(std::initializer_list<const char*> keys, std::size_t count, std::vector<double>& numbers) const
  {
    numbers = this->GetNumbers(keys);
    return numbers.size() >= count || this->Get(keys).empty();
  }

  bool FindPlace(vtkMTVolumeHeader& header, std::size_t axes) const
  {
    std::vector<double> spacing;
    std::vector<double> offset;
    std::vector<double> matrix;
    std::vector<double> center;
    if (!this->Find({ "elementspacing", "elementsize" }, axes, spacing) ||
      !this->Find({ "offset", "position", "origin" }, axes, offset) ||
      !this->Find({ "transformmatrix", "orientation", "rotation" }, axes * axes, matrix) ||
      !this->Find({ "centerofrotation" }, axes, center))
    {
      return false;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double step = spacing.empty() ? 1.0 : header.UseSpacing(spacing[axis]);
      for (std::size_t i = 0; i < 3; ++i)
      {
        const double direction = matrix.empty() ? (i == axis ? 1.0 : 0.0) : matrix[axis * axes + i];
        header.Place.Axes[axis][i] = step * direction;
      }
      header.Place.Origin[axis] = offset.empty() ? 0.0 : offset[axis];
    }
    // It turns objects of a scene; where samples are is Offset's alone.
    const bool isTurned = std::any_of(center.begin(), center.end(), [](double x) { return x != 0.0; });
    for (const auto& [name, isIgnored] : { std::pair("volume_ignored_center_of_rotation", isTurned),
           std::pair("volume_ignored_anatomical_orientation", !this->Get({ "anatomicalorientation" }).empty()) })
    {
      if (isIgnored)
      {
        header.Report[name] = 1;
      }
    }
    header.Place.World.Crs = "MetaImage";
    header.Place.World.Units = this->Get({ "distanceunits" });
    return true;
  }

  bool FindFiles(const std::string& path, vtkMTVolumeHeader& header) const
  {
    const std::string data = this->Get({ "elementdatafile" });
    std::string_view rest(data);
    const std::string first(vtkMTTextFormat::NextToken(rest));
    std::vector<double> numbers;
    double number = 0.0;
    while (vtkMTTextFormat::ToNumber(vtkMTTextFormat::NextToken(rest), number))
    {
      numbers.push_back(number);
    }
    const double skip = this->GetNumber("headersize", 0.0);
    if (vtkMTTextFormat::ToLower(data) == "local")
    {
      header.Files.push_back({ path, this->EndOfHeader });
      return true;
    }
    if (first == "LIST")
    {
      for (const std::string& name : this->List)
      {
        if (!name.empty())
        {
          header.Files.push_back({ GetPathBeside(path, name) });
        }
      }
    }
    else if (numbers.size() < 2 || first.find('%') == std::string::npos)
    {
      header.Files.push_back({ GetPathBeside(path, data) });
    }
    else if (!ListNumbered(
               path, first, { numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 1.0 }, header.Files))
    {
      return false;
    }
    for (File& file : header.Files)
    {
      file.IsAtEnd = skip < 0.0;
      file.Offset = skip > 0.0 && skip < 1e15 ? static_cast<std::uint64_t>(skip) : 0;
    }
    return true;
  }
};

bool vtkMTVolumeHeader::ReadMetaImage(const std::string& path, const vtkMTByteSource& source, std::string& error)
{
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(source.GetSize(), 1 << 20)), ' ');
  if (!source.Read(0, text.size(), text.data(), error))
  {
    return false;
  }
  MetaImage fields;
  if (!fields.Parse(text))
  {
    error = "is no MetaImage: its header has no line \"ElementDataFile = ...\"";
    return false;
  }
  std::vector<double> sizes = fields.GetNumbers({ "dimsize" });
  this->Type = fields.GetType();
  if (this->Type == VTK_VOID)
  {
    error = "its ElementType is none that is read: \"" + fields.Get({ "elementtype" }) + '"';
    return false;
  }
  const std::size_t axes = sizes.size();
  if (axes < 3 || axes > 10 || fields.GetNumber("ndims", static_cast<double>(axes)) != static_cast<double>(axes))
  {
    error = "is no volume: NDims and DimSize must give three axes or more";
    return false;
  }
  sizes.insert(sizes.begin(), fields.GetNumber("elementnumberofchannels", 1.0));
  if (!this->SetAxes(sizes, { 1, 2, 3 }, error))
  {
    return false;
  }
  if (!fields.FindPlace(*this, axes) || !fields.FindFiles(path, *this))
  {
    error = "its header has a spacing, an offset, a matrix or a list of files that is none";
    return false;
  }
  const bool isBinary = fields.Get({ "binarydata" }).empty() || fields.IsTrue({ "binarydata" });
  this->Encoding = fields.IsTrue({ "compresseddata" }) ? Deflated : isBinary ? Raw : Text;
  this->IsBigEndian = fields.IsTrue({ "binarydatabyteordermsb", "elementbyteordermsb" });
  this->Slope = fields.GetNumber("elementtointensityfunctionslope", 1.0);
  this->Intercept = fields.GetNumber("elementtointensityfunctionoffset", 0.0);
  return true;
}
