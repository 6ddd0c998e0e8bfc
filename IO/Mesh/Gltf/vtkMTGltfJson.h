// SPDX-License-Identifier: BSD-3-Clause
// Checked looks into the JSON of a glTF file. Not installed.
//
// All functions throw an Error, which says where and what, when something is not as the specification has it; `where`
// is the beginning of that message, such as "accessor 3".
#ifndef vtkMTGltfJson_h
#define vtkMTGltfJson_h

#include "vtkMTJson.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace vtkMTGltfJson
{
using Json = nlohmann::json;

class Error : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

[[noreturn]] void Fail(const std::string& where, const std::string& what);

/// Null where there is none.
const Json* Find(const Json& object, const char* key);
/// An empty list where there is none.
const Json& GetList(const Json& object, const char* key, const std::string& where);
/// An empty object where there is none.
const Json& GetObject(const Json& object, const char* key, const std::string& where);
/// The extension of an object, or null.
const Json* FindExtension(const Json& object, const char* name);

///@{
/// A whole number from 0 to 2^53.
std::uint64_t GetCount(const Json& object, const char* key, const std::string& where);
std::uint64_t GetCount(const Json& object, const char* key, const std::string& where, std::uint64_t fallback);
///@}
/// A whole number below size, which is the length of the list that it points into.
std::size_t GetIndex(const Json& object, const char* key, std::size_t size, const std::string& where);
/// `count` numbers; the fallback where there are none.
std::vector<double> GetNumbers(const Json& object, const char* key, std::size_t count, const std::string& where,
  const std::vector<double>& fallback);
/// The fallback where there is none, or where it is no text.
std::string GetText(const Json& object, const char* key, const std::string& fallback = "");
}

#endif
