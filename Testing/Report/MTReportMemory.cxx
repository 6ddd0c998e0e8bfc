// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportMemory.h"

#include <fstream>
#include <limits>
#include <string>

#include <malloc.h>

namespace
{
// Of /proc/self/status, in bytes.
double GetStatus(const std::string& key)
{
  std::ifstream in("/proc/self/status");
  for (std::string word; in >> word;)
  {
    double kibibytes = 0.0;
    if (word == key && in >> kibibytes)
    {
      return 1024.0 * kibibytes;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}
}

MTReportMemory::MTReportMemory()
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  this->Before = GetStatus("VmRSS:");
}

double MTReportMemory::GetPeak() const
{
  return GetStatus("VmHWM:") - this->Before;
}
