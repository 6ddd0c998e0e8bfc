// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPerlinNoise.h"

#include <cmath>
#include <random>
#include <utility>

namespace
{
constexpr std::uint8_t PaperPermutation[256] = { 151, 160, 137, 91, 90, 15, 131, 13, 201, 95, 96, 53, 194, 233, 7, 225,
  140, 36, 103, 30, 69, 142, 8, 99, 37, 240, 21, 10, 23, 190, 6, 148, 247, 120, 234, 75, 0, 26, 197, 62, 94, 252, 219,
  203, 117, 35, 11, 32, 57, 177, 33, 88, 237, 149, 56, 87, 174, 20, 125, 136, 171, 168, 68, 175, 74, 165, 71, 134, 139,
  48, 27, 166, 77, 146, 158, 231, 83, 111, 229, 122, 60, 211, 133, 230, 220, 105, 92, 41, 55, 46, 245, 40, 244, 102,
  143, 54, 65, 25, 63, 161, 1, 216, 80, 73, 209, 76, 132, 187, 208, 89, 18, 169, 200, 196, 135, 130, 116, 188, 159, 86,
  164, 100, 109, 198, 173, 186, 3, 64, 52, 217, 226, 250, 124, 123, 5, 202, 38, 147, 118, 126, 255, 82, 85, 212, 207,
  206, 59, 227, 47, 16, 58, 17, 182, 189, 28, 42, 223, 183, 170, 213, 119, 248, 152, 2, 44, 154, 163, 70, 221, 153, 101,
  155, 167, 43, 172, 9, 129, 22, 39, 253, 19, 98, 108, 110, 79, 113, 224, 232, 178, 185, 112, 104, 218, 246, 97, 228,
  251, 34, 242, 193, 238, 210, 144, 12, 191, 179, 162, 241, 81, 51, 145, 235, 249, 14, 239, 107, 49, 192, 214, 31, 181,
  199, 106, 157, 184, 84, 204, 176, 115, 121, 50, 45, 127, 4, 150, 254, 138, 236, 205, 93, 222, 114, 67, 29, 24, 72,
  243, 141, 128, 195, 78, 66, 215, 61, 156, 180 };

double Fade(double t)
{
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double Blend(double t, double a, double b)
{
  return a + t * (b - a);
}
}

vtkMTPerlinNoise::vtkMTPerlinNoise(std::uint64_t seed)
{
  for (int i = 0; i < 256; ++i)
  {
    this->Permutation[i] = PaperPermutation[i];
  }
  if (seed != 0)
  {
    // Not std::shuffle, whose result differs from library to library.
    std::mt19937_64 random(seed);
    for (std::uint64_t i = 255; i > 0; --i)
    {
      std::swap(this->Permutation[i], this->Permutation[random() % (i + 1)]);
    }
  }
  for (int i = 0; i < 256; ++i)
  {
    this->Permutation[256 + i] = this->Permutation[i];
  }
}

// The dot product with one of (1,1,0), (-1,1,0), ... (0,-1,-1); four of the twelve come twice to make sixteen.
double vtkMTPerlinNoise::Gradient(int hash, double x, double y, double z) const
{
  const int h = hash & 15;
  const double u = h < 8 ? x : y;
  const double v = h < 4 ? y : (h == 12 || h == 14) ? x : z;
  return ((h & 1) ? -u : u) + ((h & 2) ? -v : v);
}

double vtkMTPerlinNoise::Evaluate(double x, double y, double z) const
{
  const double floors[3] = { std::floor(x), std::floor(y), std::floor(z) };
  int cell[3];
  for (int i = 0; i < 3; ++i)
  {
    cell[i] = static_cast<int>(static_cast<std::int64_t>(floors[i]) & 255);
  }
  x -= floors[0];
  y -= floors[1];
  z -= floors[2];
  const double u = Fade(x);
  const double v = Fade(y);
  const double w = Fade(z);
  const auto& p = this->Permutation;
  const int a = p[cell[0]] + cell[1];
  const int b = p[cell[0] + 1] + cell[1];
  const int aa = p[a] + cell[2];
  const int ab = p[a + 1] + cell[2];
  const int ba = p[b] + cell[2];
  const int bb = p[b + 1] + cell[2];
  const double near = Blend(v, Blend(u, this->Gradient(p[aa], x, y, z), this->Gradient(p[ba], x - 1, y, z)),
    Blend(u, this->Gradient(p[ab], x, y - 1, z), this->Gradient(p[bb], x - 1, y - 1, z)));
  const double far =
    Blend(v, Blend(u, this->Gradient(p[aa + 1], x, y, z - 1), this->Gradient(p[ba + 1], x - 1, y, z - 1)),
      Blend(u, this->Gradient(p[ab + 1], x, y - 1, z - 1), this->Gradient(p[bb + 1], x - 1, y - 1, z - 1)));
  return Blend(w, near, far);
}
