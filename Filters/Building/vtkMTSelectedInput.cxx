// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTSelectedInput.h"

#include <algorithm>
#include <set>
#include <utility>

vtkMTSelectedInput::vtkMTSelectedInput(std::unique_ptr<vtkMTTriangleStream> input, const vtkMTInputFiles& files,
  const std::map<std::string, std::int64_t>& counts)
  : Input(std::move(input))
  , Files(files)
  , Arrays(this->Input->GetArrays())
  , Report(this->Input->GetReport())
{
  for (const auto& [name, count] : counts)
  {
    this->Report[name] += count;
  }
}

vtkMTSelectedInput::~vtkMTSelectedInput() = default;

std::string vtkMTSelectedInput::KeepArrays(const std::vector<std::string>& names)
{
  const std::set<std::string> wanted(names.begin(), names.end());
  std::set<std::string> missing = wanted;
  std::size_t columns[2] = { 0, 0 };
  this->Arrays.clear();
  for (const vtkMTArrayInfo& info : this->Input->GetArrays())
  {
    const bool isCell = info.Association == vtkMTArrayInfo::Cell;
    std::vector<std::size_t>& dropped = isCell ? this->DroppedCellColumns : this->DroppedPointColumns;
    missing.erase(info.Name);
    if (wanted.count(info.Name) > 0)
    {
      this->Arrays.push_back(info);
    }
    else
    {
      dropped.insert(dropped.begin(), columns[isCell ? 1 : 0]);
      ++this->Report["arrays_left_out"];
    }
    ++columns[isCell ? 1 : 0];
  }
  return missing.empty() ? "" : *missing.begin();
}

bool vtkMTSelectedInput::Pass(bool good)
{
  this->Error = good ? "" : this->Input->GetError();
  return good;
}

namespace
{
void Drop(const std::vector<std::size_t>& dropped, std::vector<vtkMTColumn>& columns)
{
  for (const std::size_t column : dropped)
  {
    columns.erase(columns.begin() + static_cast<std::ptrdiff_t>(std::min(column, columns.size())),
      columns.begin() + static_cast<std::ptrdiff_t>(std::min(column + 1, columns.size())));
  }
}
}

bool vtkMTSelectedInput::NextPoints(PointBlock& block)
{
  const bool good = this->Pass(this->Input->NextPoints(block));
  Drop(this->DroppedPointColumns, block.Columns);
  return good;
}

bool vtkMTSelectedInput::NextTriangles(TriangleBlock& block)
{
  const bool good = this->Pass(this->Input->NextTriangles(block));
  Drop(this->DroppedCellColumns, block.Columns);
  const std::string changed = good && !block.Triangles.empty() ? "" : this->Files.FindChanged();
  if (!changed.empty())
  {
    this->Error = changed + ": has changed while it was read; build again when it is complete" +
      (this->Error.empty() ? "" : " (" + this->Error + ")");
  }
  return good && changed.empty();
}
