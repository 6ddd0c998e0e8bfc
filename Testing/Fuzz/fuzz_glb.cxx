// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfReader.h"
#include "vtkMTMemoryByteSource.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const vtkMTMemoryByteSource bytes(std::vector<unsigned char>(data, data + size));
  vtkNew<vtkPolyData> mesh;
  std::string error;
  vtkMTGltfReader::Read(bytes, mesh, error, nullptr, std::uint64_t(64) << 20);
  return 0;
}
