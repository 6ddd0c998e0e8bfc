// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCollapseMesh.h"

#include "vtkMTFanMesh.h"

#include <memory>

vtkMTCollapseMesh::vtkMTCollapseMesh(const vtkMTFanMesh& fans)
{
  const auto corners = static_cast<std::uint32_t>(fans.Vertex.size());
  const std::unique_ptr<std::uint32_t[]> halfedges(new std::uint32_t[corners]); // that of each edge of a triangle
  std::vector<std::uint32_t> borders; // the corners behind whose edges nothing is
  std::uint32_t count = 0;
  for (std::uint32_t c = 0; c < corners; ++c)
  {
    const std::uint32_t opposite = fans.Opposite[c];
    if (opposite > c) // None too
    {
      halfedges[c] = count;
      if (opposite != vtkMTFanMesh::None)
      {
        halfedges[opposite] = count + 1;
      }
      else
      {
        borders.push_back(c);
      }
      count += 2;
    }
  }
  this->Halfedges.resize(count);
  this->Wedges.assign(fans.Seams ? count : 0, None);
  this->Faces.resize(corners / 3);
  this->Outs.resize(fans.GetNumberOfVertices());
  this->Places.resize(fans.GetNumberOfVertices());
  this->Valences.assign(fans.GetNumberOfVertices(), 0);
  for (std::uint32_t c = 0; c < corners; c += 3)
  {
    const std::uint32_t* const h = halfedges.get() + c;
    const std::uint32_t* const v = fans.Vertex.data() + c;
    this->Halfedges[h[0]] = { v[1], h[1], h[2], c / 3 };
    this->Halfedges[h[1]] = { v[2], h[2], h[0], c / 3 };
    this->Halfedges[h[2]] = { v[0], h[0], h[1], c / 3 };
    this->Faces[c / 3] = h[2];
    for (int i = 0; i < 3; ++i)
    {
      this->Outs[v[i]] = h[i];
      ++this->Valences[v[i]];
    }
  }
  for (std::uint32_t c = 0; fans.Seams && c < corners; ++c)
  {
    this->Wedges[halfedges[c]] = fans.Wedge[vtkMTFanMesh::Next(c)];
  }
  this->LinkBorders(fans, halfedges.get(), borders);
}

// A vertex is one fan, so at most one border half-edge runs into it and one out of it.
void vtkMTCollapseMesh::LinkBorders(
  const vtkMTFanMesh& fans, const std::uint32_t* halfedges, const std::vector<std::uint32_t>& borders)
{
  for (const std::uint32_t c : borders)
  {
    const std::uint32_t h = halfedges[c] ^ 1;
    this->Halfedges[h].Target = fans.Vertex[c];
    this->Outs[fans.Vertex[vtkMTFanMesh::Next(c)]] = h;
    ++this->Valences[fans.Vertex[c]];
  }
  for (const std::uint32_t c : borders)
  {
    const std::uint32_t h = halfedges[c] ^ 1;
    this->Link(h, this->Outs[this->GetTarget(h)]);
  }
}

bool vtkMTCollapseMesh::IsBorderVertex(std::uint32_t vertex) const
{
  const std::uint32_t begin = this->Outs[vertex];
  std::uint32_t out = begin;
  do
  {
    if (this->IsBorder(out))
    {
      return true;
    }
    out = this->GetNextOut(out);
  } while (out != begin);
  return false;
}

void vtkMTCollapseMesh::UpdateValences(std::uint32_t h)
{
  const std::uint32_t merged = this->GetMergedValence(h);
  this->Valences[this->GetSource(h)] = merged;
  this->Valences[this->GetTarget(h)] = merged;
  for (const std::uint32_t side : { h, h ^ 1 })
  {
    if (!this->IsBorder(side))
    {
      --this->Valences[this->GetTarget(this->GetNext(side))];
    }
  }
}

void vtkMTCollapseMesh::Collapse(std::uint32_t h)
{
  this->UpdateValences(h);
  const std::uint32_t back = h ^ 1;
  const std::uint32_t removed = this->GetSource(h);
  const std::uint32_t kept = this->GetTarget(h);
  std::uint32_t out = h;
  do
  {
    this->Halfedges[out ^ 1].Target = kept;
    out = this->GetNextOut(out);
  } while (out != h);
  // The sides of the edge at the kept vertex take the places of those at the removed one.
  const std::uint32_t left = this->GetNext(h);
  const std::uint32_t right = this->GetPrevious(back);
  const bool hasLeft = !this->IsBorder(h);
  this->RemoveSide(h, this->GetPrevious(h), left);
  this->RemoveSide(back, this->GetNext(back), right);
  this->Outs[kept] = hasLeft ? left : right ^ 1;
  this->Outs[removed] = None;
  this->Halfedges[h].Target = None;
  this->Halfedges[back].Target = None;
}

// Removes a triangle (a border half-edge) and its edge `dying`, whose outer half-edge is replaced by `heir`.
void vtkMTCollapseMesh::RemoveSide(std::uint32_t side, std::uint32_t dying, std::uint32_t heir)
{
  if (this->IsBorder(side))
  {
    this->Link(this->GetPrevious(side), this->GetNext(side));
    return;
  }
  this->Faces[this->GetFace(side)] = None;
  const std::uint32_t outer = dying ^ 1;
  const Halfedge old = this->Halfedges[outer];
  this->Halfedges[heir].Face = old.Face;
  this->Link(old.Previous, heir);
  this->Link(heir, old.Next);
  if (old.Face != None)
  {
    this->Faces[old.Face] = heir;
  }
  // The third vertex: one of the two edges started or ended there.
  const bool endsThere = this->GetTarget(heir) != this->GetTarget(side);
  this->Outs[endsThere ? this->GetTarget(heir) : this->GetSource(heir)] = endsThere ? heir ^ 1 : heir;
  this->Halfedges[dying].Target = None;
  this->Halfedges[outer].Target = None;
}

void vtkMTCollapseMesh::FillHole(std::uint32_t h)
{
  const auto face = static_cast<std::uint32_t>(this->Faces.size());
  this->Faces.push_back(h);
  for (std::uint32_t side : { h, this->GetNext(h), this->GetPrevious(h) })
  {
    this->Halfedges[side].Face = face;
  }
}

bool vtkMTCollapseMesh::IsValid() const
{
  for (std::uint32_t h = 0; h < this->Halfedges.size(); ++h)
  {
    if (!this->IsEdge(h / 2))
    {
      continue;
    }
    const Halfedge& e = this->Halfedges[h];
    const bool isTriangle = e.Face == None || this->GetNext(this->GetNext(e.Next)) == h;
    if (this->GetPrevious(e.Next) != h || this->GetNext(e.Previous) != h || this->GetSource(e.Next) != e.Target ||
      this->GetFace(e.Next) != e.Face || !isTriangle || this->Outs[e.Target] == None ||
      this->GetSource(this->Outs[e.Target]) != e.Target)
    {
      return false;
    }
  }
  return true;
}
