// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTAssembler.h"

#include "vtkMTIdTable.h"

#include <cstring>
#include <unordered_map>
#include <utility>

namespace
{
constexpr std::uint32_t None = vtkMTIdTable::None;

// A point of more wedges finds them by a hash of their values: a corner where hundreds of hard edges meet has a wedge
// between any two of them.
constexpr unsigned char MostWedgesInList = 16;

//------------------------------------------------------------------------------
void AppendTuple(vtkMTColumn& to, const vtkMTColumn& from, std::size_t index, std::size_t size)
{
  to.insert(to.end(), from.begin() + index * size, from.begin() + (index + 1) * size);
}
}

//------------------------------------------------------------------------------
struct vtkMTAssembler::Internals
{
  std::vector<std::size_t> PointSizes; // bytes of a tuple
  std::vector<std::size_t> CellSizes;
  std::vector<unsigned char> HasPointColumn;
  std::vector<unsigned char> HasCellColumn;
  std::vector<unsigned char> IsOptional; // of the point columns: only where all patches have it
  bool First = true;
  vtkMTIdTable Table;
  std::vector<std::uint32_t> FirstWedge; // per point of the mesh
  std::vector<std::uint32_t> NextWedge;  // per wedge of the mesh
  std::vector<unsigned char> Wedges;     // per point of the mesh; MostWedgesInList and one stand for more
  std::unordered_multimap<std::uint64_t, std::uint32_t> Hashed; // wedges of points of more than are looked through
  std::vector<std::uint32_t> WedgeMap;                          // per wedge of the patch

  bool AreColumnsRight(const std::vector<vtkMTColumn>& columns, const std::vector<std::size_t>& sizes,
    std::vector<unsigned char>& has, std::size_t tuples) const
  {
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      const bool carried = i < columns.size() && !(columns[i].empty() && tuples > 0);
      has[i] = this->First ? carried : has[i];
      if (has[i] && (!carried || columns[i].size() != tuples * sizes[i]))
      {
        return false;
      }
    }
    return true;
  }

  void GiveUpOptional(const vtkMTPatch& patch, vtkMTPatch& mesh)
  {
    for (std::size_t i = 0; i < this->IsOptional.size() && !this->First; ++i)
    {
      if (this->IsOptional[i] && i < patch.PointColumns.size() && patch.PointColumns[i].empty() &&
        patch.GetNumberOfWedges() > 0)
      {
        this->HasPointColumn[i] = 0;
        mesh.PointColumns[i] = vtkMTColumn();
      }
    }
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
    for (std::size_t i = 0; i < this->PointSizes.size(); ++i)
    {
      const std::size_t size = this->PointSizes[i];
      if (this->HasPointColumn[i] &&
        std::memcmp(mesh.PointColumns[i].data() + a * size, patch.PointColumns[i].data() + b * size, size) != 0)
      {
        return false;
      }
    }
    return true;
  }

  // FNV-1a.
  std::uint64_t Hash(std::uint32_t point, const vtkMTPatch& of, std::uint32_t wedge) const
  {
    std::uint64_t hash = 0xcbf29ce484222325u ^ point;
    for (std::size_t i = 0; i < this->PointSizes.size(); ++i)
    {
      const std::size_t size = this->PointSizes[i];
      for (std::size_t at = 0; this->HasPointColumn[i] && at < size; ++at)
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
    (array.Association == vtkMTArrayInfo::Cell ? this->Implementation->CellSizes : this->Implementation->PointSizes)
      .push_back(array.GetTupleSize());
    if (array.Association == vtkMTArrayInfo::Point)
    {
      this->Implementation->IsOptional.push_back(array.Role == vtkMTArrayInfo::ExactPoints ? 1 : 0);
    }
  }
  this->Implementation->HasPointColumn.resize(this->Implementation->PointSizes.size(), 1);
  this->Implementation->HasCellColumn.resize(this->Implementation->CellSizes.size(), 1);
  this->Mesh.PointColumns.resize(this->Implementation->PointSizes.size());
  this->Mesh.CellColumns.resize(this->Implementation->CellSizes.size());
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
  in.GiveUpOptional(patch, this->Mesh);
  if (!in.AreColumnsRight(patch.PointColumns, in.PointSizes, in.HasPointColumn, patch.GetNumberOfWedges()) ||
    !in.AreColumnsRight(patch.CellColumns, in.CellSizes, in.HasCellColumn, patch.Triangles.size()))
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
      for (std::size_t i = 0; i < in.PointSizes.size(); ++i)
      {
        if (in.HasPointColumn[i])
        {
          AppendTuple(this->Mesh.PointColumns[i], patch.PointColumns[i], w, in.PointSizes[i]);
        }
      }
      in.Link(this->Mesh, point, known);
    }
    in.WedgeMap[w] = known;
  }
  for (const vtkMTTriangle& t : patch.Triangles)
  {
    this->Mesh.Triangles.push_back({ in.WedgeMap[t[0]], in.WedgeMap[t[1]], in.WedgeMap[t[2]] });
  }
  for (std::size_t i = 0; i < in.CellSizes.size(); ++i)
  {
    if (in.HasCellColumn[i])
    {
      this->Mesh.CellColumns[i].insert(
        this->Mesh.CellColumns[i].end(), patch.CellColumns[i].begin(), patch.CellColumns[i].end());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTPatch vtkMTAssembler::TakeMesh()
{
  vtkMTPatch mesh = std::move(this->Mesh);
  this->Mesh = vtkMTPatch();
  this->Mesh.PointColumns.resize(this->Implementation->PointSizes.size());
  this->Mesh.CellColumns.resize(this->Implementation->CellSizes.size());
  this->Implementation->Table = vtkMTIdTable();
  this->Implementation->FirstWedge.clear();
  this->Implementation->NextWedge.clear();
  this->Implementation->Wedges.clear();
  this->Implementation->Hashed.clear();
  this->Implementation->First = true;
  return mesh;
}
