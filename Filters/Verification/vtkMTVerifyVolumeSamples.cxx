// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyVolumeSamples.h"

#include "vtkMTVerifyVolumeBytes.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>

using namespace vtkMTVerifyVolumeBytes;

namespace
{
/// No compressed or written form has fewer bytes than this share of what it stands for.
constexpr std::size_t MostExpansion = 1100;

/// Where the given number of lines ends; the end of the bytes where there are fewer.
std::size_t SkipLines(const Bytes& bytes, std::size_t from, std::int64_t lines)
{
  for (; lines > 0 && from < bytes.size(); --lines)
  {
    const void* end = std::memchr(bytes.data() + from, '\n', bytes.size() - from);
    from = end ? static_cast<std::size_t>(static_cast<const unsigned char*>(end) - bytes.data()) + 1 : bytes.size();
  }
  return from;
}

Bytes ParseHex(const Bytes& stored, std::size_t from)
{
  Bytes bytes;
  int high = -1;
  for (std::size_t i = from; i < stored.size(); ++i)
  {
    if (std::isxdigit(stored[i]))
    {
      const int digit = std::isdigit(stored[i]) ? stored[i] - '0' : std::tolower(stored[i]) - 'a' + 10;
      if (high < 0)
      {
        high = digit;
        continue;
      }
      bytes.push_back(static_cast<unsigned char>(16 * high + digit));
      high = -1;
    }
  }
  return bytes;
}

void Swap(unsigned char* bytes, std::size_t count, std::size_t size)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    std::reverse(bytes + i * size, bytes + (i + 1) * size);
  }
}
}

vtkMTVerifyVolumeSamples::vtkMTVerifyVolumeSamples(const vtkMTVerifyVolumeHeader& header)
  : Header(header)
{
}

vtkSmartPointer<vtkDataArray> vtkMTVerifyVolumeSamples::Read(std::string& error)
{
  const std::int64_t samples = this->Header.GetNumberOfSamples();
  const auto files = static_cast<std::int64_t>(this->Header.Files.size());
  if (samples * this->Header.Volumes % files != 0)
  {
    error = std::to_string(files) + " files of samples for " + std::to_string(samples) + " samples";
    return nullptr;
  }
  const std::size_t perFile = static_cast<std::size_t>(samples * this->Header.Volumes / files);
  this->Samples.TakeReference(vtkDataArray::CreateDataArray(this->Header.Type));
  this->SampleSize = static_cast<std::size_t>(this->Samples->GetDataTypeSize());
  std::size_t left = static_cast<std::size_t>(samples) * this->SampleSize;
  for (const vtkMTVerifyVolumeHeader::DataFile& file : this->Header.Files)
  {
    const std::size_t wanted = std::min(left, perFile * this->SampleSize);
    if (wanted > 0 && !this->AppendFile(file, wanted, error))
    {
      return nullptr;
    }
    left -= wanted;
  }
  return this->Scale(this->Samples);
}

