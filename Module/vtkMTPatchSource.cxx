// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchSource.h"

//------------------------------------------------------------------------------
vtkMTPatchSource::~vtkMTPatchSource() = default;

//------------------------------------------------------------------------------
const vtkMTGraph& vtkMTPatchSource::GetKnownGraph() const
{
  return this->GetGraph();
}

//------------------------------------------------------------------------------
std::string vtkMTPatchSource::GetGraphError() const
{
  return std::string();
}

//------------------------------------------------------------------------------
bool vtkMTPatchSource::ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const
{
  bytes.clear();
  error = this->GetName() + ": no blob " + std::to_string(blob);
  return false;
}

//------------------------------------------------------------------------------
void vtkMTPatchSource::ReadPatches(
  const std::vector<std::uint32_t>& arcs, const std::vector<unsigned char>* arrays, const PatchUse& use) const
{
  for (std::size_t i = 0; i < arcs.size(); ++i)
  {
    vtkMTPatch patch;
    std::string error;
    const bool read = this->ReadPatch(arcs[i], arrays, patch, error);
    use(i, read, patch, error);
  }
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTPatchSource::GetDecodeSize(std::uint32_t) const
{
  return 0;
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTPatchSource::GetPatchPlace(std::uint32_t arc) const
{
  return arc;
}
