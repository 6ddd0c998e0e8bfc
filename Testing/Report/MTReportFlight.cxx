// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportFlight.h"

#include "MTReportContext.h"
#include "MTReportScene.h"

#include "vtkMTGraph.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationMapper.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindowInteractor.h"

#include <memory>

MTReportFlight::MTReportFlight(const MTReportContext& context, const MTReportMesh& mesh)
  : Size(context.IsQuick() ? std::array<int, 2>{ 480, 360 } : std::array<int, 2>{ 960, 720 })
  , Model(mesh.Data, context.GetPatchTriangles())
  , ModelWithNormals(mesh.Data, context.GetPatchTriangles(),
      [](vtkMultiTriangulationBuilder* builder) { builder->CertifyNormalsOn(); })
  , Full(this->Model.CutByLevel(0).Mesh)
{
  double bounds[6];
  this->Model.GetGraph().GetBounds(bounds);
  this->Path = FlightPath::Make(bounds, this->Full, context.IsQuick() ? 16 : 48);
  vtkNew<vtkActor> actor;
  this->FlyMesh(actor, 0.0, this->Wanted);
}

MTReportFlight::~MTReportFlight() = default;

void MTReportFlight::Configure(vtkMultiTriangulationMapper* mapper, int metric, double pixelError) const
{
  const bool isByNormals = metric == vtkMultiTriangulationMapper::NORMAL_DEVIATION;
  mapper->SetInputData((isByNormals ? this->ModelWithNormals : this->Model).GetData());
  mapper->ScalarVisibilityOff();
  mapper->SetErrorMetric(metric);
  mapper->SetPixelError(pixelError);
  mapper->SetWaitForConvergence(vtkMultiTriangulationMapper::WAIT_ALWAYS);
}

MTReportFrames MTReportFlight::FlyModel(int metric, double pixelError) const
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  this->Configure(mapper, metric, pixelError);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  MTReportScene scene(this->Size, actor);
  MTReportFrames frames;
  for (int frame = 0; frame < this->Path.GetNumberOfFrames(); ++frame)
  {
    scene.Look(this->Path, frame);
    std::unique_ptr<MTReportPicture> ofCutBefore;
    if (frame > 0)
    {
      mapper->FreezeCutOn();
      scene.Draw();
      ofCutBefore = std::make_unique<MTReportPicture>(scene.GetPicture());
      mapper->FreezeCutOff();
    }
    const double seconds = scene.Draw();
    const MTReportPicture picture = scene.GetPicture();
    frames.Triangles.push_back(static_cast<double>(mapper->GetNumberOfTriangles()));
    frames.CertifiedPixels.push_back(mapper->GetAchievedPixelError());
    frames.Differences.push_back(picture.Compare(this->Wanted[frame]));
    if (ofCutBefore)
    {
      frames.Popping.push_back(picture.Compare(*ofCutBefore));
      frames.FrameSeconds.push_back(seconds);
      frames.CutSeconds.push_back(mapper->GetCutTime());
    }
  }
  return frames;
}

MTReportFrames MTReportFlight::FlyMesh(vtkActor* actor, double rate) const
{
  std::vector<MTReportPicture> pictures;
  MTReportFrames frames = this->FlyMesh(actor, rate, pictures);
  for (std::size_t i = 0; i < pictures.size(); ++i)
  {
    frames.Differences.push_back(pictures[i].Compare(this->Wanted[i]));
  }
  return frames;
}

MTReportFrames MTReportFlight::FlyMesh(vtkActor* actor, double rate, std::vector<MTReportPicture>& pictures) const
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Full);
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  MTReportScene scene(this->Size, actor);
  vtkNew<vtkRenderWindowInteractor> interactor; // vtkQuadricLODActor asks it
  interactor->SetRenderWindow(scene.GetWindow());
  if (rate > 0.0)
  {
    interactor->SetDesiredUpdateRate(rate);
    scene.GetWindow()->SetDesiredUpdateRate(rate);
  }
  scene.Look(this->Path, 0);
  scene.Draw(); // uploads, and builds coarse meshes
  MTReportFrames frames;
  for (int frame = 0; frame < this->Path.GetNumberOfFrames(); ++frame)
  {
    scene.Look(this->Path, frame);
    const double seconds = scene.Draw();
    pictures.push_back(scene.GetPicture());
    if (frame > 0)
    {
      frames.FrameSeconds.push_back(seconds);
    }
  }
  scene.GetWindow()->SetInteractor(nullptr);
  return frames;
}

void MTReportFlight::WritePictures(double pixelError, const std::string& path) const
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  this->Configure(mapper, vtkMultiTriangulationMapper::DISTANCE, pixelError);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  MTReportScene scene(this->Size, actor);
  std::vector<std::vector<MTReportPicture>> rows(2);
  for (const double time : { 0.3, 0.45, 0.6 })
  {
    const int frame = static_cast<int>(time * (this->Path.GetNumberOfFrames() - 1));
    scene.Look(this->Path, frame);
    scene.Draw();
    rows[0].push_back(this->Wanted[frame]);
    rows[1].push_back(scene.GetPicture());
  }
  MTReportPicture::Write(rows, this->Size[0] / 240, path);
}
