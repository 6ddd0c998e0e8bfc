// SPDX-License-Identifier: BSD-3-Clause
// Frames of a model of which the first pages have been read, and the others come by and by.
#include "MTIOTest.h"
#include "MTTestModel.h"
#include "MTViews.h"

#include "vtkMTFileSource.h"
#include "vtkMTFrame.h"
#include "vtkMTGraph.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTTargetCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <set>
#include <thread>

namespace
{
// Takes everything.
class Uploader : public vtkMTUploader
{
public:
  explicit Uploader(const vtkMTGraph& graph)
    : Graph(graph)
  {
  }
  Cost GetCost() const override { return { 12, 6 }; }
  std::vector<unsigned char> GetArrays() const override
  {
    return std::vector<unsigned char>(this->Graph.Arrays.size(), 0);
  }
  bool IsUploaded(std::uint32_t arc) const override { return this->Patches.count(arc) != 0; }
  void Begin(const std::vector<std::uint32_t>&, const std::vector<std::uint32_t>&, std::uint64_t) override {}
  bool Reserve(std::uint32_t) override { return true; }
  bool Upload(std::uint32_t arc, const vtkMTPatch& patch) override
  {
    return patch.Triangles.size() == this->Graph.Arcs[arc].Triangles && this->Patches.insert(arc).second;
  }
  void Drop(std::uint32_t arc) override { this->Patches.erase(arc); }
  std::uint64_t GetChanges() const override { return this->Patches.size(); }

private:
  const vtkMTGraph& Graph;
  std::set<std::uint32_t> Patches;
};

// A model whose graph takes some twenty pages, and frames of it.
class GrowingGraph : public testing::Test
{
protected:
  static const MTIOTest::Bytes& GetFile()
  {
    static const MTIOTest::Bytes file = []
    {
      MTTestModel::TubeOptions options;
      options.Rings = 8192;
      options.Across = 3;
      options.Regions = 2048;
      return MTIOTest::StoreModel(*MTTestModel::MakeTube(options));
    }();
    return file;
  }

  // A page of the graph that is not among the first ones is damaged.
  static MTIOTest::Bytes GetDamagedFile()
  {
    constexpr std::size_t page = 65536;
    std::string error;
    for (std::size_t place = 2 * page; place < GetFile().size(); place += page)
    {
      MTIOTest::Bytes bytes = GetFile();
      bytes[place] ^= 1;
      vtkMTFileSource source;
      if (source.OpenFirstPages(std::make_shared<vtkMTMemoryByteSource>(MTIOTest::Bytes(bytes)), error) &&
        !source.ReadOn(~std::uint64_t(0), error))
      {
        return bytes;
      }
    }
    ADD_FAILURE() << "no page is read late";
    return GetFile();
  }

  void Open(MTIOTest::Bytes bytes)
  {
    this->Source = std::make_shared<vtkMTFileSource>();
    std::string error;
    ASSERT_TRUE(this->Source->OpenFirstPages(std::make_shared<vtkMTMemoryByteSource>(std::move(bytes)), error))
      << error;
    ASSERT_FALSE(this->Graph().IsWhole());
    ASSERT_TRUE(this->Drawn.SetSource(this->Source, vtkMTPatchLoader::Settings()));
    this->GPU = std::make_unique<Uploader>(this->Graph());
    double bounds[6];
    this->Graph().GetBounds(bounds);
    this->Views = { MTViews::LookAt(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[1] - bounds[0] + bounds[3] - bounds[2]), 0.2) };
    this->Settings.Cut.Prefetch = false;
    this->Settings.Cut.PixelError = -1.0; // all that can be seen
  }

  const vtkMTGraph& Graph() const { return this->Source->GetKnownGraph(); }

  const vtkMTFrame::Result& Update()
  {
    const auto& result = this->Drawn.Update(this, this->Views, this->Settings, *this->GPU);
    EXPECT_FALSE(result.Arcs.empty());
    for (const std::uint32_t arc : result.Arcs)
    {
      EXPECT_LT(arc, this->Graph().GetNumberOfKnownArcs());
      EXPECT_TRUE(this->GPU->IsUploaded(arc));
    }
    return result;
  }

  std::vector<std::uint32_t> GetTarget() const
  {
    vtkMTTargetCut::Input input;
    input.Graph = &this->Graph();
    input.Views = this->Views;
    return vtkMTTargetCut().Extract(input, this->Settings.Cut).Arcs;
  }

