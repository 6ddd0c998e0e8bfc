// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputFiles
 * @brief the input's files as they are on the disk: what tells them from others, and whether they change
 */
#ifndef vtkMTInputFiles_h
#define vtkMTInputFiles_h

#include "vtkMTBuildingModule.h" // For export macro

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

struct vtkMTBuildError;

class VTKMTBUILDING_EXPORT vtkMTInputFiles
{
public:
  explicit vtkMTInputFiles(const std::vector<std::string>& paths);

  /// The first file that is not any more what it was; empty when there is none.
  std::string FindChanged() const;

  /// A hash (XXH3-64) of all that is in the files, one after the other, as text. goesOn is asked now and then: false is
  /// an abort. False on failure.
  bool GetHash(const std::function<bool()>& goesOn, std::string& hash, vtkMTBuildError& error) const;

  /// The same hash of a text.
  static std::string GetHash(const std::string& text);

private:
  struct State
  {
    std::string Path;
    std::uint64_t Size = 0;
    std::int64_t Time = 0;
    std::uint64_t File = 0;
    bool operator==(const State& other) const
    {
      return this->Size == other.Size && this->Time == other.Time && this->File == other.File;
    }
  };
  static State Look(const std::string& path);

  std::vector<State> Files;
};

#endif
