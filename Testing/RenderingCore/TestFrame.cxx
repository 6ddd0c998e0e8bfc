// SPDX-License-Identifier: BSD-3-Clause
// The protocol of a frame, without a window: what a GPU would hold is counted by an uploader made for that.
#include "MTGatedSource.h"
#include "MTViews.h"

#include "vtkMTFrame.h"
#include "vtkMTGraph.h"
#include "vtkMTTargetCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <numeric>
#include <set>
#include <thread>

namespace
{
// As much of a GPU as a frame knows of: it grows to what a frame draws, up to the limit, drops what was used longest
// ago where there is no room, and counts.
class CountingUploader : public vtkMTUploader
{
public:
  explicit CountingUploader(const vtkMTGraph& graph)
    : Graph(graph)
  {
  }

  Cost GetCost() const override { return { 12, 6 }; }
  std::vector<unsigned char> GetArrays() const override
  {
    return std::vector<unsigned char>(this->Graph.Arrays.size(), 0);
  }
  bool IsUploaded(std::uint32_t arc) const override
  {
    const auto found = this->Slots.find(arc);
    return found != this->Slots.end() && found->second.Filled;
  }
  void Begin(
    const std::vector<std::uint32_t>& drawn, const std::vector<std::uint32_t>& kept, std::uint64_t limit) override
  {
    ++this->Frames;
    EXPECT_TRUE(std::is_sorted(drawn.begin(), drawn.end()));
    std::uint64_t wanted = 0;
    for (const auto* arcs : { &kept, &drawn })
    {
      for (const std::uint32_t arc : *arcs)
      {
        wanted += this->GetBytesOf(arc);
        this->Touch(arc);
      }
    }
    this->FirstOfFrame = this->Clock;
    for (const std::uint32_t arc : drawn)
    {
      this->Touch(arc);
    }
    this->Capacity = std::min(limit, std::max(this->Capacity, wanted));
    this->MakeRoom(0, true);
    this->Limit = limit;
  }
  bool Reserve(std::uint32_t arc) override
  {
    if (!this->Slots.count(arc))
    {
      if (!this->MakeRoom(this->GetBytesOf(arc), false))
      {
        return false;
      }
      this->Slots[arc] = Slot();
      this->Bytes += this->GetBytesOf(arc);
      this->MostBytes = std::max(this->MostBytes, this->Bytes);
      ++this->Changes;
    }
    EXPECT_LE(this->Bytes, this->Limit);
    this->Touch(arc);
    return true;
  }
  bool Upload(std::uint32_t arc, const vtkMTPatch& patch) override
  {
    EXPECT_TRUE(this->Slots.count(arc));
    EXPECT_EQ(patch.Triangles.size(), this->Graph.Arcs[arc].Triangles);
    this->Slots[arc].Filled = true;
    this->Uploaded += this->GetBytesOf(arc);
    return true;
  }
  void Drop(std::uint32_t arc) override
  {
    if (this->Slots.erase(arc))
    {
      this->Bytes -= this->GetBytesOf(arc);
      ++this->Changes;
    }
  }
  std::uint64_t GetChanges() const override { return this->Changes; }

  std::uint64_t GetBytesOf(std::uint32_t arc) const
  {
    return std::uint64_t(this->Graph.Arcs[arc].Wedges) * 12 + std::uint64_t(this->Graph.Arcs[arc].Triangles) * 6;
  }

  std::uint64_t Uploaded = 0;
  std::uint64_t Bytes = 0;
  std::uint64_t MostBytes = 0;
  std::uint64_t Frames = 0;
  double Gaps = 0.0; // share of the buffers that cannot be used

private:
  struct Slot
  {
    bool Filled = false;
    std::uint64_t LastUse = 0;
  };

