// SPDX-License-Identifier: BSD-3-Clause
// What is left out is never seen: patches that face away, by their triangles.
#include "MTTestModel.h"

#include "vtkMTTargetCut.h"
#include "vtkMTView.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

namespace
{
// A camera at a random place around the tube, looking at it, and an actor that may shear and mirror.
vtkMTView MakeView(std::mt19937& random, bool parallel, bool shear, bool mirror)
{
  const auto draw = [&random] { return static_cast<double>(random() % 2001) / 1000.0 - 1.0; };
  double back[3] = { draw(), draw(), draw() };
  double up[3] = { draw(), draw(), draw() };
  double right[3];
  vtkMath::Normalize(back);
  vtkMath::Cross(up, back, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(back, right, up);
  const double distance = 0.5 + 3.0 * std::abs(draw());
  const double* axes[3] = { right, up, back };
  double model[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  if (shear)
  {
    for (auto& row : model)
    {
      for (double& value : row)
      {
        value += 0.4 * draw();
      }
    }
  }
  if (mirror)
  {
    for (double& value : model[0])
    {
      value = -value;
    }
  }
  vtkMTView view;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      view.ModelToEye[4 * i + j] = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        view.ModelToEye[4 * i + j] += axes[i][k] * model[k][j];
      }
    }
    view.ModelToEye[4 * i + 3] = i == 2 ? -distance : 0.2 * draw();
  }
  view.UpdateStretch();
  view.ParallelProjection = parallel;
  view.HalfSize = { 2.0, 2.0 };
  view.PixelsPerUnit = 300.0;
  view.Near = 1e-3;
  view.Far = 100.0;
  return view;
}

// What a triangle shows: positive where its corners turn to the left on the screen.
double GetTurn(const vtkMTView& view, const std::array<std::array<double, 3>, 3>& corners)
{
  std::array<std::array<double, 3>, 3> eye;
  for (int i = 0; i < 3; ++i)
  {
    eye[i] = view.ToEye(corners[i]);
  }
  double u[3];
  double v[3];
  double normal[3];
  vtkMath::Subtract(eye[1].data(), eye[0].data(), u);
  vtkMath::Subtract(eye[2].data(), eye[0].data(), v);
  vtkMath::Cross(u, v, normal);
  return view.ParallelProjection ? normal[2] : -vtkMath::Dot(normal, eye[0].data());
}

struct Count
{
  std::size_t Patches = 0;
  std::size_t Away = 0; // patches all of whose triangles face away
  std::size_t Culled = 0;
};

Count Compare(const vtkMTPatchSource& model, const vtkMTView& view)
{
  const vtkMTGraph& graph = model.GetGraph();
  vtkMTTargetCut extraction;
  vtkMTTargetCut::Settings settings;
  settings.PixelError = 0.5;
  settings.FacingCulling = true;
  settings.FrustumCulling = false;
  vtkMTTargetCut::Input input;
  input.Graph = &graph;
  input.Views = { view };
  const auto result = extraction.Extract(input, settings);
  Count count;
  std::uint64_t triangles = 0;
  for (const std::uint32_t arc : result.Cut.GetArcs())
  {
    const bool drawn = std::binary_search(result.Arcs.begin(), result.Arcs.end(), arc);
    vtkMTPatch patch;
    std::string error;
    EXPECT_TRUE(model.ReadPatch(arc, nullptr, patch, error)) << error;
    std::size_t front = 0;
    for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
    {
      const vtkMTTriangle points = patch.GetPointsOfTriangle(t);
      std::array<std::array<double, 3>, 3> corners;
      for (int i = 0; i < 3; ++i)
      {
        corners[i] = graph.Lattice.ToWorld(patch.Points[points[i]]);
      }
      front += GetTurn(view, corners) > 0.0 ? 1 : 0;
    }
    ++count.Patches;
    count.Away += front == 0 ? 1 : 0;
    count.Culled += drawn ? 0 : 1;
    triangles += drawn ? 0 : graph.Arcs[arc].Triangles;
    EXPECT_TRUE(drawn || front == 0) << "patch " << arc << " is left out and shows " << front << " triangles";
  }
  EXPECT_EQ(result.ArcsFacingAway, count.Culled);
  EXPECT_EQ(result.TrianglesFacingAway, triangles);
  EXPECT_EQ(result.ArcsCulled, 0u);
  // The cut is the one that everything is drawn of: what is left out changes nothing else.
  settings.FacingCulling = false;
  const auto whole = extraction.Extract(input, settings);
  EXPECT_EQ(whole.Cut.GetArcs(), result.Cut.GetArcs());
  return count;
}

