// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportFile.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

void MTReportFile::Write(const std::string& path, const std::string& text)
{
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out)
  {
    throw std::runtime_error(path + ": cannot be written");
  }
}

std::string MTReportFile::EscapeHtml(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
  {
    switch (c)
    {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string MTReportFile::Wrap(const std::string& text)
{
  constexpr std::size_t Width = 120;
  std::istringstream words(text);
  std::string wrapped;
  std::size_t column = 0;
  for (std::string word; words >> word;)
  {
    const bool fits = column + 1 + word.size() <= Width;
    wrapped += wrapped.empty() ? word : (fits ? " " : "\n") + word;
    column = fits && column > 0 ? column + 1 + word.size() : word.size();
  }
  return wrapped;
}
