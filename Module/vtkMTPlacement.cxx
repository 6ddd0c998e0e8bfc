// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlacement.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkMTView.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>

namespace
{
//------------------------------------------------------------------------------
// Of the linear part with columns of length 1: 0 where the map has no inverse, whatever its scale.
double GetDeterminant(const std::array<double, 16>& m)
{
  double a[3][3];
  for (int j = 0; j < 3; ++j)
  {
    const double largest = std::max({ std::abs(m[j]), std::abs(m[4 + j]), std::abs(m[8 + j]) });
    if (!(largest > 0.0))
    {
      return 0.0;
    }
    const double x[3] = { m[j] / largest, m[4 + j] / largest, m[8 + j] / largest };
    const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (int i = 0; i < 3; ++i)
    {
      a[i][j] = x[i] / length;
    }
  }
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) - a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
    a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

//------------------------------------------------------------------------------
// By the transposed inverse, whose scale does not matter; a normal of length 0 stays as it is.
void TurnNormals(const vtkMTPlacement& inverse, vtkPolyData* mesh)
{
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  if (!normals || normals->GetNumberOfComponents() != 3)
  {
    return;
  }
  vtkSmartPointer<vtkDataArray> turned;
  turned.TakeReference(normals->NewInstance());
  turned->DeepCopy(normals);
  double largest = 0.0;
  for (int i = 0; i < 12; ++i)
  {
    largest = i % 4 == 3 ? largest : std::max(largest, std::abs(inverse.Matrix[i]));
  }
  for (vtkIdType p = 0; p < normals->GetNumberOfTuples(); ++p)
  {
    double n[3];
    double result[3] = { 0.0, 0.0, 0.0 };
    normals->GetTuple(p, n);
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        result[i] += inverse.Matrix[4 * j + i] / largest * n[j];
      }
    }
    const double length = std::sqrt(result[0] * result[0] + result[1] * result[1] + result[2] * result[2]);
    if (length > 0.0)
    {
      std::transform(result, result + 3, result, [length](double x) { return x / length; });
      turned->SetTuple(p, result);
    }
  }
  mesh->GetPointData()->SetNormals(turned);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> TurnCells(vtkCellArray* cells)
{
  auto turned = vtkSmartPointer<vtkCellArray>::New();
  turned->AllocateExact(cells->GetNumberOfCells(), cells->GetNumberOfConnectivityIds());
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < cells->GetNumberOfCells(); ++c)
  {
    cells->GetCellAtId(c, corners);
    std::reverse(corners->begin() + std::min<vtkIdType>(corners->GetNumberOfIds(), 1), corners->end());
    turned->InsertNextCell(corners);
  }
  return turned;
}
}

//------------------------------------------------------------------------------
bool vtkMTPlacement::IsSound(const double matrix[16])
{
  constexpr double flat = 1e-12;
  const bool finite = std::all_of(matrix, matrix + 16, [](double x) { return std::isfinite(x); });
  const bool affine = matrix[12] == 0.0 && matrix[13] == 0.0 && matrix[14] == 0.0 && matrix[15] == 1.0;
  std::array<double, 16> copy;
  std::copy(matrix, matrix + 16, copy.begin());
  return finite && affine && std::abs(GetDeterminant(copy)) > flat;
}

//------------------------------------------------------------------------------
bool vtkMTPlacement::IsIdentity() const
{
  return this->Matrix == vtkMTPlacement().Matrix;
}

//------------------------------------------------------------------------------
bool vtkMTPlacement::IsMirrored() const
{
  return GetDeterminant(this->Matrix) < 0.0;
}

//------------------------------------------------------------------------------
double vtkMTPlacement::GetStretch() const
{
  if (this->IsIdentity())
  {
    return 1.0;
  }
  vtkMTView view;
  view.ModelToEye = this->Matrix;
  view.UpdateStretch();
  return view.Stretch;
}

//------------------------------------------------------------------------------
vtkMTPlacement vtkMTPlacement::GetInverse() const
{
  // Columns of a length near 1 keep the determinant within the range of doubles: A = B S, so 1/A = 1/S 1/B.
  std::array<double, 16> scaled = this->Matrix;
  std::array<double, 3> scale;
  for (int j = 0; j < 3; ++j)
  {
    scale[j] = std::max({ std::abs(scaled[j]), std::abs(scaled[4 + j]), std::abs(scaled[8 + j]) });
    for (int i = 0; i < 3; ++i)
    {
      scaled[4 * i + j] /= scale[j];
    }
  }
  vtkMTPlacement inverse;
  vtkMatrix4x4::Invert(scaled.data(), inverse.Matrix.data());
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      inverse.Matrix[4 * i + j] /= scale[i];
    }
  }
  return inverse;
}

//------------------------------------------------------------------------------
void vtkMTPlacement::Append(const double matrix[16])
{
  std::array<double, 16> product;
  vtkMatrix4x4::Multiply4x4(matrix, this->Matrix.data(), product.data());
  this->Matrix = product;
}

//------------------------------------------------------------------------------
std::array<double, 3> vtkMTPlacement::ToObject(const std::array<double, 3>& x) const
{
  const std::array<double, 16>& m = this->Matrix;
  return { m[0] * x[0] + m[1] * x[1] + m[2] * x[2] + m[3], m[4] * x[0] + m[5] * x[1] + m[6] * x[2] + m[7],
    m[8] * x[0] + m[9] * x[1] + m[10] * x[2] + m[11] };
}

//------------------------------------------------------------------------------
void vtkMTPlacement::ToObject(const double box[6], double bounds[6]) const
{
  if (this->IsIdentity() || box[0] > box[1])
  {
    std::copy(box, box + 6, bounds);
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    double least = this->Matrix[4 * i + 3];
    double largest = least;
    for (int j = 0; j < 3; ++j)
    {
      const double a = this->Matrix[4 * i + j] * box[2 * j];
      const double b = this->Matrix[4 * i + j] * box[2 * j + 1];
      least += std::min(a, b);
      largest += std::max(a, b);
    }
    bounds[2 * i] = least;
    bounds[2 * i + 1] = largest;
  }
}

//------------------------------------------------------------------------------
void vtkMTPlacement::Apply(vtkPolyData* mesh) const
{
  if (this->IsIdentity())
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> x;
    mesh->GetPoint(p, x.data());
    points->SetPoint(p, this->ToObject(x).data());
  }
  mesh->SetPoints(points);
  TurnNormals(this->GetInverse(), mesh);
  if (this->IsMirrored())
  {
    mesh->SetPolys(TurnCells(mesh->GetPolys()));
  }
}
