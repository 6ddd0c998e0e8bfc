// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTObjReader.h"

#include "vtkMTByteSource.h"
#include "vtkMTFieldNames.h"
#include "vtkMTIdNames.h"
#include "vtkMTObjMaterials.h"
#include "vtkMTObjParser.h"
#include "vtkMTReadWhole.h"
#include "vtkMTWedgeSplitter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>

namespace
{
constexpr std::uint64_t None = vtkMTObjParser::None;

struct Cells
{
  std::vector<vtkIdType> Offsets{ 0 };
  std::vector<vtkIdType> Corners;
  std::vector<vtkMTWedgeSplitter::Key> Keys; // texture coordinate and normal of each corner, or None; of faces alone
  std::vector<int> Materials;
  std::vector<int> Groups;
  std::vector<int> Objects;
};

class Reader : public vtkMTObjParser
{
public:
  explicit Reader(const vtkMTByteSource& bytes)
    : vtkMTObjParser(bytes)
    , Path(bytes.GetName())
  {
  }

  bool Read(vtkPolyData* output, std::string& error, vtkMTInputReport* report)
  {
    if (!this->Parse(error))
    {
      return false;
    }
    this->Finish(output);
    if (report)
    {
      vtkMTInputReports::Add(this->Report, *report);
    }
    return true;
  }

private:
  bool AddVertex(const double* place, const Color& color) override
  {
    this->Places.insert(this->Places.end(), place, place + 3);
    if (this->HasColors())
    {
      this->Colors.resize(this->Points - 1, { NoColor, NoColor, NoColor, NoColor });
      this->Colors.push_back(color);
    }
    return true;
  }
  bool AddTexture(const float* coordinates) override
  {
    this->TextureCoordinates.insert(this->TextureCoordinates.end(), coordinates, coordinates + 2);
    return true;
  }
  bool AddNormal(const float* normal) override
  {
    this->NormalVectors.insert(this->NormalVectors.end(), normal, normal + 3);
    return true;
  }
  bool AddCell(const Cell& cell) override
  {
    Cells& cells = this->CellsOfKind[cell.Kind];
    for (const Corner& corner : cell.Corners)
    {
      cells.Corners.push_back(static_cast<vtkIdType>(std::min(corner.Point, None >> 1)));
      if (cell.Kind == Face)
      {
        cells.Keys.push_back({ corner.Texture, corner.Normal });
      }
    }
    cells.Offsets.push_back(static_cast<vtkIdType>(cells.Corners.size()));
    cells.Materials.push_back(cell.Material);
    cells.Groups.push_back(cell.Group);
    cells.Objects.push_back(cell.Object);
    return true;
  }

  void Finish(vtkPolyData* output);
  void FinishPoints(vtkPolyData* output) const;
  void FinishCells(vtkPolyData* output) const;
  std::vector<bool> DropBadCorners(Cells& cells) const;
  std::array<std::uint64_t, 2> ForgetMissing(Cells& cells) const;

