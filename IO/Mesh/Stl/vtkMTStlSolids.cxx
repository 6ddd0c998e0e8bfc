// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlSolids.h"

#include "vtkMTIdNames.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"

#include <algorithm>

void vtkMTStlSolids::Add(std::uint64_t first, std::string_view name)
{
  constexpr std::string_view around(" \t\r\n\0", 5);
  const std::size_t begin = name.find_first_not_of(around);
  const std::size_t end = name.find_last_not_of(around);
  this->Firsts.push_back(first);
  this->Names.emplace_back(begin == std::string_view::npos ? std::string_view() : name.substr(begin, end - begin + 1));
  if (this->Names.back().empty())
  {
    this->Names.back() = "solid " + std::to_string(this->Names.size());
  }
}

void vtkMTStlSolids::AddIds(std::uint64_t first, std::uint64_t count, vtkCellData* attributes) const
{
  if (this->Names.size() < 2)
  {
    return;
  }
  const vtkNew<vtkIntArray> ids;
  ids->SetName("SolidIds");
  ids->SetNumberOfValues(static_cast<vtkIdType>(count));
  auto next = std::upper_bound(this->Firsts.begin(), this->Firsts.end(), first);
  for (std::uint64_t i = 0; i < count; ++i)
  {
    while (next != this->Firsts.end() && *next <= first + i)
    {
      ++next;
    }
    ids->SetValue(static_cast<vtkIdType>(i), static_cast<int>(next - this->Firsts.begin()) - 1);
  }
  vtkMTIdNames::Set(ids, this->Names);
  attributes->AddArray(ids);
}
