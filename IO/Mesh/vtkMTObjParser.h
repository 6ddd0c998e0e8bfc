// SPDX-License-Identifier: BSD-3-Clause
// The lines of a Wavefront OBJ file, understood one after the other. Not installed.
#ifndef vtkMTObjParser_h
#define vtkMTObjParser_h

#include "vtkMTTextFormat.h"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Says what the lines are; derived classes keep it. Indices may refer to what only comes later: AreIndicesGood is
/// known at the end.
class vtkMTObjParser
{
public:
  static constexpr std::uint64_t None = std::numeric_limits<std::uint64_t>::max();

  explicit vtkMTObjParser(const vtkMTByteSource& bytes)
    : Stream(bytes)
  {
  }
  virtual ~vtkMTObjParser() = default;

  /// Reads everything. False with a message in error.
  bool Parse(std::string& error);

protected:
  /// A corner of a face or a line: point, texture coordinate and normal, counted from 0, or None.
  struct Corner
  {
    std::uint64_t Point = None;
    std::uint64_t Texture = None;
    std::uint64_t Normal = None;
  };
  struct Cell
  {
    bool IsFace = true;
    std::vector<Corner> Corners;
    int Material = -1;
    int Group = 0;
  };

  ///@{
  /// What a line says. colors: three, or null. False on failure, with a message in Error.
  virtual bool AddVertex(const double* place, const float* colors) = 0;
  virtual bool AddTexture(const float* coordinates) = 0;
  virtual bool AddNormal(const float* normal) = 0;
  virtual bool AddCell(const Cell& cell) = 0;
  ///@}

  bool Fail(const std::string& reason)
  {
    this->Error = reason;
    return false;
  }

  std::string Error;
  std::uint64_t Points = 0;
  std::uint64_t Textures = 0;
  std::uint64_t Normals = 0;
  std::uint64_t Faces = 0;
  std::uint64_t Lines = 0;
  bool IsDouble = false;  ///< some coordinate says more than single precision keeps
  bool HasColors = false; ///< all vertices have some
  std::vector<std::string> MaterialNames;
  std::vector<std::string> Libraries;
  int Group = -1; ///< the present one

private:
  bool TakeWholeLine(std::string_view& line);
  bool ReadLine(std::string_view line);
  bool ReadVertex(std::string_view line);
  bool ReadNumbers(std::string_view line, std::size_t least, std::size_t count, float* values);
  bool ReadCell(std::string_view line, bool isFace);
  bool ReadCorner(std::string_view token, Corner& corner);
  static bool ReadIndex(std::string_view& token, std::uint64_t count, std::uint64_t& index);
  void UseMaterial(std::string_view line);
  void UseLibraries(std::string_view line);
  bool CheckIndices(std::string& error) const;

  vtkMTTextFormat::Stream Stream;
  std::uint64_t LineNumber = 0;
  std::string Joined; // lines that end in a backslash, with what follows
  Cell ThisCell;
  std::map<std::string, int> Materials;
  int Material = -1;
  Corner Largest{ 0, 0, 0 }; // one more than the largest index of each kind
};

#endif
