// SPDX-License-Identifier: BSD-3-Clause
// A whole file, with checksums that are made right again after every mutation: what the checks behind them are worth.
#include "MTFileSeal.h"

#include "vtkMTCut.h"
#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTValidate.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maximumSize);

namespace
{
constexpr std::uint64_t BlobsOfSeeds = 1;

void Seal(std::uint8_t* data, std::size_t size)
{
  if (size >= 256)
  {
    MTFileSeal::Put<std::uint64_t>(data, 16, size);
    MTFileSeal::SealSections(data, size, BlobsOfSeeds);
    MTFileSeal::SealPages(data, size);
  }
}
}

extern "C" std::size_t LLVMFuzzerCustomMutator(
  std::uint8_t* data, std::size_t size, std::size_t maximumSize, unsigned seed)
{
  // Most of the time the length stays, since few others can be read.
  size = LLVMFuzzerMutate(data, size, seed % 8 == 0 ? maximumSize : size);
  Seal(data, size);
  return size;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  vtkMTFileSource source;
  std::string error;
  if (!source.Open(std::make_shared<vtkMTMemoryByteSource>(std::vector<unsigned char>(data, data + size)), error))
  {
    return 0;
  }
  // By the first pages, a page at a time: the known part must be sound at any time.
  vtkMTFileSource first;
  if (first.OpenFirstPages(std::make_shared<vtkMTMemoryByteSource>(std::vector<unsigned char>(data, data + size)), error))
  {
    do
    {
      vtkMTCut cut(first.GetKnownGraph());
      cut.RefineWithDependencies(first.GetKnownGraph().GetNumberOfKnownNodes() - 1);
      cut.GetArcs();
    } while (!first.GetKnownGraph().IsWhole() && first.ReadOn(1, error));
  }
  const vtkMTGraph& graph = source.GetGraph();
  vtkMTValidate::Graph(graph);
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    if (source.ReadPatch(arc, nullptr, patch, error))
    {
      vtkMTValidate::Patch(graph, arc, patch);
    }
  }
  std::vector<unsigned char> blob;
  for (std::uint32_t i = 0; i < graph.Blobs.size(); ++i)
  {
    source.ReadBlob(i, blob, error);
  }
  return 0;
}
