// SPDX-License-Identifier: BSD-3-Clause
// The colours of a PLY element, of whatever type, as bytes. Not installed.
#ifndef vtkMTPlyColors_h
#define vtkMTPlyColors_h

#include "vtkMTPlyHeader.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;

/**
 * Which properties are colours, by their names: red green blue (alpha), diffuse_red ..., r g b (a), ambient_red ... and
 * specular_red ..., in upper or lower case. The first group that an element has is what is drawn. Channels of other
 * types than uchar are scaled to bytes by what the largest value of their type in the group says: real numbers below 2
 * count to 1, integers up to 255 are bytes, integers above count to 65535, or to the largest of their type; char is
 * uchar with another sign. So all values must have been looked at before the first is converted.
 */
class vtkMTPlyColors
{
public:
  struct Group
  {
    std::string Array; // "RGB", "RGBA", "DiffuseRGB" ...
    std::vector<const vtkMTPlyProperty*> Channels;
    std::map<int, double> Largest; // of the values, by their type

    bool AreBytes() const;
    /// That of all channels, or VTK_DOUBLE where they have several.
    int GetType() const;
    std::vector<std::string> GetNames() const;
    double GetScale(int type) const;
  };

  explicit vtkMTPlyColors(const vtkMTPlyElement& element);

  const std::vector<Group>& GetGroups() const { return this->Groups; }
  bool AreAllBytes() const;
  ///@{
  /// The arrays of the groups, as the file has them, among others: first all are looked at, then they become bytes.
  void Look(vtkDataSetAttributes* attributes);
  void Convert(vtkDataSetAttributes* attributes) const;
  ///@}
  /// What was made of so many rows, by reason.
  void Count(std::uint64_t rows, vtkMTInputReport& report) const;

private:
  void FindGroup(const vtkMTPlyElement& element, const std::vector<std::string>& names, const std::string& array);

  std::vector<Group> Groups;
  std::uint64_t NotNumbers = 0; // values that are NaN
};

#endif
