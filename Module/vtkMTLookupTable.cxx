// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTLookupTable.h"

#include "vtkMTArrayInfo.h"

#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkStdString.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"
#include "vtkVariantArray.h"

#include <cstdint>
#include <cstring>
#include <map>

namespace
{
class Writer
{
public:
  template <typename Value>
  void Put(Value value)
  {
    this->Bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  void PutText(const std::string& text)
  {
    this->Put(static_cast<std::uint32_t>(text.size()));
    this->Bytes += text;
  }
  void PutColor(bool isUsed, const double color[4])
  {
    this->Put(static_cast<std::uint8_t>(isUsed ? 1 : 0));
    for (int i = 0; i < 4; ++i)
    {
      this->Put(color[i]);
    }
  }
  std::string Bytes;
};

class Reader
{
public:
  explicit Reader(const std::string& bytes)
    : Bytes(bytes)
  {
  }
  template <typename Value>
  Value Take()
  {
    Value value{};
    const char* from = this->TakeBytes(sizeof(value));
    if (from)
    {
      std::memcpy(&value, from, sizeof(value));
    }
    return value;
  }
  const char* TakeBytes(std::size_t size)
  {
    this->Sound = this->Sound && size <= this->Bytes.size() - this->At;
    const char* from = this->Sound ? this->Bytes.data() + this->At : nullptr;
    this->At += this->Sound ? size : 0;
    return from;
  }
  std::string TakeText()
  {
    const auto size = this->Take<std::uint32_t>();
    const char* from = this->TakeBytes(size);
    return from ? std::string(from, size) : std::string();
  }
  bool TakeColor(double color[4])
  {
    const bool isUsed = this->Take<std::uint8_t>() != 0;
    for (int i = 0; i < 4; ++i)
    {
      color[i] = this->Take<double>();
    }
    return isUsed;
  }
  bool IsSound() const { return this->Sound; }
  bool IsAtEnd() const { return this->Sound && this->At == this->Bytes.size(); }

private:
  const std::string& Bytes;
  std::size_t At = 0;
  bool Sound = true;
};

// All at once: the table sorts its annotations whenever one is set. Of several for one value the last holds.
void TakeAnnotations(Reader& reader, vtkLookupTable* table)
{
  std::map<vtkVariant, vtkIdType, vtkVariantLessThan> places;
  const vtkNew<vtkVariantArray> values;
  const vtkNew<vtkStringArray> labels;
  for (auto count = reader.Take<std::uint32_t>(); count > 0 && reader.IsSound(); --count)
  {
    const bool isText = reader.Take<std::uint8_t>() != 0;
    const vtkVariant value = isText ? vtkVariant(vtkStdString(reader.TakeText())) : vtkVariant(reader.Take<double>());
    const vtkIdType place = places.emplace(value, values->GetNumberOfValues()).first->second;
    values->InsertValue(place, value);
    labels->InsertValue(place, reader.TakeText());
  }
  if (!places.empty())
  {
    table->SetAnnotations(values, labels);
  }
}
}

std::string vtkMTLookupTable::Encode(vtkLookupTable* table)
{
  Writer writer;
  const vtkIdType colors = table->GetNumberOfTableValues();
  writer.Put(static_cast<std::uint32_t>(colors));
  writer.Bytes.append(reinterpret_cast<const char*>(table->GetPointer(0)), static_cast<std::size_t>(4 * colors));
  writer.Put(table->GetTableRange()[0]);
  writer.Put(table->GetTableRange()[1]);
  writer.Put(static_cast<std::uint8_t>(table->GetScale() == VTK_SCALE_LOG10 ? 1 : 0));
  writer.Put(static_cast<std::uint8_t>(table->GetIndexedLookup() ? 1 : 0));
  writer.PutColor(true, table->GetNanColor());
  writer.PutColor(table->GetUseBelowRangeColor() != 0, table->GetBelowRangeColor());
  writer.PutColor(table->GetUseAboveRangeColor() != 0, table->GetAboveRangeColor());
  writer.Put(static_cast<std::uint32_t>(table->GetNumberOfAnnotatedValues()));
  for (vtkIdType i = 0; i < table->GetNumberOfAnnotatedValues(); ++i)
  {
    const vtkVariant value = table->GetAnnotatedValue(i);
    writer.Put(static_cast<std::uint8_t>(value.IsNumeric() ? 0 : 1));
    if (value.IsNumeric())
    {
      writer.Put(value.ToDouble());
    }
    else
    {
      writer.PutText(value.ToString());
    }
    writer.PutText(table->GetAnnotation(i));
  }
  return writer.Bytes;
}

vtkSmartPointer<vtkLookupTable> vtkMTLookupTable::Decode(const std::string& bytes)
{
  Reader reader(bytes);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  const auto count = reader.Take<std::uint32_t>();
  const char* colors = reader.TakeBytes(4 * std::size_t(count));
  if (!colors || count == 0)
  {
    return nullptr;
  }
  table->SetNumberOfTableValues(static_cast<vtkIdType>(count));
  std::memcpy(table->WritePointer(0, static_cast<int>(count)), colors, 4 * std::size_t(count));
  double range[2];
  range[0] = reader.Take<double>();
  range[1] = reader.Take<double>();
  const bool isRangeRight = range[0] <= range[1]; // NaN is not
  const bool isLogarithmic = reader.Take<std::uint8_t>() != 0;
  const bool isIndexed = reader.Take<std::uint8_t>() != 0;
  double color[4];
  reader.TakeColor(color);
  table->SetNanColor(color);
  table->SetUseBelowRangeColor(reader.TakeColor(color) ? 1 : 0);
  table->SetBelowRangeColor(color);
  table->SetUseAboveRangeColor(reader.TakeColor(color) ? 1 : 0);
  table->SetAboveRangeColor(color);
  TakeAnnotations(reader, table);
  if (!reader.IsAtEnd() || !isRangeRight)
  {
    return nullptr;
  }
  table->SetTableRange(range);
  // A logarithm changes a range that it cannot take, with a warning; both come from a table that had them.
  const bool isPossible = range[0] > 0.0 || range[1] < 0.0;
  table->SetScale(isLogarithmic && isPossible ? VTK_SCALE_LOG10 : VTK_SCALE_LINEAR);
  table->SetIndexedLookup(isIndexed ? 1 : 0);
  table->BuildSpecialColors();
  return table;
}

vtkMTLookupTable::NameList vtkMTLookupTable::GetNames(vtkScalarsToColors* table)
{
  NameList names;
  for (vtkIdType i = 0; table && i < table->GetNumberOfAnnotatedValues(); ++i)
  {
    names.emplace_back(table->GetAnnotatedValue(i).ToString(), table->GetAnnotation(i));
  }
  return names;
}

vtkMTLookupTable::NameList vtkMTLookupTable::GetNames(const vtkMTArrayInfo& array)
{
  const auto bytes = array.Properties.find("lookup_table");
  return bytes == array.Properties.end() ? NameList() : GetNames(Decode(bytes->second));
}
