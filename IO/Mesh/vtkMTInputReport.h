// SPDX-License-Identifier: BSD-3-Clause
// What a reader left out, made up or changed, by reason. Not installed.
#ifndef vtkMTInputReport_h
#define vtkMTInputReport_h

#include <cstdint>
#include <map>
#include <string>

/// As vtkMTTriangleStream::GetReport gives it.
using vtkMTInputReport = std::map<std::string, std::int64_t>;

namespace vtkMTInputReports
{
/// Reasons of which there is none are left out.
inline void Add(const char* reason, std::uint64_t count, vtkMTInputReport& report)
{
  if (count > 0)
  {
    report[reason] += static_cast<std::int64_t>(count);
  }
}

inline void Add(const vtkMTInputReport& from, vtkMTInputReport& report)
{
  for (const auto& [reason, count] : from)
  {
    report[reason] += count;
  }
}
}

#endif
