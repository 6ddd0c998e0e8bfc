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
 * The error of an arc's patch is that of the node which the arc enters; GetDistanceToInput and GetDistanceFromInput are
 * the patch's own, which are never larger, and one for each direction. Every point of a fragment is within the node's
 * OwnError of the input's surface on the lattice, and the part of the input that the fragment stands for is no farther
 * from it. Errors are saturated: Error(n) is the largest of OwnError(n) with the lattice's rounding added, and of the
 * Error of the nodes that the arcs leaving n enter, so Error never grows along a path towards the sink. EdgeLength is
 * the largest of the fragment's own mean edge length and of those of the nodes below. The sphere of a node holds its
 * fragment, its floor and the spheres of the nodes that the arcs leaving it enter; the sink's sphere is the whole
 * model's. Measures are further columns over the nodes that are saturated in the same way. A level is a scale: levels
 * fall along every arc, and nothing is promised of how much coarser one is than the next.
 *
 * A graph may be *partly known*, while a file is read by and by: then Nodes, Arcs and Entering have their full sizes,
 * and the records of the first nodes and arcs are there. GetNumberOfKnownNodes says for how many nodes everything is
 * known that refining them takes: all their arcs and the records of the nodes that these enter or leave. That is a
 * prefix which is closed under dependency, since arcs run from smaller to larger indices, so the known part with
 * nothing refined beyond it is a Multi-Triangulation of its own. It only grows, and one thread may fill in what lies
 * beyond it while others look at what lies within.
 */
#ifndef vtkMTGraph_h
#define vtkMTGraph_h

#include "vtkMTArrayInfo.h"
#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTLattice.h"
#include "vtkMTPatch.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
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
  float MeanEdgeLength = 0.0f; ///< model units; the largest number there is where it is beyond single precision
  ///@{
  /// Certified for this patch alone, in steps of the lattice, against the input on the lattice: no point of the patch
  /// is farther from the input than ToInput, and none of the points of the input that the patch stands for, which every
  /// cut with this patch shows by it, is farther from the patch than FromInput. Unknown where the error of the node
  /// that the arc enters is all that is known.
  static constexpr float Unknown = -1.0f;
  float ToInput = Unknown;
  float FromInput = Unknown;
  bool HasDistances() const { return this->ToInput >= 0.0f && this->FromInput >= 0.0f; }
  ///@}
  vtkMTPatchKind Kind = vtkMTPatchKind::Triangles;

  /// Whether the arc is a mere dependency: there is nothing to read and nothing to draw, and its box is empty.
  bool IsDependency() const { return this->Points == 0 && this->Wedges == 0 && this->Triangles == 0; }
};

/// Some arcs: indices that lie one after the other in the graph's table Entering.
class vtkMTArcList
{
public:
  vtkMTArcList(const std::uint32_t* first, std::size_t count)
    : First(first)
    , Last(first + count)
  {
  }
  const std::uint32_t* begin() const { return this->First; }
  const std::uint32_t* end() const { return this->Last; }
  std::size_t size() const { return static_cast<std::size_t>(this->Last - this->First); }

private:
  const std::uint32_t* First;
  const std::uint32_t* Last;
};

/// A column over the nodes beside Error and EdgeLength: the largest deviation of an array's values, say. While a graph
/// is built, a node's value is that of its own fragment; Saturate makes it the largest of those below as well.
struct vtkMTMeasure
{
  /// The name of that which holds certified angles (radians, at most pi) between the shading normals of a node's
  /// fragment and those of the input: every point of the fragment has a point of the input's within Error of it whose
  /// normal is within the angle, and the other way round. Of the normals as they are in the model, at its finest level;
  /// of the triangles where it has none. Models of earlier versions of the builder do not have it.
  static constexpr const char* NormalDeviation = "normal deviation";
  /// The name of the mean of these certified angles over a fragment, each of its triangles with its own one, weighted
  /// by area: it tells nodes apart where the largest angle has long been a straight one.
  static constexpr const char* MeanNormalDeviation = "mean normal deviation";

  std::string Name;
  std::vector<double> Values; ///< one for each node; finite, not negative
};

