// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class bmtCertifier
 * @brief tests a model's certified errors against the input by sampling
 *
 * (a) Every point of a patch is within the patch's error of the input surface: tested for all vertices and for
 * area-weighted samples of the patches of every level. (b) Every point of the input is no farther from a cut than the
 * largest error in that cut: tested for all vertices and for area-weighted samples of the input, against the coarsest
 * cut, one cut for every level, and random ones.
 *
 * Independent of the builder: own sampling, own closest point search, own reading of errors from the graph. Input
 * triangles that are no surface (a corner that is not finite, an index out of range, two corners at one place) are
 * skipped and counted. So are those that lie at least one extent outside of a model that says that far outliers are
 * missing from it; their number must be what the model says.
 */
#ifndef bmtCertifier_h
#define bmtCertifier_h

#include "bmtCheck.h"
#include "bmtClosestPoint.h"
#include "bmtSurface.h"

#include <cstdint>
#include <memory>
#include <vector>

class vtkMTCut;
class vtkMTPatchSource;

class bmtCertifier
{
public:
  /// samples: points on each surface beside its vertices. The source must outlive this object.
  bmtCertifier(const vtkMTPatchSource& source, bmtSurface input, std::size_t samples, std::uint64_t seed);
  ~bmtCertifier();

  /// (a) and (b) for the cut that holds the patches of one level.
  void TestLevel(std::uint32_t level);
  /// (b) for any cut.
  void TestCut(const vtkMTCut& cut, const std::string& name);

  const bmtCheck& GetPatchToInput() const { return this->PatchToInput; }
  const bmtCheck& GetInputToCut() const { return this->InputToCut; }

  /**
   * How tight the bounds are: for the nodes of each tested level the certified error over the largest distance that was
   * found by sampling, both directions; a sampled distance below the lattice's rounding counts as that rounding. By
   * level {median, worst, n}.
   */
  bmtJson GetTightness() const;
  bmtJson GetSkipped() const;
  std::uint64_t GetNumberOfCuts() const { return this->Cuts; }
  double GetTolerance() const { return this->Frame.ToModel(bmtFrame::Tolerance); }

private:
  struct CutSurface
  {
    bmtSurface Surface;
    std::vector<std::uint32_t> TriangleNodes; // the node whose error counts, per triangle
    std::vector<std::uint32_t> PointNodes;
  };
  CutSurface ReadCut(const std::vector<std::uint32_t>& arcs) const;
  void TestPatches(const CutSurface& cut, std::uint32_t level);
  void TestInput(const CutSurface& cut, double error, const std::string& name, bool countNodes);
  void Compare(bmtCheck& check, double distance, double error, const std::string& where);
  void CountNode(std::uint32_t node, double distance);

  const vtkMTPatchSource& Source;
  bmtSurface Input;
  bmtFrame Frame;
  std::size_t Samples;
  std::uint64_t Seed;
  std::unique_ptr<bmtClosestPoint> InputSearch;
  std::vector<bmtPoint> InputPoints; // vertices, then samples
  std::vector<double> NodeDistances; // largest sampled, model units; negative where nothing was sampled
  bmtCheck PatchToInput;
  bmtCheck InputToCut;
  std::uint64_t Cuts = 0;
};

#endif
