// SPDX-License-Identifier: BSD-3-Clause
// A whole file, with checksums that are made right again after every mutation: what the checks behind them are worth.
#include "vtkMTFileSource.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTValidate.h"

#include <cstring>

#define XXH_INLINE_ALL
#include <xxhash.h>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t maximumSize);

namespace
{
constexpr std::size_t HeaderSize = 256;

template <class Number>
Number Get(const std::uint8_t* data, std::size_t offset)
{
  Number value;
  std::memcpy(&value, data + offset, sizeof(value));
  return value;
}

void Put(std::uint8_t* data, std::size_t offset, std::uint64_t value)
{
  std::memcpy(data + offset, &value, sizeof(value));
}

// As far as the header's offsets lie within the file.
void Seal(std::uint8_t* data, std::size_t size)
{
  if (size < HeaderSize)
  {
    return;
  }
  const auto directory = Get<std::uint64_t>(data, 40);
  const auto metadata = Get<std::uint64_t>(data, 48);
  const auto patches = Get<std::uint64_t>(data, 64);
  Put(data, 16, size);
  if (patches < HeaderSize || patches > size)
  {
    Put(data, 248, XXH3_64bits(data, 248));
    return;
  }
  std::uint64_t at = patches;
  for (std::uint64_t entry = directory; entry >= HeaderSize && entry + 16 <= metadata && metadata <= patches;
       entry += 16)
  {
    const std::uint64_t padded = (std::uint64_t(Get<std::uint32_t>(data, entry + 8)) + 15) / 16 * 16;
    if (padded > size - at)
    {
      break;
    }
    Put(data, entry, XXH3_64bits(data + at, padded));
    at += padded;
  }
  Put(data, 240, XXH3_64bits(data + HeaderSize, patches - HeaderSize));
  Put(data, 248, XXH3_64bits(data, 248));
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
