// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTOffReader.h"

#include "vtkMTReadWhole.h"
#include "vtkMTTextFormat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace
{
using vtkMTTextFormat::NextToken;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t Few = 10; // bad lines, and a tenth of all

//------------------------------------------------------------------------------
// Colours of vertices or of faces, most of which have as many numbers.
class Colors
{
public:
  void Add(const double* numbers, std::size_t count, bool isReal)
  {
    const bool isColor = count >= 3;
    std::array<double, 4> color{ NaN, NaN, NaN, NaN };
    std::copy_n(numbers, isColor ? std::min<std::size_t>(count, 4) : 0, color.begin());
    this->Values.push_back(color);
    this->HasAlpha = this->HasAlpha || count > 3;
    this->HasAny = this->HasAny || isColor;
    this->IsReal = this->IsReal || (isColor && isReal);
    this->Largest =
      std::max({ this->Largest, isColor ? color[0] : 0.0, isColor ? color[1] : 0.0, isColor ? color[2] : 0.0 });
  }

  // White where there is none.
  void Give(vtkDataSetAttributes* attributes, vtkMTInputReport& report) const
  {
    if (!this->HasAny)
    {
      return;
    }
    const double scale = this->IsReal && this->Largest < 2.0 ? 255.0 : 1.0;
    const vtkNew<vtkUnsignedCharArray> bytes;
    bytes->SetName(this->HasAlpha ? "RGBA" : "RGB");
    bytes->SetNumberOfComponents(this->HasAlpha ? 4 : 3);
    bytes->SetNumberOfTuples(static_cast<vtkIdType>(this->Values.size()));
    std::uint64_t without = 0;
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      without += std::isnan(this->Values[i][0]) ? 1 : 0;
      for (int c = 0; c < bytes->GetNumberOfComponents(); ++c)
      {
        const double value = scale * this->Values[i][static_cast<std::size_t>(c)];
        bytes->SetTypedComponent(static_cast<vtkIdType>(i), c,
          static_cast<unsigned char>(std::isnan(value) ? 255 : std::lround(std::clamp(value, 0.0, 255.0))));
      }
    }
    attributes->SetScalars(bytes);
    vtkMTInputReports::Add("filled_colors", without, report);
    vtkMTInputReports::Add("colors_scaled_to_bytes", scale > 1.0 ? this->Values.size() : 0, report);
  }

private:
  std::vector<std::array<double, 4>> Values;
  bool HasAny = false;
  bool HasAlpha = false;
  bool IsReal = false;
  double Largest = 0.0;
};

//------------------------------------------------------------------------------
class Reader
{
public:
  explicit Reader(const vtkMTByteSource& bytes)
    : Stream(bytes)
  {
    this->Stream.SkipByteOrderMark();
  }

  bool Read(vtkPolyData* output, std::string& error)
  {
    const bool done = this->ReadHeader() && this->ReadVertices(output) && this->ReadFaces(output);
    error = this->Error.empty() ? error
      : this->LineNumber > 0    ? "line " + std::to_string(this->LineNumber) + ": " + this->Error
                                : this->Error;
    return done;
  }

  vtkMTInputReport Report;

private:
  bool Fail(const std::string& reason)
  {
    this->Error = this->Stream.GetError().empty() ? reason : this->Stream.GetError();
    return false;
  }

  // The next line that is not blank, without its comment.
  bool TakeLine()
  {
    while (this->Stream.TakeLine(this->Line))
    {
      ++this->LineNumber;
      this->Line = this->Line.substr(0, this->Line.find('#'));
      if (this->Line.find_first_not_of(" \t\r\v\f") != std::string_view::npos)
      {
        return true;
      }
    }
    return false;
  }

  // The line's numbers; NaN and all after it where a word is none.
  bool TakeNumbers()
  {
    this->Numbers.clear();
    this->Words.clear();
    for (std::string_view word = NextToken(this->Line); !word.empty(); word = NextToken(this->Line))
    {
      double number = NaN;
      if (!vtkMTTextFormat::ToNumber(word, number))
      {
        return false;
      }
      this->Numbers.push_back(number);
      this->Words.push_back(word);
    }
    return true;
  }

  bool AreReal(std::size_t first) const
  {
    return std::any_of(this->Words.begin() + static_cast<std::ptrdiff_t>(std::min(first, this->Words.size())),
      this->Words.end(), [](std::string_view word) { return word.find_first_of(".eE") != std::string_view::npos; });
  }

  bool ReadHeader()
  {
    if (!this->TakeLine())
    {
      return this->Fail("ends within its header");
    }
    std::string_view rest = this->Line;
    const std::string_view word = NextToken(rest);
    const std::size_t end = word.find("OFF");
    const bool hasWord = end != std::string_view::npos;
    const std::string_view kind = hasWord ? word.substr(0, end) : std::string_view();
    this->HasNormals = kind.find('N') != std::string_view::npos;
    this->HasTextures = kind.find("ST") != std::string_view::npos;
    if (kind.find('4') != std::string_view::npos || kind.find('n') != std::string_view::npos)
    {
      return this->Fail("has not three dimensions");
    }
    if (hasWord)
    {
      this->Line.remove_prefix(static_cast<std::size_t>(word.data() - this->Line.data()) + end + 3); // "OFF8 12 0" too
    }
    rest = this->Line;
    if (NextToken(rest) == "BINARY")
    {
      return this->Fail("is binary; OFF is read as text");
    }
    rest = this->Line;
    if (NextToken(rest).empty() && !this->TakeLine())
    {
      return this->Fail("ends within its header");
    }
    std::int64_t counts[2] = { 0, 0 };
    for (std::int64_t& count : counts)
    {
      if (!vtkMTTextFormat::ToNumber(NextToken(this->Line), count) || count < 0)
      {
        return this->Fail("has no numbers of vertices and faces");
      }
    }
    this->NumberOfVertices = static_cast<std::uint64_t>(counts[0]);
    this->NumberOfFaces = static_cast<std::uint64_t>(counts[1]);
    return true;
  }