  std::shared_ptr<vtkMTFileSource> Source;
  std::unique_ptr<Uploader> GPU;
  vtkMTFrame Drawn;
  vtkMTFrame::Settings Settings;
  std::vector<vtkMTView> Views;
};

TEST_F(GrowingGraph, FramesFollowWhatIsKnownUntilItIsWhatTheViewAsksFor)
{
  ASSERT_NO_FATAL_FAILURE(this->Open(GetFile()));
  std::string error;
  int steps = 0;
  std::size_t refined = 0;
  for (; !this->Graph().IsWhole(); ++steps)
  {
    const auto target = this->GetTarget();
    // What is known is soon drawn; but it is not yet what the view asks for.
    for (int frame = 0; frame < 10000 && this->Update().Arcs != target; ++frame)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(this->Drawn.GetLast()->Arcs, target);
    EXPECT_FALSE(this->Drawn.GetLast()->OnTarget);
    EXPECT_GE(this->Drawn.GetLast()->NodesRefined, refined);
    refined = this->Drawn.GetLast()->NodesRefined;
    ASSERT_TRUE(this->Source->ReadOn(1, error)) << error;
  }
  for (int frame = 0; frame < 10000 && !this->Update().OnTarget; ++frame)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::cout << steps << " steps, " << refined << " nodes refined before the last, "
            << this->Drawn.GetLast()->NodesRefined << " after it\n";
  EXPECT_TRUE(this->Drawn.GetLast()->OnTarget);
  EXPECT_EQ(this->Drawn.GetLast()->Arcs, this->GetTarget());
  EXPECT_GT(steps, 3);
  EXPECT_GT(refined, 0u);
  EXPECT_GT(this->Drawn.GetLast()->NodesRefined, refined);
}

TEST_F(GrowingGraph, FrameThatWaitsReadsTheRestOnlyWhereItAsksForIt)
{
  ASSERT_NO_FATAL_FAILURE(this->Open(GetFile()));
  this->Settings.Cut.Wait = true;
  this->Settings.Cut.PixelError = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(this->Update().OnTarget) << "the coarsest patches are enough";
  EXPECT_FALSE(this->Graph().IsWhole());
  this->Settings.Cut.PixelError = -1.0;
  EXPECT_TRUE(this->Update().OnTarget);
  EXPECT_TRUE(this->Graph().IsWhole());
  EXPECT_EQ(this->Drawn.GetLast()->Arcs, this->GetTarget());
}

TEST_F(GrowingGraph, PageThatCannotBeReadIsNamedOnceAndWhatIsKnownIsDrawn)
{
  for (const bool wait : { true, false })
  {
    std::string error;
    ASSERT_NO_FATAL_FAILURE(this->Open(GetDamagedFile()));
    this->Settings.Cut.Wait = wait;
    if (!wait)
    {
      EXPECT_FALSE(this->Source->ReadOn(~std::uint64_t(0), error));
    }
    for (int frame = 0; frame < 10000 && !this->Update().OnTarget; ++frame)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(this->Drawn.GetLast()->OnTarget) << "nothing more will come";
    EXPECT_FALSE(this->Drawn.GetLast()->Converged);
    EXPECT_FALSE(this->Graph().IsWhole());
    this->Update();
    const std::vector<std::string> failures = this->Drawn.TakeFailures();
    ASSERT_EQ(failures.size(), 1u);
    EXPECT_NE(failures[0].find("damaged"), std::string::npos) << failures[0];
    EXPECT_EQ(this->Drawn.GetLast()->Arcs, this->GetTarget());
  }
}

TEST_F(GrowingGraph, FramesAreDrawnWhileAThreadReadsOn)
{
  for (int run = 0; run < 3; ++run)
  {
    ASSERT_NO_FATAL_FAILURE(this->Open(GetFile()));
    this->Source->StartReadingOn();
    int frames = 0;
    while (!this->Update().OnTarget && frames < 10000)
    {
      ++frames;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(this->Graph().IsWhole());
    EXPECT_EQ(this->Drawn.GetLast()->Arcs, this->GetTarget());
    this->Drawn.SetSource(nullptr, vtkMTPatchLoader::Settings());
  }
}
}
