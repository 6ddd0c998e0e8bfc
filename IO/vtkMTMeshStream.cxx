// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshStream.h"

#include "vtkMTPlyStream.h"
#include "vtkMTStlStream.h"

#include <exception>

std::unique_ptr<vtkMTTriangleStream> vtkMTMeshStream::Open(const std::string& path)
{
  try
  {
    std::unique_ptr<vtkMTTriangleStream> stream = vtkMTPlyStream::Open(path);
    return stream ? std::move(stream) : vtkMTStlStream::Open(path);
  }
  catch (const std::exception&) // the reader of whole files meets it again and says so
  {
    return nullptr;
  }
}
