// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFileBlocks.h"

#include "vtkMTByteSource.h"
#include "vtkMTChecksum.h"

#include <algorithm>
#include <array>
#include <cstring>

using namespace vtkMTFileFormat;

namespace
{
// What is read first: the header, the checksums of some thousand pages, and the first page.
constexpr std::uint64_t HeadBytes = 98304;

//------------------------------------------------------------------------------
std::uint64_t CountPages(std::uint64_t bytes)
{
  return (bytes + PageSize - 1) / PageSize;
}

//------------------------------------------------------------------------------
// 8 bytes of checksum behind header and table.
std::uint64_t GetHeaderSize(std::size_t blocks)
{
  return std::max<std::uint64_t>(256, Align(sizeof(Header) + blocks * sizeof(BlockRecord) + sizeof(std::uint64_t)));
}

//------------------------------------------------------------------------------
// The version says what the other bytes mean, so it comes before all checksums.
bool CheckVersion(const std::vector<unsigned char>& head, std::string& error)
{
  if (!vtkMTFileBlocks::HasMagic(head.data(), head.size()))
  {
    error = head.empty() ? "it is empty" : "it is not a Multi-Triangulation file";
    return false;
  }
  std::uint32_t version = 0;
  std::memcpy(&version, head.data() + offsetof(Header, Version), std::min<std::size_t>(4, head.size() - 8));
  const std::string number = std::to_string(version);
  if (head.size() >= 12 && version > Version)
  {
    error = "it is of version " + number + " of the format, which is newer than version " + std::to_string(Version) +
      ", the newest that this program reads";
  }
  else if (head.size() < 12)
  {
    error = "it is truncated within its header";
  }
  else if (version == 0)
  {
    error = "version 0 of the format does not exist";
  }
  else if (version < Version)
  {
    error = "it is of version " + number +
      " of the format, which is not read any more; make it again from its mesh: " + "bmt build MESH -o MODEL.bmt";
  }
  return error.empty();
}

// An impossible header may leave none to copy, and then there is no address either.
template <class Record>
void CopyRecords(const unsigned char* bytes, std::vector<Record>& records)
{
  if (!records.empty())
  {
    std::memcpy(static_cast<void*>(records.data()), bytes, records.size() * sizeof(Record));
  }
}
}

//------------------------------------------------------------------------------
bool vtkMTFileBlocks::HasMagic(const unsigned char* bytes, std::size_t count)
{
  return count >= sizeof(Magic) && std::memcmp(bytes, Magic, sizeof(Magic)) == 0;
}

//------------------------------------------------------------------------------
BlockRecord vtkMTFileBlocks::Get(BlockType type) const
{
  const auto found =
    std::find_if(this->Table.begin(), this->Table.end(), [type](const BlockRecord& b) { return b.Type == type; });
  return found == this->Table.end() ? BlockRecord{ type, 0, this->Header.PageOffset, 0 } : *found;
}

