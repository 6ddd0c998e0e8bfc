// SPDX-License-Identifier: BSD-3-Clause
// Memoryless quadrics in a loop of the project's own.
#include "vtkMTCollapseModes.h"
#include "vtkMTCollapseRegion.h"
#include "vtkMTQuadrics.h"

#include <algorithm>

namespace
{
// An edge in the queue. An entry whose version is not the edge's own is out of date and is passed over.
struct Entry
{
  double Cost;
  std::uint32_t Edge;
  std::uint32_t Version;
};

// The cheapest edge is at the top of the heap, ties by index.
struct IsAfter
{
  bool operator()(const Entry& a, const Entry& b) const
  {
    return a.Cost != b.Cost ? a.Cost > b.Cost : a.Edge > b.Edge;
  }
};

/**
 * The cheapest edge is collapsed until the target is reached. After a collapse the costs of the edges at the kept
 * vertex are asked again; the quadrics at their other ends have changed too, so an edge that comes to the top of the
 * queue is looked at once more, and goes back when it has become dearer than the next one. An edge that may not be
 * collapsed leaves the queue until a collapse at one of its ends brings it back.
 */
class FastCollapse
{
public:
  explicit FastCollapse(vtkMTCollapseRegion& region)
    : R(region)
    , Mesh(region.Mesh)
    , Quadrics(region)
    , Versions(region.Mesh.GetNumberOfEdges(), 0)
  {
  }

  void Run()
  {
    this->Quadrics.Initialize();
    this->Queue.reserve(2 * this->Versions.size());
    for (std::uint32_t e = 0; e < this->Versions.size(); ++e)
    {
      if (this->Mesh.IsEdge(e))
      {
        this->Offer(2 * e);
      }
    }
    std::make_heap(this->Queue.begin(), this->Queue.end(), IsAfter());
    Entry entry;
    while (this->R.Faces > this->R.Target && this->Take(entry))
    {
      this->Try(entry);
    }
  }

private:
  // Appends the edge with its present cost, if it may be collapsed at all; the queue is no heap then.
  bool Offer(std::uint32_t h)
  {
    const std::uint32_t version = ++this->Versions[h / 2];
    const vtkMTCollapseRegion::Rule rule = this->R.GetRule(h);
    if (rule == vtkMTCollapseRegion::Rule::Refused)
    {
      return false;
    }
    this->R.Step();
    this->Queue.push_back({ this->Quadrics.Propose(h, rule).Cost, h / 2, version });
    return true;
  }

  bool Take(Entry& entry)
  {
    this->DropOutdated();
    if (this->Queue.empty())
    {
      return false;
    }
    entry = this->Queue.front();
    this->Pop();
    return true;
  }

  void Pop()
  {
    std::pop_heap(this->Queue.begin(), this->Queue.end(), IsAfter());
    this->Queue.pop_back();
  }

  void DropOutdated()
  {
    while (!this->Queue.empty() && this->Versions[this->Queue.front().Edge] != this->Queue.front().Version)
    {
      this->Pop();
    }
  }

  void Try(const Entry& entry)
  {
    this->R.Step();
    const std::uint32_t h = 2 * entry.Edge;
    const vtkMTCollapseRegion::Rule rule = this->R.GetRule(h);
    if (rule == vtkMTCollapseRegion::Rule::Refused || !this->R.SatisfiesLink(h))
    {
      return;
    }
    const vtkMTQuadrics::Proposal now = this->Quadrics.Propose(h, rule);
    this->DropOutdated();
    if (now.Cost > entry.Cost && !this->Queue.empty() && now.Cost > this->Queue.front().Cost)
    {
      this->Queue.push_back({ now.Cost, entry.Edge, entry.Version });
      std::push_heap(this->Queue.begin(), this->Queue.end(), IsAfter());
      return;
    }
    if (this->R.MakesChord(h, rule) || this->R.MakesDoubleEdge(h) || this->R.SpoilsShape(h, now.Place))
    {
      return;
    }
    this->Collapse(h, now.Place);
  }

  void Collapse(std::uint32_t h, const vtkMTQuadrics::Vector& place)
  {
    for (const std::uint32_t side : { h, h ^ 1 })
    {
      // Edges that disappear; which one of a triangle stays, the collapse decides.
      ++this->Versions[this->Mesh.GetNext(side) / 2];
      ++this->Versions[this->Mesh.GetPrevious(side) / 2];
    }
    const std::uint32_t kept = this->R.Collapse(h, place);
    this->Quadrics.Update(kept);
    const std::uint32_t begin = this->Mesh.Outs[kept];
    std::uint32_t out = begin;
    do
    {
      if (this->Offer(out))
      {
        std::push_heap(this->Queue.begin(), this->Queue.end(), IsAfter());
      }
      out = this->Mesh.GetNextOut(out);
    } while (out != begin);
  }

  vtkMTCollapseRegion& R;
  vtkMTCollapseMesh& Mesh;
  vtkMTQuadrics Quadrics;
  std::vector<std::uint32_t> Versions; // [edges]
  std::vector<Entry> Queue;            // a heap
};
}

void vtkMTCollapse::RunFast(vtkMTCollapseRegion& region)
{
  FastCollapse(region).Run();
}
