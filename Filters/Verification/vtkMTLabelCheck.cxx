// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLabelCheck.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include "vtkType.h"

#include <set>

namespace
{
constexpr std::size_t LabelsLimit = 4096;   // of arrays that are resampled as labels: more are no set to be held
constexpr std::size_t FewValuesLimit = 256; // of other arrays of whole numbers

using Tuple = std::string; // its bytes

bool MayBeLabels(const vtkMTGraph& graph, const vtkMTArrayInfo& array)
{
  const auto values = graph.Settings.find("values");
  const bool isWhole = array.Type != VTK_FLOAT && array.Type != VTK_DOUBLE;
  const bool isChosen =
    values != graph.Settings.end() && ("," + values->second + ",").find("," + array.Name + ",") != std::string::npos;
  return array.Role == vtkMTArrayInfo::Plain && isWhole && array.Components == 1 && !isChosen;
}

class Labels
{
public:
  explicit Labels(const vtkMTGraph& graph)
    : Graph(graph)
    , Finest(graph.Arrays.size())
  {
    for (const vtkMTArrayInfo& array : graph.Arrays)
    {
      this->Wanted.push_back(MayBeLabels(graph, array) ? 1 : 0);
    }
  }

  void Collect(const vtkMTPatch& patch)
  {
    this->Visit(patch,
      [this](std::size_t array, const Tuple& value)
      {
        if (this->Finest[array].size() <= LabelsLimit)
        {
          this->Finest[array].insert(value);
        }
      });
  }

  void Compare(const vtkMTPatch& patch, vtkMTVerificationCheck& check) const
  {
    this->Visit(patch,
      [&](std::size_t array, const Tuple& value)
      {
        const bool isLabel = this->Graph.Arrays[array].Resampling == vtkMTArrayInfo::Nearest;
        if (this->Finest[array].size() > (isLabel ? LabelsLimit : FewValuesLimit))
        {
          return;
        }
        ++check.Tested;
        if (this->Finest[array].count(value) == 0)
        {
          check.Fail("array '" + this->Graph.Arrays[array].Name +
            "': a coarse patch holds a label that the finest level does not hold, as if labels had been mixed");
        }
      });
  }

  const std::vector<unsigned char>& GetWanted() const { return this->Wanted; }

private:
  template <class Use>
  void Visit(const vtkMTPatch& patch, const Use& use) const
  {
    std::size_t next[2] = { 0, 0 };
    for (std::size_t array = 0; array < this->Wanted.size(); ++array)
    {
      const bool isOfCells = this->Graph.Arrays[array].Association == vtkMTArrayInfo::Cell;
      const std::size_t place = next[isOfCells ? 1 : 0]++;
      if (!this->Wanted[array])
      {
        continue;
      }
      const vtkMTColumn& column = (isOfCells ? patch.CellColumns : patch.PointColumns)[place];
      const std::size_t size = this->Graph.Arrays[array].GetTupleSize();
      for (std::size_t at = 0; at + size <= column.size(); at += size)
      {
        use(array, Tuple(reinterpret_cast<const char*>(column.data()) + at, size));
      }
    }
  }

  const vtkMTGraph& Graph;
  std::vector<unsigned char> Wanted;
  std::vector<std::set<Tuple>> Finest;
};
}

bool vtkMTLabelCheck::Test(const vtkMTPatchSource& source, const vtkMTVerificationProgress& progress,
  vtkMTVerificationCheck& check, std::string& error)
{
  const vtkMTGraph& graph = source.GetGraph();
  Labels labels(graph);
  vtkMTPatch patch;
  for (const bool isFinest : { true, false })
  {
    for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
    {
      if (graph.IsFinest(arc) != isFinest)
      {
        continue;
      }
      error.clear();
      if (!progress(
            "comparing labels", (arc / static_cast<double>(graph.Arcs.size()) + (isFinest ? 0.0 : 1.0)) / 2.0) ||
        !source.ReadPatch(arc, &labels.GetWanted(), patch, error))
      {
        return false;
      }
      isFinest ? labels.Collect(patch) : labels.Compare(patch, check);
    }
  }
  return true;
}
