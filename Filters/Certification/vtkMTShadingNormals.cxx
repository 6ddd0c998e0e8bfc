// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTShadingNormals.h"

#include "vtkMTVector.h"

#include "vtkDataSetAttributes.h"
#include "vtkSetGet.h"

#include <cstring>

using namespace vtkMTVector;

namespace
{
template <class Value>
void Copy(const vtkMTColumn& column, const vtkMTPatch& mesh, bool ofPoints, std::vector<std::array<float, 3>>& normals)
{
  std::array<Value, 3> value;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::size_t tuple = ofPoints ? mesh.Triangles[t][c] : t;
      std::memcpy(value.data(), column.data() + tuple * sizeof(value), sizeof(value));
      normals[3 * t + c] = { static_cast<float>(value[0]), static_cast<float>(value[1]), static_cast<float>(value[2]) };
    }
  }
}
}

vtkMTShadingNormals::vtkMTShadingNormals(const std::vector<vtkMTArrayInfo>& arrays)
{
  for (const auto association : { vtkMTArrayInfo::Point, vtkMTArrayInfo::Cell })
  {
    std::size_t column = 0;
    for (const vtkMTArrayInfo& array : arrays)
    {
      if (array.Association != association)
      {
        continue;
      }
      if (!this->HasArray && array.Attribute == vtkDataSetAttributes::NORMALS && array.Components == 3)
      {
        this->HasArray = true;
        this->Array = array;
        this->Column = column;
      }
      ++column;
    }
  }
}

std::vector<std::array<float, 3>> vtkMTShadingNormals::Get(const vtkMTPatch& mesh) const
{
  std::vector<std::array<float, 3>> normals(3 * mesh.Triangles.size());
  if (!this->HasArray)
  {
    vtkMTShadingNormals::GetOfTriangles(mesh, normals);
    return normals;
  }
  const bool ofPoints = this->Array.Association == vtkMTArrayInfo::Point;
  const vtkMTColumn& column = ofPoints ? mesh.PointColumns[this->Column] : mesh.CellColumns[this->Column];
  switch (this->Array.Type)
  {
    vtkTemplateMacro(Copy<VTK_TT>(column, mesh, ofPoints, normals));
  }
  return normals;
}

void vtkMTShadingNormals::GetOfTriangles(const vtkMTPatch& mesh, std::vector<std::array<float, 3>>& normals)
{
  const auto place = [&mesh](std::uint32_t p) -> Vector
  {
    const vtkMTPoint& x = mesh.Points[p];
    return { static_cast<double>(x[0]), static_cast<double>(x[1]), static_cast<double>(x[2]) };
  };
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    const Vector a = place(p[0]);
    const Vector normal = Cross(Subtract(place(p[1]), a), Subtract(place(p[2]), a));
    const double length = Norm(normal);
    const double scale = length > 0.0 ? 1.0 / length : 0.0;
    normals[3 * t] = { static_cast<float>(normal[0] * scale), static_cast<float>(normal[1] * scale),
      static_cast<float>(normal[2] * scale) };
    normals[3 * t + 1] = normals[3 * t + 2] = normals[3 * t];
  }
}