/// Ranges of chosen arrays for every arc, of everything that the arc stands for: its patch and all that is below.
struct vtkMTArcRanges
{
  struct Column
  {
    std::uint32_t Array = 0;
    std::uint32_t Component = 0;
    bool operator==(const Column& other) const
    {
      return this->Array == other.Array && this->Component == other.Component;
    }
  };
  std::vector<Column> Columns;
  std::vector<vtkMTRange> Values; ///< of column c of arc a: [a * Columns.size() + c]
};

/// What the input consisted of, by kind.
struct vtkMTInputCounts
{
  std::uint64_t Triangles = 0; ///< polygons and strips counted as triangles
  std::uint64_t Points = 0;    ///< of a cloud of points
  std::uint64_t Samples = 0;   ///< of volumes and height fields
  std::uint64_t Cells = 0;     ///< of other kinds
};

/// Figures of the whole model, which are known before all of the graph is.
struct vtkMTGraphFigures
{
  std::uint32_t Levels = 0;
  std::uint64_t FinestTriangles = 0;
  std::uint32_t LargestWedges = 0; ///< of a patch, so that buffers can be laid out for all of them
  vtkMTBox Box{ 0, -1, 0, -1, 0, -1 };
  void AddBox(const vtkMTBox& box)
  {
    for (std::size_t i = 0; i < 6 && box[0] <= box[1]; i += 2)
    {
      const bool isFirst = this->Box[i] > this->Box[i + 1];
      this->Box[i] = isFirst || box[i] < this->Box[i] ? box[i] : this->Box[i];
      this->Box[i + 1] = isFirst || box[i + 1] > this->Box[i + 1] ? box[i + 1] : this->Box[i + 1];
    }
  }
  bool operator==(const vtkMTGraphFigures& other) const
  {
    return this->Levels == other.Levels && this->FinestTriangles == other.FinestTriangles &&
      this->LargestWedges == other.LargestWedges && this->Box == other.Box;
  }
};

/// Bytes that are carried with the model as they are, such as an image that its texture coordinates refer to.
struct vtkMTBlobInfo
{
  std::string Name;                              ///< as the input calls it
  std::string Type;                              ///< its media type, "image/png"
  std::map<std::string, std::string> Properties; ///< what it is for: "texture_coordinates", "material", ...
};

class VTKMTCORE_EXPORT vtkMTGraph
{
public:
  /// How a refinement pastes: it takes the arcs that enter the node away, or it adds those that leave it to them.
  enum RefinementType : std::uint8_t
  {
    Replace = 0,
    Add = 1
  };

  vtkMTLattice Lattice;
  RefinementType Refinement = Replace;
  std::vector<vtkMTNode> Nodes;
  std::vector<vtkMTArc> Arcs;          ///< sorted by From, then To
  std::vector<std::uint32_t> Entering; ///< arc indices sorted by To, then arc index
  std::vector<vtkMTArrayInfo> Arrays;
  std::vector<vtkMTBlobInfo> Blobs; ///< their bytes are in the patch source

  std::vector<vtkMTMeasure> Measures;
  vtkMTArcRanges ArcRanges; ///< optional: patch sinks fill in the values where there are columns
  /// Of the whole model, of each component of each array: [array][component], over all tuples of the finest level, as
  /// vtkMTArrayInfo::GetRanges defines them. Patch sinks fill them in; no entries where they are not known.
  std::vector<std::vector<vtkMTRange>> ArrayRanges;

  /// From model units to the world, row by row, where the model has a frame of its own.
  std::optional<std::array<double, 16>> Frame;
  std::string Crs;   ///< coordinate reference system of the model units ("EPSG:2056", WKT), where it is known
  std::string Units; ///< of the coordinates ("m"), where they are known

  vtkMTInputCounts InputCounts;
  /// How the model was made: "partition", "simplifier" and every setting that has an influence on the bytes.
  std::map<std::string, std::string> Settings;
  /// What became of the input: triangles and points dropped, stitched or split, by reason; arrays left out.
  std::map<std::string, std::int64_t> InputReport;
  /// Edges that could not be collapsed in regions that stayed above their target, by cause.
  std::map<std::string, std::int64_t> Blocked;

  /// The measure of that name, or null.
  const vtkMTMeasure* FindMeasure(const std::string& name) const;

  std::uint32_t GetSource() const { return 0; }
  std::uint32_t GetSink() const { return static_cast<std::uint32_t>(this->Nodes.size()) - 1; }
  bool IsEmpty() const { return this->Arcs.empty(); }

