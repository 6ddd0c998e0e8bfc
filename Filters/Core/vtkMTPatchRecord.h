// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchRecord
 * @brief a patch as bytes, for the spools of a builder
 *
 * Plain and fast: lists one behind the other. Columns of zeros take no room. Never
 * part of a file: patches are encoded for that by the sink.
 */
#ifndef vtkMTPatchRecord_h
#define vtkMTPatchRecord_h

#include "vtkMTBytes.h"
#include "vtkMTFiltersCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <string>
#include <vector>

namespace vtkMTBytes
{
class Reader;
class Writer;
}

struct VTKMTFILTERSCORE_EXPORT vtkMTPatchRecord
{
  ///@{
  /// As a part of a record. Take gives false when the bytes are not those of a patch.
  static void Put(const vtkMTPatch& patch, vtkMTBytes::Writer& writer);
  static bool Take(vtkMTBytes::Reader& reader, vtkMTPatch& patch);

  /// Points and triangles of a record, where they lie.
  struct Shape
  {
    vtkMTBytes::View<vtkMTPoint> Points;
    vtkMTBytes::View<std::uint32_t> WedgePoints;
    vtkMTBytes::View<vtkMTTriangle> Triangles;
  };
  /// What Put has put, up to these.
  static Shape TakeShape(vtkMTBytes::Reader& reader);
  ///@}

  /// Replaces what is in bytes.
  static void Encode(const vtkMTPatch& patch, std::vector<unsigned char>& bytes);
  /// False with a message in error when the bytes are not those of a patch.
  static bool Decode(const vtkMTBytes::Record& bytes, vtkMTPatch& patch, std::string& error);
};

#endif
