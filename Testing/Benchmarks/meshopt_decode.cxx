// SPDX-License-Identifier: BSD-3-Clause
// meshopt_decode MODEL [ROUNDS]: how fast meshoptimizer's codecs decode the triangles and lattice positions of a
// model's patches, and how many bytes they need: a yardstick for decode_rate, as machines differ. The rate is that of
// the bytes that come out (12 per triangle, 12 per vertex), by the CPU time of one thread; identities, checksums and
// what VTK needs are not in it. Triangles come in meshoptimizer's own order.
#include "vtkMTFileSource.h"

#include <meshoptimizer.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace
{
struct Packed
{
  std::size_t Triangles;
  std::size_t Vertices;
  std::vector<unsigned char> Indices;
  std::vector<unsigned char> Positions;
};

Packed Pack(const vtkMTPatch& patch)
{
  std::vector<unsigned int> indices;
  for (const vtkMTTriangle& t : patch.Triangles)
  {
    for (const std::uint32_t wedge : t)
    {
      indices.push_back(patch.GetPointOfWedge(wedge));
    }
  }
  std::vector<vtkMTPoint> points = patch.Points;
  meshopt_optimizeVertexCache(indices.data(), indices.data(), indices.size(), points.size());
  meshopt_optimizeVertexFetch(
    points.data(), indices.data(), indices.size(), patch.Points.data(), points.size(), sizeof(vtkMTPoint));
  Packed packed{ patch.Triangles.size(), points.size(), {}, {} };
  packed.Indices.resize(meshopt_encodeIndexBufferBound(indices.size(), points.size()));
  packed.Indices.resize(
    meshopt_encodeIndexBuffer(packed.Indices.data(), packed.Indices.size(), indices.data(), indices.size()));
  packed.Positions.resize(meshopt_encodeVertexBufferBound(points.size(), sizeof(vtkMTPoint)));
  packed.Positions.resize(meshopt_encodeVertexBuffer(
    packed.Positions.data(), packed.Positions.size(), points.data(), points.size(), sizeof(vtkMTPoint)));
  return packed;
}

bool Decode(const Packed& packed)
{
  std::vector<unsigned int> indices(3 * packed.Triangles);
  std::vector<vtkMTPoint> points(packed.Vertices);
  return meshopt_decodeIndexBuffer(
           indices.data(), indices.size(), sizeof(unsigned int), packed.Indices.data(), packed.Indices.size()) == 0 &&
    meshopt_decodeVertexBuffer(
      points.data(), points.size(), sizeof(vtkMTPoint), packed.Positions.data(), packed.Positions.size()) == 0;
}

double GetCpuSeconds()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
}

int main(int argc, char** argv)
{
  vtkMTFileSource source;
  std::string error;
  if (argc < 2 || !source.Open(argv[1], error))
  {
    std::fprintf(stderr, "%s\n", argc < 2 ? "usage: meshopt_decode MODEL [ROUNDS]" : error.c_str());
    return argc < 2 ? 2 : 1;
  }
  const std::vector<unsigned char> none(source.GetGraph().Arrays.size(), 0);
  std::vector<Packed> patches;
  for (std::uint32_t arc = 0; arc < source.GetGraph().Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    if (!source.ReadPatch(arc, &none, patch, error))
    {
      std::fprintf(stderr, "%s\n", error.c_str());
      return 1;
    }
    patches.push_back(Pack(patch));
  }
  double triangles = 0.0;
  double stored = 0.0;
  double decoded = 0.0;
  for (const Packed& packed : patches)
  {
    triangles += static_cast<double>(packed.Triangles);
    stored += static_cast<double>(packed.Indices.size() + packed.Positions.size());
    decoded += 12.0 * static_cast<double>(packed.Triangles + packed.Vertices);
  }
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
  bool good = true;
  const double begin = GetCpuSeconds();
  for (int round = 0; round < rounds; ++round)
  {
    for (const Packed& packed : patches)
    {
      good = Decode(packed) && good;
    }
  }
  const double seconds = GetCpuSeconds() - begin;
  std::printf("meshoptimizer: %.2f GB/s, %.1f ns and %.2f bytes per triangle stored%s\n",
    decoded * rounds / seconds * 1e-9, seconds / (triangles * rounds) * 1e9, stored / triangles,
    good ? "" : ", DAMAGED");
  return good ? 0 : 1;
}
