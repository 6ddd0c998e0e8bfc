// SPDX-License-Identifier: BSD-3-Clause
// Multi-Triangulations of meshes, built in memory, and cuts of them.
#ifndef MTReportModel_h
#define MTReportModel_h

#include "vtkMultiTriangulation.h"
#include "vtkSmartPointer.h"

#include <functional>

class vtkMTGraph;
class vtkMultiTriangulationBuilder;
class vtkPolyData;

struct MTReportCut
{
  vtkSmartPointer<vtkPolyData> Mesh; ///< welded
  double Certified = 0.0;            ///< its largest certified distance to the input, model units
};

class MTReportModel
{
public:
  using Configure = std::function<void(vtkMultiTriangulationBuilder*)>;

  static constexpr int DefaultPatchTriangles = 1000;

  /// Builds with default settings but patches of so many triangles and one thread, all of which configure may change;
  /// what that takes is kept. Throws std::runtime_error.
  MTReportModel(vtkPolyData* mesh, int patchTriangles, const Configure& configure = {});
  ~MTReportModel();

  double GetCpuSeconds() const { return this->CpuSeconds; }
  double GetLevelSeconds() const { return this->LevelSeconds; } ///< by the clock
  const vtkMTGraph& GetGraph() const;
  vtkMultiTriangulation* GetData() const { return this->Data; }

  /// The most precise cut of at most so many triangles; the coarsest one where that has more.
  MTReportCut CutByTriangles(vtkIdType triangles) const;
  MTReportCut CutByLevel(unsigned int level) const;

private:
  double CpuSeconds = 0.0;
  double LevelSeconds = 0.0;
  vtkSmartPointer<vtkMultiTriangulation> Data;
};

#endif
