// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTXmlCheck.h"

#include "vtkMTByteSource.h"
#include "vtkMTTextFormat.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr std::size_t BlockSize = std::size_t(1) << 20;
constexpr std::size_t Overlap = 128; // longer than a name with its value

// The value of name="value" that the text begins with after the name; empty where there is none.
std::string_view GetValue(std::string_view text)
{
  const std::size_t equals = text.find('=');
  const std::size_t quote = equals == std::string_view::npos ? equals : text.find_first_of("\"'", equals);
  const std::size_t end = quote == std::string_view::npos ? quote : text.find(text[quote], quote + 1);
  return end == std::string_view::npos ? std::string_view() : text.substr(quote + 1, end - quote - 1);
}
}

vtkMTXmlCheck::vtkMTXmlCheck(const vtkMTByteSource& bytes)
  : Bytes(bytes)
{
  std::string error;
  std::string head(static_cast<std::size_t>(std::min<std::uint64_t>(4096, bytes.GetSize())), '\0');
  if (!bytes.Read(0, head.size(), head.data(), error))
  {
    return;
  }
  const std::size_t begin = head.find("<VTKFile");
  const std::size_t end = begin == std::string::npos ? begin : head.find('>', begin);
  if (end == std::string::npos)
  {
    return;
  }
  const std::string_view root = std::string_view(head).substr(begin, end - begin);
  const std::size_t type = root.find(" type");
  this->Type = type == std::string_view::npos ? "" : std::string(GetValue(root.substr(type)));
  this->IsCompressed = root.find("compressor") != std::string_view::npos;
}

bool vtkMTXmlCheck::CheckCounts(std::string& error) const
{
  std::vector<char> block;
  for (std::uint64_t from = 0; from < this->Bytes.GetSize(); from += BlockSize)
  {
    block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(BlockSize + Overlap, this->Bytes.GetSize() - from)));
    if (!this->Bytes.Read(from, block.size(), block.data(), error))
    {
      return false;
    }
    const std::string_view text(block.data(), block.size());
    const std::size_t appended = text.find("<AppendedData"); // what follows is no text
    if (!this->CheckBlock(text.substr(0, appended), error))
    {
      return false;
    }
    if (appended != std::string_view::npos)
    {
      return true;
    }
  }
  return true;
}

bool vtkMTXmlCheck::CheckBlock(std::string_view text, std::string& error) const
{
  // A point or a cell takes at least a byte; the best compressors make a thousandth of their bytes.
  const double most = static_cast<double>(this->Bytes.GetSize()) * (this->IsCompressed ? 1024.0 : 1.0);
  for (std::size_t place = text.find("NumberOf"); place != std::string_view::npos;
       place = text.find("NumberOf", place + 1))
  {
    const std::string_view rest = text.substr(place, Overlap);
    const std::string_view value = GetValue(rest);
    double number = 0.0;
    if (vtkMTTextFormat::ToNumber(value, number) && !(number >= 0.0 && number <= most))
    {
      error = std::string(rest.substr(0, rest.find('='))) + " is " + std::string(value.substr(0, 40)) +
        ", for which its size does not suffice: it is truncated, or damaged";
      return false;
    }
  }
  return true;
}
