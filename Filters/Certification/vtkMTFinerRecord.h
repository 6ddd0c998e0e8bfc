// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFinerRecord
 * @brief the shape of a patch and what is known of its triangles as bytes, of which what is near is taken
 *
 * A fragment is held against a mesh that has up to 32 times its triangles, but only near those of its triangles whose
 * sums decide (vtkMTDirectDeviation). So a record begins with balls around blocks of 64 and groups of 8 triangles,
 * which neighbours in order are in space as well, and only groups that are near are decoded; nothing is copied before.
 */
#ifndef vtkMTFinerRecord_h
#define vtkMTFinerRecord_h

#include "vtkMTBytes.h"
#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTDirectDeviation.h"

#include <vector>

class VTKMTCERTIFICATION_EXPORT vtkMTFinerRecord
{
public:
  using Bytes = std::vector<unsigned char>;

  /// deviations: [mesh's triangles]. Bytes are replaced.
  static void Encode(const vtkMTPatch& mesh, const vtkMTDirectDeviation::Deviations& deviations, Bytes& bytes);
  /// Appends the groups of a record that are near, as seen from origin. False where the record is not as it was
  /// written; the part may have some of it then.
  static bool Append(const vtkMTBytes::Record& record, const vtkMTDirectDeviation::Neighbourhood& near,
    const vtkMTPoint& origin, vtkMTDirectDeviation::FinerPart& part);

  /// Around a box of lattice points, as seen from origin, and so much wider.
  static vtkMTBoxRuns::Ball GetBall(const vtkMTBox& box, const vtkMTPoint& origin, double wider);
};

#endif
