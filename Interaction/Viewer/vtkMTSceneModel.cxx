// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSceneModel.h"

#include "vtkMTDrawableScale.h"
#include "vtkMTModelTextures.h"
#include "vtkMTPatchSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

vtkMTSceneModel::vtkMTSceneModel() = default;
vtkMTSceneModel::~vtkMTSceneModel() = default;

//------------------------------------------------------------------------------
bool vtkMTSceneModel::SetSource(const std::shared_ptr<const vtkMTPatchSource>& source, const std::string& name,
  const std::string& texture, std::string& error)
{
  error.clear();
  if (!this->Model->SetSource(source))
  {
    error = name + ": its coarsest patches cannot be read; 'bmt verify' says more";
    return false;
  }
  double bounds[6];
  this->Model->GetModelBounds(bounds);
  if (const std::string problem = vtkMTDrawableScale::FindProblem(bounds); !problem.empty())
  {
    error = name + " cannot be drawn: " + problem;
    return false;
  }
  vtkMTModelTextures textures = vtkMTModelTextures::Read(*source);
  if (!texture.empty() && !textures.ReplaceByFile(texture, error))
  {
    return false;
  }
  this->TextureProblems = textures.Problems;
  this->Mapper->SetInputDataObject(this->Model);
  this->Actor->SetMapper(this->Mapper);
  for (const vtkMTModelTextures::Texture& each : textures.Textures)
  {
    vtkNew<vtkTexture> image;
    image->SetInputData(each.Image);
    image->InterpolateOn();
    image->SetBlendingMode(vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE);
    this->Actor->GetProperty()->SetTexture(each.Name.c_str(), image);
    this->Mapper->MapTextureToMaterial(each.Name.c_str(), each.Material, each.Part);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTSceneModel::SetPreview(vtkPolyData* mesh)
{
  if (this->HasModel() || !vtkMTDrawableScale::FindProblem(mesh->GetBounds()).empty())
  {
    return false;
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  this->Actor->SetMapper(mapper);
  return true;
}
