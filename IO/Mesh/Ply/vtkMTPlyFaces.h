// SPDX-License-Identifier: BSD-3-Clause
// Rows of a PLY file's faces: their corners, their texture coordinates and their arrays. Not installed.
#ifndef vtkMTPlyFaces_h
#define vtkMTPlyFaces_h

#include "vtkMTCellCorners.h"
#include "vtkMTPlyColumns.h"

class vtkMTPlyRows;
class vtkCellData;

/// The whole element or a part of it: whoever reads a file at once and whoever reads it in parts get the same arrays.
class vtkMTPlyFaces
{
public:
  /// Gives the attributes all arrays that the element has, colours as the file has them, with so many values. There are
  /// so many vertices. The element must have a list of corners, and outlive this.
  vtkMTPlyFaces(const vtkMTPlyElement& element, const vtkMTPlyColors& colors, std::uint64_t count,
    std::uint64_t vertices, vtkCellData* attributes);

  /// Appends the corners of as many rows as there are values, none for those that cannot be read. False on failure; the
  /// rows say why.
  bool Read(vtkMTPlyRows& rows, vtkMTCellCorners& corners);

  /// The list "texcoord", two values per corner; nullptr when there is none.
  const vtkMTPlyProperty* GetTexture() const { return this->Texture; }
  /// Two for each corner that was read; 0 where a face has none.
  const std::vector<double>& GetTextureCoordinates() const { return this->TextureCoordinates; }

private:
  bool ReadRow(vtkMTPlyRows& rows, std::uint64_t row, vtkMTCellCorners& corners);
  bool ReadTexture(vtkMTPlyRows& rows);
  void FillTexture(vtkMTPlyRows& rows, std::size_t before, std::size_t wanted);

  const vtkMTPlyElement& Element;
  const std::uint64_t Count;
  const std::uint64_t Vertices;
  vtkMTPlyColumns Columns;
  const vtkMTPlyProperty* Indices;
  const vtkMTPlyProperty* Texture;
  std::vector<double> TextureCoordinates;
};

#endif
