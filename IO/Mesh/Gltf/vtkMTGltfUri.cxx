// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfUri.h"

#include <array>
#include <cstdint>

namespace
{
int GetHexadecimal(char digit)
{
  const auto between = [digit](char first, char last) { return digit >= first && digit <= last; };
  return between('0', '9') ? digit - '0'
    : between('a', 'f')    ? digit - 'a' + 10
    : between('A', 'F')    ? digit - 'A' + 10
                           : -1;
}

std::array<signed char, 256> MakeBase64()
{
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<signed char, 256> values;
  values.fill(-1);
  for (std::size_t i = 0; i < digits.size(); ++i)
  {
    values[static_cast<unsigned char>(digits[i])] = static_cast<signed char>(i);
  }
  return values;
}

// False where a digit is none.
bool FromBase64(const std::string& text, std::size_t begin, std::vector<unsigned char>& bytes)
{
  static const std::array<signed char, 256> values = MakeBase64();
  std::uint32_t bits = 0;
  int count = 0;
  bytes.reserve((text.size() - begin) / 4 * 3 + 3);
  for (std::size_t i = begin; i < text.size() && text[i] != '='; ++i)
  {
    const signed char value = values[static_cast<unsigned char>(text[i])];
    if (value < 0)
    {
      return false;
    }
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes.push_back(static_cast<unsigned char>(bits >> count & 255));
    }
  }
  return true;
}
}

namespace vtkMTGltfUri
{
std::string FromPercent(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? GetHexadecimal(uri[i + 1]) : -1;
    const int low = high >= 0 ? GetHexadecimal(uri[i + 2]) : -1;
    text += low >= 0 ? static_cast<char>(16 * high + low) : uri[i];
    i += low >= 0 ? 2 : 0;
  }
  return text;
}

bool HasData(const std::string& uri)
{
  return uri.rfind("data:", 0) == 0;
}

bool DecodeData(const std::string& uri, std::vector<unsigned char>& bytes)
{
  const std::string mark = ";base64";
  const std::size_t comma = uri.find(',');
  if (comma == std::string::npos)
  {
    return false;
  }
  if (comma >= mark.size() && uri.compare(comma - mark.size(), mark.size(), mark) == 0)
  {
    return FromBase64(uri, comma + 1, bytes);
  }
  const std::string plain = FromPercent(uri.substr(comma + 1));
  bytes.assign(plain.begin(), plain.end());
  return true;
}
}
