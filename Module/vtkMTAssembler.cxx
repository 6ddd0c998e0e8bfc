// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTAssembler.h"

#include "vtkMTIdTable.h"

#include <algorithm>
#include <cstring>
#include <unordered_map>
#include <utility>

namespace
{
constexpr std::uint32_t None = vtkMTIdTable::None;

// A point of more wedges finds them by a hash of their values: a corner where hundreds of hard edges meet has a wedge
// between any two of them.
constexpr unsigned char MostWedgesInList = 16;

// As vtkMTArrayInfo::MakeUnknown has them.
constexpr unsigned char UnknownByte = 0xff;

//------------------------------------------------------------------------------
bool IsUnknown(const unsigned char* tuple, std::size_t size)
{
  return std::all_of(tuple, tuple + size, [](unsigned char byte) { return byte == UnknownByte; });
}

//------------------------------------------------------------------------------
// An unknown one where the patch has none.
void AppendTuple(vtkMTColumn& to, const vtkMTColumn& from, std::size_t index, std::size_t size)
{
  if (from.empty())
  {
    to.insert(to.end(), size, UnknownByte);
    return;
  }
  to.insert(to.end(), from.begin() + index * size, from.begin() + (index + 1) * size);
}
}

//------------------------------------------------------------------------------
struct vtkMTAssembler::Internals
{
  // What becomes of a column that some patches do not have.
  enum class Missing : unsigned char
  {
    Refused,
    GivenUp, // the mesh has it only where all patches have
    Unknown  // theirs are unknown
  };
  using Columns = std::vector<vtkMTColumn>;
  // The arrays of points, or those of cells.
  struct Side
  {
    std::vector<std::size_t> Sizes; // bytes of a tuple
    std::vector<Missing> Missings;
    std::vector<unsigned char> Has;
  };
  Side OfPoints;
  Side OfCells;
  bool First = true;
  vtkMTIdTable Table;
  std::vector<std::uint32_t> FirstWedge; // per point of the mesh
  std::vector<std::uint32_t> NextWedge;  // per wedge of the mesh
  std::vector<unsigned char> Wedges;     // per point of the mesh; MostWedgesInList and one stand for more
  std::unordered_multimap<std::uint64_t, std::uint32_t> Hashed; // wedges of points of more than are looked through
  std::vector<std::uint32_t> WedgeMap;                          // per wedge of the patch

  static bool IsCarried(const Columns& columns, std::size_t i, std::size_t tuples)
  {
    return i < columns.size() && !(columns[i].empty() && tuples > 0);
  }

  // Decides which columns the mesh has with this patch; false when one of the patch's has the wrong length. meshTuples:
  // what the mesh has of each so far.
  bool AddColumns(const Columns& columns, std::size_t tuples, std::size_t meshTuples, Side& side, Columns& ofMesh) const
  {
    for (std::size_t i = 0; i < side.Sizes.size(); ++i)
    {
      const bool carried = IsCarried(columns, i, tuples);
      if (this->First)
      {
        side.Has[i] = carried;
      }
      else if (side.Missings[i] == Missing::GivenUp && !carried && tuples > 0)
      {
        side.Has[i] = 0;
        ofMesh[i] = vtkMTColumn();
      }
      else if (side.Missings[i] == Missing::Unknown && carried && tuples > 0 && !side.Has[i])
      {
        side.Has[i] = 1;
        ofMesh[i].assign(meshTuples * side.Sizes[i], UnknownByte);
      }
      const bool mayLack = side.Missings[i] == Missing::Unknown && i < columns.size();
      if (side.Has[i] && (carried ? columns[i].size() != tuples * side.Sizes[i] : !mayLack))
      {
        return false;
      }
    }
    return true;
  }

  bool IsSound(const vtkMTPatch& patch) const
  {
    const std::size_t wedges = patch.GetNumberOfWedges();
    for (std::uint32_t point : patch.WedgePoints)
    {
      if (point >= patch.Points.size())
      {
        return false;
      }
    }
    for (const vtkMTTriangle& t : patch.Triangles)
    {
      if (t[0] >= wedges || t[1] >= wedges || t[2] >= wedges)
      {
        return false;
      }
    }
    return patch.Ids.size() <= patch.Points.size();
  }

