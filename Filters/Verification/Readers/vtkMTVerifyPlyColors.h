// SPDX-License-Identifier: BSD-3-Clause
// What the values of a PLY file's colours count to. Not installed.
#ifndef vtkMTVerifyPlyColors_h
#define vtkMTVerifyPlyColors_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace vtkMTVerifyPlyColors
{
/// A full colour in values of a type, of which `largest` is the largest that the file has: bytes are written into any
/// type.
inline double GetUnit(const std::string& type, double largest)
{
  if (type[0] == 'f' || type[0] == 'd')
  {
    return largest < 2.0 ? 1.0 : std::max(largest, 255.0);
  }
  if (largest <= 255.0 || type.find("char") != std::string::npos || type.find("int8") != std::string::npos)
  {
    return 255.0;
  }
  const bool isShort = type.find("short") != std::string::npos || type.find("16") != std::string::npos;
  const bool isSigned = type[0] != 'u';
  if (isShort || largest <= 65535.0)
  {
    return isShort && isSigned ? 32767.0 : 65535.0;
  }
  return isSigned ? 2147483647.0 : 4294967295.0;
}

/// To 0..1, tuples of as many values as there are types.
inline void Scale(const std::vector<std::string>& types, std::vector<double>& values)
{
  std::map<std::string, double> largest;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    double& most = largest[types[i % types.size()]];
    most = std::isfinite(values[i]) ? std::max(most, values[i]) : most;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::string& type = types[i % types.size()];
    values[i] /= GetUnit(type, largest[type]);
  }
}
}

#endif
