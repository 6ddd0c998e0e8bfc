// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyInput
 * @brief reads what a model was built from another way than the builder does
 *
 * The builder's readers and these share no code, so a fault of one shows in the comparison. VTK's own formats are read
 * by VTK's readers, PLY, STL, OBJ, OFF and glTF by small plain ones that were written from the specifications alone,
 * volumes and terrain by vtkMTVerifyVolumeInput and vtkMTVerifyTerrainInput. A file may be compressed by gzip. Several
 * inputs become one mesh with a cell array PartId; all tiles of terrain are one input. What cannot be read here has a
 * reason; then the input counts as not checked.
 */
#ifndef vtkMTVerifyInput_h
#define vtkMTVerifyInput_h

#include "vtkMTVerificationModule.h" // For export macro

#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTVerifyInput
{
public:
  struct Options
  {
    std::vector<std::string> Paths;
    std::optional<double> IsoValue; ///< of volumes
    double VerticalScale = 1.0;     ///< of terrain
    bool Degrees = false;           ///< of terrain
  };

  struct Source
  {
    std::string Path;
    std::string Reader; ///< the class that read it, or would
    std::string Reason; ///< why it could not be read; empty when it was
  };

  /**
   * False when one of them could not be read; its source says why. rounding: what coordinates may differ from the
   * builder's, as a share of the largest one: where they are calculated, or stored in single precision.
   */
  static bool Read(const Options& options, vtkPolyData* out, std::vector<Source>& sources, double& rounding);
};

#endif
