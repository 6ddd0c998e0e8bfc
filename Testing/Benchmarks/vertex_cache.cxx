// SPDX-License-Identifier: BSD-3-Clause
// vertex_cache MODEL: what the order in which patches keep their triangles costs a GPU's vertex cache, beside the order
// that meshoptimizer makes of them. Misses per triangle of first-in-first-out caches, over all patches.
#include "vtkMTFileSource.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

int main(int argc, char** argv)
{
  vtkMTFileSource source;
  std::string error;
  if (argc != 2 || !source.Open(argv[1], error))
  {
    std::fprintf(stderr, "%s\n", argc == 2 ? error.c_str() : "usage: vertex_cache MODEL");
    return argc == 2 ? 1 : 2;
  }
  const std::vector<unsigned char> none(source.GetGraph().Arrays.size(), 0);
  for (const unsigned cache : { 16u, 32u })
  {
    // Ours, that of meshopt_optimizeVertexCache, that of its strips, and each vertex once.
    double misses[4] = { 0.0, 0.0, 0.0, 0.0 };
    double triangles = 0.0;
    for (std::uint32_t arc = 0; arc < source.GetGraph().Arcs.size(); ++arc)
    {
      vtkMTPatch patch;
      if (!source.ReadPatch(arc, &none, patch, error))
      {
        std::fprintf(stderr, "%s\n", error.c_str());
        return 1;
      }
      const std::size_t wedges = patch.GetNumberOfWedges();
      std::vector<unsigned int> indices;
      for (const vtkMTTriangle& t : patch.Triangles)
      {
        indices.insert(indices.end(), t.begin(), t.end());
      }
      const auto analyze = [&](const std::vector<unsigned int>& order)
      {
        return static_cast<double>(
          meshopt_analyzeVertexCache(order.data(), order.size(), wedges, cache, 0, 0).vertices_transformed);
      };
      misses[0] += analyze(indices);
      std::vector<unsigned int> optimized(indices.size());
      meshopt_optimizeVertexCache(optimized.data(), indices.data(), indices.size(), wedges);
      misses[1] += analyze(optimized);
      meshopt_optimizeVertexCacheFifo(optimized.data(), indices.data(), indices.size(), wedges, cache);
      misses[2] += analyze(optimized);
      misses[3] += static_cast<double>(wedges);
      triangles += static_cast<double>(patch.Triangles.size());
    }
    std::printf(
      "cache of %u: stored order %.3f, optimizeVertexCache %.3f (stored %+.1f %%), its FIFO variant %.3f, least "
      "%.3f misses per triangle\n",
      cache, misses[0] / triangles, misses[1] / triangles, 100.0 * (misses[0] / misses[1] - 1.0), misses[2] / triangles,
      misses[3] / triangles);
  }
  return 0;
}
