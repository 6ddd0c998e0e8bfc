// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyTerrainTiff
 * @brief the first directory of a TIFF or BigTIFF file, after TIFF's specification, revision 6.0
 */
#ifndef vtkMTVerifyTerrainTiff_h
#define vtkMTVerifyTerrainTiff_h

#include "vtkMTVerificationModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTVerifyTerrainTiff
{
public:
  /// Reads the file and its directory. False with the reason in error.
  bool Open(const std::string& path, std::string& error);

  bool Has(int tag) const { return this->Entries.count(tag) > 0; }
  /// The values of a tag of numbers; none where it is not there, or not in the file's bytes.
  std::vector<double> GetNumbers(int tag) const;
  /// Its first value, or the default.
  double GetNumber(int tag, double otherwise) const;
  std::string GetText(int tag) const;
  const std::vector<unsigned char>& GetBytes() const { return this->Bytes; }
  bool IsBigEndian() const { return this->IsBig; }

private:
  struct Entry
  {
    int Type = 0;
    std::uint64_t Count = 0;
    std::uint64_t Offset = 0; ///< of the values in the file
  };

  bool ParseDirectory(std::uint64_t at, bool isBigTiff, std::string& error);
  bool IsWithin(std::uint64_t at, std::uint64_t size) const;

  std::vector<unsigned char> Bytes;
  bool IsBig = false;
  std::map<int, Entry> Entries;
};

#endif
