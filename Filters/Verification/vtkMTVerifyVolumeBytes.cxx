// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyVolumeBytes.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>

namespace
{
constexpr std::size_t Chunk = std::size_t(1) << 22;

/// zlib's state, ended however the scope is left.
class Inflater
{
public:
  /// 32: zlib's or gzip's header, whichever is there.
  Inflater() { this->IsReady = inflateInit2(&this->State, 15 + 32) == Z_OK; }
  ~Inflater()
  {
    if (this->IsReady)
    {
      inflateEnd(&this->State);
    }
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  z_stream State = {};
  bool IsReady = false;
};
}

bool vtkMTVerifyVolumeBytes::ReadFile(const std::string& path, Bytes& bytes, std::string& error, std::size_t limit)
{
  bytes.clear();
  std::ifstream file(path, std::ios::binary);
  while (file && bytes.size() < limit)
  {
    const std::size_t from = bytes.size();
    const std::size_t want = std::min(limit - from, std::max(Chunk, from / 2));
    bytes.resize(from + want);
    file.read(reinterpret_cast<char*>(bytes.data()) + from, static_cast<std::streamsize>(want));
    bytes.resize(from + static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof() && !file)
  {
    error = "Cannot read " + path + (errno ? ": " + std::string(std::strerror(errno)) : std::string());
    return false;
  }
  return true;
}

bool vtkMTVerifyVolumeBytes::IsGzip(const Bytes& bytes)
{
  return bytes.size() > 2 && bytes[0] == 0x1f && bytes[1] == 0x8b;
}

bool vtkMTVerifyVolumeBytes::Inflate(
  const unsigned char* data, std::size_t size, std::size_t limit, Bytes& out, std::string& error)
{
  out.clear();
  Inflater inflater;
  if (!inflater.IsReady)
  {
    error = "zlib cannot start";
    return false;
  }
  z_stream& state = inflater.State;
  std::size_t consumed = 0;
  while (out.size() < limit)
  {
    const std::size_t from = out.size();
    const std::size_t want = std::min({ limit - from, std::max(Chunk, from / 2), std::size_t(1) << 30 });
    const std::size_t give = std::min(size - consumed, std::size_t(1) << 30);
    out.resize(from + want);
    state.next_in = const_cast<unsigned char*>(data) + consumed;
    state.avail_in = static_cast<uInt>(give);
    state.next_out = out.data() + from;
    state.avail_out = static_cast<uInt>(want);
    const int result = inflate(&state, Z_NO_FLUSH);
    consumed += give - state.avail_in;
    out.resize(from + want - state.avail_out);
    if (result == Z_STREAM_END)
    {
      // Zeros or other bytes may fill the file behind the last member.
      if (size - consumed < 3 || data[consumed] != 0x1f || data[consumed + 1] != 0x8b)
      {
        return true;
      }
      inflateReset(&state);
    }
    else if (result != Z_OK || (consumed == size && state.avail_out > 0))
    {
      error =
        result == Z_OK || result == Z_BUF_ERROR ? "the compressed data ends early" : "the compressed data is damaged";
      return false;
    }
  }
  return true;
}

bool vtkMTVerifyVolumeBytes::ReadInflated(const std::string& path, std::size_t limit, Bytes& bytes, std::string& error)
{
  if (!ReadFile(path, bytes, error))
  {
    return false;
  }
  if (!IsGzip(bytes))
  {
    bytes.resize(std::min(bytes.size(), limit));
    return true;
  }
  Bytes packed;
  packed.swap(bytes);
  if (Inflate(packed.data(), packed.size(), limit, bytes, error))
  {
    return true;
  }
  error = path + ": " + error;
  return false;
}

std::string vtkMTVerifyVolumeBytes::Trim(const std::string& text)
{
  const char* const blanks = " \t\r\n\v\f";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string vtkMTVerifyVolumeBytes::ToLower(std::string text)
{
  std::transform(
    text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<std::string> vtkMTVerifyVolumeBytes::Split(const std::string& text)
{
  std::istringstream words(text);
  std::vector<std::string> result;
  for (std::string word; words >> word;)
  {
    result.push_back(word);
  }
  return result;
}

bool vtkMTVerifyVolumeBytes::ToNumbers(const std::vector<std::string>& words, std::vector<double>& numbers)
{
  numbers.clear();
  for (const std::string& word : words)
  {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || *end != '\0')
    {
      return false;
    }
  }
  return true;
}

bool vtkMTVerifyVolumeBytes::EndsWith(const std::string& path, const std::string& lowerCaseEnding)
{
  return path.size() >= lowerCaseEnding.size() &&
    ToLower(path.substr(path.size() - lowerCaseEnding.size())) == lowerCaseEnding;
}

std::string vtkMTVerifyVolumeBytes::Beside(const std::string& path, const std::string& name)
{
  const bool isAbsolute = !name.empty() && (name[0] == '/' || name[0] == '\\' || (name.size() > 1 && name[1] == ':'));
  const std::size_t slash = path.find_last_of("/\\");
  return isAbsolute || slash == std::string::npos ? name : path.substr(0, slash + 1) + name;
}

bool vtkMTVerifyVolumeBytes::ExpandPattern(
  const std::string& pattern, const std::int64_t (&firstLastStep)[3], std::vector<std::string>& names)
{
  // The pattern comes from a file: it is never given to printf.
  const std::size_t percent = pattern.find('%');
  const std::size_t letter =
    percent == std::string::npos ? percent : pattern.find_first_not_of("0123456789", percent + 1);
  const auto [first, last, step] = firstLastStep;
  if (letter == std::string::npos || !std::strchr("diu", pattern[letter]) || letter - percent > 4 || step == 0 ||
    (last - first) / step < 0 || (last - first) / step > 1000000)
  {
    return false;
  }
  const std::string digits = pattern.substr(percent + 1, letter - percent - 1);
  const std::size_t width = static_cast<std::size_t>(std::atoi(digits.c_str()));
  const char fill = !digits.empty() && digits[0] == '0' ? '0' : ' ';
  names.clear();
  for (std::int64_t i = 0; i <= (last - first) / step; ++i)
  {
    std::string number = std::to_string(first + i * step);
    number.insert(0, width > number.size() ? width - number.size() : 0, fill);
    names.push_back(pattern.substr(0, percent) + number + pattern.substr(letter + 1));
  }
  return true;
}
