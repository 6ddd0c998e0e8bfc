// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyTerrainTiff.h"

#include "vtkMTVerifyVolumeBytes.h"

using namespace vtkMTVerifyVolumeBytes;

namespace
{
/// Bytes of a value of TIFF's types 1 to 18; 0 for those that do not exist.
std::uint64_t GetSize(int type)
{
  constexpr unsigned char sizes[] = { 0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8 };
  return type > 0 && type < 19 ? sizes[type] : 0;
}

double GetValue(const unsigned char* place, int type, bool isBig)
{
  switch (type)
  {
    case 3:
      return Get<std::uint16_t>(place, isBig);
    case 4:
    case 13:
      return Get<std::uint32_t>(place, isBig);
    case 5:
      return static_cast<double>(Get<std::uint32_t>(place, isBig)) / Get<std::uint32_t>(place + 4, isBig);
    case 6:
      return Get<std::int8_t>(place, isBig);
    case 8:
      return Get<std::int16_t>(place, isBig);
    case 9:
      return Get<std::int32_t>(place, isBig);
    case 10:
      return static_cast<double>(Get<std::int32_t>(place, isBig)) / Get<std::int32_t>(place + 4, isBig);
    case 11:
      return Get<float>(place, isBig);
    case 12:
      return Get<double>(place, isBig);
    case 16:
    case 18:
      return static_cast<double>(Get<std::uint64_t>(place, isBig));
    case 17:
      return static_cast<double>(Get<std::int64_t>(place, isBig));
    default:
      return *place;
  }
}
}

bool vtkMTVerifyTerrainTiff::IsWithin(std::uint64_t at, std::uint64_t size) const
{
  return at <= this->Bytes.size() && size <= this->Bytes.size() - at;
}

bool vtkMTVerifyTerrainTiff::Open(const std::string& path, std::string& error)
{
  if (!ReadFile(path, this->Bytes, error))
  {
    return false;
  }
  if (this->Bytes.size() < 16 || this->Bytes[0] != this->Bytes[1] || (this->Bytes[0] != 'I' && this->Bytes[0] != 'M'))
  {
    error = "it is not TIFF";
    return false;
  }
  this->IsBig = this->Bytes[0] == 'M';
  const unsigned char* head = this->Bytes.data();
  const int version = Get<std::uint16_t>(head + 2, this->IsBig);
  if (version != 42 && version != 43)
  {
    error = "it is not TIFF";
    return false;
  }
  const bool isBigTiff = version == 43;
  return this->ParseDirectory(
    isBigTiff ? Get<std::uint64_t>(head + 8, this->IsBig) : Get<std::uint32_t>(head + 4, this->IsBig), isBigTiff,
    error);
}

bool vtkMTVerifyTerrainTiff::ParseDirectory(std::uint64_t at, bool isBigTiff, std::string& error)
{
  const std::uint64_t countSize = isBigTiff ? 8 : 2;
  const std::uint64_t entrySize = isBigTiff ? 20 : 12;
  const std::uint64_t fieldSize = isBigTiff ? 8 : 4;
  error = "its directory is not within the file";
  if (!this->IsWithin(at, countSize))
  {
    return false;
  }
  const unsigned char* bytes = this->Bytes.data();
  const std::uint64_t count =
    isBigTiff ? Get<std::uint64_t>(bytes + at, this->IsBig) : Get<std::uint16_t>(bytes + at, this->IsBig);
  at += countSize;
  if (count > 65535 || !this->IsWithin(at, count * entrySize))
  {
    return false;
  }
  for (std::uint64_t i = 0; i < count; ++i, at += entrySize)
  {
    const unsigned char* place = bytes + at;
    Entry entry;
    entry.Type = Get<std::uint16_t>(place + 2, this->IsBig);
    entry.Count = isBigTiff ? Get<std::uint64_t>(place + 4, this->IsBig) : Get<std::uint32_t>(place + 4, this->IsBig);
    const std::uint64_t size = GetSize(entry.Type);
    const std::uint64_t field = at + 4 + fieldSize;
    // Values of few bytes are in the entry itself.
    entry.Offset = size > 0 && entry.Count <= fieldSize / size ? field
      : isBigTiff                                              ? Get<std::uint64_t>(bytes + field, this->IsBig)
                                                               : Get<std::uint32_t>(bytes + field, this->IsBig);
    if (size > 0 && entry.Count <= this->Bytes.size() / size && this->IsWithin(entry.Offset, entry.Count * size))
    {
      this->Entries.emplace(Get<std::uint16_t>(place, this->IsBig), entry);
    }
  }
  error.clear();
  return true;
}

std::vector<double> vtkMTVerifyTerrainTiff::GetNumbers(int tag) const
{
  std::vector<double> numbers;
  const auto found = this->Entries.find(tag);
  if (found != this->Entries.end())
  {
    const Entry& entry = found->second;
    for (std::uint64_t i = 0; i < entry.Count; ++i)
    {
      numbers.push_back(GetValue(this->Bytes.data() + entry.Offset + i * GetSize(entry.Type), entry.Type, this->IsBig));
    }
  }
  return numbers;
}

double vtkMTVerifyTerrainTiff::GetNumber(int tag, double otherwise) const
{
  const std::vector<double> numbers = this->GetNumbers(tag);
  return numbers.empty() ? otherwise : numbers.front();
}

std::string vtkMTVerifyTerrainTiff::GetText(int tag) const
{
  const auto found = this->Entries.find(tag);
  if (found == this->Entries.end() || found->second.Type != 2)
  {
    return std::string();
  }
  const char* text = reinterpret_cast<const char*>(this->Bytes.data()) + found->second.Offset;
  const std::string all(text, static_cast<std::size_t>(found->second.Count));
  return Trim(all.substr(0, all.find('\0')));
}
