// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTObjReader.h"

#include "vtkMTFieldNames.h"
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

namespace
{
constexpr std::uint64_t None = vtkMTObjParser::None;

struct Cells
{
  std::vector<vtkIdType> Offsets{ 0 };
  std::vector<vtkIdType> Corners;
  std::vector<vtkMTWedgeSplitter::Key> Keys; // texture coordinate and normal of each corner, or None
  std::vector<int> Materials;
  std::vector<int> Groups;
};

class Reader : public vtkMTObjParser
{
public:
  using vtkMTObjParser::vtkMTObjParser;

  bool Read(vtkPolyData* output, std::string& error)
  {
    if (!this->Parse(error))
    {
      return false;
    }
    this->Finish(output);
    return true;
  }

private:
  bool AddVertex(const double* place, const float* colors) override
  {
    this->Places.insert(this->Places.end(), place, place + 3);
    this->Colors.insert(this->Colors.end(), colors, colors ? colors + 3 : colors);
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
    Cells& cells = cell.IsFace ? this->FaceCells : this->LineCells;
    for (const Corner& corner : cell.Corners)
    {
      cells.Corners.push_back(static_cast<vtkIdType>(corner.Point));
      cells.Keys.push_back({ corner.Texture, corner.Normal });
    }
    cells.Offsets.push_back(static_cast<vtkIdType>(cells.Corners.size()));
    cells.Materials.push_back(cell.Material);
    cells.Groups.push_back(cell.Group);
    return true;
  }

  void Finish(vtkPolyData* output);
  void FinishPoints(vtkPolyData* output) const;
  void FinishCells(vtkPolyData* output) const;

  std::vector<double> Places;
  std::vector<float> Colors;
  std::vector<float> TextureCoordinates;
  std::vector<float> NormalVectors;
  Cells LineCells;
  Cells FaceCells;
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
  if (this->HasColors)
  {
    vtkNew<vtkFloatArray> colors;
    colors->SetName("RGB");
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(points->GetNumberOfPoints());
    std::copy(this->Colors.begin(), this->Colors.end(), colors->GetPointer(0));
    output->GetPointData()->AddArray(colors);
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

void Reader::FinishCells(vtkPolyData* output) const
{
  const auto add = [&](const char* name, const std::vector<int>& ofLines, const std::vector<int>& ofFaces)
  {
    vtkNew<vtkIntArray> array; // VTK numbers lines before polygons
    array->SetName(name);
    array->SetNumberOfValues(static_cast<vtkIdType>(ofLines.size() + ofFaces.size()));
    std::copy(ofFaces.begin(), ofFaces.end(), std::copy(ofLines.begin(), ofLines.end(), array->GetPointer(0)));
    output->GetCellData()->AddArray(array);
  };
  vtkMTFieldNames::Add(output, "MaterialLibraries", this->Libraries);
  if (!this->MaterialNames.empty())
  {
    add("MaterialIds", this->LineCells.Materials, this->FaceCells.Materials);
    vtkMTFieldNames::Add(output, "MaterialNames", this->MaterialNames);
  }
  if (this->Group > 0)
  {
    add("GroupIds", this->LineCells.Groups, this->FaceCells.Groups);
  }
}

void Reader::Finish(vtkPolyData* output)
{
  this->FinishPoints(output);
  const vtkMTWedgeSplitter::Result wedges =
    vtkMTWedgeSplitter::Split(this->Places.size() / 3, this->FaceCells.Corners, this->FaceCells.Keys);
  vtkMTWedgeSplitter::AppendCopies(output, wedges.Originals);
  output->GetPointData()->SetTCoords(Pick(wedges, this->FaceCells.Keys, 0, this->TextureCoordinates, 2, "TCoords"));
  output->GetPointData()->SetNormals(Pick(wedges, this->FaceCells.Keys, 1, this->NormalVectors, 3, "Normals"));
  if (!this->LineCells.Corners.empty())
  {
    output->SetLines(ToCellArray(this->LineCells));
  }
  output->SetPolys(ToCellArray(this->FaceCells));
  this->FinishCells(output);
}
}

bool vtkMTObjReader::Read(const std::string& path, vtkPolyData* output, std::string& error)
{
  return vtkMTReadWhole::ReadFile<vtkMTObjReader>(path, output, error);
}

bool vtkMTObjReader::Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error)
{
  return vtkMTReadWhole::Read(
    bytes, output, error, [&](std::string& reason) { return Reader(bytes).Read(output, reason); });
}
