// SPDX-License-Identifier: BSD-3-Clause
// The frame of a reader that gives a whole mesh or none. Not installed.
#ifndef vtkMTReadWhole_h
#define vtkMTReadWhole_h

#include "vtkMTFileByteSource.h"

#include "vtkPolyData.h"

#include <exception>
#include <new>
#include <string>

namespace vtkMTReadWhole
{
/// read(reason) fills output. False, with the source's name and the reason in error, and an empty output where it
/// fails.
template <class Function>
bool Read(const vtkMTByteSource& bytes, vtkPolyData* output, std::string& error, const Function& read)
{
  output->Initialize();
  std::string reason;
  try
  {
    if (read(reason))
    {
      return true;
    }
  }
  catch (const std::bad_alloc&)
  {
    reason = "takes more memory than there is";
  }
  catch (const std::exception& exception)
  {
    reason = exception.what();
  }
  output->Initialize();
  error = bytes.GetName() + ": " + reason;
  return false;
}

/// The same of a file.
template <class Reader>
bool ReadFile(const std::string& path, vtkPolyData* output, std::string& error)
{
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  output->Initialize();
  return bytes && Reader::Read(*bytes, output, error);
}
}

#endif
