// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMadeNormals.h"

#include "Processor/vtkMTWideProcessors.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
constexpr std::size_t BlockSize = 64;
constexpr char BitsProperty[] = "normal_bits";
constexpr float Unit = 131072.0f; // of terms
// So many triangles' terms at a point are a sum of 32 bits: each is less than 2^17 (pi + 0.001).
constexpr std::size_t MostOf32Bits = 5000;

// Loops over blocks have no branches, so that several triangles or directions are computed at once.
struct Triangles
{
  std::int32_t X[3][3][BlockSize]; // corners and coordinates
  float Normal[3][BlockSize];
  float Weights[3][BlockSize]; // of the normal at the corners
};

// Whatever of this size is added to is not zero, and what is not zero stays as it is.
constexpr float Nothing = 0x1p-100f;

// The angle whose tangent is y / x, in (0, pi), for y >= 0: a quarter of pi off the arc tangent of (|x| - y) / (|x| +
// y). That is a polynomial with the least largest error, 2e-5, among those that are right in value and slope at 1,
// which is an angle of 0.
inline float GetAngle(float y, float x)
{
  constexpr float quarter = 0.785398185f;
  const float a = std::abs(x);
  const float r = (a - y) / ((a + y) + Nothing);
  const float s = r * r;
  const float p =
    r * (0.999793112f + s * (-0.329162508f + s * (0.175562292f + s * (-0.0785178393f + s * 0.0177230909f))));
  return 2.0f * quarter - std::copysign(quarter + p, x + 0.0f); // which -0 is not
}

MT_FOR_WIDE_PROCESSORS void ComputeFactors(Triangles& block, std::size_t count)
{
  constexpr double scale = 0x1p-32; // so that squares of floats are in their range
  for (std::size_t t = 0; t < count; ++t)
  {
    double a[3];
    double u[3];
    double v[3];
    double w[3];
    for (int i = 0; i < 3; ++i)
    {
      a[i] = static_cast<double>(block.X[0][i][t]);
      u[i] = static_cast<double>(block.X[1][i][t]) - a[i];
      v[i] = static_cast<double>(block.X[2][i][t]) - a[i];
      w[i] = v[i] - u[i];
    }
    const auto n0 = static_cast<float>((u[1] * v[2] - u[2] * v[1]) * scale);
    const auto n1 = static_cast<float>((u[2] * v[0] - u[0] * v[2]) * scale);
    const auto n2 = static_cast<float>((u[0] * v[1] - u[1] * v[0]) * scale);
    const auto atA = static_cast<float>((u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) * scale);
    const auto atB = -static_cast<float>((u[0] * w[0] + u[1] * w[1] + u[2] * w[2]) * scale);
    const auto atC = static_cast<float>((v[0] * w[0] + v[1] * w[1] + v[2] * w[2]) * scale);
    const float length = std::sqrt(n0 * n0 + n1 * n1 + n2 * n2);
    const float inverse = 1.0f / (length + Nothing);
    block.Normal[0][t] = n0 * inverse;
    block.Normal[1][t] = n1 * inverse;
    block.Normal[2][t] = n2 * inverse;
    block.Weights[0][t] = Unit * GetAngle(length, atA);
    block.Weights[1][t] = Unit * GetAngle(length, atB);
    block.Weights[2][t] = Unit * GetAngle(length, atC);
  }
}

// Four numbers, of which the last one is not used, so that a processor adds them at once.
using Floats = float __attribute__((vector_size(16)));
using Terms32 = std::int32_t __attribute__((vector_size(16)));
using Terms64 = std::int64_t __attribute__((vector_size(32)));

// Calls use with the triangle's corner and what it adds there, one after the other.
template <class Terms, class Use>
void ForAllTerms(const vtkMTPatch& mesh, const std::uint32_t* pointOf, Use&& use)
{
  Triangles block;
  const auto* const points = mesh.Points.data();
  for (std::size_t begin = 0; begin < mesh.Triangles.size(); begin += BlockSize)
  {
    const std::size_t count = std::min(BlockSize, mesh.Triangles.size() - begin);
    const vtkMTTriangle* const triangles = mesh.Triangles.data() + begin;
    for (std::size_t t = 0; t < count; ++t)
    {
      for (int c = 0; c < 3; ++c)
      {
        const std::uint32_t wedge = triangles[t][c];
        const vtkMTPoint& point = points[pointOf ? pointOf[wedge] : wedge];
        block.X[c][0][t] = point[0];
        block.X[c][1][t] = point[1];
        block.X[c][2][t] = point[2];
      }
    }
    ComputeFactors(block, count);
    for (std::size_t t = 0; t < count; ++t)
    {
      const Floats normal{ block.Normal[0][t], block.Normal[1][t], block.Normal[2][t], 0.0f };
      for (int c = 0; c < 3; ++c)
      {
        use(triangles[t][c], __builtin_convertvector(normal * block.Weights[c][t], Terms));
      }
    }
  }
}

template <class Terms>
void AddAll(const vtkMTPatch& mesh, bool ofPoints, std::vector<Terms>& sums)
{
  sums.assign(ofPoints ? mesh.Points.size() : mesh.GetNumberOfWedges(), Terms{ 0, 0, 0, 0 });
  const std::uint32_t* const pointOf = mesh.WedgePoints.empty() ? nullptr : mesh.WedgePoints.data();
  Terms* const all = sums.data();
  if (ofPoints && pointOf)
  {
    ForAllTerms<Terms>(mesh, pointOf, [=](std::uint32_t wedge, const Terms& terms) { all[pointOf[wedge]] += terms; });
  }
  else
  {
    ForAllTerms<Terms>(mesh, pointOf, [=](std::uint32_t wedge, const Terms& terms) { all[wedge] += terms; });
  }
}

