// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlyFaces.h"

#include "vtkMTPlyRows.h"

#include "vtkCellData.h"

vtkMTPlyFaces::vtkMTPlyFaces(const vtkMTPlyElement& element, const vtkMTPlyColors& colors, std::uint64_t count,
  std::uint64_t vertices, vtkCellData* attributes)
  : Element(element)
  , Count(count)
  , Vertices(vertices)
  , Columns(element, count)
  , Indices(element.FindCorners())
  , Texture(element.Find("texcoord"))
{
  this->Texture = this->Texture && this->Texture->IsList() ? this->Texture : nullptr;
  this->Columns.AddColors(colors, attributes);
  this->Columns.AddOthers(attributes);
}

bool vtkMTPlyFaces::Read(vtkMTPlyRows& rows, vtkMTCellCorners& corners)
{
  const bool isPlain = this->Element.Properties.size() == 1;
  for (std::uint64_t row = 0; row < this->Count;)
  {
    const std::size_t before = corners.Points.size();
    const std::uint64_t triangles =
      isPlain ? rows.TakeTriangles(*this->Indices, this->Count - row, this->Vertices, corners.Points) : 0;
    for (std::size_t t = 1; t <= triangles; ++t)
    {
      corners.Ends.push_back(before + 3 * t);
    }
    if (triangles == 0)
    {
      const std::size_t textureBefore = this->TextureCoordinates.size();
      bool isGood = true;
      if (!rows.BeginRow() || !rows.EndRow(this->ReadRow(rows, row, corners), isGood))
      {
        return false;
      }
      if (!isGood)
      {
        corners.Points.resize(before);
        this->TextureCoordinates.resize(textureBefore);
        this->Columns.Blank(row);
      }
      corners.Ends.push_back(corners.Points.size());
      this->FillTexture(rows, textureBefore, 2 * (corners.Points.size() - before));
    }
    row += triangles > 0 ? triangles : 1;
  }
  return true;
}

bool vtkMTPlyFaces::ReadRow(vtkMTPlyRows& rows, std::uint64_t row, vtkMTCellCorners& corners)
{
  for (std::size_t i = 0; i < this->Element.Properties.size(); ++i)
  {
    const vtkMTPlyProperty& property = this->Element.Properties[i];
    double value = 0.0;
    const bool done = &property == this->Indices ? rows.ReadCorners(property, this->Vertices, corners.Points)
      : &property == this->Texture               ? this->ReadTexture(rows)
      : property.IsList()                        ? rows.SkipProperty(property)
                                                 : rows.Read(property, value);
    if (!done)
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

// The face's corners may come before or after them in the row.
bool vtkMTPlyFaces::ReadTexture(vtkMTPlyRows& rows)
{
  std::uint64_t count = 0;
  if (!rows.ReadCount(*this->Texture, count))
  {
    return false;
  }
  for (std::uint64_t i = 0; i < count; ++i)
  {
    double value = 0.0;
    if (!rows.Read(*this->Texture, value))
    {
      return false;
    }
    this->TextureCoordinates.push_back(value);
  }
  return true;
}

// A face without coordinates, or with too many or too few of them, gets zeros.
void vtkMTPlyFaces::FillTexture(vtkMTPlyRows& rows, std::size_t before, std::size_t wanted)
{
  const std::size_t found = this->TextureCoordinates.size() - before;
  if (!this->Texture || found == wanted)
  {
    return;
  }
  if (found > 0)
  {
    rows.Count("faces_with_impossible_texture_coordinates");
  }
  this->TextureCoordinates.resize(before);
  this->TextureCoordinates.resize(before + wanted, 0.0);
}
