// SPDX-License-Identifier: BSD-3-Clause
// The lines of a Wavefront OBJ file, understood one after the other. Not installed.
#ifndef vtkMTObjParser_h
#define vtkMTObjParser_h

#include "vtkMTInputReport.h"
#include "vtkMTTextFormat.h"

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/**
 * Says what the lines are; derived classes keep it. A line that is wrong costs itself, or what it says, and is counted:
 * a vertex keeps its number and has no place (NaN), a normal or a texture coordinate is 0, a cell is left out. Indices
 * may refer to what only comes later: which do not exist is known at the end (HasCorner, HasTexture, HasNormal), and
 * derived classes leave it out then.
 */
class vtkMTObjParser
{
public:
  static constexpr std::uint64_t None = std::numeric_limits<std::uint64_t>::max();
  static constexpr float NoColor = std::numeric_limits<float>::quiet_NaN();
  /// Red, green, blue and alpha as the file has them; NoColor where it has none.
  using Color = std::array<float, 4>;

  explicit vtkMTObjParser(const vtkMTByteSource& bytes)
    : Stream(bytes)
  {
  }
  virtual ~vtkMTObjParser() = default;

  /// Reads everything. False with a message in error.
  bool Parse(std::string& error);

protected:
  /// A corner of a cell: point, texture coordinate and normal, counted from 0, or None.
  struct Corner
  {
    std::uint64_t Point = None;
    std::uint64_t Texture = None;
    std::uint64_t Normal = None;
  };
  /// In the order in which VTK numbers them.
  enum KindType
  {
    Vertices,
    Line,
    Face
  };
  struct Cell
  {
    KindType Kind = Face;
    std::vector<Corner> Corners;
    int Material = -1; ///< -1: none
    int Group = 0;
    int Object = -1; ///< -1: none
  };
  /// Names, numbered in the order in which they come up.
  struct NameList
  {
    int GetId(const std::string& name);
    std::vector<std::string> Names;
    std::map<std::string, int> Ids;
  };

  ///@{
  /// What a line says. False on failure, with a message in Error.
  virtual bool AddVertex(const double* place, const Color& color) = 0;
  virtual bool AddTexture(const float* coordinates) = 0;
  virtual bool AddNormal(const float* normal) = 0;
  virtual bool AddCell(const Cell& cell) = 0;
  ///@}

  ///@{
  /// What there is, when all has been read.
  bool HasCorner(std::uint64_t point) const { return point < this->Points; }
  bool HasTexture(std::uint64_t index) const { return index < this->Textures; }
  bool HasNormal(std::uint64_t index) const { return index < this->Normals; }
  bool HasColors() const { return this->ColoredVertices > 0; }
  bool HasAlpha() const { return this->LargestAlpha >= 0.0f; }
  bool HasGroups() const { return this->Groups.Names.size() > 1; }
  bool HasObjects() const { return this->Objects.Names.size() + (this->HasCellsOfNoObject ? 1 : 0) > 1; }
  ///@}
  /// Counts what Parse found, when all has been read. missing: corners that name texture coordinates and normals that
  /// do not exist; badCells: cells with points that do not.
  void CountAll(const std::array<std::uint64_t, 2>& missing, std::uint64_t badCells);
  /// The color of a vertex in 0 ... 1, white where it has none.
  Color FinishColor(Color color) const;

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
  bool IsDouble = false; ///< some coordinate says more than single precision keeps
  NameList Materials;
  NameList Groups;
  NameList Objects;
  std::vector<std::string> Libraries; ///< what follows mtllib: one name, or several
  vtkMTInputReport Report;

private:
  bool CheckEncoding();
  bool TakeWholeLine(std::string_view& line);
  bool ReadLine(std::string_view line);
  bool ReadVertex(std::string_view line);
  std::size_t ReadCoordinates(std::string_view line, double* values);
  Color TakeColor(const double* values, std::size_t count);
  bool ReadTexture(std::string_view line);
  bool ReadNormal(std::string_view line);
  bool ReadCell(std::string_view line, KindType kind, std::size_t least);
  bool ReadCorner(std::string_view token, Corner& corner);
  void CountCorners();
  bool ReadNames(std::string_view keyword, std::string_view line);
  void CountIgnored(std::string_view keyword, std::string_view line);
  void Count(const char* reason) { ++this->Report[reason]; }

  vtkMTTextFormat::Stream Stream;
  std::string Joined; // lines that end in a backslash, with what follows
  Cell ThisCell;
  int Material = -1;
  int Object = -1;
  int Group = -1; // -1: not known, as no cell has used the name
  std::string GroupName = "default";
  std::string ObjectName;
  bool HasCellsOfNoObject = false;
  std::set<std::string> SmoothingGroups;

  std::uint64_t ColoredVertices = 0;
  float LargestColor = 0.0f;
  float LargestAlpha = -1.0f; // -1: none has any
  bool AreColorsWhole = true;
  std::uint64_t FaceCorners = 0;
  std::uint64_t CornersWithTexture = 0;
  std::uint64_t CornersWithNormal = 0;
  std::uint64_t MissingTextures = 0; // named by 0, or counted backwards beyond the first
  std::uint64_t MissingNormals = 0;
};

#endif
