// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyJson.h"

#include "vtkMTVerifyText.h"

namespace
{
constexpr int DepthLimit = 200;

class Parser
{
public:
  explicit Parser(std::string_view text)
    : Text(text)
  {
  }

  bool ParseAll(vtkMTVerifyJson& value)
  {
    if (!this->ParseValue(value, 0))
    {
      return false;
    }
    this->SkipBlanks();
    while (this->At < this->Text.size() && this->Text[this->At] == '\0') // some writers pad with zeros
    {
      ++this->At;
    }
    return this->At == this->Text.size();
  }

private:
  void SkipBlanks() { this->At = std::min(this->Text.find_first_not_of(" \t\r\n", this->At), this->Text.size()); }

  bool Take(std::string_view word)
  {
    const bool found = this->Text.substr(this->At, word.size()) == word;
    this->At += found ? word.size() : 0;
    return found;
  }

  bool ParseValue(vtkMTVerifyJson& value, int depth)
  {
    this->SkipBlanks();
    if (this->At == this->Text.size() || depth > DepthLimit)
    {
      return false;
    }
    switch (this->Text[this->At])
    {
      case '{':
        return this->ParseObject(value, depth);
      case '[':
        return this->ParseList(value, depth);
      case '"':
        value.Type = vtkMTVerifyJson::Text;
        return this->ParseString(value.String);
      case 't':
      case 'f':
        value.Type = vtkMTVerifyJson::Boolean;
        value.Value = this->Text[this->At] == 't' ? 1.0 : 0.0;
        return this->Take("true") || this->Take("false");
      case 'n':
        return this->Take("null");
      default:
        return this->ParseNumber(value);
    }
  }

  bool ParseNumber(vtkMTVerifyJson& value)
  {
    const std::size_t end = std::min(this->Text.find_first_not_of("+-0123456789.eE", this->At), this->Text.size());
    const std::string_view word = this->Text.substr(this->At, end - this->At);
    value.Type = vtkMTVerifyJson::Number;
    this->At = end;
    return vtkMTVerifyText::ParseNumber(word, value.Value);
  }

  static void AppendCharacter(unsigned int code, std::string& text)
  {
    if (code < 0x80)
    {
      text += static_cast<char>(code);
    }
    else if (code < 0x800)
    {
      text += { static_cast<char>(0xc0 | code >> 6), static_cast<char>(0x80 | (code & 63)) };
    }
    else if (code < 0x10000)
    {
      text += { static_cast<char>(0xe0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 63)),
        static_cast<char>(0x80 | (code & 63)) };
    }
    else
    {
      text += { static_cast<char>(0xf0 | code >> 18), static_cast<char>(0x80 | (code >> 12 & 63)),
        static_cast<char>(0x80 | (code >> 6 & 63)), static_cast<char>(0x80 | (code & 63)) };
    }
  }

  bool ParseCode(unsigned int& code)
  {
    code = 0;
    for (int i = 0; i < 4; ++i, ++this->At)
    {
      const std::size_t digit =
        this->At < this->Text.size() ? std::string_view("0123456789abcdef").find(this->Text[this->At] | 0x20) : 16;
      if (digit > 15)
      {
        return false;
      }
      code = code << 4 | static_cast<unsigned int>(digit);
    }
    return true;
  }

  bool ParseEscape(std::string& text)
  {
    const char kind = this->At < this->Text.size() ? this->Text[this->At++] : '\0';
    const std::size_t simple = std::string_view("\"\\/bfnrt").find(kind);
    if (kind != 'u')
    {
      text += simple < 8 ? "\"\\/\b\f\n\r\t"[simple] : '\0';
      return simple < 8;
    }
    unsigned int code = 0;
    if (!this->ParseCode(code))
    {
      return false;
    }
    unsigned int low = 0;
    if (code >> 10 == 0x36 && this->Take("\\u") && this->ParseCode(low))
    {
      code = 0x10000 + ((code & 0x3ff) << 10) + (low & 0x3ff);
    }
    AppendCharacter(code, text);
    return true;
  }

  bool ParseString(std::string& text)
  {
    ++this->At;
    while (this->At < this->Text.size())
    {
      const char c = this->Text[this->At++];
      if (c == '"')
      {
        return true;
      }
      if (c != '\\')
      {
        text += c;
      }
      else if (!this->ParseEscape(text))
      {
        return false;
      }
    }
    return false;
  }

  bool ParseList(vtkMTVerifyJson& value, int depth)
  {
    value.Type = vtkMTVerifyJson::List;
    ++this->At;
    this->SkipBlanks();
    if (this->Take("]"))
    {
      return true;
    }
    do
    {
      value.Items.emplace_back();
      if (!this->ParseValue(value.Items.back(), depth + 1))
      {
        return false;
      }
      this->SkipBlanks();
    } while (this->Take(","));
    return this->Take("]");
  }

  bool ParseObject(vtkMTVerifyJson& value, int depth)
  {
    value.Type = vtkMTVerifyJson::Object;
    ++this->At;
    this->SkipBlanks();
    if (this->Take("}"))
    {
      return true;
    }
    do
    {
      this->SkipBlanks();
      std::string name;
      if (this->At == this->Text.size() || this->Text[this->At] != '"' || !this->ParseString(name))
      {
        return false;
      }
      this->SkipBlanks();
      if (!this->Take(":") || !this->ParseValue(value.Members[name], depth + 1))
      {
        return false;
      }
      this->SkipBlanks();
    } while (this->Take(","));
    return this->Take("}");
  }

  std::string_view Text;
  std::size_t At = 0;
};

const vtkMTVerifyJson Nothing;
}

bool vtkMTVerifyJson::Parse(std::string_view text, vtkMTVerifyJson& value)
{
  value = vtkMTVerifyJson();
  return Parser(vtkMTVerifyText::SkipMark(text)).ParseAll(value);
}

const vtkMTVerifyJson& vtkMTVerifyJson::Get(const std::string& name) const
{
  const auto found = this->Members.find(name);
  return found == this->Members.end() ? Nothing : found->second;
}

const vtkMTVerifyJson& vtkMTVerifyJson::At(double index) const
{
  return index >= 0.0 && index < static_cast<double>(this->Items.size()) ? this->Items[static_cast<std::size_t>(index)]
                                                                         : Nothing;
}

double vtkMTVerifyJson::GetNumber(const std::string& name, double otherwise) const
{
  const vtkMTVerifyJson& value = this->Get(name);
  return value.Type == Number || value.Type == Boolean ? value.Value : otherwise;
}

std::vector<double> vtkMTVerifyJson::GetNumbers(const std::string& name, const std::vector<double>& otherwise) const
{
  const vtkMTVerifyJson& list = this->Get(name);
  std::vector<double> numbers;
  for (const vtkMTVerifyJson& item : list.Items)
  {
    numbers.push_back(item.Value);
  }
  return !otherwise.empty() && numbers.size() != otherwise.size() ? otherwise : numbers;
}