TEST(Culling, PatchThatFacesAwayShowsNoTriangleFromTheFront)
{
  MTTestModel::TubeOptions options;
  options.Rings = 1024;
  options.Across = 32;
  options.Regions = 64;
  // Its patches go all around the tube, so few of them face away: this is about those that do not.
  const auto tube = MTTestModel::MakeTube(options);
  std::mt19937 random(11);
  for (const bool parallel : { false, true })
  {
    for (const bool shear : { false, true })
    {
      for (const bool mirror : { false, true })
      {
        for (int i = 0; i < 6; ++i)
        {
          Compare(*tube, MakeView(random, parallel, shear, mirror));
        }
      }
    }
  }
}

// A ball of patches of one triangle fan each, all cones exact: most of what faces away is left out.
std::shared_ptr<vtkMTPatchStore> MakeBall(int bands, int sectors)
{
  vtkMTGraph graph;
  const double bounds[6] = { -1, 1, -1, 1, -1, 1 };
  graph.Lattice = vtkMTLattice::FromBounds(bounds);
  graph.Nodes.resize(2);
  std::vector<vtkMTPatch> patches;
  const auto place = [&](int band, int sector)
  {
    const double theta = vtkMath::Pi() * band / bands;
    const double phi = 2.0 * vtkMath::Pi() * sector / sectors;
    const double x[3] = { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) };
    return graph.Lattice.Snap(x);
  };
  for (int band = 0; band < bands; ++band)
  {
    for (int sector = 0; sector < sectors; ++sector)
    {
      vtkMTPatch patch;
      patch.Points = { place(band, sector), place(band + 1, sector), place(band + 1, sector + 1),
        place(band, sector + 1) };
      patch.Triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
      vtkMTArc arc;
      arc.To = 1;
      MTTestModel::FillRecord(patch, graph.Lattice, arc);
      graph.Arcs.push_back(arc);
      patches.push_back(patch);
    }
  }
  const auto order = graph.Index();
  graph.Saturate(0.0);
  auto store = std::make_shared<vtkMTPatchStore>();
  EXPECT_TRUE(store->Begin({}));
  for (const vtkMTPatch& patch : patches)
  {
    EXPECT_TRUE(store->WritePatch(vtkMTPatch(patch)));
  }
  EXPECT_TRUE(store->Finish(graph, order)) << store->GetError();
  return store;
}

TEST(Culling, MostOfWhatFacesAwayIsLeftOut)
{
  const auto ball = MakeBall(24, 48);
  std::mt19937 random(12);
  for (const bool parallel : { false, true })
  {
    for (const bool mirror : { false, true })
    {
      Count sum;
      for (int i = 0; i < 20; ++i)
      {
        const Count count = Compare(*ball, MakeView(random, parallel, i % 2 == 1, mirror));
        sum.Patches += count.Patches;
        sum.Away += count.Away;
        sum.Culled += count.Culled;
      }
      std::cout << (parallel ? "parallel" : "perspective") << (mirror ? ", mirrored: " : ": ") << sum.Culled
                << " patches left out of " << sum.Away << " that face away, " << sum.Patches << " in all\n";
      EXPECT_GT(sum.Culled, 0.8 * static_cast<double>(sum.Away));
      EXPECT_GT(sum.Away, sum.Patches / 10);
    }
  }
}

TEST(Culling, ConesThatLieCullNothing)
{
  const auto ball = MakeBall(8, 16);
  vtkMTGraph graph = ball->GetGraph();
  std::mt19937 random(13);
  const vtkMTView view = MakeView(random, false, false, false);
  vtkMTTargetCut extraction;
  vtkMTTargetCut::Settings settings;
  settings.FacingCulling = true;
  vtkMTTargetCut::Input input;
  input.Graph = &graph;
  input.Views = { view };
  EXPECT_GT(extraction.Extract(input, settings).ArcsFacingAway, 0u);
  const float nan = std::nanf("");
  for (const std::array<float, 4>& cone : { std::array<float, 4>{ 0, 0, 0, 0.9f }, { 1e30f, 0, 0, 0.9f },
         { nan, 0, 1, 0.9f }, { 0, 0, 1, nan }, { 0.1f, 0, 0, 1.0f } })
  {
    for (vtkMTArc& arc : graph.Arcs)
    {
      arc.ConeAxis = { cone[0], cone[1], cone[2] };
      arc.ConeCosine = cone[3];
    }
    EXPECT_EQ(extraction.Extract(input, settings).ArcsFacingAway, 0u);
  }
}
}
