// SPDX-License-Identifier: BSD-3-Clause
// What is computed for four at a time, and what is kept from one collapse to the next, against the definition.
#include "SimplificationTesting.h"

#include "vtkMTCollapseModes.h"
#include "vtkMTCollapseRegion.h"
#include "vtkMTFanMesh.h"
#include "vtkMTQuadrics.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

using namespace SimplificationTesting;
using namespace vtkMTVector;

namespace
{
using Rule = vtkMTCollapseRegion::Rule;

struct Case
{
  vtkMTPatch Floor;
  vtkMTFanMesh Fans;
  std::unique_ptr<vtkMTCollapseRegion> Region;

  Case(const vtkMTPatch& floor, const Locks& locked)
    : Floor(floor)
  {
    std::string error;
    EXPECT_TRUE(this->Fans.Build(this->Floor, locked, error)) << error;
    this->Region = std::make_unique<vtkMTCollapseRegion>(this->Floor, this->Fans);
  }
};

Vector GetNormal(const vtkMTCollapseMesh& m, std::uint32_t h)
{
  const Vector& p = m.GetPlace(m.GetTarget(h));
  return Cross(Subtract(m.GetPlace(m.GetTarget(m.GetNext(h))), p), Subtract(m.GetPlace(m.GetSource(h)), p));
}

// Area times squared distance to the planes of the triangles around the ends.
double GetCost(const vtkMTCollapseMesh& m, std::uint32_t h, const Vector& place)
{
  double sum = 0.0;
  for (const std::uint32_t start : { h, h ^ 1 })
  {
    std::uint32_t out = start;
    do
    {
      if (!m.IsBorder(out))
      {
        const Vector n = GetNormal(m, out);
        const double length = Norm(n);
        const double distance = length > 0.0 ? Dot(n, Subtract(place, m.GetPlace(m.GetTarget(out)))) / length : 0.0;
        sum += 0.5 * length * distance * distance;
      }
      out = m.GetNextOut(out);
    } while (out != start);
  }
  return sum;
}
}

TEST(Quadrics, CostsOfFourAtATimeAreAreasTimesSquaredDistances)
{
  const vtkMTPatch floor = MakeFractalCap(4, 2000, 0);
  const Case made(floor, LockBorder(floor));
  const vtkMTCollapseMesh& m = made.Region->Mesh;
  vtkMTQuadrics quadrics(*made.Region);
  quadrics.Initialize();
  std::vector<vtkMTQuadrics::Request> requests;
  for (std::uint32_t e = 0; e < m.GetNumberOfEdges(); ++e)
  {
    const Rule rule = made.Region->GetRule(2 * e);
    if (rule != Rule::Refused)
    {
      requests.push_back({ 2 * e, rule });
    }
  }
  requests.resize(requests.size() / 4 * 4);
  std::vector<vtkMTQuadrics::Four> proposals(requests.size() / 4);
  quadrics.Propose(requests.data(), requests.size(), proposals.data());
  double farthest = 0.0;
  std::size_t held[5] = {};
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    const std::uint32_t h = requests[i].Halfedge;
    const vtkMTQuadrics::Four& four = proposals[i / 4];
    const Vector place{ four.Place[0][i % 4], four.Place[1][i % 4], four.Place[2][i % 4] };
    const double expected = GetCost(m, h, place);
    // The other term is a millionth of the area, at most twice that of a dozen triangles, times the squared length.
    const Vector along = Subtract(m.GetPlace(m.GetTarget(h)), m.GetPlace(m.GetSource(h)));
    EXPECT_NEAR(four.Cost[i % 4], expected, 1e-4 * Dot(along, along) + 1e-14);
    farthest = std::max(farthest, std::abs(four.Cost[i % 4] - expected) / (expected + 1e-12));
    ++held[static_cast<int>(requests[i].ByRule)];
    const Rule rule = requests[i].ByRule;
    EXPECT_TRUE(rule != Rule::First || place == m.GetPlace(m.GetSource(h)));
    EXPECT_TRUE(rule != Rule::Second || place == m.GetPlace(m.GetTarget(h)));
    const vtkMTQuadrics::Proposal alone = quadrics.Propose(h, rule);
    EXPECT_TRUE(alone.Cost == four.Cost[i % 4] && alone.Place == place); // to the last bit, whatever is beside it
    EXPECT_LE(expected,
      GetCost(
        m, h, rule == Rule::Free ? Scale(Add(m.GetPlace(m.GetSource(h)), m.GetPlace(m.GetTarget(h))), 0.5) : place) +
        1e-14);
  }
  std::printf("%zu edges, %zu and %zu of them to one end; costs off by %.2g times at most\n", requests.size(), held[1],
    held[2], farthest);
  EXPECT_GT(held[static_cast<int>(Rule::First)], 0u);
  EXPECT_GT(held[static_cast<int>(Rule::Second)], 0u);
}

TEST(Quadrics, NormalsThatAreKeptAreThoseOfTheTriangles)
{
  const vtkMTPatch cap = MakeFractalCap(4, 3000, 1);
  for (const Locks& locked : { LockBorder(cap), LockNothing(cap) })
  {
    const Case made(cap, locked);
    vtkMTCollapseRegion& region = *made.Region;
    region.Target = 400;
    vtkMTCollapse::RunFast(region);
    EXPECT_LE(region.Faces, 1500u);
    double farthest = 0.0;
    for (const std::uint32_t h : region.Mesh.Faces)
    {
      if (h != vtkMTCollapseMesh::None)
      {
        const Vector n = GetNormal(region.Mesh, h);
        const double off = Norm(Subtract(n, region.GetNormal(region.Mesh.GetFace(h))));
        farthest = std::max(farthest, off / (Norm(n) + 1e-12));
      }
    }
    std::printf("%zu triangles of 3000, normals off by %.2g of their length at most\n", region.Faces, farthest);
    EXPECT_LT(farthest, 1e-9);
  }
}