  void Touch(std::uint32_t arc)
  {
    const auto found = this->Slots.find(arc);
    if (found != this->Slots.end())
    {
      found->second.LastUse = ++this->Clock;
    }
  }
  bool MakeRoom(std::uint64_t bytes, bool anything)
  {
    const vtkMTNode& source = this->Graph.Nodes[this->Graph.GetSource()];
    std::uint64_t room = 0; // the coarsest patches always have it
    for (std::uint32_t arc = source.FirstOut; arc < source.FirstOut + source.OutCount; ++arc)
    {
      room += this->GetBytesOf(arc);
    }
    room = std::min(this->Capacity,
      std::max(room, static_cast<std::uint64_t>((1.0 - this->Gaps) * static_cast<double>(this->Capacity))));
    while (this->Bytes + bytes > room)
    {
      const auto oldest = std::min_element(this->Slots.begin(), this->Slots.end(),
        [](const auto& a, const auto& b) { return a.second.LastUse < b.second.LastUse; });
      if (oldest == this->Slots.end() || (!anything && oldest->second.LastUse > this->FirstOfFrame))
      {
        return false;
      }
      this->Drop(oldest->first);
    }
    return true;
  }

  const vtkMTGraph& Graph;
  std::map<std::uint32_t, Slot> Slots;
  std::uint64_t Capacity = 0;
  std::uint64_t Limit = 0;
  std::uint64_t Changes = 0;
  std::uint64_t Clock = 0;
  std::uint64_t FirstOfFrame = 0;
};

// A model that is long along x, so that one sees a part of it at a time, and frames of it.
class Frame : public testing::Test
{
protected:
  Frame()
  {
    MTTestModel::TubeOptions options;
    options.Rings = 1024;
    options.Regions = 64;
    this->Source = std::make_shared<MTGatedSource>(MTTestModel::MakeTube(options));
    EXPECT_TRUE(this->Drawn.SetSource(this->Source, vtkMTPatchLoader::Settings()));
    this->Settings.Cut.PixelError = 0.5;
    this->Settings.Cut.Prefetch = false;
    double bounds[6];
    this->Graph().GetBounds(bounds);
    this->Center = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]) };
    this->Radius = 0.5 * std::max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
  }

  const vtkMTGraph& Graph() const { return this->Source->GetGraph(); }

  // From above, where t goes around the model; the height in its radii.
  std::vector<vtkMTView> Look(double t, double height) const
  {
    const double angle = 6.28318 * t;
    return { MTViews::LookAt(this->Center[0] + 0.7 * this->Radius * std::cos(angle),
      this->Center[1] + 0.7 * this->Radius * std::sin(angle), height * this->Radius, 0.2) };
  }

  const vtkMTFrame::Result& Update(CountingUploader& uploader, const std::vector<vtkMTView>& views, int renderer = 0)
  {
    const vtkMTFrame::Result& result = this->Drawn.Update(&this->Keys[renderer], views, this->Settings, uploader);
    EXPECT_FALSE(result.Arcs.empty());
    for (const std::uint32_t arc : result.Arcs)
    {
      EXPECT_TRUE(uploader.IsUploaded(arc)) << "patch " << arc << " is drawn";
    }
    return result;
  }

  // All arcs that the views ask for, however they got there.
  std::vector<std::uint32_t> GetTarget(const std::vector<vtkMTView>& views) const
  {
    vtkMTTargetCut::Input input;
    input.Graph = &this->Graph();
    input.Views = views;
    return vtkMTTargetCut().Extract(input, this->Settings.Cut).Arcs;
  }

  std::shared_ptr<MTGatedSource> Source;
  vtkMTFrame Drawn;
  vtkMTFrame::Settings Settings;
  std::array<double, 2> Center;
  double Radius = 1.0;
  const std::array<char, 4> Keys{};
};

