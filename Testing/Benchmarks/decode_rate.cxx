// SPDX-License-Identifier: BSD-3-Clause
// How fast patches are decoded: decode_rate MODEL [ROUNDS]. The file is held in memory; the rate is that of the bytes
// that come out, by the CPU time of one thread, checksums included, in the fastest round and on average.
#include "vtkMTFileByteSource.h"
#include "vtkMTFileSource.h"
#include "vtkMTMemoryByteSource.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace
{
double GetCpuSeconds()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool Measure(const vtkMTFileSource& source, const std::vector<unsigned char>& arrays, int rounds, const char* what)
{
  double bytes = 0.0;
  double triangles = 0.0;
  double least = 1e300;
  double all = 0.0;
  for (int round = 0; round < rounds; ++round)
  {
    bytes = triangles = 0.0;
    const double begin = GetCpuSeconds();
    for (std::uint32_t arc = 0; arc < source.GetGraph().Arcs.size(); ++arc)
    {
      vtkMTPatch patch;
      std::string error;
      if (!source.ReadPatch(arc, &arrays, patch, error))
      {
        std::fprintf(stderr, "%s\n", error.c_str());
        return false;
      }
      bytes += static_cast<double>(patch.GetMemorySize());
      triangles += static_cast<double>(patch.Triangles.size());
    }
    const double seconds = GetCpuSeconds() - begin;
    least = std::min(least, seconds);
    all += seconds;
  }
  std::printf("%s: %.2f GB/s, %.1f ns per triangle; on average %.2f GB/s\n", what, bytes / least * 1e-9,
    least / triangles * 1e9, bytes * rounds / all * 1e-9);
  return true;
}
}

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: decode_rate MODEL [ROUNDS]\n");
    return 2;
  }
  std::string error;
  const auto file = vtkMTFileByteSource::Open(argv[1], error);
  std::vector<unsigned char> bytes(file ? static_cast<std::size_t>(file->GetSize()) : 0);
  vtkMTFileSource source;
  if (!file || !file->Read(0, bytes.size(), bytes.data(), error) ||
    !source.Open(std::make_shared<vtkMTMemoryByteSource>(std::move(bytes)), error))
  {
    std::fprintf(stderr, "%s\n", error.c_str());
    return 1;
  }
  const int rounds = argc > 2 ? std::atoi(argv[2]) : 10;
  const std::size_t arrays = source.GetGraph().Arrays.size();
  bool done = Measure(source, std::vector<unsigned char>(arrays, 0), rounds, "positions, ids and topology");
  for (std::size_t i = 0; i < arrays && done; ++i)
  {
    std::vector<unsigned char> one(arrays, 0);
    one[i] = 1;
    done = Measure(source, one, rounds, ("with " + source.GetGraph().Arrays[i].Name).c_str());
  }
  return done && Measure(source, std::vector<unsigned char>(arrays, 1), rounds, "with all arrays") ? 0 : 1;
}
