// SPDX-License-Identifier: BSD-3-Clause
// Cuts that many tests look at, and their meshes.
#ifndef MTCuts_h
#define MTCuts_h

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace MTCuts
{
/// The cut of all patches of the finest level: what was built, at full resolution.
inline vtkMTCut GetFinest(const vtkMTGraph& graph)
{
  vtkMTCut cut(graph);
  for (std::uint32_t node = 1; node < graph.GetSink(); ++node)
  {
    EXPECT_TRUE(cut.Refine(node));
  }
  return cut;
}

inline vtkSmartPointer<vtkPolyData> GetMesh(const vtkMTPatchSource& source, const vtkMTCut& cut)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  std::string error;
  EXPECT_TRUE(vtkMultiTriangulation::CutToPolyData(source, cut, mesh, error)) << error;
  return mesh;
}

inline vtkSmartPointer<vtkPolyData> GetFinestMesh(const vtkMTPatchSource& source)
{
  return GetMesh(source, GetFinest(source.GetGraph()));
}
}

#endif
