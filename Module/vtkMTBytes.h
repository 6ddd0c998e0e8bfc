// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBytes
 * @brief numbers, lists and texts to bytes and back, in the machine's order, for what a builder puts aside
 *
 * For temporary data of one machine only: files that leave it have formats of their own. Reading checks every length
 * against the bytes that are left; once something was wrong, everything reads as zero and IsSound says so. Lists begin
 * at multiples of 8 bytes, so that one whose bytes lie at such an address is copied without being cleared before.
 */
#ifndef vtkMTBytes_h
#define vtkMTBytes_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace vtkMTBytes
{
constexpr std::size_t Alignment = 8;

class Writer
{
public:
  explicit Writer(std::vector<unsigned char>& bytes)
    : Bytes(bytes)
  {
  }

  template <typename Value>
  void Put(const Value& value)
  {
    static_assert(std::is_trivially_copyable<Value>::value, "only values without pointers");
    this->PutBytes(&value, sizeof(value));
  }
  template <typename Value>
  void PutList(const std::vector<Value>& list)
  {
    static_assert(std::is_trivially_copyable<Value>::value, "only values without pointers");
    this->Put<std::uint64_t>(list.size());
    this->Bytes.resize((this->Bytes.size() + Alignment - 1) / Alignment * Alignment);
    this->PutBytes(list.data(), list.size() * sizeof(Value));
  }
  void PutText(const std::string& text)
  {
    this->Put<std::uint64_t>(text.size());
    this->PutBytes(text.data(), text.size());
  }
  void PutCounts(const std::map<std::string, std::int64_t>& counts)
  {
    this->Put<std::uint64_t>(counts.size());
    for (const auto& [name, count] : counts)
    {
      this->PutText(name);
      this->Put(count);
    }
  }

private:
  void PutBytes(const void* data, std::size_t size)
  {
    const unsigned char* from = static_cast<const unsigned char*>(data);
    this->Bytes.insert(this->Bytes.end(), from, from + size);
  }

  std::vector<unsigned char>& Bytes;
};

/// A list that stays where it was written; it must outlive the view.
template <typename Value>
class View
{
public:
  View() = default;
  View(const unsigned char* bytes, std::size_t size)
    : Bytes(bytes)
    , Size(size)
  {
  }

  std::size_t size() const { return this->Size; }
  bool empty() const { return this->Size == 0; }
  /// The values, when they lie where such values may; else null.
  const Value* data() const
  {
    const bool isAligned = reinterpret_cast<std::uintptr_t>(this->Bytes) % alignof(Value) == 0;
    return isAligned ? reinterpret_cast<const Value*>(this->Bytes) : nullptr;
  }
  Value operator[](std::size_t i) const
  {
    Value value;
    std::memcpy(&value, this->Bytes + i * sizeof(Value), sizeof(Value)); // bytes have no alignment
    return value;
  }

private:
  const unsigned char* Bytes = nullptr;
  std::size_t Size = 0;
};

/// Bytes that stay where they are, with their owner, or that it owns itself.
class Record
{
public:
  Record() = default;
  Record(const std::vector<unsigned char>& bytes) // NOLINT(google-explicit-constructor): as good as the vector
    : Record(bytes.data(), bytes.size())
  {
  }
  Record(const unsigned char* bytes, std::size_t size)
    : Bytes(bytes)
    , Size(size)
  {
  }
  Record(Record&&) = default;
  Record& operator=(Record&&) = default;

  /// Room for its own bytes, for others to write to.
  unsigned char* Allocate(std::size_t size)
  {
    this->Own.resize(size);
    this->Bytes = this->Own.data();
    this->Size = size;
    return this->Own.data();
  }

  const unsigned char* data() const { return this->Bytes; }
  std::size_t size() const { return this->Size; }

private:
  std::vector<unsigned char> Own;
  const unsigned char* Bytes = nullptr;
  std::size_t Size = 0;
};

class Reader
{
public:
  Reader(const unsigned char* bytes, std::size_t size)
    : Begin(bytes)
    , Next(bytes)
    , Left(size)
  {
  }
  explicit Reader(const Record& record)
    : Reader(record.data(), record.size())
  {
  }

  bool IsSound() const { return this->Sound; }
  bool IsAtEnd() const { return this->Left == 0; }

  template <typename Value>
  Value Take()
  {
    static_assert(std::is_trivially_copyable<Value>::value, "only values without pointers");
    Value value{};
    this->TakeBytes(&value, sizeof(value));
    return value;
  }
  template <typename Value>
  void TakeList(std::vector<Value>& list)
  {
    static_assert(alignof(Value) <= Alignment, "lists begin where any of their values may");
    const auto size = static_cast<std::size_t>(this->TakeListCount(sizeof(Value)));
    if (reinterpret_cast<std::uintptr_t>(this->Next) % alignof(Value) == 0)
    {
      const Value* values = reinterpret_cast<const Value*>(this->Next);
      list.assign(values, values + size);
      this->Step(size * sizeof(Value));
      return;
    }
    list.resize(size);
    this->TakeBytes(list.data(), size * sizeof(Value));
  }
  template <typename Value>
  View<Value> TakeView()
  {
    const auto size = static_cast<std::size_t>(this->TakeListCount(sizeof(Value)));
    const View<Value> view(this->Next, size);
    this->Step(size * sizeof(Value));
    return view;
  }
  std::string TakeText()
  {
    std::string text(static_cast<std::size_t>(this->TakeCount(1)), '\0');
    this->TakeBytes(&text[0], text.size());
    return text;
  }
  void TakeCounts(std::map<std::string, std::int64_t>& counts)
  {
    counts.clear();
    const std::uint64_t size = this->TakeCount(1);
    for (std::uint64_t i = 0; i < size && this->Sound; ++i)
    {
      const std::string name = this->TakeText();
      counts[name] = this->Take<std::int64_t>();
    }
  }

private:
  std::uint64_t TakeCount(std::size_t itemSize)
  {
    const auto count = this->Take<std::uint64_t>();
    this->Sound = this->Sound && count <= this->Left / itemSize;
    return this->Sound ? count : 0;
  }
  // Of a list that is there as a whole, up to its first value.
  std::uint64_t TakeListCount(std::size_t itemSize)
  {
    const auto count = this->Take<std::uint64_t>();
    const std::size_t padding =
      (Alignment - static_cast<std::size_t>(this->Next - this->Begin) % Alignment) % Alignment;
    this->Sound = this->Sound && padding <= this->Left;
    this->Step(this->Sound ? padding : 0);
    this->Sound = this->Sound && count <= this->Left / itemSize;
    return this->Sound ? count : 0;
  }
  void TakeBytes(void* to, std::size_t size)
  {
    this->Sound = this->Sound && size <= this->Left;
    if (this->Sound && size > 0)
    {
      std::memcpy(to, this->Next, size);
      this->Step(size);
    }
  }
  void Step(std::size_t size)
  {
    this->Next += size;
    this->Left -= size;
  }

  const unsigned char* Begin;
  const unsigned char* Next;
  std::size_t Left;
  bool Sound = true;
};
}

#endif
