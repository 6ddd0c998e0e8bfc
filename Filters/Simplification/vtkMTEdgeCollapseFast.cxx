// SPDX-License-Identifier: BSD-3-Clause
// Memoryless quadrics in a loop of the project's own.
#include "vtkMTCollapseModes.h"
#include "vtkMTCollapseRegion.h"
#include "vtkMTEdgeQueue.h"
#include "vtkMTQuadrics.h"

#include <array>

namespace
{
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
    , Queue(region.Mesh.GetNumberOfEdges())
  {
  }

  void Run()
  {
    this->Quadrics.Initialize();
    for (std::uint32_t e = 0; e < this->Mesh.GetNumberOfEdges(); ++e)
    {
      if (this->Mesh.IsEdge(e))
      {
        this->Offer(2 * e);
      }
    }
    this->Flush();
    while (this->R.Faces > this->R.Target)
    {
      const std::uint32_t edge = this->Queue.Take();
      if (edge == vtkMTEdgeQueue::None)
      {
        return;
      }
      this->Try(2 * edge);
    }
  }

private:
  // Puts the edge in the queue with its present cost, if it may be collapsed at all; with the next ones, as the costs
  // of four are found at once.
  void Offer(std::uint32_t h)
  {
    const vtkMTCollapseRegion::Rule rule = this->R.GetRule(h);
    if (rule == vtkMTCollapseRegion::Rule::Refused)
    {
      this->Queue.Withdraw(h / 2);
      return;
    }
    this->R.Step();
    this->Offers[this->Count++] = { h, rule };
    if (this->Count == this->Offers.size())
    {
      this->Flush();
    }
  }

  void Flush()
  {
    const std::size_t offered = this->Count;
    while (this->Count % 4 != 0)
    {
      this->Offers[this->Count++] = this->Offers[offered - 1];
    }
    this->Quadrics.Propose(this->Offers.data(), this->Count, this->Proposals.data());
    for (std::size_t i = 0; i < offered; ++i)
    {
      this->Queue.Put(this->Offers[i].Halfedge / 2, this->Proposals[i / 4].Cost[i % 4]);
    }
    this->Count = 0;
  }

  void Try(std::uint32_t h)
  {
    this->R.Step();
    const vtkMTCollapseRegion::Rule rule = this->R.GetRule(h);
    if (rule == vtkMTCollapseRegion::Rule::Refused || this->R.MakesHub(h))
    {
      return;
    }
    const vtkMTQuadrics::Proposal now = this->Quadrics.Propose(h, rule);
    if (!this->Queue.IsNext(now.Cost))
    {
      this->Queue.Put(h / 2, now.Cost);
    }
    else if (this->R.SatisfiesLink(h) && !this->R.MakesChord(h, rule) && !this->R.MakesDoubleEdge(h) &&
      !this->R.SpoilsShape(h, now.Place))
    {
      this->Collapse(h, now.Place);
    }
  }

  void Collapse(std::uint32_t h, const vtkMTQuadrics::Vector& place)
  {
    for (const std::uint32_t side : { h, h ^ 1 })
    {
      // Edges that disappear; which one of a triangle stays, the collapse decides.
      this->Queue.Withdraw(this->Mesh.GetNext(side) / 2);
      this->Queue.Withdraw(this->Mesh.GetPrevious(side) / 2);
    }
    const std::uint32_t kept = this->R.Collapse(h, place);
    this->Quadrics.Update(kept);
    const std::uint32_t begin = this->Mesh.Outs[kept];
    std::uint32_t out = begin;
    do
    {
      this->Offer(out);
      out = this->Mesh.GetNextOut(out);
    } while (out != begin);
    this->Flush();
  }

  vtkMTCollapseRegion& R;
  vtkMTCollapseMesh& Mesh;
  vtkMTQuadrics Quadrics;
  vtkMTEdgeQueue Queue;
  std::array<vtkMTQuadrics::Request, 32> Offers;
  std::array<vtkMTQuadrics::Four, 8> Proposals;
  std::size_t Count = 0; // of offers
};
}

void vtkMTCollapse::RunFast(vtkMTCollapseRegion& region)
{
  FastCollapse(region).Run();
}
