// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTexture
 * @brief an image that a mesh refers to, as the bytes of its file, and what it is put on
 */
#ifndef vtkMTTexture_h
#define vtkMTTexture_h

#include <string>
#include <vector>

struct vtkMTTexture
{
  std::string Name;     ///< as the input calls it
  std::string MimeType; ///< "image/png" and so on, found in the bytes themselves
  std::vector<unsigned char> Bytes;
  std::string Coordinates = "TCoords"; ///< the point array that it goes by, counted from the image's lower left
  int Material = -1;                   ///< the value of the cell array "MaterialIds", or -1 for all cells
  std::string MaterialName;
  int Part = -1; ///< the value of the cell array "PartId", or -1 where there is one part
};

#endif
