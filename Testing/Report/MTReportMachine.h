// SPDX-License-Identifier: BSD-3-Clause
// On what the report was made: for its head, and for nothing else.
#ifndef MTReportMachine_h
#define MTReportMachine_h

#include <string>
#include <utility>
#include <vector>

namespace MTReportMachine
{
/// Name and value: machine, system, versions, compiler and the date.
std::vector<std::pair<std::string, std::string>> Describe();
}

#endif
