// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCertifiedMesh.h"

#include "vtkMTBytes.h"
#include "vtkMTPatchRecord.h"

#include <algorithm>

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
}

bool vtkMTCertifiedMesh::Take(vtkMTBytes::Reader& reader)
{
  if (!vtkMTPatchRecord::Take(reader, this->Mesh))
  {
    return false;
  }
  reader.TakeList(this->Deviations);
  const bool isZero = this->Deviations.empty();
  this->Deviations.resize(isZero ? this->Mesh.Triangles.size() : this->Deviations.size());
  return reader.IsSound() && this->Deviations.size() == this->Mesh.Triangles.size();
}

void vtkMTCertifiedMesh::Encode(std::vector<unsigned char>& bytes) const
{
  bytes.clear();
  bytes.reserve(this->Mesh.GetMemorySize() + this->Deviations.size() * sizeof(vtkMTTriangleDeviation) + 256);
  vtkMTBytes::Writer writer(bytes);
  this->Put(writer);
}

bool vtkMTCertifiedMesh::Decode(const std::vector<unsigned char>& bytes, std::string& error)
{
  vtkMTBytes::Reader reader(bytes);
  if (!this->Take(reader) || !reader.IsAtEnd())
  {
    error = "temporary data does not hold the mesh that was written";
    return false;
  }
  return true;
}
