// SPDX-License-Identifier: BSD-3-Clause
// What a checkpoint keeps of a build's state comes back, and bytes that are not whole are noticed.
#include "vtkMTBuildState.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>

namespace
{
vtkMTBuildState MakeState()
{
  vtkMTBuildState state;
  state.Level = 3;
  state.Graph.Lattice.Step = 0.25;
  state.Graph.Lattice.MaximumShift = 0.1;
  state.Graph.InputCounts.Triangles = 77;
  state.Graph.InputReport = { { "dropped_degenerate", 2 }, { "isolated_points", 1 } };
  state.Graph.Blocked = { { "locked", 5 } };
  state.Graph.FullySharedBorders = 4;
  vtkMTArrayInfo colours;
  colours.Name = "colours";
  colours.Type = 3;
  colours.Components = 4;
  colours.Association = vtkMTArrayInfo::Point;
  colours.Resampling = vtkMTArrayInfo::Nearest;
  colours.ComponentNames = { "red", "", "blue" };
  colours.Properties["texture"] = "a name with spaces";
  vtkMTArrayInfo ids;
  ids.Name = "ids";
  ids.Association = vtkMTArrayInfo::Cell;
  ids.Role = vtkMTArrayInfo::InputCellIds;
  state.Graph.Arrays = { colours, ids };
  state.Nodes = { { 1, 7, 0.5, 2.0 }, { 2, 0, 1.5, 4.0 } };
  vtkMTArc arc;
  arc.Triangles = 9;
  state.Arcs = { { arc, 1, 0 }, { arc, vtkMTBuildState::None, 1 }, { arc, 0, vtkMTBuildState::None } };
  state.LevelElements = { 77, 40, 21, 10 };
  return state;
}

std::vector<unsigned char> Save(const vtkMTBuildState& state)
{
  std::vector<unsigned char> bytes;
  vtkMTBytes::Writer writer(bytes);
  state.Save(writer);
  return bytes;
}
}

TEST(BuildState, LoadGivesBackWhatSaveKept)
{
  const vtkMTBuildState state = MakeState();
  const std::vector<unsigned char> bytes = Save(state);
  vtkMTBytes::Reader reader(bytes);
  vtkMTBuildState loaded;
  loaded.Graph.Arrays.resize(5); // what was there before is replaced
  loaded.Load(reader);
  ASSERT_TRUE(reader.IsSound());
  EXPECT_TRUE(reader.IsAtEnd());
  EXPECT_EQ(loaded.Level, 3u);
  EXPECT_EQ(loaded.Graph.Lattice.Step, 0.25);
  EXPECT_EQ(loaded.Graph.Lattice.MaximumShift, 0.1);
  EXPECT_EQ(loaded.Graph.InputCounts.Triangles, 77u);
  EXPECT_EQ(loaded.Graph.InputReport, state.Graph.InputReport);
  EXPECT_EQ(loaded.Graph.Blocked, state.Graph.Blocked);
  EXPECT_EQ(loaded.Graph.FullySharedBorders, 4u);
  EXPECT_EQ(loaded.LevelElements, state.LevelElements);
  ASSERT_EQ(loaded.Graph.Arrays.size(), 2u);
  EXPECT_EQ(loaded.Graph.Arrays[0].ComponentNames, state.Graph.Arrays[0].ComponentNames);
  EXPECT_EQ(loaded.Graph.Arrays[0].Properties, state.Graph.Arrays[0].Properties);
  EXPECT_EQ(loaded.Graph.Arrays[0].Resampling, vtkMTArrayInfo::Nearest);
  EXPECT_EQ(loaded.Graph.Arrays[1].Role, vtkMTArrayInfo::InputCellIds);
  ASSERT_EQ(loaded.Nodes.size(), 2u);
  EXPECT_EQ(loaded.Nodes[0].Region, 7u);
  EXPECT_EQ(loaded.Nodes[1].Error, 1.5);
  ASSERT_EQ(loaded.Arcs.size(), 3u);
  EXPECT_EQ(loaded.Arcs[0].Arc.Triangles, 9u);
  EXPECT_EQ(loaded.Arcs[1].FromNode, vtkMTBuildState::None);
  EXPECT_EQ(Save(loaded), bytes);
}

TEST(BuildState, BytesThatEndTooEarlyAreNotSound)
{
  const std::vector<unsigned char> bytes = Save(MakeState());
  for (std::size_t size = 0; size < bytes.size(); ++size)
  {
    vtkMTBytes::Reader reader(bytes.data(), size);
    vtkMTBuildState loaded;
    loaded.Load(reader);
    EXPECT_FALSE(reader.IsSound()) << size << " of " << bytes.size() << " bytes";
  }
  std::printf("%zu lengths\n", bytes.size());
}
