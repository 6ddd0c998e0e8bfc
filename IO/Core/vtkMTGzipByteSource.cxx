// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGzipByteSource.h"

#include "vtkMTFileByteSource.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include <zlib.h>

namespace
{
constexpr std::size_t BlockSize = std::size_t(1) << 18;
constexpr std::size_t MostCopies = 256;

// The decompressor's state between two bytes.
struct Place
{
  z_stream Zlib{};
  std::uint64_t Input = 0;  // the compressed byte that comes next
  std::uint64_t Output = 0; // the byte that comes next
  bool IsAtEnd = false;

  Place()
  {
    constexpr int withGzipHeader = 16 + MAX_WBITS;
    if (inflateInit2(&this->Zlib, withGzipHeader) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  Place(const Place& other) { this->Copy(other); }
  Place& operator=(const Place& other)
  {
    if (this != &other)
    {
      inflateEnd(&this->Zlib);
      this->Copy(other);
    }
    return *this;
  }
  ~Place() { inflateEnd(&this->Zlib); }

private:
  void Copy(const Place& other)
  {
    if (inflateCopy(&this->Zlib, const_cast<z_stream*>(&other.Zlib)) != Z_OK)
    {
      throw std::bad_alloc();
    }
    this->Zlib.avail_in = 0;
    this->Input = other.Input;
    this->Output = other.Output;
    this->IsAtEnd = other.IsAtEnd;
  }
};
}

//------------------------------------------------------------------------------
class vtkMTGzipByteSource::Decompressor
{
public:
  explicit Decompressor(const vtkMTByteSource& source)
    : Source(source)
  {
    this->Copies.reserve(MostCopies + 1);
    this->Copies.push_back(this->Now);
  }

  bool FindSize(std::uint64_t& size, std::string& error)
  {
    std::vector<unsigned char> unwanted(BlockSize);
    while (!this->Now.IsAtEnd)
    {
      std::size_t got = 0;
      if (!this->Take(unwanted.data(), unwanted.size(), got, error))
      {
        return false;
      }
      if (this->Now.Output >= this->Copies.back().Output + this->Distance)
      {
        this->KeepCopy();
      }
    }
    size = this->Now.Output;
    return true;
  }

  bool Read(std::uint64_t offset, std::size_t count, unsigned char* to, std::string& error)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->GoBefore(offset);
    std::vector<unsigned char> unwanted;
    while (this->Now.Output < offset)
    {
      unwanted.resize(static_cast<std::size_t>(std::min<std::uint64_t>(BlockSize, offset - this->Now.Output)));
      std::size_t got = 0;
      if (!this->Take(unwanted.data(), unwanted.size(), got, error))
      {
        return false;
      }
    }
    while (count > 0)
    {
      std::size_t got = 0;
      if (!this->Take(to, count, got, error))
      {
        return false;
      }
      to += got;
      count -= got;
    }
    return true;
  }

private:
  bool Fail(const std::string& reason, std::string& error) const
  {
    error = this->Source.GetName() + ": " + reason;
    return false;
  }

  void KeepCopy()
  {
    this->Copies.push_back(this->Now);
    if (this->Copies.size() > MostCopies)
    {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < this->Copies.size(); i += 2)
      {
        this->Copies[kept++] = this->Copies[i];
      }
      this->Copies.resize(kept);
      this->Distance *= 2;
    }
  }

  // To the last known place from which the offset is ahead.
  void GoBefore(std::uint64_t offset)
  {
    const auto after = std::upper_bound(this->Copies.begin(), this->Copies.end(), offset,
      [](std::uint64_t wanted, const Place& place) { return wanted < place.Output; });
    const Place& place = *std::prev(after); // the first is at 0
    if (this->Now.Output > offset || this->Now.Output < place.Output)
    {
      this->Now = place;
    }
  }

