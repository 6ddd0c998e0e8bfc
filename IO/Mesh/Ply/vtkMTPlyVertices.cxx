// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyVertices.h"

#include "vtkMTPlyRows.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

vtkMTPlyVertices::vtkMTPlyVertices(
  const vtkMTPlyElement& element, const vtkMTPlyColors& colors, std::uint64_t count, vtkPolyData* output)
  : Element(element)
  , Count(count)
  , Columns(element, count)
{
  const std::vector<std::string> place = { "x", "y", "z" };
  const vtkNew<vtkPoints> points;
  points->SetData(this->Columns.Group(place, "Points", this->Columns.FindRealType(place)));
  output->SetPoints(points);
  vtkPointData* attributes = output->GetPointData();
  const std::vector<std::string> normal = { "nx", "ny", "nz" };
  attributes->SetNormals(this->Columns.Group(normal, "Normals", this->Columns.FindRealType(normal)));
  this->Columns.AddColors(colors, attributes);
  const std::vector<std::vector<std::string>> pairs = { { "s", "t" }, { "u", "v" }, { "texture_u", "texture_v" },
    { "texture_s", "texture_t" } };
  for (const std::vector<std::string>& pair : pairs)
  {
    if (!attributes->GetTCoords())
    {
      attributes->SetTCoords(this->Columns.Group(pair, "TCoords", this->Columns.FindRealType(pair)));
    }
  }
  this->Columns.AddOthers(attributes);
}

bool vtkMTPlyVertices::Read(vtkMTPlyRows& rows)
{
  const bool areAsInFile = this->Columns.AreAsInFile();
  for (std::uint64_t row = 0; row < this->Count; ++row)
  {
    const unsigned char* buffered = nullptr;
    const std::uint64_t rowsAtOnce = areAsInFile ? rows.GetBuffered(this->Count - row, buffered) : 0;
    if (rowsAtOnce > 0)
    {
      this->Columns.Copy(buffered, row, rowsAtOnce);
      row += rowsAtOnce - 1;
      if (!rows.SkipRows(rowsAtOnce))
      {
        return false;
      }
      continue;
    }
    bool isGood = true;
    if (!rows.BeginRow() || !rows.EndRow(this->ReadRow(rows, row), isGood))
    {
      return false;
    }
    if (!isGood)
    {
      this->Columns.Blank(row);
    }
  }
  return true;
}

bool vtkMTPlyVertices::ReadRow(vtkMTPlyRows& rows, std::uint64_t row)
{
  for (std::size_t i = 0; i < this->Element.Properties.size(); ++i)
  {
    const vtkMTPlyProperty& property = this->Element.Properties[i];
    double value = 0.0;
    if (property.IsList() ? !rows.SkipProperty(property) : !rows.Read(property, value))
    {
      return false;
    }
    if (!property.IsList())
    {
      this->Columns.Store(i, row, value);
    }
  }
  return true;
}
