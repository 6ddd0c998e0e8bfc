// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRangeCollector
 * @brief the ranges of a model's arrays out of those of its patches
 *
 * For patch sinks: when the graph is finished, each arc's patch gives its ranges (vtkMTPatch::GetRanges), in any order;
 * the results do not depend on it. The ranges of the whole model are those of the finest level; those of arcs are made
 * for the columns that the graph's ArcRanges ask for.
 */
#ifndef vtkMTRangeCollector_h
#define vtkMTRangeCollector_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTGraph.h"

#include <cstdint>
#include <vector>

class VTKMTCORE_EXPORT vtkMTRangeCollector
{
public:
  /// The graph must outlive the collector.
  explicit vtkMTRangeCollector(const vtkMTGraph& graph);

  /// Whether the ranges of the arc's patch have an influence on the results.
  bool Wants(std::uint32_t arc) const;
  void Add(std::uint32_t arc, const std::vector<vtkMTRange>& ofPatch);
  /// After all patches.
  void Finish();

  const std::vector<std::vector<vtkMTRange>>& GetArrayRanges() const { return this->ArrayRanges; }
  const vtkMTArcRanges& GetArcRanges() const { return this->ArcRanges; }

private:
  const vtkMTGraph* Graph;
  std::vector<std::vector<vtkMTRange>> ArrayRanges;
  std::vector<std::size_t> FirstComponent; // of each array, among all components
  vtkMTArcRanges ArcRanges;
};

#endif
