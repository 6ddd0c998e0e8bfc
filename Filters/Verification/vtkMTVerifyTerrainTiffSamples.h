// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyTerrainTiffSamples
 * @brief decodes the first band of a TIFF image, in strips or tiles
 *
 * Whole numbers of 8 to 64 bits and real ones of 32 and 64; without compression, PackBits, LZW and Deflate; horizontal
 * differences (predictor 2) and those of real numbers (3, Adobe's technical note 3). A block that the file leaves out
 * is void.
 */
#ifndef vtkMTVerifyTerrainTiffSamples_h
#define vtkMTVerifyTerrainTiffSamples_h

#include "vtkMTVerificationModule.h" // For export macro

#include <cstddef>
#include <string>
#include <vector>

class vtkMTVerifyTerrainTiff;
struct vtkMTVerifyTerrainTile;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyTerrainTiffSamples
{
public:
  vtkMTVerifyTerrainTiffSamples(const vtkMTVerifyTerrainTiff& tiff, vtkMTVerifyTerrainTile& tile);

  /// Sets the tile's Columns, Rows and Heights. False with the reason in error.
  bool Read(std::string& error);

private:
  bool ReadLayout(std::string& error);
  bool IsKnown(std::string& error);
  bool ReadBlock(std::size_t index, std::string& error);
  bool Decompress(
    const unsigned char* data, std::size_t size, std::vector<unsigned char>& block, std::string& error) const;
  /// Undoes the predictor; the bytes are in the order of IsBig afterwards.
  void Integrate(std::vector<unsigned char>& block);
  void IntegrateWhole(unsigned char* row) const;
  void IntegrateReal(unsigned char* row) const;
  double GetSample(const unsigned char* place) const;

  const vtkMTVerifyTerrainTiff& Tiff;
  vtkMTVerifyTerrainTile& Tile;
  std::size_t SampleBytes = 0; ///< of one sample
  std::size_t Bands = 1;       ///< samples beside each other in a block
  std::size_t BlockColumns = 0;
  std::size_t BlockRows = 0;
  std::size_t BlocksAcross = 0;
  std::size_t BlocksDown = 0;
  int Format = 1; ///< 1: unsigned, 2: signed, 3: real
  int Compression = 1;
  int Predictor = 1;
  bool IsBig = false; ///< byte order of samples; predictor 3 has its own
  std::vector<double> Offsets;
  std::vector<double> Sizes;
};

#endif
