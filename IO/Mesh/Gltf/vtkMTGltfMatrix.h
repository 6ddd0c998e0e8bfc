// SPDX-License-Identifier: BSD-3-Clause
// An affine transform of the nodes of a glTF scene: the first three rows of its matrix. Not installed.
//
// Normals go by the matrix of cofactors with the sign of the determinant, which is the inverse transpose but for a
// positive factor, and exists for matrices without an inverse.
#ifndef vtkMTGltfMatrix_h
#define vtkMTGltfMatrix_h

#include <array>
#include <cmath>

struct vtkMTGltfMatrix
{
  std::array<std::array<double, 4>, 3> Rows{ { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 },
    { 0.0, 0.0, 1.0, 0.0 } } };

  /// Of a quaternion x, y, z, w of any length; of length 0 it turns nothing.
  static vtkMTGltfMatrix FromParts(const double translation[3], const double rotation[4], const double scale[3])
  {
    const double length = std::sqrt(
      rotation[0] * rotation[0] + rotation[1] * rotation[1] + rotation[2] * rotation[2] + rotation[3] * rotation[3]);
    const double s = length > 0.0 ? 1.0 / length : 0.0;
    const double x = rotation[0] * s, y = rotation[1] * s, z = rotation[2] * s,
                 w = length > 0.0 ? rotation[3] * s : 1.0;
    const double turn[3][3] = { { 1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y) },
      { 2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x) },
      { 2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y) } };
    vtkMTGltfMatrix matrix;
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        matrix.Rows[i][j] = turn[i][j] * scale[j];
      }
      matrix.Rows[i][3] = translation[i];
    }
    return matrix;
  }

  /// First other, then this.
  vtkMTGltfMatrix operator*(const vtkMTGltfMatrix& other) const
  {
    vtkMTGltfMatrix product;
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 4; ++j)
      {
        product.Rows[i][j] = this->Rows[i][0] * other.Rows[0][j] + this->Rows[i][1] * other.Rows[1][j] +
          this->Rows[i][2] * other.Rows[2][j] + (j == 3 ? this->Rows[i][3] : 0.0);
      }
    }
    return product;
  }

  bool IsIdentity() const { return this->Rows == vtkMTGltfMatrix().Rows; }

  double GetCofactor(std::size_t i, std::size_t j) const
  {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return this->Rows[a][c] * this->Rows[b][d] - this->Rows[a][d] * this->Rows[b][c];
  }

  double GetDeterminant() const
  {
    return this->Rows[0][0] * this->GetCofactor(0, 0) + this->Rows[0][1] * this->GetCofactor(0, 1) +
      this->Rows[0][2] * this->GetCofactor(0, 2);
  }

  void TransformPoint(const double from[3], double to[3]) const
  {
    this->TransformDirection(from, to);
    for (std::size_t i = 0; i < 3; ++i)
    {
      to[i] += this->Rows[i][3];
    }
  }

  void TransformDirection(const double from[3], double to[3]) const
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      to[i] = this->Rows[i][0] * from[0] + this->Rows[i][1] * from[1] + this->Rows[i][2] * from[2];
    }
  }

  /// The matrix that normals go by.
  vtkMTGltfMatrix GetNormalMatrix() const
  {
    const double sign = this->GetDeterminant() < 0.0 ? -1.0 : 1.0;
    vtkMTGltfMatrix matrix;
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        matrix.Rows[i][j] = sign * this->GetCofactor(i, j);
      }
    }
    return matrix;
  }
};

#endif