  bool AreWedgesEqual(const vtkMTPatch& mesh, std::uint32_t a, const vtkMTPatch& patch, std::uint32_t b) const
  {
    for (std::size_t i = 0; i < this->OfPoints.Sizes.size(); ++i)
    {
      const std::size_t size = this->OfPoints.Sizes[i];
      if (!this->OfPoints.Has[i] || patch.PointColumns[i].empty())
      {
        continue;
      }
      const unsigned char* const known = mesh.PointColumns[i].data() + a * size;
      const bool isKnown = this->OfPoints.Missings[i] != Missing::Unknown || !IsUnknown(known, size);
      if (isKnown && std::memcmp(known, patch.PointColumns[i].data() + b * size, size) != 0)
      {
        return false;
      }
    }
    return true;
  }

  // Values that the wedge had not, and which the patch has.
  void AddKnown(std::uint32_t wedge, const vtkMTPatch& patch, std::uint32_t of, vtkMTPatch& mesh) const
  {
    for (std::size_t i = 0; i < this->OfPoints.Sizes.size(); ++i)
    {
      const std::size_t size = this->OfPoints.Sizes[i];
      if (this->OfPoints.Has[i] && this->OfPoints.Missings[i] == Missing::Unknown && !patch.PointColumns[i].empty())
      {
        std::memcpy(mesh.PointColumns[i].data() + wedge * size, patch.PointColumns[i].data() + of * size, size);
      }
    }
  }

  // FNV-1a, without what may be unknown.
  std::uint64_t Hash(std::uint32_t point, const vtkMTPatch& of, std::uint32_t wedge) const
  {
    std::uint64_t hash = 0xcbf29ce484222325u ^ point;
    for (std::size_t i = 0; i < this->OfPoints.Sizes.size(); ++i)
    {
      const std::size_t size = this->OfPoints.Sizes[i];
      const bool counts = this->OfPoints.Has[i] && this->OfPoints.Missings[i] != Missing::Unknown;
      for (std::size_t at = 0; counts && at < size; ++at)
      {
        const auto byte = static_cast<unsigned char>(of.PointColumns[i][wedge * size + at]);
        hash = (hash ^ byte) * 0x100000001b3u;
      }
    }
    return hash;
  }

  bool IsHashed(std::uint32_t point) const { return this->Wedges[point] > MostWedgesInList; }

  // The wedge of the point that has the values of the patch's.
  std::uint32_t Find(const vtkMTPatch& mesh, std::uint32_t point, const vtkMTPatch& patch, std::uint32_t wedge) const
  {
    if (this->IsHashed(point))
    {
      const auto range = this->Hashed.equal_range(this->Hash(point, patch, wedge));
      for (auto i = range.first; i != range.second; ++i)
      {
        if (mesh.WedgePoints[i->second] == point && this->AreWedgesEqual(mesh, i->second, patch, wedge))
        {
          return i->second;
        }
      }
      return None;
    }
    std::uint32_t known = this->FirstWedge[point];
    while (known != None && !this->AreWedgesEqual(mesh, known, patch, wedge))
    {
      known = this->NextWedge[known];
    }
    return known;
  }

  // After its values were appended to the mesh.
  void Link(const vtkMTPatch& mesh, std::uint32_t point, std::uint32_t wedge)
  {
    const bool wasHashed = this->IsHashed(point);
    this->NextWedge.push_back(this->FirstWedge[point]);
    this->FirstWedge[point] = wedge;
    this->Wedges[point] += wasHashed ? 0 : 1;
    const std::uint32_t last = wasHashed ? this->NextWedge[wedge] : None;
    for (std::uint32_t w = this->IsHashed(point) ? wedge : last; w != last; w = this->NextWedge[w])
    {
      this->Hashed.emplace(this->Hash(point, mesh, w), w);
    }
  }
};

//------------------------------------------------------------------------------
vtkMTAssembler::vtkMTAssembler(const std::vector<vtkMTArrayInfo>& arrays)
  : Implementation(new Internals)
{
  for (const vtkMTArrayInfo& array : arrays)
  {
    const bool ofCells = array.Association == vtkMTArrayInfo::Cell;
    Internals::Side& side = ofCells ? this->Implementation->OfCells : this->Implementation->OfPoints;
    side.Sizes.push_back(array.GetTupleSize());
    side.Missings.push_back(array.Role == vtkMTArrayInfo::ExactPoints ? Internals::Missing::GivenUp
        : array.IsFinestOnly()                                        ? Internals::Missing::Unknown
                                                                      : Internals::Missing::Refused);
    side.Has.push_back(1);
  }
  this->Mesh.PointColumns.resize(this->Implementation->OfPoints.Sizes.size());
  this->Mesh.CellColumns.resize(this->Implementation->OfCells.Sizes.size());
}

//------------------------------------------------------------------------------
vtkMTAssembler::~vtkMTAssembler() = default;

