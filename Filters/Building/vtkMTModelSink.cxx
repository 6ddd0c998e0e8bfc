// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTModelSink.h"

#include <algorithm>

namespace
{
vtkMTBlobInfo Describe(const vtkMTTexture& texture)
{
  vtkMTBlobInfo info;
  info.Name = texture.Name;
  info.Type = texture.MimeType;
  info.Properties = { { "use", "texture" }, { "coordinates", texture.Coordinates },
    { "material", std::to_string(texture.Material) }, { "material_name", texture.MaterialName },
    { "part", std::to_string(texture.Part) } };
  return info;
}
}

vtkMTModelSink::vtkMTModelSink(vtkMTPatchSink& next, const vtkMTBuildInput::Result& input, const std::string& identity)
  : Next(next)
  , Input(input)
  , Identity(identity)
{
}

bool vtkMTModelSink::Pass(bool done)
{
  this->Error = done ? "" : this->Next.GetError();
  return done;
}

bool vtkMTModelSink::Begin(const std::vector<vtkMTArrayInfo>& arrays)
{
  bool done = this->Next.Begin(arrays);
  for (std::size_t i = 0; done && i < this->Input.Textures.size(); ++i)
  {
    done = this->Next.WriteBlob(std::vector<unsigned char>(this->Input.Textures[i].Bytes));
  }
  return this->Pass(done);
}

bool vtkMTModelSink::WritePatch(vtkMTPatch&& patch)
{
  return this->Pass(this->Next.WritePatch(std::move(patch)));
}

std::unique_ptr<vtkMTPatchSink::PreparedPatch> vtkMTModelSink::Prepare(vtkMTPatch&& patch, std::string& error) const
{
  return this->Next.Prepare(std::move(patch), error);
}

bool vtkMTModelSink::WritePrepared(std::unique_ptr<PreparedPatch> patch)
{
  return this->Pass(this->Next.WritePrepared(std::move(patch)));
}

bool vtkMTModelSink::Save(std::vector<unsigned char>& state)
{
  return this->Pass(this->Next.Save(state));
}

bool vtkMTModelSink::Restore(const std::vector<vtkMTArrayInfo>& arrays, const std::vector<unsigned char>& state)
{
  return this->Pass(this->Next.Restore(arrays, state));
}

bool vtkMTModelSink::WriteBlob(std::vector<unsigned char>&& bytes)
{
  return this->Pass(this->Next.WriteBlob(std::move(bytes)));
}

bool vtkMTModelSink::Finish(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc)
{
  vtkMTGraph finished = graph;
  finished.Settings["build"] = this->Identity;
  finished.Crs = this->Input.Crs;
  finished.Units = this->Input.Units;
  std::vector<vtkMTBlobInfo> blobs;
  std::transform(this->Input.Textures.begin(), this->Input.Textures.end(), std::back_inserter(blobs), Describe);
  finished.Blobs.insert(finished.Blobs.begin(), blobs.begin(), blobs.end());
  return this->Pass(this->Next.Finish(finished, patchOfArc));
}
