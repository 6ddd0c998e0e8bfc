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

bool IsIds(const vtkMTArrayInfo& array)
{
  return array.Role == vtkMTArrayInfo::InputCellIds;
}
}

vtkMTModelSink::vtkMTModelSink(
  vtkMTPatchSink& next, const vtkMTBuildInput::Result& input, bool withIds, const std::string& identity)
  : Next(next)
  , Input(input)
  , WithIds(withIds)
  , Identity(identity)
{
}

bool vtkMTModelSink::Pass(bool done)
{
  this->Error = done ? "" : this->Next.GetError();
  return done;
}

std::vector<vtkMTArrayInfo> vtkMTModelSink::Select(const std::vector<vtkMTArrayInfo>& arrays) const
{
  std::vector<vtkMTArrayInfo> selected = arrays;
  if (!this->WithIds)
  {
    selected.erase(std::remove_if(selected.begin(), selected.end(), IsIds), selected.end());
  }
  return selected;
}

void vtkMTModelSink::FindDroppedColumns(const std::vector<vtkMTArrayInfo>& arrays)
{
  this->DroppedCellColumns.clear();
  std::size_t column = 0;
  for (const vtkMTArrayInfo& array : arrays)
  {
    if (array.Association == vtkMTArrayInfo::Cell)
    {
      if (!this->WithIds && IsIds(array))
      {
        this->DroppedCellColumns.insert(this->DroppedCellColumns.begin(), column);
      }
      ++column;
    }
  }
}

void vtkMTModelSink::Drop(vtkMTPatch& patch) const
{
  for (std::size_t column : this->DroppedCellColumns)
  {
    patch.CellColumns.erase(patch.CellColumns.begin() + static_cast<std::ptrdiff_t>(column));
  }
}

bool vtkMTModelSink::Begin(const std::vector<vtkMTArrayInfo>& arrays)
{
  this->FindDroppedColumns(arrays);
  bool done = this->Next.Begin(this->Select(arrays));
  for (std::size_t i = 0; done && i < this->Input.Textures.size(); ++i)
  {
    done = this->Next.WriteBlob(std::vector<unsigned char>(this->Input.Textures[i].Bytes));
  }
  return this->Pass(done);
}

bool vtkMTModelSink::WritePatch(vtkMTPatch&& patch)
{
  this->Drop(patch);
  return this->Pass(this->Next.WritePatch(std::move(patch)));
}

std::unique_ptr<vtkMTPatchSink::PreparedPatch> vtkMTModelSink::Prepare(vtkMTPatch&& patch, std::string& error) const
{
  this->Drop(patch);
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
  this->FindDroppedColumns(arrays);
  return this->Pass(this->Next.Restore(this->Select(arrays), state));
}

bool vtkMTModelSink::WriteBlob(std::vector<unsigned char>&& bytes)
{
  return this->Pass(this->Next.WriteBlob(std::move(bytes)));
}

bool vtkMTModelSink::Finish(const vtkMTGraph& graph, const std::vector<std::uint32_t>& patchOfArc)
{
  vtkMTGraph finished = graph;
  finished.Arrays = this->Select(graph.Arrays);
  finished.Settings["build"] = this->Identity;
  finished.Crs = this->Input.Crs;
  finished.Units = this->Input.Units;
  std::vector<vtkMTBlobInfo> blobs;
  std::transform(this->Input.Textures.begin(), this->Input.Textures.end(), std::back_inserter(blobs), Describe);
  finished.Blobs.insert(finished.Blobs.begin(), blobs.begin(), blobs.end());
  return this->Pass(this->Next.Finish(finished, patchOfArc));
}