//------------------------------------------------------------------------------
bool vtkMTAssembler::Add(const vtkMTPatch& patch)
{
  Internals& in = *this->Implementation;
  if (!in.IsSound(patch))
  {
    this->Error = "a patch has an index out of range";
    return false;
  }
  if (!in.AddColumns(patch.PointColumns, patch.GetNumberOfWedges(), this->Mesh.WedgePoints.size(), in.OfPoints,
        this->Mesh.PointColumns) ||
    !in.AddColumns(
      patch.CellColumns, patch.Triangles.size(), this->Mesh.Triangles.size(), in.OfCells, this->Mesh.CellColumns))
  {
    this->Error = "a patch has an array of the wrong length";
    return false;
  }
  in.First = false;
  return this->AddPoints(patch) && this->AddWedgesAndTriangles(patch);
}

//------------------------------------------------------------------------------
bool vtkMTAssembler::AddPoints(const vtkMTPatch& patch)
{
  Internals& in = *this->Implementation;
  this->PointMap.resize(patch.Points.size());
  for (std::size_t i = 0; i < patch.Points.size(); ++i)
  {
    const std::uint64_t id = i < patch.Ids.size() ? patch.Ids[i] : NoId;
    const std::uint32_t fresh = static_cast<std::uint32_t>(this->Mesh.Points.size());
    std::uint32_t known = None;
    if (id != NoId)
    {
      std::uint32_t& entry = in.Table[id];
      known = entry;
      entry = known == None ? fresh : known;
    }
    if (known != None)
    {
      if (this->Mesh.Points[known] != patch.Points[i])
      {
        this->Error = "the shared point " + std::to_string(id) + " lies in two places";
        return false;
      }
      this->PointMap[i] = known;
      continue;
    }
    this->PointMap[i] = fresh;
    this->Mesh.Points.push_back(patch.Points[i]);
    this->Mesh.Ids.push_back(id);
    in.FirstWedge.push_back(None);
    in.Wedges.push_back(0);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTAssembler::AddWedgesAndTriangles(const vtkMTPatch& patch)
{
  Internals& in = *this->Implementation;
  const std::uint32_t wedges = static_cast<std::uint32_t>(patch.GetNumberOfWedges());
  in.WedgeMap.resize(wedges);
  for (std::uint32_t w = 0; w < wedges; ++w)
  {
    const std::uint32_t inPatch = patch.GetPointOfWedge(w);
    const std::uint32_t point = this->PointMap[inPatch];
    const bool shared = inPatch < patch.Ids.size() && patch.Ids[inPatch] != NoId;
    std::uint32_t known = shared ? in.Find(this->Mesh, point, patch, w) : None;
    if (known == None)
    {
      known = static_cast<std::uint32_t>(this->Mesh.WedgePoints.size());
      this->Mesh.WedgePoints.push_back(point);
      for (std::size_t i = 0; i < in.OfPoints.Sizes.size(); ++i)
      {
        if (in.OfPoints.Has[i])
        {
          AppendTuple(this->Mesh.PointColumns[i], patch.PointColumns[i], w, in.OfPoints.Sizes[i]);
        }
      }
      in.Link(this->Mesh, point, known);
    }
    else
    {
      in.AddKnown(known, patch, w, this->Mesh);
    }
    in.WedgeMap[w] = known;
  }
  for (const vtkMTTriangle& t : patch.Triangles)
  {
    this->Mesh.Triangles.push_back({ in.WedgeMap[t[0]], in.WedgeMap[t[1]], in.WedgeMap[t[2]] });
  }
  for (std::size_t i = 0; i < in.OfCells.Sizes.size(); ++i)
  {
    if (in.OfCells.Has[i])
    {
      vtkMTColumn& column = this->Mesh.CellColumns[i];
      column.insert(column.end(), patch.CellColumns[i].begin(), patch.CellColumns[i].end());
      column.resize(this->Mesh.Triangles.size() * in.OfCells.Sizes[i], UnknownByte);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTPatch vtkMTAssembler::TakeMesh()
{
  vtkMTPatch mesh = std::move(this->Mesh);
  this->Mesh = vtkMTPatch();
  this->Mesh.PointColumns.resize(this->Implementation->OfPoints.Sizes.size());
  this->Mesh.CellColumns.resize(this->Implementation->OfCells.Sizes.size());
  this->Implementation->Table = vtkMTIdTable();
  this->Implementation->FirstWedge.clear();
  this->Implementation->NextWedge.clear();
  this->Implementation->Wedges.clear();
  this->Implementation->Hashed.clear();
  this->Implementation->First = true;
  return mesh;
}
