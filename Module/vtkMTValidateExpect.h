// SPDX-License-Identifier: BSD-3-Clause
// How the checks of vtkMTValidate count and report. Not installed.
#ifndef vtkMTValidateExpect_h
#define vtkMTValidateExpect_h

#include "vtkMTValidate.h"

#include <sstream>
#include <string>

namespace vtkMTValidateExpect
{
//------------------------------------------------------------------------------
template <typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream text;
  text.precision(17);
  (text << ... << parts);
  return text.str();
}

//------------------------------------------------------------------------------
// One test: counts it, and reports a violation unless ok.
template <typename... Parts>
bool Expect(vtkMTValidate::Result& result, const char* check, bool ok, const Parts&... parts)
{
  ++result.Tested;
  if (!ok)
  {
    result.Report(check, Text(parts...));
  }
  return ok;
}

}

#endif
