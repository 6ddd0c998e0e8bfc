// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyGltfFile
 * @brief the JSON and the accessors of a glTF 2.0 file, for the verification, after the specification alone
 *
 * .gltf and .glb; buffers in the file, beside it (names are percent-decoded) and as data URIs in base64. Accessors are
 * read as doubles: every component type, normalized integers, strides and sparse substitution. Buffer views that are
 * compressed (meshopt) are not read.
 */
#ifndef vtkMTVerifyGltfFile_h
#define vtkMTVerifyGltfFile_h

#include "vtkMTVerificationModule.h" // For export macro
#include "vtkMTVerifyJson.h"

#include <cstddef>
#include <string>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTVerifyGltfFile
{
public:
  struct Accessor
  {
    std::vector<double> Values;
    int Components = 1;
    std::size_t Count = 0;
  };

  bool Open(const std::string& path, std::string& error);
  const vtkMTVerifyJson& GetRoot() const { return this->Root; }
  bool Read(double index, Accessor& accessor, std::string& error);

private:
  const std::string* GetBuffer(double index, std::string& error);
  bool ReadNumbers(const vtkMTVerifyJson& where, double componentType, std::size_t components, std::size_t count,
    bool isNormalized, std::vector<double>& values, std::string& error);
  bool Substitute(
    const vtkMTVerifyJson& sparse, double componentType, bool isNormalized, Accessor& accessor, std::string& error);

  std::string Path;
  vtkMTVerifyJson Root;
  std::string Binary; ///< of a .glb
  bool HasBinary = false;
  std::vector<std::string> Buffers;
  std::vector<bool> IsRead;
};

#endif
