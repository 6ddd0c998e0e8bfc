// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyText.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <memory>

bool vtkMTVerifyText::Load(const std::string& path, std::string& bytes, std::string& error)
{
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
  if (!file)
  {
    error = path + ": cannot be opened";
    return false;
  }
  bytes.clear();
  std::vector<char> block(std::size_t(1) << 20);
  int count = 0;
  while ((count = gzread(file.get(), block.data(), static_cast<unsigned int>(block.size()))) > 0)
  {
    bytes.append(block.data(), static_cast<std::size_t>(count));
  }
  int code = Z_OK;
  const char* message = gzerror(file.get(), &code);
  if (count < 0 || code == Z_BUF_ERROR)
  {
    error = path + ": cannot be read to its end: " + message;
    return false;
  }
  return true;
}

bool vtkMTVerifyText::IsReadable(std::string_view bytes, std::string& error)
{
  const bool isWide = bytes.substr(0, 2) == "\xff\xfe" || bytes.substr(0, 2) == "\xfe\xff";
  error = isWide ? "is UTF-16" : "";
  return !isWide;
}

std::string_view vtkMTVerifyText::SkipMark(std::string_view bytes)
{
  return bytes.substr(bytes.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0);
}

std::vector<std::string_view> vtkMTVerifyText::Split(std::string_view line)
{
  constexpr const char* blanks = " \t\v\f\r\n";
  std::vector<std::string_view> words;
  std::size_t end = 0;
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;
       begin = line.find_first_not_of(blanks, end))
  {
    end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
  }
  return words;
}

bool vtkMTVerifyText::ParseNumber(std::string_view word, double& value)
{
  word.remove_prefix(!word.empty() && word[0] == '+' ? 1 : 0);
  if (word.find("#IND") != std::string_view::npos || word.find("#QNAN") != std::string_view::npos ||
    word.find("#SNAN") != std::string_view::npos)
  {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  if (word.find("#INF") != std::string_view::npos)
  {
    value = (word[0] == '-' ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
    return true;
  }
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, value);
  if (result.ec == std::errc::result_out_of_range) // too small for a double, or too large
  {
    const std::size_t exponent = word.find_first_of("eE");
    const bool isSmall = exponent != std::string_view::npos && word.substr(exponent + 1, 1) == "-";
    value = isSmall ? 0.0 : (word[0] == '-' ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
    return true;
  }
  return result.ec == std::errc() && result.ptr == end;
}

bool vtkMTVerifyText::ParseInteger(std::string_view word, long long& value)
{
  word.remove_prefix(!word.empty() && word[0] == '+' ? 1 : 0);
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

std::string vtkMTVerifyText::ToLower(std::string_view text)
{
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  return lower;
}

std::string vtkMTVerifyText::GetEnding(const std::string& path)
{
  std::string name = ToLower(std::string_view(path).substr(path.find_last_of("/\\") + 1));
  if (name.size() > 3 && name.compare(name.size() - 3, 3, ".gz") == 0)
  {
    name.resize(name.size() - 3);
  }
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos ? "" : name.substr(dot + 1);
}

std::string vtkMTVerifyText::GetFolder(const std::string& path)
{
  return path.substr(0, path.find_last_of("/\\") + 1);
}

bool vtkMTVerifyText::Next(std::string_view& line)
{
  if (this->Position >= this->Text.size())
  {
    return false;
  }
  const std::size_t end = std::min(this->Text.find_first_of("\r\n", this->Position), this->Text.size());
  line = this->Text.substr(this->Position, end - this->Position);
  this->Position = end + (this->Text.substr(end, 2) == "\r\n" ? 2 : 1);
  return true;
}
