// SPDX-License-Identifier: BSD-3-Clause
// Walks over the blocks of a triangle stream. Not installed.
#ifndef vtkMTStreamWalk_h
#define vtkMTStreamWalk_h

#include "vtkMTTriangleStream.h"

#include <string>

namespace vtkMTStreamWalk
{
/// Calls use with every block of points that is left; use gives false, and sets error, to stop.
template <typename Use>
bool ForEachPointBlock(vtkMTTriangleStream& mesh, std::string& error, Use&& use)
{
  vtkMTTriangleStream::PointBlock block;
  while (mesh.NextPoints(block))
  {
    if (block.Points.empty())
    {
      return true;
    }
    if (!use(block))
    {
      return false;
    }
  }
  error = mesh.GetError();
  return false;
}

template <typename Use>
bool ForEachTriangleBlock(vtkMTTriangleStream& mesh, std::string& error, Use&& use)
{
  vtkMTTriangleStream::TriangleBlock block;
  while (mesh.NextTriangles(block))
  {
    if (block.Triangles.empty())
    {
      return true;
    }
    if (!use(block))
    {
      return false;
    }
  }
  error = mesh.GetError();
  return false;
}

inline bool Rewind(vtkMTTriangleStream& mesh, std::string& error)
{
  const bool done = mesh.Rewind();
  error = done ? error : mesh.GetError();
  return done;
}
}

#endif
