// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchStreams
 * @brief which of the model's data is on the GPU, in what form, and how it gets there
 *
 * A plan says what the shader asks for: positions and indices always, normals packed with positions where they fit
 * (vtkMTPackedVertices); else normals, texture coordinates, tangents and
 * further attributes as floats; colours per vertex or per triangle. Apply declares the streams in the arena, so that
 * what changed is uploaded again and nothing else is, and Upload brings one patch up to date.
 *
 * Actors that share a mapper have plans of their own: one shows lines, the other surfaces. Streams of different form
 * have different names, and one goes only when no plan that was applied lately has it. So actors that take turns do not
 * take each other's data away; and one that is drawn no more leaves its data behind for a few frames only.
 */
#ifndef vtkMTPatchStreams_h
#define vtkMTPatchStreams_h

#include "vtkMTPackedVertices.h"
#include "vtkMTPatch.h"
#include "vtkMTPatchArena.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkMTGraph;

class vtkMTPatchStreams
{
public:
  /// Model data as a float attribute of the shader.
  struct Floats
  {
    std::string Attribute;
    int Array = -1;     ///< in the graph's Arrays
    int Components = 3; ///< of the attribute
    int Component = -1; ///< the array's component to begin with
  };

  /// A texture that is drawn on the cells of a material, of a part, only; -1: of all.
  struct CellTexture
  {
    std::string Name;
    int Material = -1;
    int Part = -1;
  };

  enum ColoringType : std::uint8_t
  {
    NoColors,
    PointColors,      ///< RGBA per vertex, attribute scalarColor
    PointCoordinates, ///< into the colour texture, attribute tcoord
    CellColors,       ///< RGBA per primitive, a texture buffer
    OneColor          ///< for everything: no stream, a constant attribute scalarColor
  };

  struct Plan
  {
    bool Edges = false;            ///< line indices (wireframe), else triangles
    bool ShortIndices = false;     ///< of 16 bits; no patch may have more than 65536 wedges then
    int PrimitivesPerTriangle = 1; ///< what OpenGL counts while it draws one triangle
    std::vector<Floats> Attributes;
    vtkMTPackedVertices
      Packing; ///< of this array of normals, which is none of Attributes then; -1: they are not packed
    int PackedNormals = -1;
    bool ShowsNormals = false;             ///< those of points
    int CellNormals = -1;                  ///< an array of association Cell, or none
    std::vector<CellTexture> CellTextures; ///< each cell has the first one that it may have
    std::uint64_t CellTexturesRevision = 1;
    int Materials = -1; ///< arrays of association Cell that CellTextures are about, or none
    int Parts = -1;
    ColoringType Coloring = NoColors;
    int Scalars = -1;                ///< the array that colours come from
    std::uint64_t ColorRevision = 1; ///< another one makes all colours stale
  };

  /// What maps a patch's scalars: to RGBA bytes or, for PointCoordinates, to two floats.
  using Mapping = std::function<void(int array, const vtkMTPatch& patch, std::vector<unsigned char>& bytes)>;

  static constexpr const char* Positions = "latticeMC";
  static constexpr const char* PackedPositions = "packedMC";
  static constexpr const char* CellColorStream = "cellColors";
  static constexpr const char* CellNormalStream = "cellNormals";
  static constexpr const char* CellTextureStream = "cellTextures";
  /// The streams of the plan's indices, and of data of triangles, whose form depends on what is counted as one.
  static std::string GetIndexStream(const Plan& plan);
  static std::string GetCellStream(const char* stream, const Plan& plan);

  /// user: whose plan it is; another plan of the same user takes the place of the one before.
  void Apply(const Plan& plan, const void* user, vtkMTPatchArena& arena);
  const Plan& GetPlan() const { return this->Current; }
  /// Forgets the users: their plans are of another graph.
  void Clear() { this->Uses.clear(); }

  /// One flag per array of the graph: what Upload will look at, for any of the users.
  std::vector<unsigned char> GetArrays(const vtkMTGraph& graph) const;
  bool IsStale(const vtkMTPatchArena& arena, const vtkMTPatchArena::Slot& slot) const;
  /// False when the patch has not as much data as the slot has room for.
  bool Upload(vtkMTPatchArena& arena, vtkMTPatchArena::Slot& slot, const vtkMTGraph& graph, const vtkMTPatch& patch,
    const Mapping& mapping) const;

private:
  struct Stream
  {
    int Number = 0; // in the arena
    enum KindType
    {
      Points,
      PackedPoints,
      Connectivity,
      Attribute,
      CellNormal,
      Texture,
      Color
    } Kind = Points;
    std::size_t Which = 0; // of Plan::Attributes
  };

  using Declaration = std::function<void(const std::string& name, const vtkMTPatchArena::Format& format,
    std::uint64_t revision, Stream::KindType kind, std::size_t which)>;
  static void DeclareVertices(const Plan& plan, const Declaration& declare);
  static void DeclareTriangles(const Plan& plan, const Declaration& declare);
  static void DeclareColors(const Plan& plan, const Declaration& declare);

  std::vector<float> GetCellTextures(const vtkMTGraph& graph, const vtkMTPatch& patch) const;
  std::vector<unsigned char> Make(
    const Stream& stream, const vtkMTGraph& graph, const vtkMTPatch& patch, const Mapping& mapping) const;

  // What a user has asked for last, and when.
  struct Use
  {
    Plan Wanted;
    std::vector<std::string> Names;
    std::uint64_t Time = 0;
  };

  void Note(const Plan& plan, const void* user, const std::vector<std::string>& names);
  void RemoveUnused(vtkMTPatchArena& arena);

  Plan Current;
  std::vector<Stream> Streams;
  std::vector<std::string> Names; // of the streams in the arena
  std::map<const void*, Use> Uses;
  std::uint64_t Time = 0;
};

#endif
