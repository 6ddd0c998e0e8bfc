// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is measured on a Multi-Triangulation of a stiff or extreme mesh: a model is built and verified, and each level's
 * cut is searched for its worst place, in both directions, and counted through.
 */
#ifndef MTStiffStudy_h
#define MTStiffStudy_h

#include "MTStiffTopology.h"
#include "MTWorstPlace.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkMTPatchStore;
class vtkPolyData;

class MTStiffStudy
{
public:
  struct Settings
  {
    int PatchTriangles = 64;
    int LatticeBits = 24;
    int DirectLevels = 5; ///< see vtkMultiTriangulationBuilder
    bool IsVerified = true;
    int Samples = 2000; ///< of the verifier, on each surface
    int Cuts = 6;       ///< of the verifier
    std::size_t Climbs = 24;
    std::size_t Pairs = 3000000;         ///< of boxes that overlap; intersections are not counted where there are more
    std::size_t SearchTriangles = 30000; ///< larger inputs are not searched, and not counted through
  };

  /// The cut that holds the patches of one level. Distances are in model units.
  struct Level
  {
    std::uint64_t Triangles = 0;
    double Certified = 0.0;     ///< the largest error in the cut
    double OwnDistance = 0.0;   ///< the largest of the patches' own certified distances, in either direction
    double MedianError = 0.0;   ///< of the nodes of this level
    double Found = 0.0;         ///< the worst place of either direction
    double ViolatedPatch = 0.0; ///< the largest of what was found in a triangle over its patch's own certified distance
    double ViolatedCut = 0.0;   ///< what was found from the input over the largest such distance of the cut's patches
    std::int64_t Flipped = 0;   ///< triangles that face away from the level 0 beside their barycentre
    MTStiffTopology Topology;
  };

  struct Result
  {
    std::string Error; ///< empty: it was built
    std::uint64_t InputTriangles = 0;
    double CpuSeconds = 0.0; ///< of the build
    double Diagonal = 0.0;
    double Step = 0.0;
    std::uint64_t RootTriangles = 0;
    double LargestOwnError = 0.0; ///< of all nodes but source and sink
    bool IsValid = false;         ///< what the verifier finds
    std::string Violation;        ///< its first message
    bool IsFinite = false;        ///< every number of graph and patches
    bool IsSearched = false;      ///< whether Found, Violated, Flipped and Topology are there
    std::vector<Level> Levels;

    double GetViolation() const; ///< the largest of all levels: at most 1 where certified errors hold
    /// The largest of certified over found, of all levels; where less was found than ten steps, over ten steps.
    double GetLooseness() const;
    double GetOwnLooseness() const;            ///< the same of the patches' own distances
    double GetFlippedShare() const;            ///< the largest of all levels
    std::int64_t GetMadeIntersections() const; ///< the largest of all levels over level 0; -1: not counted
    bool KeepsComponents() const;
    bool KeepsEuler() const;
    double GetCoarsestShare() const; ///< what was found at the coarsest level over the diagonal
  };

  /// False, with the reason in error, when it cannot be built.
  static bool Build(vtkPolyData* input, const Settings& settings, vtkMTPatchStore& store, std::string& error);
  static Result Run(vtkPolyData* input, const Settings& settings);

  /// What the second model differs from the first by when the input was scaled by a power of two; empty: by nothing.
  static std::string CompareScaled(const vtkMTPatchStore& store, const vtkMTPatchStore& scaled, double scale);

  /**
   * How far two models of one surface are apart: the largest ratio, one way or the other, of the median errors of a
   * level that both have and where either is more than ten steps; 1 where there is no such level.
   */
  static double CompareErrors(const Result& a, const Result& b);
};

#endif