//------------------------------------------------------------------------------
bool vtkMTFileBlocks::CheckHeader(const std::vector<unsigned char>& head, std::uint64_t size, std::string& error)
{
  if (head.size() < sizeof(this->Header))
  {
    error = "it is truncated within its header";
    return false;
  }
  std::memcpy(&this->Header, head.data(), sizeof(this->Header));
  const std::uint64_t headerSize = this->Header.HeaderSize;
  std::uint64_t checksum = 0;
  const bool fits = headerSize <= std::min<std::uint64_t>(HeaderSizeLimit, head.size()) &&
    this->Header.BlockCount < HeaderSizeLimit && headerSize == GetHeaderSize(this->Header.BlockCount);
  if (fits)
  {
    std::memcpy(&checksum, head.data() + headerSize - sizeof(checksum), sizeof(checksum));
  }
  if (!fits || vtkMTChecksum(head.data(), static_cast<std::size_t>(headerSize) - sizeof(checksum)) != checksum)
  {
    error = "its header is damaged: the checksum is wrong";
    return false;
  }
  if (this->Header.FileSize != size)
  {
    error = "it has " + std::to_string(size) + " bytes and should have " + std::to_string(this->Header.FileSize) +
      (size < this->Header.FileSize ? ": it is truncated" : ": something was added to it");
    return false;
  }
  this->Table.resize(this->Header.BlockCount);
  CopyRecords(head.data() + sizeof(this->Header), this->Table);
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFileBlocks::CheckTable(std::string& error) const
{
  const vtkMTFileFormat::Header& h = this->Header;
  const BlockRecord pages = this->Get(PageBlock);
  bool good = h.PageBytes == PageSize && h.Reserved == 0 && h.PageOffset <= h.SectionOffset &&
    h.SectionOffset <= h.FileSize && h.SectionOffset % SectionStart == 0 && pages.Offset == h.HeaderSize &&
    pages.Size == 8 * CountPages(h.SectionOffset - h.PageOffset) && h.PageOffset == pages.Offset + Align(pages.Size);
  std::vector<BlockRecord> blocks = this->Table;
  std::sort(
    blocks.begin(), blocks.end(), [](const BlockRecord& a, const BlockRecord& b) { return a.Offset < b.Offset; });
  std::uint64_t next = h.HeaderSize;
  std::array<int, NumberOfBlockTypes> times{};
  for (const BlockRecord& block : blocks)
  {
    const bool isKnown = block.Type > 0 && block.Type < NumberOfBlockTypes;
    if (!isKnown && (block.Flags & MustBeKnown) != 0)
    {
      error = "it has a block of type " + std::to_string(block.Type) + ", which a newer program must read";
      return false;
    }
    good = good && block.Flags <= MustBeKnown && block.Offset % Alignment == 0 && block.Offset >= next &&
      block.Offset <= h.SectionOffset && block.Size <= h.SectionOffset - block.Offset;
    good = good && (!isKnown || ++times[block.Type] == 1);
    next = good ? block.Offset + block.Size : next;
  }
  error = good ? error : "its header is impossible: blocks overlap or pass the end";
  return good;
}

//------------------------------------------------------------------------------
bool vtkMTFileBlocks::ReadPageChecksums(
  const vtkMTByteSource& bytes, const std::vector<unsigned char>& head, std::string& error)
{
  const auto size = static_cast<std::size_t>(this->Header.PageOffset - this->Header.HeaderSize); // padding included
  std::vector<unsigned char> block(size);
  if (this->Header.PageOffset <= head.size())
  {
    std::copy_n(head.begin() + this->Header.HeaderSize, size, block.begin());
  }
  else if (!bytes.Read(this->Header.HeaderSize, size, block.data(), error))
  {
    return false;
  }
  if (vtkMTChecksum(block.data(), size) != this->Header.PageChecksum)
  {
    error = "the checksums of its pages are damaged";
    return false;
  }
  this->PageChecksums.resize(static_cast<std::size_t>(this->Get(PageBlock).Size / sizeof(std::uint64_t)));
  CopyRecords(block.data(), this->PageChecksums);
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFileBlocks::Read(const vtkMTByteSource& bytes, std::vector<unsigned char>& head, std::string& error)
{
  head.resize(static_cast<std::size_t>(std::min(HeadBytes, bytes.GetSize())));
  return bytes.Read(0, head.size(), head.data(), error) && CheckVersion(head, error) &&
    this->CheckHeader(head, bytes.GetSize(), error) && this->CheckTable(error) &&
    this->ReadPageChecksums(bytes, head, error);
}

//------------------------------------------------------------------------------
// The more pages there are, the later the first one begins; a page more at most once or twice.
void vtkMTFileBlocks::Place()
{
  vtkMTFileFormat::Header& h = this->Header;
  h.HeaderSize = static_cast<std::uint32_t>(GetHeaderSize(this->Table.size()));
  std::uint64_t content = 0;
  for (std::size_t i = 1; i < this->Table.size(); ++i)
  {
    content += Align(this->Table[i].Size);
  }
  std::uint64_t pages = CountPages(content);
  for (std::uint64_t before = pages + 1; before != pages;)
  {
    before = pages;
    h.PageOffset = h.HeaderSize + Align(8 * pages);
    h.SectionOffset = (h.PageOffset + content + SectionStart - 1) / SectionStart * SectionStart;
    pages = CountPages(h.SectionOffset - h.PageOffset);
  }
  this->Table[0].Offset = h.HeaderSize;
  this->Table[0].Size = 8 * pages;
  std::uint64_t next = h.PageOffset;
  for (std::size_t i = 1; i < this->Table.size(); ++i)
  {
    this->Table[i].Offset = next;
    next += Align(this->Table[i].Size);
  }
}

//------------------------------------------------------------------------------
void vtkMTFileBlocks::Seal(std::uint64_t fileSize, std::vector<unsigned char>& bytes)
{
  vtkMTFileFormat::Header& h = this->Header;
  std::memcpy(h.Magic, Magic, sizeof(Magic));
  h.Version = Version;
  h.FileSize = fileSize;
  h.PageBytes = PageSize;
  h.BlockCount = static_cast<std::uint32_t>(this->Table.size());
  unsigned char* to = bytes.data() + h.HeaderSize;
  for (std::uint64_t page = h.PageOffset; page < h.SectionOffset; page += PageSize)
  {
    const std::uint64_t checksum =
      vtkMTChecksum(bytes.data() + page, static_cast<std::size_t>(std::min(PageSize, h.SectionOffset - page)));
    std::memcpy(to, &checksum, sizeof(checksum));
    to += sizeof(checksum);
  }
  h.PageChecksum = vtkMTChecksum(bytes.data() + h.HeaderSize, static_cast<std::size_t>(h.PageOffset - h.HeaderSize));
  std::memcpy(bytes.data(), &h, sizeof(h));
  std::memcpy(bytes.data() + sizeof(h), this->Table.data(), this->Table.size() * sizeof(BlockRecord));
  const std::size_t end = h.HeaderSize - sizeof(std::uint64_t);
  const std::uint64_t checksum = vtkMTChecksum(bytes.data(), end);
  std::memcpy(bytes.data() + end, &checksum, sizeof(checksum));
}
