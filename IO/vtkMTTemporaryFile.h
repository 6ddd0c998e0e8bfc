// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTemporaryFile
 * @brief a nameless file: written at its end, read anywhere, gone with the process
 *
 * It is made in a given folder, so that it fills the disk that the user has chosen for the output, and loses its name
 * at once: whatever ends the process, nothing remains.
 */
#ifndef vtkMTTemporaryFile_h
#define vtkMTTemporaryFile_h

#include "vtkMTIOModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <string>

class VTKMTIO_EXPORT vtkMTTemporaryFile
{
public:
  vtkMTTemporaryFile();
  ~vtkMTTemporaryFile();

  /// The file is made in the folder of path.
  bool OpenBeside(const std::string& path);
  bool Append(const void* data, std::size_t size);
  bool Read(std::uint64_t offset, std::size_t count, void* destination);
  void Close();

  bool IsOpen() const { return this->Descriptor >= 0; }
  std::uint64_t GetSize() const { return this->Size; }
  const std::string& GetError() const { return this->Error; }

private:
  vtkMTTemporaryFile(const vtkMTTemporaryFile&) = delete;
  void operator=(const vtkMTTemporaryFile&) = delete;

  std::string Folder;
  std::string Error;
  int Descriptor = -1;
  std::uint64_t Size = 0;
};

#endif