TEST_F(Frame, NeverWaitsForWhatIsBeingRead)
{
  CountingUploader uploader(this->Graph());
  this->Settings.Cut.PixelError = 1e9;
  this->Update(uploader, this->Look(0.0, 2.0)); // the coarsest patches, for which the first frame waits
  this->Settings.Cut.PixelError = 0.5;
  this->Source->SetOpen(false);
  for (int frame = 0; frame < 50; ++frame)
  {
    // Would never come back if it waited for anything.
    const auto& result = this->Update(uploader, this->Look(frame / 50.0, 0.6));
    EXPECT_FALSE(result.OnTarget);
    EXPECT_EQ(result.NodesRefined, 0u);
  }
  this->Source->SetOpen(true);
  const auto views = this->Look(0.3, 0.6);
  int frames = 0;
  while (!this->Update(uploader, views).OnTarget && frames < 10000)
  {
    ++frames;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::cout << frames << " frames until " << this->Drawn.GetLast()->Arcs.size() << " patches were there\n";
  EXPECT_EQ(this->Drawn.GetLast()->Arcs, this->GetTarget(views));
}

TEST_F(Frame, ThatWaitsDrawsWhatTheViewAsksForAtOnce)
{
  CountingUploader uploader(this->Graph());
  this->Settings.Cut.Wait = true;
  this->Settings.Cut.UploadBudget = 1; // is for frames that do not wait
  for (const double t : { 0.1, 0.4, 0.8 })
  {
    const auto views = this->Look(t, 0.4);
    const auto& result = this->Update(uploader, views);
    EXPECT_TRUE(result.OnTarget);
    EXPECT_EQ(result.Arcs, this->GetTarget(views));
    EXPECT_GT(result.NodesRefined, 20u);
  }
}

TEST_F(Frame, FurtherPassesDrawTheSameCutAndUploadNothing)
{
  CountingUploader uploader(this->Graph());
  const auto views = this->Look(0.2, 0.5);
  const auto* first = &this->Update(uploader, views);
  const auto arcs = first->Arcs;
  const std::uint64_t cuts = this->Drawn.GetNumberOfCuts();
  this->Settings.Advance = false;
  for (int pass = 0; pass < 5; ++pass)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(2)); // patches come meanwhile
    EXPECT_EQ(this->Update(uploader, views).Arcs, arcs);
  }
  EXPECT_EQ(this->Drawn.GetNumberOfCuts(), cuts);
}

TEST_F(Frame, LimitsOfMemoryAreHardAlongAFlight)
{
  CountingUploader unlimited(this->Graph());
  this->Settings.Cut.Wait = true;
  for (int step = 0; step <= 40; ++step)
  {
    this->Update(unlimited, this->Look(step / 40.0, 0.4));
  }
  const std::uint64_t needed = unlimited.MostBytes;
  const std::size_t patches = this->Drawn.GetCache()->GetMostUsedBytes();
  for (const bool wait : { true, false })
  {
    for (const int part : { 2, 3, 6 })
    {
      vtkMTFrame frame;
      frame.SetSource(this->Source, vtkMTPatchLoader::Settings());
      CountingUploader uploader(this->Graph());
      uploader.Gaps = 0.3; // more than the cut allows for
      this->Settings.Cut.Wait = wait;
      this->Settings.GraphicsMemoryLimit = needed / part;
      this->Settings.PatchMemoryLimit = patches / part;
      std::size_t refined = 0;
      for (int step = 0; step <= 40; ++step)
      {
        const auto& result = frame.Update(&this->Keys[0], this->Look(step / 40.0, 0.4), this->Settings, uploader);
        refined = std::max(refined, result.NodesRefined);
        for (const std::uint32_t arc : result.Arcs)
        {
          EXPECT_TRUE(uploader.IsUploaded(arc));
        }
      }
      std::cout << (wait ? "waiting: " : "moving: ") << uploader.MostBytes << " of " << needed / part << " bytes, "
                << frame.GetCache()->GetMostUsedBytes() << " of " << patches / part << " in main memory, at most "
                << refined << " nodes refined\n";
      EXPECT_LE(uploader.MostBytes, needed / part);
      EXPECT_LE(frame.GetCache()->GetMostUsedBytes(), patches / part);
      EXPECT_TRUE(!wait || refined > 10u); // how much comes to a frame that does not wait depends on timing
    }
  }
}

