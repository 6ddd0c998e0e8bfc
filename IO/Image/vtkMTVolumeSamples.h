// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVolumeSamples
 * @brief the samples that a volume's header describes, a slab of slices at a time
 *
 * Samples that are stored as they are are read from their files when a slab is wanted; encoded ones are decoded once
 * and held, and slabs lie in that memory where they can. Values that the header scales become float where the elements
 * have at most 16 bits or are float themselves, else double. Not installed.
 */
#ifndef vtkMTVolumeSamples_h
#define vtkMTVolumeSamples_h

#include "vtkMTVolumeHeader.h"
#include "vtkMTVolumeSlabs.h"

#include <cstddef>
#include <memory>
#include <vector>

class vtkDataArray;
class vtkMTByteSource;

class vtkMTVolumeSamples : public vtkMTVolumeSlabs
{
public:
  vtkMTVolumeSamples();
  ~vtkMTVolumeSamples() override;

  /// Opens the files, and decodes what is encoded. False with a reason when they cannot hold the samples.
  bool Open(const vtkMTVolumeHeader& header, std::string& error);

  bool Read(int first, int last, vtkImageData* slab, std::string& error) override;

private:
  bool OpenFiles(std::string& error);
  bool CheckFile(const vtkMTByteSource& file, vtkMTVolumeHeader::File& place, std::string& error) const;
  bool Decode(std::string& error);
  bool DecodeText(
    const vtkMTByteSource& file, std::uint64_t offset, std::size_t count, unsigned char* to, std::string& error) const;
  std::uint64_t GetElementsOfFile() const { return this->Header.Elements / this->Header.Files.size(); }
  std::uint64_t GetNumberOfNeededElements() const;
  bool ReadElements(std::uint64_t first, std::size_t count, unsigned char* to, std::string& error) const;
  bool Gather(int first, int last, unsigned char* to, std::string& error);
  void Swap(unsigned char* elements, std::size_t count) const;

  vtkMTVolumeHeader Header;
  std::size_t ElementSize = 1;
  bool IsPlain = false; // samples lie one behind the other
  bool IsScaled = false;
  std::vector<std::unique_ptr<vtkMTByteSource>> Sources; // of raw samples
  std::vector<unsigned char> Decoded;                    // of others, in this machine's order
  std::vector<unsigned char> Slice;
};

#endif
