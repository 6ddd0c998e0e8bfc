// SPDX-License-Identifier: BSD-3-Clause
/**
 * The cuts of a model's levels beside its input, in a frame of unit size: what MTStiffStudy measures on each.
 */
#ifndef MTStiffLevels_h
#define MTStiffLevels_h

#include "MTStiffStudy.h"

#include <memory>

class MTStiffLevels
{
public:
  /// Both must outlive this object. isSearched: without, only triangles and certified errors are there.
  MTStiffLevels(vtkPolyData* input, const vtkMTPatchStore& store, std::size_t climbs, bool isSearched);

  MTStiffStudy::Level Measure(std::uint32_t level, std::size_t pairs) const;
  /// In the frame.
  const MTWorstPlace::Surface& GetInput() const { return this->Input; }
  MTWorstPlace::Surface GetSurface(std::uint32_t level) const;
  double ToLocal(double distance) const;
  double GetDiagonal() const { return this->Diagonal; } ///< of the input, model units

private:
  /// A level's cut as one mesh.
  struct Cut
  {
    MTStiffTopology::Mesh Lattice;
    MTWorstPlace::Surface Surface; // local
    std::vector<double> ToInput;   // certified for each triangle's patch, model units
    double FromInput = 0.0;        // the largest in the cut
    double OwnDistance = 0.0;      // the larger of FromInput and the largest ToInput
    double Error = 0.0;            // the largest in the cut, of nodes
  };
  bool Read(std::uint32_t level, Cut& cut) const;
  void ReadInput(vtkPolyData* input);
  MTWorstPlace::Place ToLocal(const MTWorstPlace::Place& x) const;
  void Search(const Cut& cut, MTStiffStudy::Level& found) const;
  std::int64_t CountFlipped(const Cut& cut) const;

  const vtkMTPatchStore& Store;
  const std::size_t Climbs;
  const bool IsSearched;
  MTWorstPlace::Place Center{ 0.0, 0.0, 0.0 };
  int Exponent = 0; // local = (model - Center) * 2^Exponent
  double Diagonal = 0.0;
  MTWorstPlace::Surface Input; // local
  std::unique_ptr<MTWorstPlace> InputSearch;
  Cut Finest;
  std::unique_ptr<MTWorstPlace> FinestSearch;
};

#endif
