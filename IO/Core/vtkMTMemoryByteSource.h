// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTMemoryByteSource
 * @brief a block of memory as a byte source
 */
#ifndef vtkMTMemoryByteSource_h
#define vtkMTMemoryByteSource_h

#include "vtkMTByteSource.h"
#include "vtkMTIOCoreModule.h" // For export macro

#include <vector>

class VTKMTIOCORE_EXPORT vtkMTMemoryByteSource : public vtkMTByteSource
{
public:
  explicit vtkMTMemoryByteSource(std::vector<unsigned char> bytes);
  ~vtkMTMemoryByteSource() override;

  std::uint64_t GetSize() const override { return this->Bytes.size(); }
  bool Read(std::uint64_t offset, std::size_t count, void* destination, std::string& error) const override;
  std::string GetName() const override { return "memory"; }

private:
  std::vector<unsigned char> Bytes;
};

#endif
