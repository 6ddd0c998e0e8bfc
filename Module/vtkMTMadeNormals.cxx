// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMadeNormals.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr std::size_t BlockSize = 64;
constexpr char BitsProperty[] = "normal_bits";
constexpr double Unit = 1048576.0; // of terms

// Loops over blocks have no branches, so that several triangles or directions are computed at once.
struct Triangles
{
  double X[3][3][BlockSize]; // corners and coordinates
  std::int32_t Terms[3][3][BlockSize];
};

// The angle whose tangent is y / x, in (0, pi), for y > 0. Abramowitz and Stegun 4.4.49 would do with more terms; these
// coefficients are those of the least largest error on [0, 1], 8e-5.
inline float GetAngle(float y, float x)
{
  constexpr float pi = 3.14159274f;
  const float a = std::abs(x);
  const float t = std::min(a, y) / std::max(std::max(a, y), 1.0f);
  const float s = t * t;
  const float p = t * (0.99921406f + s * (-0.32118190f + s * (0.14627620f - s * 0.03899290f)));
  const float q = a < y ? 0.5f * pi - p : p;
  return x < 0.0f ? pi - q : q;
}

// Of corner c with the weight that belongs to it, as floats.
struct Terms
{
  float Normal[3];
  float Weights[3];
};

inline Terms GetFactors(const double (&a)[3], const double (&b)[3], const double (&c)[3])
{
  const double u[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const double v[3] = { c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const double w[3] = { c[0] - b[0], c[1] - b[1], c[2] - b[2] };
  const double n[3] = { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  const double inverse = length > 0.0 ? 1.0 / length : 0.0;
  const double atA = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const double atB = -(u[0] * w[0] + u[1] * w[1] + u[2] * w[2]);
  const double atC = v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
  const auto twiceArea = static_cast<float>(length);
  constexpr auto unit = static_cast<float>(Unit);
  Terms terms;
  for (int i = 0; i < 3; ++i)
  {
    terms.Normal[i] = static_cast<float>(n[i] * inverse);
  }
  terms.Weights[0] = unit * GetAngle(twiceArea, static_cast<float>(atA));
  terms.Weights[1] = unit * GetAngle(twiceArea, static_cast<float>(atB));
  terms.Weights[2] = unit * GetAngle(twiceArea, static_cast<float>(atC));
  return terms;
}

void ComputeTerms(Triangles& block, std::size_t count)
{
  for (std::size_t t = 0; t < count; ++t)
  {
    const auto& x = block.X;
    const Terms terms = GetFactors({ x[0][0][t], x[0][1][t], x[0][2][t] }, { x[1][0][t], x[1][1][t], x[1][2][t] },
      { x[2][0][t], x[2][1][t], x[2][2][t] });
    for (int c = 0; c < 3; ++c)
    {
      for (int i = 0; i < 3; ++i)
      {
        block.Terms[c][i][t] = static_cast<std::int32_t>(terms.Normal[i] * terms.Weights[c]);
      }
    }
  }
}

double GetHalf(int bits)
{
  return static_cast<double>((1 << (bits - 1)) - 1);
}

// To the nearest whole number, halves to the even one; |x| < 2^51.
inline double Round(double x)
{
  constexpr double magic = 6755399441055744.0; // 1.5 * 2^52
  return (x + magic) - magic;
}

// x, y and z are not all zero, or the place is the middle.
inline void PutPlace(double x, double y, double z, double half, std::uint16_t& u, std::uint16_t& v)
{
  const double length = std::abs(x) + std::abs(y) + std::abs(z);
  const double scale = length > 0.0 ? half / length : 0.0;
  const double p = x * scale;
  const double q = y * scale;
  const double foldedP = p < 0.0 ? std::abs(q) - half : half - std::abs(q);
  const double foldedQ = q < 0.0 ? std::abs(p) - half : half - std::abs(p);
  const double a = Round(z < 0.0 ? foldedP : p);
  const double b = Round(z < 0.0 ? foldedQ : q);
  u = static_cast<std::uint16_t>(static_cast<std::int32_t>((std::abs(b) == half ? std::abs(a) : a) + half));
  v = static_cast<std::uint16_t>(static_cast<std::int32_t>((std::abs(a) == half ? std::abs(b) : b) + half));
}
}

int vtkMTMadeNormals::GetBits(const vtkMTArrayInfo& array)
{
  const auto found = array.Properties.find(BitsProperty);
  int bits = 0;
  for (const char digit : found == array.Properties.end() ? std::string() : found->second)
  {
    bits = digit >= '0' && digit <= '9' && bits < MaximumBits ? 10 * bits + (digit - '0') : MaximumBits + 1;
  }
  return bits < MinimumBits || bits > MaximumBits ? DefaultBits : bits;
}

void vtkMTMadeNormals::SetBits(int bits, vtkMTArrayInfo& array)
{
  array.Properties[BitsProperty] = std::to_string(bits);
}

bool vtkMTMadeNormals::AreIn(const vtkMTArrayInfo& array)
{
  return array.Role == vtkMTArrayInfo::MadeNormals && array.GetTupleSize() == 3 * sizeof(float) &&
    array.Association == vtkMTArrayInfo::Point;
}

double vtkMTMadeNormals::GetRounding(int bits)
{
  // Half a place each way, where the net is stretched most: measured 2.1e-3 of 1 / N.
  return 2.15 / GetHalf(bits);
}

bool vtkMTMadeNormals::GetTerms(
  const std::array<const vtkMTPoint*, 3>& corners, std::array<std::array<double, 3>, 3>& terms)
{
  double x[3][3];
  for (int c = 0; c < 3; ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      x[c][i] = static_cast<double>((*corners[c])[i]);
    }
  }
  const Terms factors = GetFactors(x[0], x[1], x[2]);
  for (int c = 0; c < 3; ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      terms[c][i] = static_cast<double>(factors.Normal[i] * factors.Weights[c]);
    }
  }
  return factors.Normal[0] != 0.0f || factors.Normal[1] != 0.0f || factors.Normal[2] != 0.0f;
}

