// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportScene.h"

#include "FlightPath.h"
#include "MTReportTimes.h"

#include "vtkProp.h"

MTReportScene::MTReportScene(const std::array<int, 2>& size, vtkProp* actor)
{
  const auto& background = MTReportPicture::Background;
  this->Renderer->SetBackground(background[0] / 255.0, background[1] / 255.0, background[2] / 255.0);
  this->Renderer->AddViewProp(actor);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(size[0], size[1]);
  this->Window->AddRenderer(this->Renderer);
}

void MTReportScene::Look(const FlightPath& path, int frame)
{
  path.Apply(frame, this->Renderer);
}

double MTReportScene::Draw()
{
  const double begin = MTReportTimes::GetCpuSeconds();
  this->Window->Render();
  this->Window->WaitForCompletion();
  return MTReportTimes::GetCpuSeconds() - begin;
}