double GetHalf(int bits)
{
  return static_cast<double>((1 << (bits - 1)) - 1);
}

// To the nearest whole number, halves to the even one; |x| < 2^21.
inline float Round(float x)
{
  constexpr float magic = 12582912.0f; // 1.5 * 2^23
  return (x + magic) - magic;
}

// The middle where x, y and z are zero.
inline void PutPlace(float x, float y, float z, float half, std::uint16_t& u, std::uint16_t& v)
{
  const float scale = half / (std::abs(x) + std::abs(y) + std::abs(z) + Nothing);
  const float p = x * scale + 0.0f; // which -0 is not
  const float q = y * scale + 0.0f;
  const float foldedP = std::copysign(half - std::abs(q), p);
  const float foldedQ = std::copysign(half - std::abs(p), q);
  const float a = Round(z < 0.0f ? foldedP : p);
  const float b = Round(z < 0.0f ? foldedQ : q);
  u = static_cast<std::uint16_t>(static_cast<std::int32_t>((std::abs(b) == half ? std::abs(a) : a) + half));
  v = static_cast<std::uint16_t>(static_cast<std::int32_t>((std::abs(a) == half ? std::abs(b) : b) + half));
}

template <class Terms>
void PutPlaces(const Terms* sums, std::size_t count, int bits, std::uint16_t* u, std::uint16_t* v)
{
  const auto half = static_cast<float>(GetHalf(bits));
  float x[3][BlockSize];
  for (std::size_t begin = 0; begin < count; begin += BlockSize)
  {
    const std::size_t size = std::min(BlockSize, count - begin);
    for (std::size_t i = 0; i < size; ++i)
    {
      x[0][i] = static_cast<float>(sums[begin + i][0]);
      x[1][i] = static_cast<float>(sums[begin + i][1]);
      x[2][i] = static_cast<float>(sums[begin + i][2]);
    }
    for (std::size_t i = 0; i < size; ++i)
    {
      PutPlace(x[0][i], x[1][i], x[2][i], half, u[begin + i], v[begin + i]);
    }
  }
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
  // Half a place each way in the middle of a side, where the net is stretched most: sqrt(6) / 2 sqrt(3), and a little
  // for single precision.
  return 2.15 / GetHalf(bits);
}

bool vtkMTMadeNormals::GetTerms(
  const std::array<const vtkMTPoint*, 3>& corners, std::array<std::array<double, 3>, 3>& terms)
{
  Triangles block;
  for (int c = 0; c < 3; ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      block.X[c][i][0] = (*corners[c])[i];
    }
  }
  ComputeFactors(block, 1);
  bool isSome = false;
  for (int i = 0; i < 3; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      terms[c][i] = static_cast<double>(block.Normal[i][0] * block.Weights[c][0]);
    }
    isSome = isSome || block.Normal[i][0] != 0.0f;
  }
  return isSome;
}

void vtkMTMadeNormals::GetSums(const vtkMTPatch& mesh, bool ofPoints, std::vector<Sum>& sums)
{
  std::vector<Terms64> all;
  AddAll(mesh, ofPoints, all);
  sums.resize(all.size());
  std::transform(all.begin(), all.end(), sums.begin(),
    [](const Terms64& sum) {
      return Sum{ sum[0], sum[1], sum[2] };
    });
}

void vtkMTMadeNormals::GetPlaces(
  const vtkMTPatch& mesh, bool ofPoints, int bits, std::vector<std::uint16_t>& u, std::vector<std::uint16_t>& v)
{
  const auto put = [&](auto sums)
  {
    AddAll(mesh, ofPoints, sums);
    u.resize(sums.size());
    v.resize(sums.size());
    PutPlaces(sums.data(), sums.size(), bits, u.data(), v.data());
  };
  if (mesh.Triangles.size() <= MostOf32Bits)
  {
    put(std::vector<Terms32>());
  }
  else
  {
    put(std::vector<Terms64>());
  }
}

vtkMTMadeNormals::Place vtkMTMadeNormals::GetPlace(const Sum& sum, int bits)
{
  Place place;
  PutPlaces(&sum, 1, bits, &place[0], &place[1]);
  return place;
}

vtkMTMadeNormals::Place vtkMTMadeNormals::GetPlace(const std::array<float, 3>& normal, int bits)
{
  const float length = std::abs(normal[0]) + std::abs(normal[1]) + std::abs(normal[2]);
  Place place;
  place[0] = place[1] = static_cast<std::uint16_t>((1 << bits) - 1);
  if (length > 0.0f && std::isfinite(length))
  {
    PutPlace(normal[0], normal[1], normal[2], static_cast<float>(GetHalf(bits)), place[0], place[1]);
  }
  return place;
}

std::array<float, 3> vtkMTMadeNormals::GetNormal(const Place& place, int bits)
{
  std::array<float, 3> normal;
  GetNormals(place.data(), place.data() + 1, 1, bits, nullptr, reinterpret_cast<unsigned char*>(normal.data()));
  return normal;
}

MT_FOR_WIDE_PROCESSORS void vtkMTMadeNormals::GetNormals(const std::uint16_t* u, const std::uint16_t* v,
  std::size_t count, int bits, const std::uint32_t* places, unsigned char* normals)
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
