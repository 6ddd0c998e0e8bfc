// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStreamOutput.h"

#include "Interpreter/vtkMTLongWork.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkMTCompatibility.h"
#include "vtkMTTriangleStream.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>

namespace
{
class Filling
{
public:
  Filling(vtkMTTriangleStream& stream, vtkAlgorithm* algorithm)
    : Stream(stream)
    , Algorithm(algorithm)
    , All(static_cast<double>(stream.GetNumberOfPoints() + stream.GetNumberOfTriangles()))
  {
  }

  bool AddPoints(vtkPoints* points)
  {
    vtkMTTriangleStream::PointBlock block;
    vtkIdType next = 0;
    points->SetDataType(VTK_FLOAT);
    points->SetNumberOfPoints(static_cast<vtkIdType>(this->Stream.GetNumberOfPoints()));
    while (this->Stream.NextPoints(block))
    {
      if (block.Points.empty())
      {
        return true;
      }
      for (const std::array<double, 3>& point : block.Points)
      {
        points->SetPoint(next++, point.data());
      }
      if (!this->Advance(block.Points.size()))
      {
        return false;
      }
    }
    return false;
  }

  bool AddTriangles(vtkCellArray* triangles)
  {
    vtkMTTriangleStream::TriangleBlock block;
    const auto count = static_cast<vtkIdType>(this->Stream.GetNumberOfTriangles());
    if (!triangles->AllocateExact(count, 3 * count))
    {
      throw std::bad_alloc();
    }
    while (this->Stream.NextTriangles(block))
    {
      if (block.Triangles.empty())
      {
        return true;
      }
      for (const std::array<std::uint64_t, 3>& triangle : block.Triangles)
      {
        triangles->InsertNextCell({ static_cast<vtkIdType>(triangle[0]), static_cast<vtkIdType>(triangle[1]),
          static_cast<vtkIdType>(triangle[2]) });
      }
      if (!this->Advance(block.Triangles.size()))
      {
        return false;
      }
    }
    return false;
  }

private:
  bool Advance(std::size_t count)
  {
    this->Done += static_cast<double>(count);
    this->Algorithm->UpdateProgress(this->Done / this->All);
    return !vtkMTIsAborted(this->Algorithm);
  }

  vtkMTTriangleStream& Stream;
  vtkAlgorithm* Algorithm;
  const double All;
  double Done = 0.0;
};
}

bool vtkMTStreamOutput::Fill(
  vtkMTTriangleStream& stream, vtkAlgorithm* algorithm, vtkPolyData* output, std::string& error)
{
  const vtkMTLongWork work;
  output->Initialize();
  try
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> triangles;
    Filling filling(stream, algorithm);
    if (stream.Rewind() && filling.AddPoints(points) && filling.AddTriangles(triangles))
    {
      output->SetPoints(points);
      output->SetPolys(triangles);
      return true;
    }
    error = stream.GetError();
  }
  catch (const std::exception& e)
  {
    error = std::string("out of memory or an internal fault: ") + e.what();
  }
  return false;
}
