// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInflate.h"

#include "vtkMTByteSource.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

namespace
{
class Inflater
{
public:
  Inflater(const vtkMTByteSource& source, std::uint64_t offset)
    : Source(source)
    , Offset(offset)
    , Packed(std::size_t(1) << 18)
  {
    this->IsReady = inflateInit2(&this->State, 15 + 32) == Z_OK; // either form, by its first bytes
  }
  ~Inflater() { inflateEnd(&this->State); } // which does nothing where it was not begun
  Inflater(const Inflater&) = delete;
  void operator=(const Inflater&) = delete;

  bool Take(std::size_t count, unsigned char* to, std::string& error)
  {
    while (count > 0 && this->IsReady)
    {
      if (this->State.avail_in == 0 && !this->Fill(error))
      {
        return false;
      }
      const std::size_t part = std::min<std::size_t>(count, 1 << 30);
      this->State.next_out = to;
      this->State.avail_out = static_cast<unsigned>(part);
      const int code = inflate(&this->State, Z_NO_FLUSH);
      this->IsBetween = code == Z_STREAM_END;
      const std::size_t done = part - this->State.avail_out;
      to += done;
      count -= done;
      // Another member may follow.
      this->IsReady = code == Z_STREAM_END ? inflateReset(&this->State) == Z_OK : code == Z_OK || code == Z_BUF_ERROR;
    }
    error = this->IsReady ? error : "its packed samples are damaged";
    return this->IsReady;
  }

  // Goes on to the end of the member, unless the last byte was its last: there its checksum is compared.
  bool Finish(std::string& error)
  {
    std::vector<unsigned char> rest(this->IsBetween ? 0 : std::size_t(1) << 16);
    while (!this->IsBetween)
    {
      if (this->State.avail_in == 0 && !this->Fill(error))
      {
        return false;
      }
      this->State.next_out = rest.data();
      this->State.avail_out = static_cast<unsigned>(rest.size());
      const int code = inflate(&this->State, Z_NO_FLUSH);
      this->IsBetween = code == Z_STREAM_END;
      if (!this->IsBetween && code != Z_OK && code != Z_BUF_ERROR)
      {
        error = "its packed samples are damaged";
        return false;
      }
    }
    return true;
  }

private:
  bool Fill(std::string& error)
  {
    const std::uint64_t size = this->Source.GetSize();
    const auto count =
      static_cast<std::size_t>(std::min<std::uint64_t>(this->Packed.size(), size - std::min(size, this->Offset)));
    if (count == 0)
    {
      error = "its packed samples end too early: it is truncated";
      return false;
    }
    if (!this->Source.Read(this->Offset, count, this->Packed.data(), error))
    {
      return false;
    }
    this->Offset += count;
    this->State.next_in = this->Packed.data();
    this->State.avail_in = static_cast<unsigned>(count);
    return true;
  }

  const vtkMTByteSource& Source;
  std::uint64_t Offset;
  std::vector<unsigned char> Packed;
  z_stream State{};
  bool IsReady = false;
  bool IsBetween = false;
};
}

bool vtkMTInflate(const vtkMTByteSource& source, std::uint64_t offset, std::uint64_t skip, std::size_t count,
  void* destination, bool toEnd, std::string& error)
{
  Inflater inflater(source, offset);
  std::vector<unsigned char> skipped(static_cast<std::size_t>(std::min<std::uint64_t>(skip, 1 << 16)));
  while (skip > 0)
  {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(skip, skipped.size()));
    if (!inflater.Take(part, skipped.data(), error))
    {
      return false;
    }
    skip -= part;
  }
  return inflater.Take(count, static_cast<unsigned char*>(destination), error) && (!toEnd || inflater.Finish(error));
}
