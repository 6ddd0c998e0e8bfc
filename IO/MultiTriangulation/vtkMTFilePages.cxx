// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFilePages.h"

#include "vtkMTByteSource.h"
#include "vtkMTChecksum.h"

#include <algorithm>
#include <cstring>
#include <utility>

using vtkMTFileFormat::PageSize;

//------------------------------------------------------------------------------
vtkMTFilePages::vtkMTFilePages(
  const vtkMTByteSource& source, const vtkMTFileBlocks& blocks, std::vector<unsigned char> head)
  : Source(source)
  , Blocks(blocks)
  , Head(std::move(head))
  , BytesRead(this->Head.size())
{
  if (blocks.Header.PageOffset > this->Head.size())
  {
    this->BytesRead += blocks.Header.PageOffset - blocks.Header.HeaderSize;
  }
  for (const vtkMTFileFormat::BlockRecord& block : blocks.Table)
  {
    for (const std::uint64_t border : { block.Offset, block.Offset + block.Size })
    {
      if (border >= blocks.Header.PageOffset)
      {
        this->Shared.insert((border - blocks.Header.PageOffset) / PageSize);
      }
    }
  }
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTFilePages::GetOffset(std::uint64_t page) const
{
  return std::min(this->Blocks.Header.PageOffset + page * PageSize, this->Blocks.Header.SectionOffset);
}

//------------------------------------------------------------------------------
std::uint64_t vtkMTFilePages::GetPageEnd(std::uint64_t offset) const
{
  return this->GetOffset((offset - this->Blocks.Header.PageOffset + PageSize - 1) / PageSize);
}

//------------------------------------------------------------------------------
// Pages first to end - 1, into the buffer.
bool vtkMTFilePages::Fetch(std::uint64_t first, std::uint64_t end, std::string& error)
{
  const std::uint64_t begin = this->GetOffset(first);
  this->Buffer.resize(static_cast<std::size_t>(this->GetOffset(end) - begin));
  if (begin + this->Buffer.size() <= this->Head.size())
  {
    std::memcpy(this->Buffer.data(), this->Head.data() + begin, this->Buffer.size());
  }
  else
  {
    if (!this->Source.Read(begin, this->Buffer.size(), this->Buffer.data(), error))
    {
      return false;
    }
    this->BytesRead += this->Buffer.size();
  }
  for (std::uint64_t page = first; page < end; ++page)
  {
    const unsigned char* data = this->Buffer.data() + (this->GetOffset(page) - begin);
    const auto size = static_cast<std::size_t>(this->GetOffset(page + 1) - this->GetOffset(page));
    if (vtkMTChecksum(data, size) != this->Blocks.PageChecksums[static_cast<std::size_t>(page)])
    {
      error = "page " + std::to_string(page) + " of its DAG is damaged: the checksum is wrong";
      return false;
    }
    if (this->Shared.count(page) != 0)
    {
      this->Kept[page].assign(data, data + size);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTFilePages::Read(std::uint64_t offset, std::size_t count, unsigned char* destination, std::string& error)
{
  const std::uint64_t end = offset + count;
  while (offset < end)
  {
    const std::uint64_t page = (offset - this->Blocks.Header.PageOffset) / PageSize;
    const auto kept = this->Kept.find(page);
    const unsigned char* data = nullptr;
    std::uint64_t next = page + 1;
    if (kept != this->Kept.end())
    {
      data = kept->second.data();
    }
    else
    {
      while (this->GetOffset(next) < end && this->Kept.count(next) == 0)
      {
        ++next;
      }
      if (!this->Fetch(page, next, error))
      {
        return false;
      }
      data = this->Buffer.data();
    }
    const auto size = static_cast<std::size_t>(std::min(end, this->GetOffset(next)) - offset);
    std::memcpy(destination, data + (offset - this->GetOffset(page)), size);
    destination += size;
    offset += size;
  }
  return true;
}
