// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportMachine.h"

#include "MTReportVersions.h"
#include "vtkMTVersion.h"

#include "vtkVersion.h"

#include <ctime>
#include <fstream>
#include <thread>

#include <sys/utsname.h>
#include <unistd.h>

namespace
{
// What follows the separator in the first line that begins with the key; empty where there is none.
std::string FindValue(const char* file, const std::string& key, char separator)
{
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
  {
    const std::size_t at = line.find(separator);
    if (line.compare(0, key.size(), key) == 0 && at != std::string::npos)
    {
      const std::size_t begin = line.find_first_not_of(" \t\"", at + 1);
      const std::size_t end = line.find_last_not_of(" \"");
      return begin == std::string::npos ? "" : line.substr(begin, end + 1 - begin);
    }
  }
  return "";
}

std::string GetDate()
{
  const std::time_t now = std::time(nullptr);
  std::tm time;
  gmtime_r(&now, &time);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d", &time);
  return text;
}
}

std::vector<std::pair<std::string, std::string>> MTReportMachine::Describe()
{
  utsname system;
  uname(&system);
  const double memory =
    static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1073741824.0;
  return { { "date", GetDate() },
    { "processor",
      FindValue("/proc/cpuinfo", "model name", ':') + ", " + std::to_string(std::thread::hardware_concurrency()) +
        " threads" },
    { "memory", std::to_string(static_cast<int>(memory + 0.5)) + " GiB" },
    { "system", FindValue("/etc/os-release", "PRETTY_NAME", '=') + ", " + system.sysname + " " + system.release },
    { "toolkit", vtkMTVersion::GetVersion() }, { "VTK", vtkVersion::GetVTKVersion() },
    { "meshoptimizer", MT_REPORT_MESHOPTIMIZER_VERSION },
    { "compiler", std::string(MT_REPORT_COMPILER) + ", " MT_REPORT_BUILD_TYPE " (" MT_REPORT_FLAGS ")" } };
}
