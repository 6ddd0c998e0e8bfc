// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTMemoryPlan.h"

#include "vtkMTWorkSettings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
constexpr double MiB = 1024.0 * 1024.0;

// Of the process, on top of what it holds before it builds: code that is not in memory yet, thread stacks, what the
// allocator keeps.
constexpr std::uint64_t Reserve = std::uint64_t(12) << 20;

// What no machine has counts as 2^60, so that sums of several fit as well.
std::uint64_t ToBytes(double bytes)
{
  constexpr std::uint64_t most = std::uint64_t(1) << 60;
  return bytes < static_cast<double>(most) ? static_cast<std::uint64_t>(bytes) : most;
}

std::string Refuse(std::uint64_t limit, const char* whose, std::uint64_t least)
{
  return "a memory limit of " + vtkMTMemoryPlan::ToText(limit) + whose +
    " is too small for this input: " + vtkMTMemoryPlan::ToText(least) + " is the least that would do";
}
}

vtkMTMemoryPlan::vtkMTMemoryPlan(const Needs& needs)
  : Standing(ToBytes(needs.Standing))
  , Fixed(ToBytes(needs.Standing + needs.Work))
  , Blocks(ToBytes(needs.Blocks))
  , Whole(ToBytes(needs.Sorts))
  , SpoolSize(ToBytes(needs.Spools))
{
}

std::size_t vtkMTMemoryPlan::GetSortMemory(std::uint64_t limit) const
{
  return static_cast<std::size_t>(limit == 0 ? this->Whole : std::min(this->Whole, limit - this->Fixed));
}

std::uint64_t vtkMTMemoryPlan::GetWorkMemory(std::uint64_t limit) const
{
  return limit == 0 ? 0 : limit - this->Standing;
}

// While blocks are worked on no region is: they may have that as well.
std::uint64_t vtkMTMemoryPlan::GetBlockMemory(std::uint64_t limit) const
{
  return limit == 0 ? 0 : this->GetWorkMemory(limit) - this->GetSortMemory(limit) + this->Blocks;
}

bool vtkMTMemoryPlan::Apply(std::uint64_t limit, vtkMTWorkSettings& settings, std::string& error) const
{
  if (limit > 0 && limit < this->GetLeast())
  {
    error = Refuse(limit, " for the builder", this->GetLeast());
    return false;
  }
  settings.MemoryLimit = limit;
  settings.SortMemory = this->GetSortMemory(limit);
  settings.WorkMemory = this->GetWorkMemory(limit);
  settings.BlockMemory = this->GetBlockMemory(limit);
  return true;
}

std::uint64_t vtkMTMemoryPlan::GetBase(std::uint64_t resident)
{
  return std::max(LeastBase, resident + Reserve);
}

bool vtkMTMemoryPlan::Divide(
  std::uint64_t limit, std::uint64_t resident, std::uint64_t& builderLimit, std::string& error) const
{
  const std::uint64_t base = GetBase(resident);
  if (limit < base + this->GetLeast())
  {
    error = Refuse(limit, "", GetBase(resident + GetVariation(resident)) + this->GetLeast());
    return false;
  }
  builderLimit = limit - base;
  return true;
}

bool vtkMTMemoryPlan::IsWhole(std::uint64_t limit, std::uint64_t resident) const
{
  return GetBase(resident) + this->GetLeast() + this->SpoolSize + this->Whole <= limit;
}

std::string vtkMTMemoryPlan::ToText(std::uint64_t bytes)
{
  const double mebibytes = std::ceil(static_cast<double>(bytes) / MiB);
  char text[64];
  if (mebibytes < 1024.0)
  {
    std::snprintf(text, sizeof(text), "%.0f MiB", mebibytes);
  }
  else
  {
    std::snprintf(text, sizeof(text), "%.1f GiB", std::ceil(mebibytes / 102.4) / 10.0);
  }
  return text;
}
