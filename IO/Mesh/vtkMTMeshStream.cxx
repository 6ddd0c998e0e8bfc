// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMeshStream.h"

#include "Obj/vtkMTObjStream.h"
#include "vtkMTMergedStream.h"
#include "vtkMTMeshFormat.h"
#include "vtkMTPlyStream.h"
#include "vtkMTStlStream.h"
#include "vtkMTVtpStream.h"

#include <exception>

std::unique_ptr<vtkMTTriangleStream> vtkMTMeshStream::Open(const std::string& path, vtkPolyData* names)
{
  return Open(path, Settings(), names);
}

std::unique_ptr<vtkMTTriangleStream> vtkMTMeshStream::Open(
  const std::string& path, const Settings& settings, vtkPolyData* names)
{
  try
  {
    std::unique_ptr<vtkMTTriangleStream> stream = vtkMTPlyStream::Open(path, settings, names);
    const std::string ending = vtkMTMeshFormat::GetEnding(path);
    if (!stream && ending == "stl")
    {
      stream = vtkMTStlStream::Open(path, settings, names);
    }
    if (!stream && ending == "obj")
    {
      stream = vtkMTObjStream::Open(path, settings, names);
    }
    if (!stream && ending == "vtp")
    {
      stream = vtkMTVtpStream::Open(path, settings, names);
    }
    return stream;
  }
  catch (const std::exception&) // the reader of whole files meets it again and says so
  {
    return nullptr;
  }
}

std::unique_ptr<vtkMTTriangleStream> vtkMTMeshStream::OpenAll(const std::vector<std::string>& paths,
  const Settings& settings, const std::vector<vtkSmartPointer<vtkPolyData>>& names, std::vector<std::uint64_t>& cells)
{
  std::vector<std::unique_ptr<vtkMTChunkStream>> parts;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    std::unique_ptr<vtkMTTriangleStream> stream = Open(paths[i], settings, names[i]);
    if (!dynamic_cast<vtkMTChunkStream*>(stream.get()))
    {
      return nullptr;
    }
    parts.emplace_back(static_cast<vtkMTChunkStream*>(stream.release()));
    cells.push_back(parts.back()->GetNumberOfCells());
  }
  return parts.empty() ? nullptr : vtkMTMergedStream::Make(std::move(parts));
}
