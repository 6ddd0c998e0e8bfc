// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTModelTextures
 * @brief the images of a model's textures, and what each of them is put on
 *
 * The builder keeps the image files that a mesh refers to as blobs of the model (use: texture). Those in PNG and JPEG
 * that go by the active texture coordinates are read here, the first NumberLimit of them: what shaders can look at in
 * any OpenGL. Whatever is not read is listed with the reason.
 */
#ifndef vtkMTModelTextures_h
#define vtkMTModelTextures_h

#include "vtkImageData.h"
#include "vtkMTFiltersModule.h" // For export macro
#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkMTPatchSource;

struct VTKMTFILTERS_EXPORT vtkMTModelTextures
{
  struct Texture
  {
    std::string Name;  ///< an identifier, another for each
    int Material = -1; ///< the value of the cell array "MaterialIds", or -1 for all cells
    int Part = -1;     ///< likewise of "PartId"
    vtkSmartPointer<vtkImageData> Image;
  };

  static constexpr std::size_t NumberLimit = 12;

  std::vector<Texture> Textures;
  std::vector<std::string> Problems;

  static vtkMTModelTextures Read(const vtkMTPatchSource& source);

  /// In their place, an image file (PNG or JPEG) that the mesh does not refer to, on all cells. False with the reason,
  /// which names the file.
  bool ReplaceByFile(const std::string& path, std::string& error);
};

#endif
