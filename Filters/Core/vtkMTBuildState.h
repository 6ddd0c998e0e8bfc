// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBuildState
 * @brief what every builder records of the graph while it makes it
 *
 * Regions become nodes in the order in which they are done, patches become arcs in the order in which they are written;
 * the final numbers follow at the end (vtkMTFinishGraph). Each builder adds what its own steps go on from. Save and
 * Load are for checkpoints.
 */
#ifndef vtkMTBuildState_h
#define vtkMTBuildState_h

#include "vtkMTBytes.h"
#include "vtkMTFiltersCoreModule.h" // For export macro
#include "vtkMTGraph.h"

#include <cstdint>
#include <string>
#include <vector>

class VTKMTFILTERSCORE_EXPORT vtkMTBuildState
{
public:
  static constexpr std::uint32_t None = ~std::uint32_t(0);

  struct NodeRecord
  {
    std::uint32_t Level;
    std::uint32_t Region;
    double Error;                  // steps
    double EdgeLength;             // steps
    double NormalDeviation = -1.0; // radians; below 0: not certified
    double MeanNormalDeviation = -1.0;
  };

  struct ArcRecord
  {
    vtkMTArc Arc;
    std::uint32_t FromNode; // index of a node record, None for the source; a region until that is done
    std::uint32_t ToNode;   // the same, None for the sink
  };

  vtkMTBuildState();
  ~vtkMTBuildState();

  std::uint32_t Level = 0;
  vtkMTGraph Graph;                         ///< lattice, arrays, reports; nodes and arcs only at the end
  std::vector<NodeRecord> Nodes;            ///< in the order in which their regions were done
  std::vector<std::string> CertifiedArrays; ///< whose values are certified
  std::vector<vtkMTRange> CertifiedRanges;  ///< of those, over the input
  std::vector<double> NodeValueDeviations;  ///< [node * arrays + array] of those
  std::vector<ArcRecord> Arcs;              ///< in the order in which their patches were written
  std::vector<std::uint64_t> LevelElements; ///< triangles, points or samples of level 0, 1 ...

  void Save(vtkMTBytes::Writer& writer) const;
  /// What is wrong shows in the reader (IsSound).
  void Load(vtkMTBytes::Reader& reader);
};

#endif
