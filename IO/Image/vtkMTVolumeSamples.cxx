// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVolumeSamples.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTInflate.h"
#include "vtkMTTextFormat.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace
{
bool IsBigEndianMachine()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

// What a number of a text becomes as an element; false where the type does not hold it.
template <typename Element>
bool Put(std::string_view token, Element* to)
{
  std::int64_t whole = 0;
  double real = 0.0;
  if (std::numeric_limits<Element>::is_integer && vtkMTTextFormat::ToNumber(token, whole))
  {
    *to = static_cast<Element>(whole);
    return static_cast<std::int64_t>(*to) == whole;
  }
  if (!vtkMTTextFormat::ToNumber(token, real) ||
    (std::numeric_limits<Element>::is_integer &&
      !(real >= static_cast<double>(std::numeric_limits<Element>::lowest()) &&
        real <= static_cast<double>(std::numeric_limits<Element>::max()))))
  {
    return false;
  }
  *to = static_cast<Element>(real);
  return true;
}

template <typename Element, typename Value>
void Scale(const Element* elements, vtkIdType count, double slope, double intercept, Value* values)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    values[i] = static_cast<Value>(slope * static_cast<double>(elements[i]) + intercept);
  }
}

vtkSmartPointer<vtkDataArray> ScaleArray(vtkDataArray* elements, double slope, double intercept)
{
  const bool isSmall = elements->GetDataTypeSize() <= 2 || elements->GetDataType() == VTK_FLOAT;
  auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(isSmall ? VTK_FLOAT : VTK_DOUBLE));
  const vtkIdType count = elements->GetNumberOfTuples();
  values->SetNumberOfTuples(count);
  void* to = values->GetVoidPointer(0);
  switch (elements->GetDataType())
  {
    vtkTemplateMacro(isSmall ? Scale(static_cast<const VTK_TT*>(elements->GetVoidPointer(0)), count, slope, intercept,
                                 static_cast<float*>(to))
                             : Scale(static_cast<const VTK_TT*>(elements->GetVoidPointer(0)), count, slope, intercept,
                                 static_cast<double*>(to)));
  }
  return values;
}
}

vtkMTVolumeSamples::vtkMTVolumeSamples() = default;
vtkMTVolumeSamples::~vtkMTVolumeSamples() = default;

bool vtkMTVolumeSamples::Open(const vtkMTVolumeHeader& header, std::string& error)
{
  this->Header = header;
  this->Place = header.Place;
  this->Report = header.Report;
  this->ElementSize = static_cast<std::size_t>(vtkDataArray::GetDataTypeSize(header.Type));
  const auto& size = header.Size;
  this->IsPlain = header.Stride == std::array<std::uint64_t, 3>{ 1, size[0], size[0] * size[1] };
  this->IsScaled = header.Slope != 1.0 || header.Intercept != 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Extent[2 * axis] = 0;
    this->Extent[2 * axis + 1] = static_cast<int>(size[axis]) - 1;
  }
  return this->OpenFiles(error) && (header.Encoding == vtkMTVolumeHeader::Raw || this->Decode(error));
}

//------------------------------------------------------------------------------
// Files
bool vtkMTVolumeSamples::OpenFiles(std::string& error)
{
  for (vtkMTVolumeHeader::File& place : this->Header.Files)
  {
    std::unique_ptr<vtkMTByteSource> file = vtkMTFileByteSource::Open(place.Path, error);
    if (!file || !this->CheckFile(*file, place, error))
    {
      return false;
    }
    this->Sources.push_back(std::move(file));
  }
  return true;
}

// Before memory is asked for.
bool vtkMTVolumeSamples::CheckFile(
  const vtkMTByteSource& file, vtkMTVolumeHeader::File& place, std::string& error) const
{
  const std::uint64_t bytes = this->GetElementsOfFile() * this->ElementSize;
  if (place.IsAtEnd)
  {
    place.Offset = file.GetSize() - std::min(file.GetSize(), bytes);
  }
  const double there = static_cast<double>(file.GetSize() - std::min(file.GetSize(), place.Offset));
  // Deflate's best is 1032 to 1; a number of text has a digit and a blank.
  double most = there;
  switch (this->Header.Encoding)
  {
    case vtkMTVolumeHeader::Raw:
      break;
    case vtkMTVolumeHeader::Deflated:
      most = 1100.0 * there - static_cast<double>(this->Header.DecodedSkip);
      break;
    case vtkMTVolumeHeader::Text:
      most = static_cast<double>(this->ElementSize) * (there + 1.0) / 2.0;
      break;
    case vtkMTVolumeHeader::Hexadecimal:
      most = there / 2.0;
      break;
  }
  if (static_cast<double>(bytes) > most)
  {
    error = "claims more samples than its bytes can hold: it is damaged, or " + place.Path + " is";
    return false;
  }
  return true;
}

// Up to the last one that is a sample.
std::uint64_t vtkMTVolumeSamples::GetNumberOfNeededElements() const
{
  std::uint64_t last = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    last += this->Header.Stride[axis] * (this->Header.Size[axis] - 1);
  }
  return last + 1;
}

