// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTGraph
 * @brief the DAG of a Multi-Triangulation: nodes, arcs, saturated errors and spheres
 *
 * The Multi-Triangulation of Cignoni et al., "Batched Multi Triangulation" (2005), section 3.1, with the orientation of
 * its figures: the DAG runs from coarse to fine. A node is one region's simplification. Arcs that enter a node carry
 * the patches of its fragment (coarse), arcs that leave it those of its floor (fine). Node 0 is the source, the arcs
 * that leave it carry the coarsest patches; the last node is the sink, the arcs that enter it carry the finest ones.
 * Every arc runs from a smaller to a larger node index, which is the proof that the graph has no cycle.
 *
 * The error of an arc's patch is that of the node which the arc enters. Every point of a fragment is within the node's
 * OwnError of the input's surface on the lattice, and the part of the input that the fragment stands for is no farther
 * from it. Errors are saturated: Error(n) is the largest of OwnError(n) with the lattice's rounding added, and of the
 * Error of the nodes that the arcs leaving n enter, so Error never grows along a path towards the sink. EdgeLength is
 * the largest of the fragment's own mean edge length and of those of the nodes below. The sphere of a node holds its
 * fragment, its floor and the spheres of the nodes that the arcs leaving it enter; the sink's sphere is the whole
 * model's.
 */
#ifndef vtkMTGraph_h
#define vtkMTGraph_h

#include "vtkMTArrayInfo.h"
#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTLattice.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

struct vtkMTNode
{
  double Error = 0.0;    ///< saturated certified distance to the input, model units; at the sink the lattice's rounding
  double OwnError = 0.0; ///< certified two-sided distance of this node's fragment and the snapped input, model units
  double EdgeLength = 0.0;                       ///< saturated mean edge length of the fragment, model units
  std::array<double, 3> Center{ 0.0, 0.0, 0.0 }; ///< of the saturated sphere, model units
  double Radius = 0.0;
  std::uint32_t FirstOut = 0; ///< the arcs that leave are Arcs[FirstOut .. FirstOut + OutCount)
  std::uint32_t OutCount = 0;
  std::uint32_t FirstIn = 0; ///< the arcs that enter are Entering[FirstIn .. FirstIn + InCount)
  std::uint32_t InCount = 0;
  std::uint32_t Level = 0;  ///< 0 at the sink; the fragment of a node of level i is part of the i-th mesh
  std::uint32_t Region = 0; ///< index of the region within its partition
};

struct vtkMTArc
{
  std::uint32_t From = 0;
  std::uint32_t To = 0;
  std::uint32_t Triangles = 0;
  std::uint32_t Points = 0;
  std::uint32_t Wedges = 0;
  std::uint32_t SharedPoints = 0;
  vtkMTBox Box{ 0, -1, 0, -1, 0, -1 }; ///< tight, in steps
  /// Every triangle's normal n has dot(n, ConeAxis) >= ConeCosine; ConeCosine <= 0 means that the cone culls nothing.
  std::array<float, 3> ConeAxis{ 0.0f, 0.0f, 1.0f };
  float ConeCosine = -1.0f;
  float MeanEdgeLength = 0.0f; ///< model units
};

/// Bytes that are carried with the model as they are, such as an image that its texture coordinates speak of.
struct vtkMTBlobInfo
{
  std::string Name;                              ///< as the input calls it
  std::string Type;                              ///< its media type, "image/png"
  std::map<std::string, std::string> Properties; ///< what it is for: "texture_coordinates", "material", ...
};

class VTKMTCORE_EXPORT vtkMTGraph
{
public:
  vtkMTLattice Lattice;
  std::vector<vtkMTNode> Nodes;
  std::vector<vtkMTArc> Arcs;          ///< sorted by From, then To
  std::vector<std::uint32_t> Entering; ///< arc indices sorted by To, then arc index
  std::vector<vtkMTArrayInfo> Arrays;
  std::vector<vtkMTBlobInfo> Blobs; ///< their bytes are in the patch source

  std::uint64_t InputTriangles = 0; ///< of the input, polygons and strips counted as triangles
  /// How the model was made: "partition", "simplifier" and every setting that has an influence on the bytes.
  std::map<std::string, std::string> Settings;
  /// What became of the input: triangles and points dropped, stitched or split, by reason; arrays left out.
  std::map<std::string, std::int64_t> InputReport;
  /// Edges that could not be collapsed in regions that stayed above their target, by cause.
  std::map<std::string, std::int64_t> Blocked;

  std::uint32_t GetSource() const { return 0; }
  std::uint32_t GetSink() const { return static_cast<std::uint32_t>(this->Nodes.size()) - 1; }
  bool IsEmpty() const { return this->Arcs.empty(); }
  /// 1 + the level of the coarsest patches.
  std::uint32_t GetNumberOfLevels() const;
  std::uint32_t GetLevelOfArc(std::uint32_t arc) const { return this->Nodes[this->Arcs[arc].To].Level; }
  /// Triangles on the arcs that leave the source, and on those that enter the sink.
  std::uint64_t GetNumberOfRootTriangles() const;
  std::uint64_t GetNumberOfFinestTriangles() const;
  void GetBounds(double bounds[6]) const;

  /// Sorts Arcs, then fills Entering and the nodes' First/Count fields from the arcs' From and To. Gives the
  /// permutation: new arc i was arc result[i].
  std::vector<std::uint32_t> Index();

  /**
   * Fills Error, EdgeLength and the spheres from the nodes' OwnError, their own mean edge length (in EdgeLength) and
   * the arcs' boxes; sinkError is the lattice's rounding. Call after Index().
   */
  void Saturate(double sinkError);

  /// BMT section 3.2: how well conditioned the DAG is.
  struct Conditioning
  {
    std::uint32_t Depth = 0;    ///< nodes on the longest path from source to sink, both not counted
    double DiameterRatio = 0.0; ///< mean over the levels of (median diameter of a level) / (that of the next finer)
    std::uint32_t FullySharedBorders =
      0; ///< filled by the builder: nodes that share their border with all of their floor's fragments
    std::uint64_t LargestFloor = 0; ///< triangles of the floor that has most
  };
  Conditioning GetConditioning() const;
  std::uint32_t FullySharedBorders = 0;
};

#endif
