// SPDX-License-Identifier: BSD-3-Clause
// Fills a vector without clearing it before. Not installed.
#ifndef vtkMTFill_h
#define vtkMTFill_h

#include <cstddef>
#include <iterator>
#include <vector>

namespace vtkMTFillDetail
{
// As much of an iterator as std::vector asks for.
template <class T, class Make>
struct Iterator
{
  using iterator_category = std::random_access_iterator_tag;
  using value_type = T;
  using difference_type = std::ptrdiff_t;
  using pointer = const T*;
  using reference = T;

  std::size_t At;
  const Make* Function;

  T operator*() const { return (*this->Function)(this->At); }
  Iterator& operator++()
  {
    ++this->At;
    return *this;
  }
  Iterator& operator--()
  {
    --this->At;
    return *this;
  }
  Iterator& operator+=(std::ptrdiff_t n)
  {
    this->At += static_cast<std::size_t>(n);
    return *this;
  }
  std::ptrdiff_t operator-(const Iterator& other) const { return static_cast<std::ptrdiff_t>(this->At - other.At); }
  bool operator==(const Iterator& other) const { return this->At == other.At; }
  bool operator!=(const Iterator& other) const { return this->At != other.At; }
};
}

/// Makes `values` consist of make(0), make(1) and so on, `size` of them.
template <class T, class Make>
void vtkMTFill(std::vector<T>& values, std::size_t size, const Make& make)
{
  using Iterator = vtkMTFillDetail::Iterator<T, Make>;
  values.assign(Iterator{ 0, &make }, Iterator{ size, &make });
}

#endif
