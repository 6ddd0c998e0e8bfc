// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTErrorSampling
 * @brief tests a model's certified errors against the input by sampling
 *
 * (a) Every point of a patch is within the patch's own distance of the input surface: tested for all vertices and for
 * area-weighted samples of the patches of every level. (b) Every point of the input is no farther from a cut than the
 * largest distance of its patches for that direction: tested for all vertices and for area-weighted samples of the
 * input, against the coarsest cut, one cut for every level, and random ones. From the samples of a node that are
 * farthest away the search climbs to places that are farther. And where a point is farther from the nearest patch than
 * that one's own distance, there must be another patch within whose distance it is, which stands for it. Where a model
 * has no distances of its patches the errors of their nodes take their place.
 *
 * Independent of the builder: own sampling, own closest point search, own reading of errors from the graph. Input
 * triangles that are no surface (a corner that is not finite, an index out of range, two corners at one place) are
 * skipped and counted. So are those that lie at least one extent outside of a model that says that far outliers are
 * missing from it; their number must be what the model says. Where the input has slack (vtkMTVerifyPolygons), distances
 * may be larger by it.
 */
#ifndef vtkMTErrorSampling_h
#define vtkMTErrorSampling_h

#include "vtkMTClosestPoint.h"
#include "vtkMTFarthestPlaces.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTSurfaceSampler.h"
#include "vtkMTVerificationCheck.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

class vtkMTCut;
class vtkMTGraph;
class vtkMTPatchSource;

class VTKMTVERIFICATION_EXPORT vtkMTErrorSampling
{
public:
  /// samples: points on each surface beside its vertices. The source must outlive this object.
  vtkMTErrorSampling(
    const vtkMTPatchSource& source, vtkMTSampledSurface input, std::size_t samples, std::uint64_t seed);
  ~vtkMTErrorSampling();

  ///@{
  /// False when a patch cannot be read, which error says, and when progress stopped it; then error is as it was.
  /// (a) and (b) for the cut that holds the patches of one level.
  bool TestLevel(std::uint32_t level, const vtkMTVerificationProgress& progress, std::string& error);
  /// (b) for any cut.
  bool TestCut(
    const vtkMTCut& cut, const std::string& name, const vtkMTVerificationProgress& progress, std::string& error);
  ///@}

  /// The cut whose patches are those of one level: everything coarser is refined.
  static vtkMTCut MakeLevelCut(const vtkMTGraph& graph, std::uint32_t level);

  const vtkMTVerificationCheck& GetPatchToInput() const { return this->PatchToInput; }
  const vtkMTVerificationCheck& GetInputToCut() const { return this->InputToCut; }

  /**
   * How tight the bounds are: for the nodes of each tested level the certified error over the largest distance that was
   * found by sampling, both directions; a sampled distance below the lattice's rounding counts as that rounding.
   */
  struct Tightness
  {
    double Median = 0.0;
    double Worst = 0.0;
    std::size_t Nodes = 0;
  };
  /// By level.
  std::map<std::uint32_t, Tightness> GetTightness() const;
  /// What the input has, and what of it was left out.
  const vtkMTSampledSurface& GetInput() const { return this->Input; }
  std::uint64_t GetNumberOfCuts() const { return this->Cuts; }
  /// For the rounding of coordinates, the input's where these are calculated included; model units.
  double GetTolerance() const { return this->Frame.ToModel(vtkMTMeasuringFrame::Tolerance) + this->Input.Rounding; }

private:
  struct CutSurface
  {
    vtkMTSampledSurface Surface;
    std::vector<std::uint32_t> TriangleArcs; // per triangle
    std::vector<std::uint32_t> PointArcs;
  };
  bool ReadCut(const std::vector<std::uint32_t>& arcs, const vtkMTVerificationProgress& progress, CutSurface& cut,
    std::string& error) const;
  bool TestPatches(const CutSurface& cut, std::uint32_t level, const vtkMTVerificationProgress& progress);
  bool TestInput(const CutSurface& cut, const std::vector<std::uint32_t>& arcs, const std::string& name,
    bool countNodes, const vtkMTVerificationProgress& progress);
  using Places = vtkMTFarthestPlaces::Places;
  void TestPlaceOfPatch(std::uint32_t arc, const vtkMTFarthestPlaces::Place& place, const std::string& name);
  struct CutTest
  {
    const CutSurface& Cut;
    const vtkMTClosestPoint& Search;
    const std::string& Name;
    double Error; // the largest of its patches
    bool CountsNodes;
  };
  void TestPlaceOfInput(const CutTest& test, const vtkMTFarthestPlaces::Place& place);
  bool IsStoodFor(const CutSurface& cut, const vtkMTClosestPoint& search, const vtkMTRealPoint& point, double radius,
    double allowance) const;
  void Compare(vtkMTVerificationCheck& check, double distance, double error, const std::string& where);
  void CountNode(std::uint32_t node, double distance);

  const vtkMTPatchSource& Source;
  vtkMTSampledSurface Input;
  vtkMTMeasuringFrame Frame;
  std::size_t Samples;
  std::uint64_t Seed;
  std::unique_ptr<vtkMTClosestPoint> InputSearch;
  std::vector<vtkMTRealPoint> InputVertices;
  vtkMTSurfaceSampler::Samples InputSamples;
  double LargestSlack = 0.0;         // local units
  std::vector<double> NodeDistances; // largest sampled, model units; negative where nothing was sampled
  vtkMTVerificationCheck PatchToInput;
  vtkMTVerificationCheck InputToCut;
  std::uint64_t Cuts = 0;
};

#endif
