// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfJson.h"

#include <cmath>

namespace vtkMTGltfJson
{
void Fail(const std::string& where, const std::string& what)
{
  throw Error(where + ": " + what);
}

const Json* Find(const Json& object, const char* key)
{
  const auto found = object.find(key); // end() where it is no object
  return found == object.end() ? nullptr : &*found;
}

const Json& GetList(const Json& object, const char* key, const std::string& where)
{
  static const Json none = Json::array();
  const Json* list = Find(object, key);
  if (list && !list->is_array())
  {
    Fail(where, std::string("\"") + key + "\" is no list");
  }
  return list ? *list : none;
}

const Json& GetObject(const Json& object, const char* key, const std::string& where)
{
  static const Json none = Json::object();
  const Json* found = Find(object, key);
  if (found && !found->is_object())
  {
    Fail(where, std::string("\"") + key + "\" is no object");
  }
  return found ? *found : none;
}

const Json* FindExtension(const Json& object, const char* name)
{
  const Json* extensions = Find(object, "extensions");
  const Json* extension = extensions ? Find(*extensions, name) : nullptr;
  return extension && extension->is_object() ? extension : nullptr;
}

std::uint64_t GetCount(const Json& object, const char* key, const std::string& where)
{
  const Json* number = Find(object, key);
  if (!number)
  {
    Fail(where, std::string("has no \"") + key + "\"");
  }
  // Some programs write 3.0 for 3.
  const double value = number->is_number() ? number->get<double>() : -1.0;
  if (!(value >= 0.0 && value <= 9007199254740992.0) || value != std::floor(value))
  {
    Fail(where, std::string("\"") + key + "\" is no number or index");
  }
  return static_cast<std::uint64_t>(value);
}

std::uint64_t GetCount(const Json& object, const char* key, const std::string& where, std::uint64_t fallback)
{
  return Find(object, key) ? GetCount(object, key, where) : fallback;
}

std::size_t GetIndex(const Json& object, const char* key, std::size_t size, const std::string& where)
{
  const std::uint64_t index = GetCount(object, key, where);
  if (index >= size)
  {
    Fail(where, std::string("\"") + key + "\" is " + std::to_string(index) + ", of " + std::to_string(size));
  }
  return static_cast<std::size_t>(index);
}

std::vector<double> GetNumbers(
  const Json& object, const char* key, std::size_t count, const std::string& where, const std::vector<double>& fallback)
{
  const Json* list = Find(object, key);
  if (!list)
  {
    return fallback;
  }
  std::vector<double> numbers;
  for (const Json& number : *list)
  {
    numbers.push_back(number.is_number() ? number.get<double>() : std::nan(""));
    if (!std::isfinite(numbers.back()))
    {
      break;
    }
  }
  if (!list->is_array() || numbers.size() != count || (count > 0 && !std::isfinite(numbers.back())))
  {
    Fail(where, std::string("\"") + key + "\" is not " + std::to_string(count) + " numbers");
  }
  return numbers;
}

std::string GetText(const Json& object, const char* key, const std::string& fallback)
{
  const Json* text = Find(object, key);
  return text && text->is_string() ? text->get<std::string>() : fallback;
}
}
