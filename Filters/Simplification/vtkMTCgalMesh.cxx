// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCgalMesh.h"

namespace
{
constexpr std::uint32_t None = vtkMTCollapseMesh::None;

template <class Index>
std::uint32_t ToNumber(Index i)
{
  return i.is_valid() ? static_cast<std::uint32_t>(i.idx()) : None;
}
}

vtkMTCgalMesh::vtkMTCgalMesh(vtkMTCollapseMesh& mesh)
  : Copy(mesh)
{
  this->Mesh.resize(static_cast<Surface::size_type>(mesh.Outs.size()), mesh.GetNumberOfEdges(),
    static_cast<Surface::size_type>(mesh.Faces.size()));
  for (std::uint32_t h = 0; h < mesh.Halfedges.size(); ++h)
  {
    if (mesh.IsEdge(h / 2))
    {
      const vtkMTCollapseMesh::Halfedge& from = mesh.Halfedges[h];
      this->Mesh.set_target(Halfedge(h), Vertex(from.Target));
      this->Mesh.set_next(Halfedge(h), Halfedge(from.Next));
      this->Mesh.set_face(Halfedge(h), from.Face == None ? Surface::null_face() : Face(from.Face));
    }
  }
  for (std::uint32_t v = 0; v < mesh.Outs.size(); ++v)
  {
    this->Mesh.point(Vertex(v)) = ToPoint(mesh.GetPlace(v));
    if (mesh.Outs[v] == None)
    {
      this->Mesh.remove_vertex(Vertex(v));
      continue;
    }
    this->Mesh.set_halfedge(Vertex(v), Halfedge(mesh.Outs[v] ^ 1));
  }
  for (std::uint32_t f = 0; f < mesh.Faces.size(); ++f)
  {
    if (mesh.Faces[f] == None)
    {
      this->Mesh.remove_face(Face(f));
      continue;
    }
    this->Mesh.set_halfedge(Face(f), Halfedge(mesh.Faces[f]));
  }
  for (std::uint32_t e = 0; e < mesh.GetNumberOfEdges(); ++e)
  {
    if (!mesh.IsEdge(e))
    {
      this->Mesh.remove_edge(Edge(e));
    }
  }
}

void vtkMTCgalMesh::BeginCollapse(Halfedge h)
{
  this->Copy.UpdateValences(static_cast<std::uint32_t>(h.idx()));
  this->Around.clear();
  this->Ends = { this->Mesh.source(h), this->Mesh.target(h) };
  for (const Halfedge start : { h, this->Mesh.opposite(h) })
  {
    Halfedge out = start;
    do
    {
      this->Remember(out);
      this->Remember(this->Mesh.next(out));
      this->Remember(this->Mesh.prev(out));
      out = this->Mesh.opposite(this->Mesh.prev(out));
    } while (out != start);
  }
}

// With its opposite, and their neighbours, whose links change with them.
void vtkMTCgalMesh::Remember(Halfedge h)
{
  for (const Halfedge side : { h, this->Mesh.opposite(h) })
  {
    this->Around.push_back(side);
    this->Around.push_back(this->Mesh.next(side));
    this->Around.push_back(this->Mesh.prev(side));
  }
}

void vtkMTCgalMesh::EndCollapse(Vertex kept)
{
  for (const Halfedge h : this->Around)
  {
    this->CopyHalfedge(h);
  }
  for (const Vertex v : this->Ends)
  {
    if (v != kept)
    {
      this->Copy.Outs[v.idx()] = None;
    }
  }
  this->Copy.Places[kept.idx()].At = ToVector(this->Mesh.point(kept));
}

void vtkMTCgalMesh::CopyHalfedge(Halfedge h)
{
  vtkMTCollapseMesh::Halfedge& to = this->Copy.Halfedges[h.idx()];
  if (to.Face != None && this->Mesh.is_removed(Face(to.Face)))
  {
    this->Copy.Faces[to.Face] = None;
  }
  if (this->Mesh.is_removed(h))
  {
    to.Target = None;
    return;
  }
  to = { ToNumber(this->Mesh.target(h)), ToNumber(this->Mesh.next(h)), ToNumber(this->Mesh.prev(h)),
    ToNumber(this->Mesh.face(h)) };
  this->Copy.Outs[this->Mesh.source(h).idx()] = static_cast<std::uint32_t>(h.idx());
  if (to.Face != None)
  {
    this->Copy.Faces[to.Face] = static_cast<std::uint32_t>(h.idx());
  }
}
