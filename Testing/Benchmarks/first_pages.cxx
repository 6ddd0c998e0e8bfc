// SPDX-License-Identifier: BSD-3-Clause
// first_pages MODEL.bmt: bytes, reads and time until the coarsest cut is decoded, and until the whole graph is known.
#include "vtkMTByteSource.h"
#include "vtkMTCut.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTFileSource.h"

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

namespace
{
class CountingSource : public vtkMTByteSource
{
public:
  explicit CountingSource(std::shared_ptr<const vtkMTByteSource> inner)
    : Inner(std::move(inner))
  {
  }
  std::uint64_t GetSize() const override { return this->Inner->GetSize(); }
  bool Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const override
  {
    this->Bytes += count;
    ++this->Reads;
    return this->Inner->Read(offset, count, destination, error);
  }
  std::string GetName() const override { return this->Inner->GetName(); }
  mutable std::uint64_t Bytes = 0; // one thread reads
  mutable std::uint64_t Reads = 0;

private:
  std::shared_ptr<const vtkMTByteSource> Inner;
};

using Clock = std::chrono::steady_clock;

void Report(const char* what, const CountingSource& bytes, const vtkMTGraph& graph, Clock::time_point start)
{
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  std::printf("%-28s %12llu bytes %6llu reads %9.2f ms; %u of %zu nodes, %u of %zu arcs known\n", what,
    static_cast<unsigned long long>(bytes.Bytes), static_cast<unsigned long long>(bytes.Reads), 1000.0 * seconds,
    graph.GetNumberOfKnownNodes(), graph.Nodes.size(), graph.GetNumberOfKnownArcs(), graph.Arcs.size());
}

bool Measure(const std::shared_ptr<CountingSource>& bytes, std::string& error)
{
  const Clock::time_point start = Clock::now();
  vtkMTFileSource source;
  if (!source.OpenFirstPages(bytes, error))
  {
    return false;
  }
  const vtkMTGraph& graph = source.GetKnownGraph();
  Report("opened", *bytes, graph, start);
  vtkMTPatch patch;
  for (const std::uint32_t arc : vtkMTCut(graph).GetArcs())
  {
    if (!source.ReadPatch(arc, nullptr, patch, error))
    {
      return false;
    }
  }
  Report("coarsest cut decoded", *bytes, graph, start);
  while (!graph.IsWhole())
  {
    if (!source.ReadOn(std::uint64_t(1) << 24, error))
    {
      return false;
    }
  }
  Report("whole graph known", *bytes, graph, start);
  return true;
}
}

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: first_pages MODEL.bmt\n");
    return 2;
  }
  std::string error;
  const std::shared_ptr<const vtkMTByteSource> file = vtkMTFileByteSource::Open(argv[1], error);
  if (!file || !Measure(std::make_shared<CountingSource>(file), error))
  {
    std::fprintf(stderr, "first_pages: %s\n", error.c_str());
    return 1;
  }
  return 0;
}