// Seen from near, a finer cut may draw fewer triangles than the coarsest one, so that a limit on them does not end
// there.
TEST_F(Frame, WithRoomForTheCoarsestPatchesOnlyAllThatItDrawsIsThere)
{
  std::uint64_t coarsest = 0;
  for (std::uint32_t arc = 0; arc < this->Graph().Nodes[0].OutCount; ++arc)
  {
    coarsest += CountingUploader(this->Graph()).GetBytesOf(arc);
  }
  for (const bool wait : { true, false })
  {
    vtkMTFrame frame;
    frame.SetSource(this->Source, vtkMTPatchLoader::Settings());
    CountingUploader uploader(this->Graph());
    uploader.Gaps = 1.0;
    this->Settings.Cut.Wait = wait;
    for (int step = 0; step <= 40; ++step)
    {
      const auto& result = frame.Update(&this->Keys[0], this->Look(step / 40.0, 0.4), this->Settings, uploader);
      EXPECT_LE(uploader.Bytes, coarsest);
      EXPECT_FALSE(result.Arcs.empty());
      for (const std::uint32_t arc : result.Arcs)
      {
        EXPECT_TRUE(uploader.IsUploaded(arc));
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1)); // what is asked for comes meanwhile
    }
    EXPECT_GT(frame.GetCache()->GetNumberOfPatches(), this->Graph().Nodes[0].OutCount);
  }
}