  const std::string Path;
  std::vector<double> Places;
  std::vector<Color> Colors; // empty: none has any
  std::vector<float> TextureCoordinates;
  std::vector<float> NormalVectors;
  std::array<Cells, 3> CellsOfKind; // by KindType
};

void Reader::FinishPoints(vtkPolyData* output) const
{
  vtkNew<vtkPoints> points;
  points->SetDataType(this->IsDouble ? VTK_DOUBLE : VTK_FLOAT);
  points->SetNumberOfPoints(static_cast<vtkIdType>(this->Places.size() / 3));
  for (std::size_t i = 0; i + 2 < this->Places.size(); i += 3)
  {
    points->SetPoint(static_cast<vtkIdType>(i / 3), this->Places.data() + i);
  }
  output->SetPoints(points);
  if (this->HasColors())
  {
    vtkNew<vtkFloatArray> colors;
    colors->SetName(this->HasAlpha() ? "RGBA" : "RGB");
    colors->SetNumberOfComponents(this->HasAlpha() ? 4 : 3);
    colors->SetNumberOfTuples(points->GetNumberOfPoints());
    for (std::size_t i = 0; i < this->Colors.size(); ++i)
    {
      colors->SetTypedTuple(static_cast<vtkIdType>(i), this->FinishColor(this->Colors[i]).data());
    }
    output->GetPointData()->SetScalars(colors);
  }
}

// One value of `all` per point, by the index that the point's corner has; 0 where it has none.
vtkSmartPointer<vtkFloatArray> Pick(const vtkMTWedgeSplitter::Result& wedges,
  const std::vector<vtkMTWedgeSplitter::Key>& keys, std::size_t kind, const std::vector<float>& all, int components,
  const char* name)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(wedges.Corners.size()));
  array->FillValue(0.0f);
  bool isUsed = false;
  for (std::size_t i = 0; i < wedges.Corners.size(); ++i)
  {
    const std::size_t corner = wedges.Corners[i];
    const std::uint64_t index = corner == vtkMTWedgeSplitter::NoCorner ? None : keys[corner][kind];
    if (index != None)
    {
      isUsed = true;
      array->SetTypedTuple(static_cast<vtkIdType>(i), all.data() + index * static_cast<std::size_t>(components));
    }
  }
  return isUsed ? array : nullptr;
}

vtkSmartPointer<vtkCellArray> ToCellArray(const Cells& cells)
{
  const auto copy = [](const std::vector<vtkIdType>& values)
  {
    auto array = vtkSmartPointer<vtkIdTypeArray>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
  };
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->SetData(copy(cells.Offsets), copy(cells.Corners));
  return array;
}

// Corners at points that do not exist; gives the cells that had some.
std::vector<bool> Reader::DropBadCorners(Cells& cells) const
{
  const std::size_t count = cells.Offsets.size() - 1;
  std::vector<bool> isBad(count, false);
  std::size_t kept = 0;
  std::size_t next = 0;
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    for (; next < static_cast<std::size_t>(cells.Offsets[cell + 1]); ++next)
    {
      if (!this->HasCorner(static_cast<std::uint64_t>(cells.Corners[next])))
      {
        isBad[cell] = true;
        continue;
      }
      cells.Corners[kept] = cells.Corners[next];
      if (!cells.Keys.empty())
      {
        cells.Keys[kept] = cells.Keys[next];
      }
      ++kept;
    }
    cells.Offsets[cell + 1] = static_cast<vtkIdType>(kept);
  }
  cells.Corners.resize(kept);
  cells.Keys.resize(std::min(kept, cells.Keys.size()));
  return isBad;
}

void DropCells(Cells& cells, const std::vector<bool>& isBad)
{
  std::size_t kept = 0;
  std::size_t corners = 0;
  std::size_t next = 0;
  for (std::size_t cell = 0; cell < isBad.size(); ++cell)
  {
    const auto end = static_cast<std::size_t>(cells.Offsets[cell + 1]);
    for (; next < end; ++next)
    {
      cells.Corners[corners] = cells.Corners[next];
      corners += isBad[cell] ? 0 : 1;
    }
    if (!isBad[cell])
    {
      cells.Materials[kept] = cells.Materials[cell];
      cells.Groups[kept] = cells.Groups[cell];
      cells.Objects[kept] = cells.Objects[cell];
      cells.Offsets[++kept] = static_cast<vtkIdType>(corners);
    }
  }
  cells.Corners.resize(corners);
  cells.Offsets.resize(kept + 1);
  for (std::vector<int>* values : { &cells.Materials, &cells.Groups, &cells.Objects })
  {
    values->resize(kept);
  }
}