  // At most count bytes, at least one, unless there are none left.
  bool Take(unsigned char* to, std::size_t count, std::size_t& got, std::string& error)
  {
    z_stream& zlib = this->Now.Zlib;
    const std::size_t wanted = std::min(count, BlockSize);
    zlib.next_out = to;
    zlib.avail_out = static_cast<uInt>(wanted);
    while (zlib.avail_out > 0 && !this->Now.IsAtEnd)
    {
      if (!this->Fill(1, error))
      {
        return false;
      }
      const uInt before = zlib.avail_in;
      const int result = inflate(&zlib, Z_NO_FLUSH);
      this->Now.Input += before - zlib.avail_in;
      if (result == Z_STREAM_END)
      {
        if (!this->GoToNextMember(error))
        {
          return false;
        }
      }
      else if (result != Z_OK || (before == 0 && zlib.avail_out > 0))
      {
        return this->Fail(before == 0 ? "is truncated: its compressed data end early"
                                      : "its compressed data are damaged near byte " + std::to_string(this->Now.Input),
          error);
      }
    }
    got = wanted - zlib.avail_out;
    this->Now.Output += got;
    return got > 0 || this->Now.IsAtEnd ? true : this->Fail("its compressed data are damaged", error);
  }

  // What follows the last member, such as zeros of a tape, is none of the data.
  bool GoToNextMember(std::string& error)
  {
    z_stream& zlib = this->Now.Zlib;
    if (!this->Fill(2, error))
    {
      return false;
    }
    this->Now.IsAtEnd = zlib.avail_in < 2 || zlib.next_in[0] != 0x1f || zlib.next_in[1] != 0x8b;
    return this->Now.IsAtEnd || inflateReset(&zlib) == Z_OK || this->Fail("its compressed data are damaged", error);
  }

  // At least so many bytes of input, where there are.
  bool Fill(uInt least, std::string& error)
  {
    z_stream& zlib = this->Now.Zlib;
    if (zlib.avail_in >= least)
    {
      return true;
    }
    const std::uint64_t left = this->Source.GetSize() - this->Now.Input;
    this->Block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(BlockSize, left)));
    zlib.next_in = this->Block.data();
    zlib.avail_in = static_cast<uInt>(this->Block.size());
    return this->Block.empty() || this->Source.Read(this->Now.Input, this->Block.size(), this->Block.data(), error);
  }

  const vtkMTByteSource& Source;
  Place Now;
  std::vector<Place> Copies; // in order of their places
  std::uint64_t Distance = std::uint64_t(1) << 22;
  std::vector<unsigned char> Block; // of the input, of which Now has taken a part
  std::mutex Mutex;
};

//------------------------------------------------------------------------------
vtkMTGzipByteSource::vtkMTGzipByteSource(std::unique_ptr<vtkMTByteSource> compressed)
  : Compressed(std::move(compressed))
  , State(std::make_unique<Decompressor>(*this->Compressed))
{
}

vtkMTGzipByteSource::~vtkMTGzipByteSource() = default;

bool vtkMTGzipByteSource::IsGzip(const vtkMTByteSource& bytes)
{
  unsigned char head[3] = {};
  std::string error;
  return bytes.GetSize() >= sizeof(head) && bytes.Read(0, sizeof(head), head, error) && head[0] == 0x1f &&
    head[1] == 0x8b && head[2] == 8;
}

std::unique_ptr<vtkMTGzipByteSource> vtkMTGzipByteSource::Open(
  std::unique_ptr<vtkMTByteSource> compressed, std::string& error)
{
  std::unique_ptr<vtkMTGzipByteSource> source(new vtkMTGzipByteSource(std::move(compressed)));
  return source->State->FindSize(source->Size, error) ? std::move(source) : nullptr;
}

std::unique_ptr<vtkMTByteSource> vtkMTGzipByteSource::OpenFile(const std::string& path, std::string& error)
{
  std::unique_ptr<vtkMTByteSource> bytes = vtkMTFileByteSource::Open(path, error);
  return bytes && IsGzip(*bytes) ? std::unique_ptr<vtkMTByteSource>(Open(std::move(bytes), error)) : std::move(bytes);
}

bool vtkMTGzipByteSource::Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const
{
  if (offset > this->Size || count > this->Size - offset)
  {
    error = this->GetName() + ": bytes " + std::to_string(offset) + " to " + std::to_string(offset + count) +
      " lie beyond the end at " + std::to_string(this->Size);
    return false;
  }
  return this->State->Read(offset, count, static_cast<unsigned char*>(destination), error);
}