TEST_F(Frame, ThatDoesNotWaitUploadsNoMoreThanItsBudget)
{
  CountingUploader uploader(this->Graph());
  this->Update(uploader, this->Look(0.0, 5.0));
  this->Settings.Cut.UploadBudget = 20000;
  std::uint64_t before = uploader.Uploaded;
  const auto views = this->Look(0.6, 0.4);
  int frames = 0;
  while (!this->Update(uploader, views).OnTarget && frames < 10000)
  {
    EXPECT_LE(uploader.Uploaded - before, this->Settings.Cut.UploadBudget);
    before = uploader.Uploaded;
    ++frames;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::cout << frames << " frames, " << uploader.Uploaded << " bytes\n";
  EXPECT_GT(uploader.Uploaded, 2 * this->Settings.Cut.UploadBudget);
  EXPECT_TRUE(this->Drawn.GetLast()->OnTarget);
}

TEST_F(Frame, PatchThatCannotBeReadIsNamedOnceAndTheCoarserOneIsDrawn)
{
  const auto views = this->Look(0.5, 0.4);
  const std::vector<std::uint32_t> target = this->GetTarget(views);
  for (std::size_t i = 0; i < target.size(); i += 5)
  {
    if (this->Graph().Arcs[target[i]].From != this->Graph().GetSource())
    {
      (i % 2 ? this->Source->Broken : this->Source->Throwing).insert(target[i]);
    }
  }
  ASSERT_FALSE(this->Source->Broken.empty());
  for (const bool wait : { true, false })
  {
    vtkMTFrame frame;
    frame.SetSource(this->Source, vtkMTPatchLoader::Settings());
    CountingUploader uploader(this->Graph());
    this->Settings.Cut.Wait = wait;
    std::multiset<std::string> failures;
    const vtkMTFrame::Result* result = nullptr;
    for (int i = 0; i < 10000 && (!result || !result->OnTarget); ++i)
    {
      result = &frame.Update(&this->Keys[0], views, this->Settings, uploader);
      for (const std::string& failure : frame.TakeFailures())
      {
        failures.insert(failure);
      }
      for (const std::uint32_t arc : result->Arcs)
      {
        EXPECT_TRUE(uploader.IsUploaded(arc));
        EXPECT_FALSE(this->Source->Broken.count(arc) || this->Source->Throwing.count(arc));
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(wait ? 0 : 1));
    }
    std::cout << failures.size() << " failures, " << result->Arcs.size() << " patches drawn of " << target.size()
              << "\n";
    EXPECT_TRUE(result->OnTarget);
    EXPECT_FALSE(result->Converged);
    EXPECT_GT(result->NodesRefined, 0u);
    EXPECT_FALSE(failures.empty());
    for (const std::string& failure : failures)
    {
      EXPECT_EQ(failures.count(failure), 1u) << failure;
      EXPECT_EQ(failure.compare(0, 6, "gate: "), 0) << failure;
    }
  }
}

// Two renderers through one uploader, turn by turn, whose cuts have little in common.
TEST_F(Frame, RenderersThatShareAnUploaderUploadNothingWhereNothingMoves)
{
  this->Settings.Cut.Wait = true;
  for (int round = 0; round < 2; ++round)
  {
    CountingUploader uploader(this->Graph());
    const auto first = this->Look(0.1, 0.3);
    const auto second = this->Look(0.6, 0.3);
    std::uint64_t uploaded = 0;
    for (int frame = 0; frame < 6; ++frame)
    {
      this->Update(uploader, first, 0);
      this->Update(uploader, second, 1);
      EXPECT_TRUE(frame < 2 || uploader.Uploaded == uploaded)
        << uploader.Uploaded - uploaded << " bytes uploaded in frame " << frame;
      uploaded = uploader.Uploaded;
    }
    std::cout << uploaded << " bytes uploaded for " << uploader.Bytes << " that are there, limit "
              << this->Settings.GraphicsMemoryLimit << "\n";
    // Two thirds of what both need together.
    this->Settings.GraphicsMemoryLimit = uploader.Bytes / 3 * 2;
  }
}

TEST_F(Frame, RenderersOfSeveralWindowsHaveTheirPatchesOnEachGPU)
{
  this->Settings.Cut.Wait = true;
  CountingUploader uploaders[2] = { CountingUploader(this->Graph()), CountingUploader(this->Graph()) };
  const auto views = this->Look(0.1, 0.3);
  std::uint64_t uploaded[2] = { 0, 0 };
  for (int frame = 0; frame < 4; ++frame)
  {
    for (int i = 0; i < 2; ++i)
    {
      this->Update(uploaders[i], views, i);
      EXPECT_TRUE(frame == 0 || uploaders[i].Uploaded == uploaded[i]);
      uploaded[i] = uploaders[i].Uploaded;
    }
  }
  EXPECT_EQ(uploaded[0], uploaded[1]);
  EXPECT_EQ(this->Drawn.GetNumberOfCuts(), 2u);
  EXPECT_EQ(this->Drawn.GetCache()->GetNumberOfReads(), this->Drawn.GetLast()->Arcs.size());
}

// What a renderer drew that no longer draws, or is gone, keeps nothing from those that do.
TEST_F(Frame, RendererThatDrawsNoLongerHoldsNoShare)
{
  this->Settings.Cut.Wait = true;
  CountingUploader uploader(this->Graph());
  const auto first = this->Look(0.1, 0.3);
  const auto second = this->Look(0.6, 0.3);
  this->Update(uploader, first, 0);
  const auto alone = this->Drawn.GetLast()->Arcs;
  this->Settings.GraphicsMemoryLimit = uploader.Bytes / 3 * 4 + 100;
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Update(uploader, second, 1);
    this->Update(uploader, first, 0);
  }
  EXPECT_FALSE(this->Drawn.GetLast()->Converged);
  this->Update(uploader, first, 0);
  EXPECT_EQ(this->Update(uploader, first, 0).Arcs, alone);
  EXPECT_TRUE(this->Drawn.GetLast()->Converged);
  this->Update(uploader, second, 1);
  this->Drawn.Forget(&this->Keys[1]);
  EXPECT_EQ(this->Update(uploader, first, 0).Arcs, alone);
}

TEST_F(Frame, AnotherSourceForgetsEverything)
{
  CountingUploader uploader(this->Graph());
  this->Settings.Cut.Wait = true;
  this->Update(uploader, this->Look(0.1, 0.3));
  EXPECT_FALSE(this->Drawn.SetSource(this->Source, vtkMTPatchLoader::Settings()));
  EXPECT_NE(this->Drawn.GetLast(), nullptr);
  EXPECT_TRUE(this->Drawn.SetSource(nullptr, vtkMTPatchLoader::Settings()));
  EXPECT_EQ(this->Drawn.GetLast(), nullptr);
  EXPECT_EQ(this->Drawn.GetCache(), nullptr);
  EXPECT_EQ(this->Drawn.GetNumberOfFinestTriangles(), 0u);
}
}