  // Counts the line that was read last. False: there are too many, or the file ends in it.
  bool ForgiveLine(std::uint64_t count, const std::string& reason)
  {
    const bool isLast = this->Stream.GetLineEnd() == vtkMTTextFormat::Stream::NoEnd;
    if (isLast || ++this->BadLines > Few + count / Few)
    {
      return this->Fail(reason);
    }
    ++this->Report["bad_records"];
    return true;
  }

  bool ReadVertices(vtkPolyData* output)
  {
    const vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    const vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    const vtkNew<vtkFloatArray> textures;
    textures->SetName("TCoords");
    textures->SetNumberOfComponents(2);
    Colors colors;
    const std::size_t colorsBegin = this->HasNormals ? 6 : 3;
    for (std::uint64_t i = 0; i < this->NumberOfVertices; ++i)
    {
      if (!this->TakeLine())
      {
        return this->Fail("ends before vertex " + std::to_string(i + 1) + ": it is truncated");
      }
      const std::size_t least = colorsBegin + (this->HasTextures ? 2 : 0);
      if (!this->TakeNumbers() || this->Numbers.size() < least)
      {
        if (!this->ForgiveLine(this->NumberOfVertices, "a vertex has not enough numbers"))
        {
          return false;
        }
        this->Numbers.assign(least, NaN);
        this->Words.clear();
      }
      const double* const values = this->Numbers.data();
      points->InsertNextPoint(values);
      normals->InsertNextTuple(values + colorsBegin - 3);
      textures->InsertNextTuple(values + this->Numbers.size() - 2);
      colors.Add(values + colorsBegin, this->Numbers.size() - least, this->AreReal(colorsBegin));
    }
    output->SetPoints(points);
    output->GetPointData()->SetNormals(this->HasNormals ? normals.Get() : nullptr);
    output->GetPointData()->SetTCoords(this->HasTextures ? textures.Get() : nullptr);
    colors.Give(output->GetPointData(), this->Report);
    return true;
  }

  bool IsFace(std::size_t& corners) const
  {
    const auto isPoint = [this](double number)
    { return number >= 0.0 && number < static_cast<double>(this->NumberOfVertices) && number == std::floor(number); };
    if (this->Numbers.empty() || !(this->Numbers[0] >= 0.0) ||
      this->Numbers[0] > static_cast<double>(this->Numbers.size() - 1))
    {
      return false;
    }
    corners = static_cast<std::size_t>(this->Numbers[0]);
    return std::all_of(
      this->Numbers.begin() + 1, this->Numbers.begin() + 1 + static_cast<std::ptrdiff_t>(corners), isPoint);
  }

  bool ReadFaces(vtkPolyData* output)
  {
    const vtkNew<vtkCellArray> cells;
    const vtkNew<vtkIntArray> indices;
    indices->SetName("ColorIndex");
    bool hasIndices = false;
    Colors colors;
    this->BadLines = 0;
    for (std::uint64_t i = 0; i < this->NumberOfFaces; ++i)
    {
      if (!this->TakeLine())
      {
        return this->Fail("ends before face " + std::to_string(i + 1) + ": it is truncated");
      }
      std::size_t corners = 0;
      if (!this->TakeNumbers() || !this->IsFace(corners))
      {
        if (!this->ForgiveLine(
              this->NumberOfFaces, "a face has not as many vertices as it says, or one that is not there"))
        {
          return false;
        }
        corners = 0;
        this->Numbers.assign(1, 0.0);
        this->Words.clear();
      }
      cells->InsertNextCell(static_cast<int>(corners));
      for (std::size_t c = 1; c <= corners; ++c)
      {
        cells->InsertCellPoint(static_cast<vtkIdType>(this->Numbers[c]));
      }
      const std::size_t more = this->Numbers.size() - 1 - corners;
      colors.Add(this->Numbers.data() + 1 + corners, more, this->AreReal(1 + corners));
      const bool isIndex = more == 1 && std::fabs(this->Numbers.back()) < 1e9;
      indices->InsertNextValue(isIndex ? static_cast<int>(this->Numbers.back()) : -1);
      hasIndices = hasIndices || isIndex;
    }
    output->SetPolys(cells);
    colors.Give(output->GetCellData(), this->Report);
    output->GetCellData()->AddArray(hasIndices ? indices.Get() : nullptr);
    return true;
  }

  vtkMTTextFormat::Stream Stream;
  std::string_view Line;
  std::vector<double> Numbers;
  std::vector<std::string_view> Words; // that the numbers were
  std::uint64_t LineNumber = 0;
  std::uint64_t NumberOfVertices = 0;
  std::uint64_t NumberOfFaces = 0;
  std::uint64_t BadLines = 0;
  bool HasNormals = false;
  bool HasTextures = false;
  std::string Error;
};
}

bool vtkMTOffReader::Read(
  const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport* report)
{
  const auto read = [&](std::string& reason)
  {
    Reader reader(bytes);
    const bool isRead = reader.Read(output, reason);
    if (report)
    {
      vtkMTInputReports::Add(reader.Report, *report);
    }
    return isRead;
  };
  return vtkMTReadWhole::Read(bytes, output, error, read);
}
