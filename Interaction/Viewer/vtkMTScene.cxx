// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTScene.h"

#include "vtkCamera.h"
#include "vtkMTCameraPathFile.h"
#include "vtkRenderer.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkMTScene::vtkMTScene(vtkRenderer* renderer, const vtkMTCameraView& view, bool hasView)
  : Renderer(renderer)
{
  view.Set(renderer->GetActiveCamera());
  this->CameraTime = hasView ? 0 : renderer->GetActiveCamera()->GetMTime();
}

vtkMTScene::~vtkMTScene() = default;

//------------------------------------------------------------------------------
std::size_t vtkMTScene::AddItem()
{
  this->Items.push_back(std::make_unique<vtkMTSceneModel>());
  return this->Items.size() - 1;
}

//------------------------------------------------------------------------------
bool vtkMTScene::ShowModel(std::size_t item, const std::shared_ptr<const vtkMTPatchSource>& source,
  const std::string& name, const std::string& texture, std::string& error)
{
  const bool isThere = this->Items[item]->SetSource(source, name, texture, error);
  if (isThere)
  {
    this->Show(this->Items[item]->Actor);
  }
  return isThere;
}

//------------------------------------------------------------------------------
void vtkMTScene::ShowPreview(std::size_t item, vtkPolyData* mesh)
{
  if (this->Items[item]->SetPreview(mesh))
  {
    this->Show(this->Items[item]->Actor);
  }
}

//------------------------------------------------------------------------------
bool vtkMTScene::IsAllSeen() const
{
  return std::all_of(
    this->Items.begin(), this->Items.end(), [](const auto& item) { return item->Actor->GetMapper() != nullptr; });
}

//------------------------------------------------------------------------------
void vtkMTScene::Show(vtkActor* actor)
{
  if (!this->Renderer->HasViewProp(actor))
  {
    this->Renderer->AddActor(actor);
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  if (camera->GetMTime() == this->CameraTime)
  {
    this->Renderer->ResetCamera();
    this->CameraTime = camera->GetMTime();
  }
  else
  {
    this->Renderer->ResetCameraClippingRange();
  }
}