  ///@{
  /// How much is known, see above. All that is within may be looked at from any thread.
  std::uint32_t GetNumberOfKnownNodes() const;
  std::uint32_t GetNumberOfKnownArcs() const; ///< those that leave known nodes
  bool IsWhole() const { return this->Known.Count.load(std::memory_order_acquire) == KnownPrefix::All; }
  /// For whoever reads the graph by and by: what it has filled in is for all to see from now on. nodes: at most their
  /// number, which says that the graph is whole.
  void SetNumberOfKnownNodes(std::uint32_t nodes);
  ///@}

  /// Of the whole model, also where the graph is partly known. 1 + the level of the coarsest patches.
  std::uint32_t GetNumberOfLevels() const;
  /// Whether the arc's patch is part of the finest level: it enters the sink, or refinement only adds.
  bool IsFinest(std::uint32_t arc) const { return this->Refinement == Add || this->Arcs[arc].To == this->GetSink(); }
  ///@{
  /// Of an arc's patch and the input, the lattice's rounding included, model units: no point of the patch is farther
  /// from the input, and no point of that part of the input which the patch stands for is farther from the patch. So
  /// no point of the input is farther from a cut than the largest GetDistanceFromInput of its arcs.
  double GetDistanceToInput(std::uint32_t arc) const { return this->GetDistance(arc, this->Arcs[arc].ToInput); }
  double GetDistanceFromInput(std::uint32_t arc) const { return this->GetDistance(arc, this->Arcs[arc].FromInput); }
  /// Whether all arcs have distances of their own.
  bool HasArcDistances() const;
  ///@}
  std::uint32_t GetLevelOfArc(std::uint32_t arc) const { return this->Nodes[this->Arcs[arc].To].Level; }
  /// Triangles on the arcs that leave the source, and on those that enter the sink.
  std::uint64_t GetNumberOfRootTriangles() const;
  std::uint64_t GetNumberOfFinestTriangles() const;
  void GetBounds(double bounds[6]) const;
  /// All of these; where the graph is whole they are counted.
  vtkMTGraphFigures GetFigures() const;
  /// What GetFigures gives while the graph is partly known.
  void SetFigures(const vtkMTGraphFigures& figures) { this->Figures = figures; }

  /// The arcs that enter the node: what it depends on.
  vtkMTArcList GetEntering(std::uint32_t node) const
  {
    const vtkMTNode& record = this->Nodes[node];
    return { this->Entering.data() + record.FirstIn, record.InCount };
  }
  /// The arcs that refining the node takes away: those that enter it, or none where refinement adds.
  vtkMTArcList GetReplaced(std::uint32_t node) const
  {
    const vtkMTNode& record = this->Nodes[node];
    return { this->Entering.data() + record.FirstIn, this->Refinement == Replace ? record.InCount : 0 };
  }
  /// Neither the sink nor beyond what is known. When a node can be refined, so can all that it depends on.
  bool IsRefinable(std::uint32_t node) const
  {
    return node != this->GetSink() && node < this->Known.Count.load(std::memory_order_acquire);
  }

  /// Sorts Arcs, then fills Entering and the nodes' First/Count fields from the arcs' From and To. Gives the
  /// permutation: new arc i was arc result[i].
  std::vector<std::uint32_t> Index();

  /**
   * Fills Error, EdgeLength and the spheres from the nodes' OwnError, their own mean edge length (in EdgeLength) and
   * the arcs' boxes, and saturates Measures; sinkError is the lattice's rounding. Call after Index().
   */
  void Saturate(double sinkError);
  /// Makes of the ranges of the arcs' patches those of everything that the arcs stand for.
  void SaturateRanges(vtkMTArcRanges& ranges) const;

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

private:
  // A prefix that other threads may see grow. Copying a graph copies what is known at that time.
  struct KnownPrefix
  {
    static constexpr std::uint32_t All = 0xffffffffu;
    std::atomic<std::uint32_t> Count{ All };

    KnownPrefix() = default;
    KnownPrefix(const KnownPrefix& other)
      : Count(other.Count.load())
    {
    }
    KnownPrefix& operator=(const KnownPrefix& other)
    {
      this->Count = other.Count.load();
      return *this;
    }
  };
  double GetDistance(std::uint32_t arc, float steps) const;

  KnownPrefix Known;
  vtkMTGraphFigures Figures;
};

#endif
