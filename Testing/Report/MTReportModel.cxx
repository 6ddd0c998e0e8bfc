// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportModel.h"

#include "MTReportTimes.h"

#include "vtkMTCut.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTStageTimes.h"
#include "vtkMTTargetCut.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <stdexcept>

namespace
{
MTReportCut MakeCut(const vtkMTPatchSource& source, const vtkMTCut& cut)
{
  MTReportCut result{ vtkSmartPointer<vtkPolyData>::New(), cut.GetError() };
  std::string error;
  if (!vtkMultiTriangulation::CutToPolyData(source, cut, result.Mesh, error))
  {
    throw std::runtime_error(error);
  }
  return result;
}
}

MTReportModel::MTReportModel(vtkPolyData* mesh, int patchTriangles, const Configure& configure)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(mesh);
  builder->SetPatchTriangles(patchTriangles);
  builder->SetNumberOfThreads(1);
  if (configure)
  {
    configure(builder);
  }
  const double begin = MTReportTimes::GetCpuSeconds();
  builder->Update();
  this->CpuSeconds = MTReportTimes::GetCpuSeconds() - begin;
  this->LevelSeconds = builder->GetStageTimes().GetLevelSeconds();
  this->Data = vtkMultiTriangulation::SafeDownCast(builder->GetOutput());
  if (!this->Data || !this->Data->GetSource())
  {
    throw std::runtime_error("building failed: " + builder->GetErrorMessage());
  }
}

MTReportModel::~MTReportModel() = default;

const vtkMTGraph& MTReportModel::GetGraph() const
{
  return this->Data->GetSource()->GetGraph();
}

MTReportCut MTReportModel::CutByTriangles(vtkIdType triangles) const
{
  vtkMTCut cut(this->GetGraph());
  std::string tooFew; // then the cut is the coarsest one
  vtkMTTargetCut().ByTriangles(this->GetGraph(), static_cast<std::uint64_t>(triangles), cut, tooFew);
  return MakeCut(*this->Data->GetSource(), cut);
}

MTReportCut MTReportModel::CutByLevel(unsigned int level) const
{
  vtkMTCut cut(this->GetGraph());
  std::string error;
  if (!vtkMTTargetCut::ByLevel(this->GetGraph(), level, cut, error))
  {
    throw std::runtime_error(error);
  }
  return MakeCut(*this->Data->GetSource(), cut);
}