bool vtkMTVerifyVolumeSamples::AppendFile(
  const vtkMTVerifyVolumeHeader::DataFile& file, std::size_t wanted, std::string& error)
{
  Bytes stored;
  if (!ReadFile(file.Path, stored, error))
  {
    return false;
  }
  const std::size_t from = SkipLines(stored,
    std::min(static_cast<std::size_t>(std::max<std::int64_t>(file.Offset, 0)), stored.size()), this->Header.LineSkip);
  // Looked at before memory is taken: a header may promise anything.
  if ((stored.size() - from) < wanted / MostExpansion)
  {
    error = file.Path + ": " + std::to_string(stored.size() - from) + " bytes, too few for the samples";
    return false;
  }
  this->Samples->SetNumberOfTuples(this->Header.GetNumberOfSamples());
  auto* target = static_cast<unsigned char*>(this->Samples->GetVoidPointer(0)) + this->Filled;
  if (this->Header.Encoding == vtkMTVerifyVolumeHeader::Encodings::Ascii)
  {
    if (!this->ParseText(stored, from, error))
    {
      error = file.Path + ": " + error;
      return false;
    }
    return true;
  }
  Bytes decoded;
  if (!this->Decode(stored, from, wanted, decoded, error))
  {
    error = file.Path + ": " + error;
    return false;
  }
  const bool isRaw = this->Header.Encoding == vtkMTVerifyVolumeHeader::Encodings::Raw;
  const Bytes& bytes = isRaw ? stored : decoded;
  const std::size_t first = isRaw ? from : 0;
  const std::size_t skip = static_cast<std::size_t>(std::max<std::int64_t>(this->Header.ByteSkip, 0));
  const std::size_t there = bytes.size() - first;
  if (there < wanted || there - wanted < skip)
  {
    error = file.Path + ": " + std::to_string(there) + " bytes, too few for the samples";
    return false;
  }
  const std::size_t at = this->Header.ByteSkip < 0 ? bytes.size() - wanted : first + skip;
  std::memcpy(target, bytes.data() + at, wanted);
  const std::uint16_t one = 1;
  if (this->Header.IsBigEndian == (*reinterpret_cast<const unsigned char*>(&one) == 1))
  {
    Swap(target, wanted / this->SampleSize, this->SampleSize);
  }
  this->Filled += wanted;
  return true;
}

bool vtkMTVerifyVolumeSamples::Decode(
  const Bytes& stored, std::size_t from, std::size_t wanted, Bytes& decoded, std::string& error) const
{
  if (this->Header.Encoding == vtkMTVerifyVolumeHeader::Encodings::Hex)
  {
    decoded = ParseHex(stored, from);
  }
  else if (this->Header.Encoding == vtkMTVerifyVolumeHeader::Encodings::Deflate)
  {
    const std::size_t limit =
      this->Header.ByteSkip < 0 ? NoLimit : wanted + static_cast<std::size_t>(this->Header.ByteSkip);
    return Inflate(stored.data() + from, stored.size() - from, limit, decoded, error);
  }
  return true;
}

bool vtkMTVerifyVolumeSamples::ParseText(const Bytes& stored, std::size_t from, std::string& error)
{
  const std::size_t skip = static_cast<std::size_t>(std::max<std::int64_t>(this->Header.ByteSkip, 0));
  std::string text(stored.begin() + static_cast<std::ptrdiff_t>(std::min(from + skip, stored.size())), stored.end());
  std::replace(text.begin(), text.end(), ',', ' ');
  const char* at = text.c_str();
  const auto count = this->Samples->GetNumberOfTuples();
  const auto files = static_cast<vtkIdType>(this->Header.Files.size());
  const auto first = static_cast<vtkIdType>(this->Filled / this->SampleSize);
  const vtkIdType last = std::min<vtkIdType>(count, first + count * this->Header.Volumes / files);
  for (vtkIdType i = first; i < last; ++i)
  {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at)
    {
      error = "sample " + std::to_string(i) + " of " + std::to_string(count) + " is no number";
      return false;
    }
    this->Samples->SetComponent(i, 0, value);
    at = end;
  }
  this->Filled = static_cast<std::size_t>(last) * this->SampleSize;
  return true;
}

vtkSmartPointer<vtkDataArray> vtkMTVerifyVolumeSamples::Scale(vtkDataArray* samples) const
{
  if (this->Header.Slope == 1.0 && this->Header.Intercept == 0.0)
  {
    return samples;
  }
  vtkSmartPointer<vtkDoubleArray> scaled = vtkSmartPointer<vtkDoubleArray>::New();
  scaled->SetNumberOfTuples(samples->GetNumberOfTuples());
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
  {
    scaled->SetValue(i, this->Header.Slope * samples->GetComponent(i, 0) + this->Header.Intercept);
  }
  return scaled;
}
