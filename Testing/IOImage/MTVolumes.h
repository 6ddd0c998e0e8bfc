// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MTVolumes.h
 * @brief small volumes that tests write sample by sample, and what their isosurfaces must be in the world
 *
 * The samples are 400 - 4 (i - 8)^2 - 3 (j - 10)^2 - 5 (k - 7)^2: an ellipsoid that lies askew in its box, whose
 * gradient is linear, so that contours and normals are known in every frame.
 */
#ifndef MTVolumes_h
#define MTVolumes_h

#include "MTIOTest.h"

#include "vtkMTWorldFrame.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkPolyData;

namespace MTVolumes
{
constexpr std::array<int, 3> Size{ 20, 21, 16 };
constexpr double IsoValue = 250.5;

using Vector = std::array<double, 3>;

/// The place of the sample i j k is Origin + i Axes[0] + j Axes[1] + k Axes[2].
struct Frame
{
  std::array<Vector, 3> Axes{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  Vector Origin{ 0, 0, 0 };
  double GetDeterminant() const;
};

int GetSample(int i, int j, int k);

/// All of them, i fastest, of a type, in this machine's order of bytes or swapped.
template <typename Number>
MTIOTest::Bytes GetSamples(bool isSwapped = false);

void Append(MTIOTest::Bytes& bytes, const std::string& text);
void Append(MTIOTest::Bytes& bytes, const MTIOTest::Bytes& more);
MTIOTest::Bytes Gzip(const MTIOTest::Bytes& bytes);

/// Of a mesh of triangles: positive where they are counterclockwise from outside.
double GetSignedVolume(vtkPolyData* mesh);

/// What was read of a file beside the surface.
struct Read
{
  vtkMTWorldFrame Frame;
  std::map<std::string, std::int64_t> Report;
  std::int64_t Triangles = 0;
};

/**
 * Reads the isosurface whole with gradient normals, and in slabs of several sizes. Of both, every vertex must be on an
 * edge of the grid that the frame gives, where the samples between its ends are the isovalue; the signed volume must be
 * that of the ellipsoid; gradient normals must be those of the ellipsoid in the frame.
 */
Read ExpectEllipsoid(const std::string& path, const Frame& frame, double isoValue = IsoValue);
}

#endif