bool vtkMTVolumeSamples::Decode(std::string& error)
{
  const std::uint64_t needed = this->GetNumberOfNeededElements();
  this->Decoded.resize(static_cast<std::size_t>(needed) * this->ElementSize);
  std::uint64_t done = 0;
  for (std::size_t i = 0; i < this->Sources.size() && done < needed; ++i)
  {
    const auto count = static_cast<std::size_t>(std::min(this->GetElementsOfFile(), needed - done));
    unsigned char* to = this->Decoded.data() + done * this->ElementSize;
    const std::uint64_t offset = this->Header.Files[i].Offset;
    const bool isGood = this->Header.Encoding == vtkMTVolumeHeader::Deflated
      ? vtkMTInflate(*this->Sources[i], offset, this->Header.DecodedSkip, count * this->ElementSize, to,
          count == this->GetElementsOfFile(), error)
      : this->DecodeText(*this->Sources[i], offset, count, to, error);
    if (!isGood)
    {
      return false;
    }
    done += count;
  }
  if (this->Header.Encoding != vtkMTVolumeHeader::Text) // numbers of text are in order
  {
    this->Swap(this->Decoded.data(), static_cast<std::size_t>(needed));
  }
  this->Sources.clear();
  return true;
}

bool vtkMTVolumeSamples::DecodeText(
  const vtkMTByteSource& file, std::uint64_t offset, std::size_t count, unsigned char* to, std::string& error) const
{
  std::string text(static_cast<std::size_t>(file.GetSize() - offset), ' ');
  if (!file.Read(offset, text.size(), text.data(), error))
  {
    return false;
  }
  if (this->Header.Encoding == vtkMTVolumeHeader::Hexadecimal)
  {
    std::size_t digits = 0;
    for (const char c : text)
    {
      static const std::string known = "0123456789abcdef0123456789ABCDEF";
      const std::size_t digit = known.find(c);
      if (digit != std::string::npos && digits < 2 * count * this->ElementSize)
      {
        to[digits / 2] = static_cast<unsigned char>((digits % 2 == 0 ? 0 : to[digits / 2] << 4) | (digit % 16));
        ++digits;
      }
    }
    error = digits == 2 * count * this->ElementSize ? error : "its hexadecimal samples end too early";
    return digits == 2 * count * this->ElementSize;
  }
  std::replace(text.begin(), text.end(), ',', ' ');
  std::string_view rest(text);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::string_view token = vtkMTTextFormat::NextToken(rest);
    bool isGood = false;
    switch (this->Header.Type)
    {
      vtkTemplateMacro(isGood = Put(token, reinterpret_cast<VTK_TT*>(to) + i));
    }
    if (!isGood)
    {
      error = "its sample " + std::to_string(i + 1) + " is missing, or no number of its type";
      return false;
    }
  }
  return true;
}

void vtkMTVolumeSamples::Swap(unsigned char* elements, std::size_t count) const
{
  if (this->ElementSize > 1 && this->Header.IsBigEndian != IsBigEndianMachine())
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      std::reverse(elements + i * this->ElementSize, elements + (i + 1) * this->ElementSize);
    }
  }
}

//------------------------------------------------------------------------------
// Slabs
bool vtkMTVolumeSamples::ReadElements(
  std::uint64_t first, std::size_t count, unsigned char* to, std::string& error) const
{
  const std::uint64_t each = this->GetElementsOfFile();
  while (count > 0)
  {
    const std::uint64_t within = first % each;
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(count, each - within));
    const auto file = static_cast<std::size_t>(first / each);
    const std::uint64_t offset = this->Header.Files[file].Offset + within * this->ElementSize;
    if (!this->Sources[file]->Read(offset, part * this->ElementSize, to, error))
    {
      return false;
    }
    this->Swap(to, part);
    to += part * this->ElementSize;
    first += part;
    count -= part;
  }
  return true;
}

bool vtkMTVolumeSamples::Gather(int first, int last, unsigned char* to, std::string& error)
{
  const auto& size = this->Header.Size;
  const auto& stride = this->Header.Stride;
  const auto slices = static_cast<std::size_t>(last - first + 1);
  if (this->IsPlain)
  {
    return this->ReadElements(static_cast<std::uint64_t>(first) * stride[2], slices * stride[2], to, error);
  }
  const auto elements = static_cast<std::size_t>(stride[0] * (size[0] - 1) + stride[1] * (size[1] - 1) + 1);
  for (std::size_t k = 0; k < slices; ++k)
  {
    const std::uint64_t begin = (static_cast<std::uint64_t>(first) + k) * stride[2];
    const unsigned char* from = nullptr;
    if (!this->Decoded.empty())
    {
      from = this->Decoded.data() + begin * this->ElementSize;
    }
    else
    {
      this->Slice.resize(elements * this->ElementSize);
      from = this->Slice.data();
      if (!this->ReadElements(begin, elements, this->Slice.data(), error))
      {
        return false;
      }
    }
    for (std::size_t j = 0; j < size[1]; ++j)
    {
      for (std::size_t i = 0; i < size[0]; ++i, to += this->ElementSize)
      {
        std::memcpy(to, from + (j * stride[1] + i * stride[0]) * this->ElementSize, this->ElementSize);
      }
    }
  }
  return true;
}

bool vtkMTVolumeSamples::Read(int first, int last, vtkImageData* slab, std::string& error)
{
  const auto& size = this->Header.Size;
  const auto count = static_cast<vtkIdType>(size[0] * size[1]) * (last - first + 1);
  auto samples = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(this->Header.Type));
  if (this->IsPlain && !this->Decoded.empty())
  {
    const std::uint64_t begin = static_cast<std::uint64_t>(first) * this->Header.Stride[2] * this->ElementSize;
    samples->SetVoidArray(this->Decoded.data() + begin, count, 1);
  }
  else
  {
    samples->SetNumberOfTuples(count);
    if (!this->Gather(first, last, static_cast<unsigned char*>(samples->GetVoidPointer(0)), error))
    {
      return false;
    }
  }
  slab->Initialize();
  slab->SetExtent(0, this->Extent[1], 0, this->Extent[3], first, last);
  slab->GetPointData()->SetScalars(
    this->IsScaled ? ScaleArray(samples, this->Header.Slope, this->Header.Intercept) : samples);
  return true;
}
