// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRangeCollector.h"

//------------------------------------------------------------------------------
vtkMTRangeCollector::vtkMTRangeCollector(const vtkMTGraph& graph)
  : Graph(&graph)
{
  std::size_t components = 0;
  for (const vtkMTArrayInfo& array : graph.Arrays)
  {
    this->FirstComponent.push_back(components);
    this->ArrayRanges.emplace_back(static_cast<std::size_t>(array.Components));
    components += this->ArrayRanges.back().size();
  }
  this->ArcRanges.Columns = graph.ArcRanges.Columns;
  this->ArcRanges.Values.resize(this->ArcRanges.Columns.size() * graph.Arcs.size());
}

//------------------------------------------------------------------------------
bool vtkMTRangeCollector::Wants(std::uint32_t arc) const
{
  return !this->ArrayRanges.empty() && (this->Graph->IsFinest(arc) || !this->ArcRanges.Columns.empty());
}

//------------------------------------------------------------------------------
void vtkMTRangeCollector::Add(std::uint32_t arc, const std::vector<vtkMTRange>& ofPatch)
{
  std::size_t next = 0;
  for (std::size_t array = 0; this->Graph->IsFinest(arc) && array < this->ArrayRanges.size(); ++array)
  {
    for (vtkMTRange& range : this->ArrayRanges[array])
    {
      range.Add(ofPatch[next++]);
    }
  }
  const std::size_t columns = this->ArcRanges.Columns.size();
  for (std::size_t c = 0; c < columns; ++c)
  {
    const vtkMTArcRanges::Column& column = this->ArcRanges.Columns[c];
    this->ArcRanges.Values[arc * columns + c] = ofPatch[this->FirstComponent[column.Array] + column.Component];
  }
}

//------------------------------------------------------------------------------
void vtkMTRangeCollector::Finish()
{
  this->Graph->SaturateRanges(this->ArcRanges);
}
