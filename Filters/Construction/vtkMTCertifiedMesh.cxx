// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCertifiedMesh.h"

#include "vtkMTBytes.h"
#include "vtkMTPatchRecord.h"

#include <algorithm>

void vtkMTCertifiedMesh::TakeDeviations(const vtkMTCertifiedMesh& whole, const std::vector<std::uint32_t>& triangles)
{
  const std::size_t arrays = whole.ValueDeviations.size() / std::max<std::size_t>(1, whole.Deviations.size());
  this->Deviations.reserve(triangles.size());
  for (const std::uint32_t t : triangles)
  {
    this->Deviations.push_back(whole.Deviations[t]);
  }
  this->ValueDeviations.reserve(triangles.size() * arrays);
  for (std::size_t i = 0; i < triangles.size() && arrays > 0; ++i)
  {
    const auto first = whole.ValueDeviations.begin() + static_cast<std::ptrdiff_t>(triangles[i] * arrays);
    this->ValueDeviations.insert(this->ValueDeviations.end(), first, first + static_cast<std::ptrdiff_t>(arrays));
  }
}

void vtkMTCertifiedMesh::Put(vtkMTBytes::Writer& writer) const
{
  vtkMTPatchRecord::Put(this->Mesh, writer);
  const bool isZero = std::all_of(this->Deviations.begin(), this->Deviations.end(),
    [](const vtkMTTriangleDeviation& deviation)
    {
      return deviation.ToInput == 0.0f && deviation.FromInput == 0.0f && deviation.NormalToInput == 0 &&
        deviation.NormalFromInput == 0;
    });
  writer.PutList(isZero ? std::vector<vtkMTTriangleDeviation>() : this->Deviations);
  writer.PutList(this->ValueDeviations);
}

bool vtkMTCertifiedMesh::Take(vtkMTBytes::Reader& reader)
{
  if (!vtkMTPatchRecord::Take(reader, this->Mesh))
  {
    return false;
  }
  reader.TakeList(this->Deviations);
  reader.TakeList(this->ValueDeviations);
  const bool isZero = this->Deviations.empty();
  this->Deviations.resize(isZero ? this->Mesh.Triangles.size() : this->Deviations.size());
  const std::size_t triangles = this->Mesh.Triangles.size();
  return reader.IsSound() && this->Deviations.size() == triangles &&
    (this->ValueDeviations.empty() || (triangles > 0 && this->ValueDeviations.size() % triangles == 0));
}

void vtkMTCertifiedMesh::Encode(std::vector<unsigned char>& bytes) const
{
  bytes.clear();
  bytes.reserve(this->Mesh.GetMemorySize() + this->Deviations.size() * sizeof(vtkMTTriangleDeviation) +
    this->ValueDeviations.size() * sizeof(vtkMTValueDeviation) + 256);
  vtkMTBytes::Writer writer(bytes);
  this->Put(writer);
}

bool vtkMTCertifiedMesh::Decode(const vtkMTBytes::Record& bytes, std::string& error)
{
  vtkMTBytes::Reader reader(bytes);
  if (!this->Take(reader) || !reader.IsAtEnd())
  {
    error = "temporary data does not hold the mesh that was written";
    return false;
  }
  return true;
}
