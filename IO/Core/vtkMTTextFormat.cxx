// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTextFormat.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>

namespace
{
constexpr std::size_t BlockSize = std::size_t(1) << 20;

bool IsSpace(char c)
{
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

std::string_view WithoutPlus(std::string_view token)
{
  const bool hasPlus = token.size() > 1 && token[0] == '+' && token[1] != '-' && token[1] != '+';
  return hasPlus ? token.substr(1) : token;
}

// What Microsoft's runtime library writes for NaN and infinity: "1.#QNAN", "-1.#IND00", "1.#INF".
template <typename Real>
bool ToSpecial(std::string_view token, Real& value)
{
  const bool isNegative = !token.empty() && token[0] == '-';
  token.remove_prefix(isNegative ? 1 : 0);
  if (token.substr(0, 3) != "1.#")
  {
    return false;
  }
  const std::string name = vtkMTTextFormat::ToLower(token.substr(3, 4));
  const bool isInfinite = name.substr(0, 3) == "inf";
  value = isInfinite ? std::numeric_limits<Real>::infinity() : std::numeric_limits<Real>::quiet_NaN();
  value = isNegative ? -value : value;
  return isInfinite || name.substr(0, 3) == "ind" || name == "qnan" || name == "snan";
}

// A number out of range: of the two reasons, being too small is told by its negative exponent.
template <typename Real>
bool ToReal(std::string_view token, Real& value)
{
  token = WithoutPlus(token);
  const char* end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, value);
  if (token.empty() || result.ptr != end || result.ec == std::errc::invalid_argument)
  {
    return ToSpecial(token, value);
  }
  if (result.ec == std::errc::result_out_of_range)
  {
    value = 0;
    const bool isSmall = token.find("e-") != std::string_view::npos || token.find("E-") != std::string_view::npos;
    const std::size_t digit = token.find_first_not_of("-0.");
    return isSmall ||
      (token.find_first_of("eE") == std::string_view::npos && digit != std::string_view::npos &&
        token.find('.') < digit);
  }
  return true;
}
}

namespace vtkMTTextFormat
{
std::string ToLower(std::string_view text)
{
  std::string lower(text);
  for (char& c : lower)
  {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return lower;
}

std::string GetLowerCaseEnding(const std::string& path)
{
  const std::size_t dot = path.rfind('.');
  const std::size_t slash = path.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash))
  {
    return "";
  }
  return ToLower(std::string_view(path).substr(dot + 1));
}

std::string_view NextToken(std::string_view& line)
{
  std::size_t begin = 0;
  while (begin < line.size() && IsSpace(line[begin]))
  {
    ++begin;
  }
  std::size_t end = begin;
  while (end < line.size() && !IsSpace(line[end]))
  {
    ++end;
  }
  const std::string_view token = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return token;
}

bool ToNumber(std::string_view token, double& value)
{
  return ToReal(token, value);
}

bool ToNumber(std::string_view token, float& value)
{
  return ToReal(token, value);
}

bool ToNumber(std::string_view token, std::int64_t& value)
{
  token = WithoutPlus(token);
  const char* end = token.data() + token.size();
  const std::from_chars_result result = std::from_chars(token.data(), end, value);
  return !token.empty() && result.ptr == end && result.ec == std::errc();
}

std::size_t GetByteOrderMarkSize(std::string_view begin)
{
  return begin.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
}

bool IsUtf16(std::string_view begin)
{
  const std::string_view mark = begin.substr(0, 2);
  const bool isMarked = mark == "\xFF\xFE" || mark == "\xFE\xFF";
  // Without a mark: letters of ASCII, each with a zero byte on the same side.
  const std::string_view letters = begin.substr(isMarked ? 2 : 0, 8);
  const auto isText = [letters](std::size_t zero)
  {
    bool good = letters.size() == 8;
    for (std::size_t i = 0; good && i < letters.size(); ++i)
    {
      const char c = letters[i];
      good = i % 2 == zero ? c == 0 : (c >= ' ' && c <= '~') || IsSpace(c);
    }
    return good;
  };
  return isText(0) || isText(1);
}

//------------------------------------------------------------------------------
Stream::Stream(const vtkMTByteSource& source)
  : Source(source)
{
}

// Drops what has been taken and appends a block; false at the end and on failure.
bool Stream::Fill()
{
  this->Buffer.erase(this->Buffer.begin(), this->Buffer.begin() + static_cast<std::ptrdiff_t>(this->Next));
  this->Offset += this->Next;
  this->Next = 0;
  const std::uint64_t from = this->Offset + this->Buffer.size();
  const std::size_t count = static_cast<std::size_t>(std::min<std::uint64_t>(BlockSize, this->Source.GetSize() - from));
  if (count == 0)
  {
    return false;
  }
  const std::size_t kept = this->Buffer.size();
  this->Buffer.resize(kept + count);
  if (!this->Source.Read(from, count, this->Buffer.data() + kept, this->Error))
  {
    this->Buffer.resize(kept);
    return false;
  }
  return true;
}

const unsigned char* Stream::Take(std::size_t count)
{
  while (this->Buffer.size() - this->Next < count)
  {
    if (!this->Fill())
    {
      return nullptr;
    }
  }
  const unsigned char* bytes = this->Buffer.data() + this->Next;
  this->Next += count;
  return bytes;
}

bool Stream::Skip(std::uint64_t count)
{
  if (count > this->GetLeft())
  {
    return false;
  }
  const std::size_t buffered = this->Buffer.size() - this->Next;
  if (count <= buffered)
  {
    this->Next += static_cast<std::size_t>(count);
    return true;
  }
  this->Offset = this->GetPosition() + count;
  this->Buffer.clear();
  this->Next = 0;
  return true;
}

void Stream::SkipByteOrderMark()
{
  while (this->Buffer.size() - this->Next < 3 && this->Fill())
  {
  }
  const auto [bytes, size] = this->GetBuffered();
  this->Next += GetByteOrderMarkSize(std::string_view(reinterpret_cast<const char*>(bytes), size));
}

bool Stream::TakeLine(std::string_view& line)
{
  std::size_t looked = 0; // bytes after Next that hold no end of line
  while (true)
  {
    const std::size_t size = this->Buffer.size() - this->Next;
    const char* begin = reinterpret_cast<const char*>(this->Buffer.data() + this->Next);
    const char* end = std::find_if(begin + looked, begin + size, [](char c) { return c == '\n' || c == '\r'; });
    // After \r one more byte must be in memory to see whether it is \r\n.
    if (end != begin + size && (*end == '\n' || end + 1 != begin + size || this->GetLeft() == size))
    {
      line = std::string_view(begin, static_cast<std::size_t>(end - begin));
      const bool isPair = *end == '\r' && end + 1 != begin + size && end[1] == '\n';
      this->Next += line.size() + (isPair ? 2 : 1);
      this->LineEnd = isPair ? ReturnAndNewLine : *end == '\r' ? Return : NewLine;
      return true;
    }
    looked = static_cast<std::size_t>(end - begin);
    if (looked > LargestLine)
    {
      this->Error = "a line is longer than " + std::to_string(LargestLine) + " bytes";
      return false;
    }
    if (!this->Fill())
    {
      begin = reinterpret_cast<const char*>(this->Buffer.data() + this->Next);
      line = std::string_view(begin, this->Buffer.size() - this->Next);
      this->Next = this->Buffer.size();
      this->LineEnd = NoEnd;
      return this->Error.empty() && !line.empty();
    }
  }
}
}
