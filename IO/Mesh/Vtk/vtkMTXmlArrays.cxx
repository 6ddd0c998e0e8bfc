// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTXmlArrays.h"

#include "vtkMTErrorCollector.h"
#include "vtkMTFileByteSource.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkLZ4DataCompressor.h"
#include "vtkLZMADataCompressor.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLDataParser.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkZLibDataCompressor.h"

#include <cstring>
#include <fstream>

namespace
{
// What VTK's reader makes of an element.
class ArrayMaker : public vtkXMLPolyDataReader
{
public:
  static ArrayMaker* New();
  vtkTypeMacro(ArrayMaker, vtkXMLPolyDataReader);
  using vtkXMLPolyDataReader::CreateArray;
};
vtkStandardNewMacro(ArrayMaker);

vtkSmartPointer<vtkDataCompressor> MakeCompressor(const char* name)
{
  const std::string type = name ? name : "";
  if (type == "vtkZLibDataCompressor")
  {
    return vtkSmartPointer<vtkZLibDataCompressor>::New();
  }
  if (type == "vtkLZ4DataCompressor")
  {
    return vtkSmartPointer<vtkLZ4DataCompressor>::New();
  }
  return type == "vtkLZMADataCompressor" ? vtkSmartPointer<vtkLZMADataCompressor>::New() : nullptr;
}

bool IsReal(int type)
{
  return type == VTK_FLOAT || type == VTK_DOUBLE;
}
}

//------------------------------------------------------------------------------
class vtkMTXmlArrays::Parser : public vtkXMLDataParser
{
public:
  static Parser* New();
  vtkTypeMacro(Parser, vtkXMLDataParser);

  std::uint64_t FindInlineData(vtkXMLDataElement* element)
  {
    this->SeekInlineDataPosition(element);
    return static_cast<std::uint64_t>(this->TellG());
  }

  std::ifstream Input;

protected:
  Parser() = default;
  ~Parser() override { this->SetStream(nullptr); }
};
vtkStandardNewMacro(vtkMTXmlArrays::Parser);

// An array as text, and how far it has been read.
struct vtkMTXmlArrays::Text
{
  std::unique_ptr<vtkMTFileByteSource> Bytes;
  std::unique_ptr<vtkMTTextFormat::Stream> Lines;
  std::string_view Line;
  std::uint64_t NextTuple = 0;

  bool Begin(const std::string& path, std::uint64_t position, std::string& error)
  {
    this->Bytes = vtkMTFileByteSource::Open(path, error);
    if (!this->Bytes)
    {
      return false;
    }
    this->Lines = std::make_unique<vtkMTTextFormat::Stream>(*this->Bytes);
    this->Line = {};
    this->NextTuple = 0;
    return this->Lines->Skip(position);
  }

  // Empty at the end.
  std::string_view NextToken()
  {
    std::string_view token = vtkMTTextFormat::NextToken(this->Line);
    while (token.empty() && this->Lines->TakeLine(this->Line))
    {
      token = vtkMTTextFormat::NextToken(this->Line);
    }
    return token.substr(0, token.find('<'));
  }
};

vtkMTXmlArrays::vtkMTXmlArrays() = default;

vtkMTXmlArrays::~vtkMTXmlArrays() = default;

bool vtkMTXmlArrays::Open(const std::string& path, std::string& error)
{
  this->Path = path;
  this->Xml = vtkSmartPointer<Parser>::New();
  this->Errors.Observe(this->Xml);
  this->Xml->Input.open(path, std::ios::binary);
  this->Xml->SetStream(&this->Xml->Input);
  if (!this->Xml->Input || !this->Xml->Parse() || !this->GetRoot())
  {
    error = path + ": " + (this->Errors.HasErrors() ? this->Errors.GetMessage() : "is no XML");
    return false;
  }
  this->Xml->SetCompressor(MakeCompressor(this->GetRoot()->GetAttribute("compressor")));
  return true;
}

vtkXMLDataElement* vtkMTXmlArrays::GetRoot() const
{
  return this->Xml->GetRootElement();
}

vtkSmartPointer<vtkAbstractArray> vtkMTXmlArrays::MakeArray(vtkXMLDataElement* element)
{
  const auto maker = vtkSmartPointer<ArrayMaker>::New();
  vtkMTErrorCollector::IgnoreUnknownKeys(maker);
  return vtkSmartPointer<vtkAbstractArray>::Take(maker->CreateArray(element));
}

bool vtkMTXmlArrays::Read(
  vtkXMLDataElement* element, std::uint64_t first, std::uint64_t count, vtkDataArray* values, std::string& error)
{
  const auto components = static_cast<std::uint64_t>(values->GetNumberOfComponents());
  const std::uint64_t words = count * components;
  values->SetNumberOfTuples(static_cast<vtkIdType>(count));
  const char* format = element->GetAttribute("format");
  vtkTypeInt64 offset = 0;
  std::size_t read = 0;
  if (element->GetScalarAttribute("offset", offset))
  {
    read =
      this->Xml->ReadAppendedData(offset, values->GetVoidPointer(0), first * components, words, values->GetDataType());
  }
  else if (format && std::strcmp(format, "binary") == 0)
  {
    read = this->Xml->ReadInlineData(
      element, 0, values->GetVoidPointer(0), first * components, words, values->GetDataType());
  }
  else
  {
    return this->ReadText(element, first, values, error);
  }
  if (read != words || this->Errors.HasErrors())
  {
    const char* name = element->GetAttribute("Name");
    error = this->Path + ": the array " + (name ? name : "") + " ends early" +
      (this->Errors.HasErrors() ? ": " + this->Errors.GetMessage() : "");
    return false;
  }
  return true;
}

bool vtkMTXmlArrays::ReadText(vtkXMLDataElement* element, std::uint64_t first, vtkDataArray* values, std::string& error)
{
  std::unique_ptr<Text>& text = this->Texts[element];
  if (!text || first != text->NextTuple)
  {
    text = std::make_unique<Text>();
    if (first != 0 || !text->Begin(this->Path, this->Xml->FindInlineData(element), error))
    {
      error = error.empty() ? this->Path + ": an array as text can only be read from its beginning" : error;
      return false;
    }
  }
  const vtkIdType components = values->GetNumberOfComponents();
  for (vtkIdType i = 0; i < components * values->GetNumberOfTuples(); ++i)
  {
    const std::string_view token = text->NextToken();
    double real = 0.0;
    float single = 0.0f;
    std::int64_t whole = 0;
    const int type = values->GetDataType();
    // 64-bit integers do not fit into the doubles through which values are set.
    const bool isGood = !IsReal(type) ? vtkMTTextFormat::ToNumber(token, whole)
      : type == VTK_FLOAT             ? vtkMTTextFormat::ToNumber(token, single)
                                      : vtkMTTextFormat::ToNumber(token, real);
    if (!isGood)
    {
      error = this->Path + ": \"" + std::string(token.substr(0, 40)) + "\" is no number of the array's type";
      return false;
    }
    values->SetVariantValue(i, !IsReal(type) ? vtkVariant(whole) : vtkVariant(type == VTK_FLOAT ? single : real));
  }
  text->NextTuple += static_cast<std::uint64_t>(values->GetNumberOfTuples());
  return true;
}
