// SPDX-License-Identifier: BSD-3-Clause
// Text files of the report.
#ifndef MTReportFile_h
#define MTReportFile_h

#include <string>

namespace MTReportFile
{
/// Throws std::runtime_error where the file cannot be written.
void Write(const std::string& path, const std::string& text);

/// With what HTML reserves replaced.
std::string EscapeHtml(const std::string& text);

/// One paragraph, filled to 120 columns.
std::string Wrap(const std::string& text);
}

#endif
