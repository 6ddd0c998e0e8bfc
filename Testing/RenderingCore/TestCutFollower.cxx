// SPDX-License-Identifier: BSD-3-Clause
#include "MTRandomGraph.h"
#include "MTViews.h"

#include "vtkMTCutFollower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <iostream>
#include <random>

namespace
{
using Follower = vtkMTCutFollower;

// Of the processor, not of the wall: other tests run beside this one.
double GetThreadTime()
{
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::uint64_t GetMeanPatch(const vtkMTGraph& graph)
{
  std::uint64_t sum = 0;
  for (const vtkMTArc& arc : graph.Arcs)
  {
    sum += arc.Triangles;
  }
  return sum / graph.Arcs.size();
}

// What is in main memory and on the GPU.
struct World
{
  explicit World(const vtkMTGraph& graph, Follower::StateType state = Follower::Absent)
    : Graph(graph)
    , States(graph.Arcs.size(), state)
  {
  }

  Follower::Input See(const vtkMTView& view)
  {
    Follower::Input input;
    input.Graph = &this->Graph;
    input.Views = { view };
    input.GetState = [this](std::uint32_t arc) { return this->States[arc]; };
    return input;
  }

  // What a mapper does with a result: upload what is drawn.
  void Upload(const Follower::Result& result)
  {
    for (const auto* arcs : { &result.Arcs, &result.Early })
    {
      for (const std::uint32_t arc : *arcs)
      {
        this->States[arc] = Follower::Uploaded;
      }
    }
  }
  // What a loader does: the most urgent ones.
  std::size_t Load(const Follower::Result& result, std::size_t count)
  {
    std::vector<vtkMTPatchCache::Want> wants = result.Wants;
    std::stable_sort(wants.begin(), wants.end(),
      [](const vtkMTPatchCache::Want& a, const vtkMTPatchCache::Want& b) { return a.Priority > b.Priority; });
    std::size_t loaded = 0;
    for (const vtkMTPatchCache::Want& want : wants)
    {
      if (want.Load && this->States[want.Arc] == Follower::Absent && loaded < count)
      {
        this->States[want.Arc] = Follower::Loaded;
        ++loaded;
      }
    }
    return loaded;
  }
  void Randomise(std::mt19937& random, std::uint32_t absent, std::uint32_t loaded)
  {
    for (Follower::StateType& state : this->States)
    {
      const std::uint32_t draw = random() % 100;
      state = draw < absent ? Follower::Absent : draw < absent + loaded ? Follower::Loaded : Follower::Uploaded;
    }
  }

  const vtkMTGraph& Graph;
  std::vector<Follower::StateType> States;
};

// The promises that hold for every result.
void Check(const World& world, const Follower::Settings& settings, const Follower::Result& result)
{
  const vtkMTGraph& graph = world.Graph;
  ASSERT_TRUE(MTRandomGraph::IsClosed(graph, result.Cut));
  std::uint64_t triangles = 0;
  std::uint64_t bytes = 0;
  std::uint64_t upload = 0;
  for (const std::uint32_t arc : result.Arcs)
  {
    const vtkMTArc& record = graph.Arcs[arc];
    ASSERT_TRUE(result.Cut.Contains(arc));
    const std::uint64_t size = std::uint64_t(record.Wedges) * settings.BytesPerVertex +
      std::uint64_t(record.Triangles) * settings.BytesPerTriangle;
    triangles += record.Triangles;
    bytes += size;
    if (record.From != graph.GetSource())
    {
      ASSERT_NE(world.States[arc], Follower::Absent);
      upload += world.States[arc] == Follower::Loaded ? size : 0;
    }
  }
  EXPECT_EQ(result.Triangles, triangles);
  EXPECT_EQ(result.Bytes, bytes);
  std::uint64_t held = bytes;
  for (const std::uint32_t arc : result.Early)
  {
    const std::uint64_t size = std::uint64_t(graph.Arcs[arc].Wedges) * settings.BytesPerVertex +
      std::uint64_t(graph.Arcs[arc].Triangles) * settings.BytesPerTriangle;
    ASSERT_NE(world.States[arc], Follower::Absent);
    EXPECT_FALSE(result.Cut.Contains(arc));
    upload += world.States[arc] == Follower::Loaded ? size : 0;
    held += size;
  }
  EXPECT_TRUE(result.Early.empty() || settings.ByteLimit == 0 || held <= settings.ByteLimit);
  EXPECT_EQ(result.UploadBytes, upload);
  const auto within = [](std::uint64_t value, std::uint64_t budget) { return budget == 0 || value <= budget; };
  if (result.NodesRefined > 0)
  {
    EXPECT_TRUE(within(triangles, settings.TriangleLimit));
    EXPECT_TRUE(within(bytes, settings.ByteLimit));
  }
  EXPECT_TRUE(within(upload, settings.UploadBudget));
  EXPECT_EQ(result.WithinLimits, within(triangles, settings.TriangleLimit) && within(bytes, settings.ByteLimit));
}

TEST(CutFollower, TakesWhatExtractionGivesWhereEverythingIsThere)
{
  const vtkMTGraph graph = MTRandomGraph::Make(21, 400);
  World world(graph, Follower::Uploaded);
  Follower follower;
  Follower::Settings settings;
  settings.PixelError = 0.3;
  settings.TriangleLimit = 200 * GetMeanPatch(graph);
  std::size_t operations = 0;
  for (const vtkMTView& view : MTViews::MakePath(200))
  {
    const auto input = world.See(view);
    const auto result = follower.Update(input, settings);
    Check(world, settings, result);
    vtkMTTargetCut extraction;
    const auto target = extraction.Extract(input, settings);
    EXPECT_EQ(result.Arcs, target.Arcs);
    EXPECT_EQ(result.Triangles, target.Triangles);
    EXPECT_TRUE(result.OnTarget);
    operations += result.Refined + result.Coarsened;
    if (!result.Converged)
    {
      EXPECT_GE(result.Triangles, 0.9 * settings.TriangleLimit);
    }
  }
  std::cout << operations << " operations in 200 frames\n";
}

TEST(CutFollower, KeepsItsPromisesForAnyViewBudgetAndResidentSet)
{
  std::mt19937 random(5);
  std::size_t forced = 0;
  std::size_t refined = 0;
  std::size_t coarsened = 0;
  int cases = 0;
  for (std::uint32_t seed = 0; seed < 12; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(100 + seed, 30 + 20 * static_cast<int>(seed));
    const std::uint64_t mean = GetMeanPatch(graph);
    World world(graph);
    Follower follower;
    for (const vtkMTView& view : MTViews::MakeRandom(seed, 60))
    {
      world.Randomise(random, random() % 60, random() % 40);
      Follower::Settings settings;
      settings.PixelError = 0.05 * (1 + random() % 20);
      settings.TriangleLimit = random() % 3 ? (10 + random() % 300) * mean : 0;
      settings.ByteLimit = random() % 3 ? (10 + random() % 300) * mean * 18 : 0;
      settings.UploadBudget = random() % 3 ? (1 + random() % 40) * mean * 18 : 0;
      const auto result = follower.Update(world.See(view), settings);
      Check(world, settings, result);
      forced += result.Forced;
      refined += result.Refined;
      coarsened += result.Coarsened;
      ++cases;
    }
  }
  std::cout << cases << " cases, " << refined << " refinements, " << coarsened << " coarsenings, " << forced
            << " forced ones\n";
  EXPECT_GT(forced, 100u);
  EXPECT_GT(refined, 100u);
  EXPECT_GT(coarsened, 100u);
}

TEST(CutFollower, BudgetsAreUsedToNineTenthsFromFiftyMeanPatchesOn)
{
  std::mt19937 random(7);
  double least = 1.0;
  int limited = 0;
  for (std::uint32_t seed = 0; seed < 4; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(400 + seed, 1500);
    const std::uint64_t mean = GetMeanPatch(graph);
    World world(graph, Follower::Uploaded);
    Follower follower;
    for (const vtkMTView& view : MTViews::MakeRandom(seed, 40))
    {
      const bool bytes = random() % 2 != 0;
      const std::uint64_t patches = 50 + random() % 400;
      Follower::Settings settings;
      settings.PixelError = 0.02;
      settings.TriangleLimit = bytes ? 0 : patches * mean;
      settings.ByteLimit = bytes ? patches * mean * 18 : 0;
      const auto result = follower.Update(world.See(view), settings);
      Check(world, settings, result);
      if (!result.Converged)
      {
        const double used = bytes ? static_cast<double>(result.Bytes) / static_cast<double>(settings.ByteLimit)
                                  : static_cast<double>(result.Triangles) / static_cast<double>(settings.TriangleLimit);
        least = std::min(least, used);
        EXPECT_GE(used, 0.9);
        ++limited;
      }
    }
  }
  std::cout << limited << " budgets too small for the error, the least use is " << least << "\n";
  EXPECT_GT(limited, 50);
}

// A clock that says how often it has been asked: so time is over at any operation that one wants.
TEST(CutFollower, StoppedAtAnyOperationTheCutConformsAndIsWithinItsBudgets)
{
  const vtkMTGraph graph = MTRandomGraph::Make(31, 60);
  std::mt19937 random(6);
  std::size_t stopped = 0;
  int complete = 0;
  const auto views = MTViews::MakeRandom(3, 12);
  for (int operations = 1; operations < 400; operations += 1 + operations / 8)
  {
    World world(graph);
    Follower follower;
    for (const vtkMTView& view : views)
    {
      world.Randomise(random, 10, 30);
      Follower::Settings settings;
      settings.PixelError = 0.1;
      settings.TriangleLimit = 60 * GetMeanPatch(graph);
      settings.UploadBudget = 20 * 18 * GetMeanPatch(graph);
      int asked = 0;
      settings.Clock = [&asked] { return static_cast<double>(asked++); };
      settings.TimeLimit = operations;
      const auto result = follower.Update(world.See(view), settings);
      Check(world, settings, result);
      stopped += result.Complete ? 0 : 1;
      complete += result.Complete ? 1 : 0;
    }
  }
  std::cout << stopped << " frames stopped, " << complete << " complete\n";
  EXPECT_GT(stopped, 50u);
  EXPECT_GT(complete, 50);
}

TEST(CutFollower, SmallTimeBudgetStillGetsForward)
{
  const vtkMTGraph graph = MTRandomGraph::Make(33, 60);
  World world(graph, Follower::Loaded);
  Follower follower;
  const vtkMTView view = MTViews::LookAt(0.5, 0.4, 0.3, 0.6);
  Follower::Settings settings;
  settings.PixelError = 0.1;
  settings.UploadBudget = 10 * 18 * GetMeanPatch(graph);
  double asked = 0.0;
  settings.Clock = [&asked] { return asked += 1.0; };
  settings.TimeLimit = 10.0;
  int frames = 0;
  auto result = follower.Update(world.See(view), settings);
  EXPECT_FALSE(result.Complete);
  for (; !result.Converged && frames < 500; ++frames)
  {
    world.Upload(result);
    result = follower.Update(world.See(view), settings);
    Check(world, settings, result);
  }
  std::cout << frames << " frames\n";
  EXPECT_TRUE(result.Converged);
}

TEST(CutFollower, StillViewConvergesToTheCutFromScratchAsPatchesArrive)
{
  for (std::uint32_t seed = 0; seed < 8; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(200 + seed, 150);
    World world(graph);
    Follower follower;
    Follower::Settings settings;
    settings.PixelError = 0.15;
    settings.TriangleLimit = 150 * GetMeanPatch(graph);
    settings.UploadBudget = 12 * 18 * GetMeanPatch(graph);
    settings.Prefetch = false;
    // It comes from somewhere else.
    std::mt19937 random(seed);
    for (const vtkMTView& view : MTViews::MakeRandom(seed, 3))
    {
      world.Randomise(random, 50, 25);
      follower.Update(world.See(view), settings);
    }
    const vtkMTView view = MTViews::LookAt(0.5, 0.3, 0.25, 0.7);
    const auto input = world.See(view);
    int frames = 0;
    std::size_t loaded = 0;
    auto result = follower.Update(input, settings);
    for (; !result.OnTarget && frames < 1000; ++frames)
    {
      Check(world, settings, result);
      world.Upload(result);
      loaded += world.Load(result, 7);
      result = follower.Update(input, settings);
    }
    EXPECT_TRUE(result.OnTarget) << "seed " << seed;
    vtkMTTargetCut extraction;
    EXPECT_EQ(result.Arcs, extraction.Extract(input, settings).Arcs);
    std::cout << frames << " frames, " << loaded << " patches loaded for a picture of " << result.Arcs.size() << "\n";
  }
}

TEST(CutFollower, ErrorFallsFromFrameToFrameWhileNothingButPatchesChanges)
{
  const vtkMTGraph graph = MTRandomGraph::Make(41, 200);
  World world(graph);
  Follower follower;
  Follower::Settings settings;
  settings.PixelError = 0.2;
  const vtkMTView view = MTViews::LookAt(0.5, 0.3, 0.2, 0.5);
  auto result = follower.Update(world.See(view), settings);
  while (!result.OnTarget)
  {
    const std::size_t nodes = result.NodesRefined;
    world.Upload(result);
    ASSERT_GT(world.Load(result, 5), 0u);
    result = follower.Update(world.See(view), settings);
    EXPECT_GE(result.NodesRefined, nodes);
    EXPECT_EQ(result.Coarsened + result.Forced, 0u);
  }
  EXPECT_TRUE(result.Converged);
}

TEST(CutFollower, PatchThatCannotBeReadStopsNobodyElse)
{
  const vtkMTGraph graph = MTRandomGraph::Make(43, 150);
  const vtkMTView view = MTViews::LookAt(0.5, 0.3, 0.3, 0.5);
  Follower::Settings settings;
  settings.PixelError = 0.2;
  World world(graph);
  Follower follower;
  auto input = world.See(view);
  vtkMTTargetCut extraction;
  const auto whole = extraction.Extract(input, settings);
  std::vector<unsigned char> readable(graph.Arcs.size(), 1);
  for (std::size_t i = 0; i < whole.Arcs.size(); i += 17)
  {
    readable[whole.Arcs[i]] = graph.Arcs[whole.Arcs[i]].From == graph.GetSource() ? 1 : 0;
  }
  input.Resident = &readable;
  auto result = follower.Update(input, settings);
  for (int frame = 0; !result.OnTarget && frame < 1000; ++frame)
  {
    world.Upload(result);
    world.Load(result, 20);
    result = follower.Update(input, settings);
    Check(world, settings, result);
  }
  EXPECT_TRUE(result.OnTarget);
  EXPECT_FALSE(result.Converged);
  for (const std::uint32_t arc : result.Arcs)
  {
    EXPECT_TRUE(readable[arc]);
  }
  EXPECT_GT(result.NodesRefined, whole.NodesRefined / 3);
}

// What is there is used: no refinement that the target has, that is possible and that fits is left undone.
TEST(CutFollower, LeavesNothingUndoneThatIsPossible)
{
  std::mt19937 random(9);
  int tried = 0;
  for (std::uint32_t seed = 0; seed < 20; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(300 + seed, 12);
    World world(graph);
    for (const vtkMTView& view : MTViews::MakeRandom(seed, 6))
    {
      world.Randomise(random, 20, 20);
      Follower follower;
      Follower::Settings settings;
      settings.PixelError = 0.3;
      const auto input = world.See(view);
      const auto result = follower.Update(input, settings);
      vtkMTTargetCut extraction;
      const auto target = extraction.Extract(input, settings);
      for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
      {
        if (!target.Cut.IsRefined(node) || !result.Cut.CanRefine(node))
        {
          continue;
        }
        const vtkMTNode& record = graph.Nodes[node];
        bool possible = true;
        for (std::uint32_t arc = record.FirstOut; arc < record.FirstOut + record.OutCount; ++arc)
        {
          possible =
            possible && (!vtkMTTargetCut::IsVisible(graph, view, arc) || world.States[arc] != Follower::Absent);
        }
        EXPECT_FALSE(possible) << "seed " << seed << ", node " << node;
        ++tried;
      }
      // Nothing beyond the target, and every cut between is a part of it.
      for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
      {
        EXPECT_TRUE(!result.Cut.IsRefined(node) || target.Cut.IsRefined(node));
      }
    }
  }
  std::cout << tried << " refinements left undone, none of them possible\n";
  EXPECT_GT(tried, 20);
}

// The oracle: every closed cut of small graphs. The target is a smallest one that the view is satisfied with.
TEST(CutFollower, NoSmallerClosedCutSatisfiesTheView)
{
  std::size_t compared = 0;
  for (std::uint32_t seed = 0; seed < 25; ++seed)
  {
    const vtkMTGraph graph = MTRandomGraph::Make(seed, 6);
    const std::vector<vtkMTCut> all = MTRandomGraph::EnumerateCuts(graph);
    World world(graph, Follower::Uploaded);
    for (const vtkMTView& view : MTViews::MakeRandom(seed, 6))
    {
      Follower follower;
      Follower::Settings settings;
      settings.PixelError = 1.0;
      const auto input = world.See(view);
      const auto result = follower.Update(input, settings);
      vtkMTTargetCut extraction;
      EXPECT_TRUE(result.Converged);
      for (const vtkMTCut& cut : all)
      {
        bool smaller = true;
        bool same = true;
        for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
        {
          smaller = smaller && (!cut.IsRefined(node) || result.Cut.IsRefined(node));
          same = same && cut.IsRefined(node) == result.Cut.IsRefined(node);
        }
        if (smaller && !same)
        {
          EXPECT_FALSE(extraction.View(cut, input, settings).Converged);
          ++compared;
        }
      }
    }
  }
  std::cout << compared << " smaller cuts compared\n";
  EXPECT_GT(compared, 500u);
}

TEST(CutFollower, PrefetchHasThereWhatTheNextFramesNeed)
{
  const vtkMTGraph graph = MTRandomGraph::Make(61, 600);
  std::size_t forced[2] = { 0, 0 };
  std::size_t late[2] = { 0, 0 };
  for (const bool prefetch : { false, true })
  {
    World world(graph);
    Follower follower;
    Follower::Settings settings;
    settings.PixelError = 0.3;
    settings.Prefetch = prefetch;
    for (const vtkMTView& view : MTViews::MakePath(300))
    {
      const auto result = follower.Update(world.See(view), settings);
      forced[prefetch] += result.Forced;
      late[prefetch] += result.Requests.size();
      world.Upload(result);
      world.Load(result, 60);
    }
  }
  std::cout << "without: " << forced[0] << " coarsenings for what was not there, " << late[0]
            << " patches missing; with: " << forced[1] << ", " << late[1] << "\n";
  EXPECT_LE(forced[1], forced[0]);
  EXPECT_LT(late[1], late[0]);
}

TEST(CutFollower, CutTakesLittleTimeAlongAFlight)
{
  const vtkMTGraph graph = MTRandomGraph::Make(51, 6000);
  World world(graph, Follower::Uploaded);
  Follower follower;
  Follower::Settings settings;
  settings.PixelError = 0.2;
  std::vector<double> times;
  std::size_t patches = 0;
  std::size_t refined = 0;
  for (const vtkMTView& view : MTViews::MakePath(300))
  {
    const auto input = world.See(view);
    const double start = GetThreadTime();
    const auto result = follower.Update(input, settings);
    times.push_back(GetThreadTime() - start);
    patches += result.Arcs.size();
    refined += result.NodesRefined;
  }
  std::sort(times.begin(), times.end());
  std::cout << graph.Arcs.size() << " patches, " << graph.Nodes.size() << " nodes; cuts of " << patches / 300
            << " patches on average, " << refined / 300 << " nodes refined; median " << times[150] * 1e3
            << " ms, worst " << times.back() * 1e3 << " ms\n";
  EXPECT_GT(patches / 300, 100u);
}
}