// Texture coordinates and normals that do not exist; gives how many corners named each.
std::array<std::uint64_t, 2> Reader::ForgetMissing(Cells& cells) const
{
  std::array<std::uint64_t, 2> missing = { 0, 0 };
  for (vtkMTWedgeSplitter::Key& key : cells.Keys)
  {
    const bool isThere[2] = { this->HasTexture(key[0]), this->HasNormal(key[1]) };
    for (std::size_t kind = 0; kind < 2; ++kind)
    {
      if (!isThere[kind] && key[kind] != None)
      {
        key[kind] = None;
        ++missing[kind];
      }
    }
  }
  return missing;
}

void Reader::FinishCells(vtkPolyData* output) const
{
  const auto add = [&](const char* name, std::vector<int> Cells::*values)
  {
    const vtkNew<vtkIntArray> array;
    array->SetName(name);
    for (const Cells& cells : this->CellsOfKind)
    {
      for (const int value : cells.*values)
      {
        array->InsertNextValue(value);
      }
    }
    output->GetCellData()->AddArray(array);
    return array.Get();
  };
  vtkMTFieldNames::Add(output, "MaterialLibraries", this->Libraries);
  if (!this->Materials.Names.empty())
  {
    std::vector<std::string> ignored; // vtkMTTextureCollector meets them again
    vtkMTObjMaterials::SetTable(add("MaterialIds", &Cells::Materials), this->Materials.Names,
      vtkMTObjMaterials::Read(this->Path, this->Libraries, ignored));
    vtkMTFieldNames::Add(output, "MaterialNames", this->Materials.Names);
  }
  if (this->HasGroups())
  {
    vtkMTIdNames::Set(add("GroupIds", &Cells::Groups), this->Groups.Names);
  }
  if (this->HasObjects())
  {
    vtkMTIdNames::Set(add("ObjectIds", &Cells::Objects), this->Objects.Names);
  }
}

void Reader::Finish(vtkPolyData* output)
{
  std::array<std::vector<bool>, 3> isBad;
  std::uint64_t badCells = 0;
  for (std::size_t kind = 0; kind < 3; ++kind)
  {
    isBad[kind] = this->DropBadCorners(this->CellsOfKind[kind]);
    badCells += static_cast<std::uint64_t>(std::count(isBad[kind].begin(), isBad[kind].end(), true));
  }
  Cells& faces = this->CellsOfKind[Face];
  const std::array<std::uint64_t, 2> missing = this->ForgetMissing(faces);
  this->CountAll(missing, badCells);
  this->Colors.resize(this->HasColors() ? this->Points : 0, { NoColor, NoColor, NoColor, NoColor });
  this->FinishPoints(output);
  const vtkMTWedgeSplitter::Result wedges =
    vtkMTWedgeSplitter::Split(this->Places.size() / 3, faces.Corners, faces.Keys);
  vtkMTWedgeSplitter::AppendCopies(output, wedges.Originals);
  output->GetPointData()->SetTCoords(Pick(wedges, faces.Keys, 0, this->TextureCoordinates, 2, "TCoords"));
  output->GetPointData()->SetNormals(Pick(wedges, faces.Keys, 1, this->NormalVectors, 3, "Normals"));
  for (std::size_t kind = 0; kind < 3; ++kind)
  {
    Cells& cells = this->CellsOfKind[kind];
    if (badCells > 0)
    {
      DropCells(cells, isBad[kind]);
    }
    if (kind == Face || !cells.Materials.empty())
    {
      kind == Vertices ? output->SetVerts(ToCellArray(cells))
        : kind == Line ? output->SetLines(ToCellArray(cells))
                       : output->SetPolys(ToCellArray(cells));
    }
  }
  this->FinishCells(output);
}
}

bool vtkMTObjReader::Read(const std::string& path, vtkPolyData* output, std::string& error)
{
  return vtkMTReadWhole::ReadFile<vtkMTObjReader>(path, output, error);
}

bool vtkMTObjReader::Read(
  const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, vtkMTInputReport* report)
{
  return vtkMTReadWhole::Read(
    bytes, output, error, [&](std::string& reason) { return Reader(bytes).Read(output, reason, report); });
}
