// SPDX-License-Identifier: BSD-3-Clause
#include "Obj/vtkMTObjReader.h"
#include "vtkMTMemoryByteSource.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const vtkMTMemoryByteSource bytes(std::vector<unsigned char>(data, data + size));
  vtkNew<vtkPolyData> mesh;
  std::string error;
  vtkMTObjReader::Read(bytes, mesh, error);
  return 0;
}
