// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyJson
 * @brief a value of JSON (RFC 8259) as a tree, for the verification's own reading of glTF
 *
 * What is not there is a value of type Null, so chains of Get need no tests. Numbers are doubles.
 */
#ifndef vtkMTVerifyJson_h
#define vtkMTVerifyJson_h

#include "vtkMTVerificationModule.h" // For export macro

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTVerifyJson
{
public:
  enum ValueType
  {
    Null,
    Boolean,
    Number,
    Text,
    List,
    Object
  };

  /// False when the text is no JSON.
  static bool Parse(std::string_view text, vtkMTVerifyJson& value);

  ValueType Type = Null;
  double Value = 0.0; ///< of numbers; 1 for true
  std::string String;
  std::vector<vtkMTVerifyJson> Items;
  std::map<std::string, vtkMTVerifyJson> Members;

  const vtkMTVerifyJson& Get(const std::string& name) const;
  /// An entry of a list, where the index is one.
  const vtkMTVerifyJson& At(double index) const;
  bool Has(const std::string& name) const { return this->Members.count(name) > 0; }
  double GetNumber(const std::string& name, double otherwise) const;
  /// The numbers of a list; those of `otherwise` where it has not as many.
  std::vector<double> GetNumbers(const std::string& name, const std::vector<double>& otherwise) const;
};

#endif