void vtkMTMadeNormals::GetSums(const vtkMTPatch& mesh, bool ofPoints, std::vector<Sum>& sums)
{
  sums.assign(ofPoints ? mesh.Points.size() : mesh.GetNumberOfWedges(), Sum{ 0, 0, 0 });
  const std::uint32_t* const pointOf = mesh.WedgePoints.empty() ? nullptr : mesh.WedgePoints.data();
  Triangles block;
  for (std::size_t begin = 0; begin < mesh.Triangles.size(); begin += BlockSize)
  {
    const std::size_t count = std::min(BlockSize, mesh.Triangles.size() - begin);
    for (std::size_t t = 0; t < count; ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::uint32_t wedge = mesh.Triangles[begin + t][c];
        const vtkMTPoint& point = mesh.Points[pointOf ? pointOf[wedge] : wedge];
        block.X[c][0][t] = static_cast<double>(point[0]);
        block.X[c][1][t] = static_cast<double>(point[1]);
        block.X[c][2][t] = static_cast<double>(point[2]);
      }
    }
    ComputeTerms(block, count);
    for (std::size_t t = 0; t < count; ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::uint32_t wedge = mesh.Triangles[begin + t][c];
        Sum& sum = sums[ofPoints && pointOf ? pointOf[wedge] : wedge];
        sum[0] += block.Terms[c][0][t];
        sum[1] += block.Terms[c][1][t];
        sum[2] += block.Terms[c][2][t];
      }
    }
  }
}

vtkMTMadeNormals::Place vtkMTMadeNormals::GetPlace(const Sum& sum, int bits)
{
  Place place;
  GetPlaces(&sum, 1, bits, &place[0], &place[1]);
  return place;
}

vtkMTMadeNormals::Place vtkMTMadeNormals::GetPlace(const std::array<float, 3>& normal, int bits)
{
  const double x = normal[0];
  const double y = normal[1];
  const double z = normal[2];
  const double length = std::abs(x) + std::abs(y) + std::abs(z);
  Place place;
  place[0] = place[1] = static_cast<std::uint16_t>((1 << bits) - 1);
  if (length > 0.0 && std::isfinite(length))
  {
    PutPlace(x, y, z, GetHalf(bits), place[0], place[1]);
  }
  return place;
}

void vtkMTMadeNormals::GetPlaces(const Sum* sums, std::size_t count, int bits, std::uint16_t* u, std::uint16_t* v)
{
  const double half = GetHalf(bits);
  double x[3][BlockSize];
  for (std::size_t begin = 0; begin < count; begin += BlockSize)
  {
    const std::size_t size = std::min(BlockSize, count - begin);
    for (std::size_t i = 0; i < size; ++i)
    {
      x[0][i] = static_cast<double>(sums[begin + i][0]);
      x[1][i] = static_cast<double>(sums[begin + i][1]);
      x[2][i] = static_cast<double>(sums[begin + i][2]);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      PutPlace(x[0][i], x[1][i], x[2][i], half, u[begin + i], v[begin + i]);
    }
  }
}

std::array<float, 3> vtkMTMadeNormals::GetNormal(const Place& place, int bits)
{
  std::array<float, 3> normal;
  GetNormals(place.data(), place.data() + 1, 1, bits, nullptr, reinterpret_cast<unsigned char*>(normal.data()));
  return normal;
}

void vtkMTMadeNormals::GetNormals(const std::uint16_t* u, const std::uint16_t* v, std::size_t count, int bits,
  const std::uint32_t* places, unsigned char* normals)
{
  const auto half = static_cast<float>(GetHalf(bits));
  const int none = (1 << bits) - 1;
  float xs[BlockSize];
  float ys[BlockSize];
  float zs[BlockSize];
  for (std::size_t begin = 0; begin < count; begin += BlockSize)
  {
    const std::size_t size = std::min(BlockSize, count - begin);
    for (std::size_t i = 0; i < size; ++i)
    {
      const float isSome = std::max(u[begin + i], v[begin + i]) < none ? 1.0f : 0.0f;
      const float x = (static_cast<float>(u[begin + i]) - half) / half;
      const float y = (static_cast<float>(v[begin + i]) - half) / half;
      const float z = 1.0f - std::abs(x) - std::abs(y);
      const float unfoldedX = std::copysign(1.0f - std::abs(y), x);
      const float unfoldedY = std::copysign(1.0f - std::abs(x), y);
      const float a = z < 0.0f ? unfoldedX : x;
      const float b = z < 0.0f ? unfoldedY : y;
      const float length = std::sqrt(a * a + b * b + z * z);
      xs[i] = isSome * (a / length);
      ys[i] = isSome * (b / length);
      zs[i] = isSome * (z / length);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      const float normal[3] = { xs[i], ys[i], zs[i] };
      const std::size_t at = places ? places[begin + i] : begin + i;
      std::memcpy(normals + at * sizeof(normal), normal, sizeof(normal));
    }
  }
}
