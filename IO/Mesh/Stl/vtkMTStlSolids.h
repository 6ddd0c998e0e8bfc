// SPDX-License-Identifier: BSD-3-Clause
// The solids of an STL file. Not installed.
#ifndef vtkMTStlSolids_h
#define vtkMTStlSolids_h

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

class vtkCellData;

class vtkMTStlSolids
{
public:
  /// The next one, which begins at that triangle. Spaces around the name are none of it.
  void Add(std::uint64_t first, std::string_view name);
  std::size_t GetNumberOfSolids() const { return this->Names.size(); }

  /// Where there are several, the array "SolidIds" (int; 0, 1, 2 ...) of so many triangles, with the names.
  void AddIds(std::uint64_t first, std::uint64_t count, vtkCellData* attributes) const;

private:
  std::vector<std::string> Names;
  std::vector<std::uint64_t> Firsts; // triangles, ascending
};

#endif
