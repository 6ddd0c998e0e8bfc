// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCounterparts
 * @brief which triangles of a model's finest level are a triangle of its input
 *
 * Those whose corners are no farther from the input's than is allowed, each from one of its own. Faces that lie on each
 * other have several; they are told apart by their turn, and counted: of n copies of a triangle in one turn the model
 * must have n. Which of several in the same turn is which cannot be told from their places.
 */
#ifndef vtkMTCounterparts_h
#define vtkMTCounterparts_h

#include "vtkMTLatticeKeys.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTCounterparts
{
public:
  /// A triangle of the model; corner i of the input's is Corners[i] of it.
  struct Counterpart
  {
    std::uint32_t Triangle;
    std::array<int, 3> Corners;
    bool IsTurned() const { return (this->Corners[1] + 3 - this->Corners[0]) % 3 != 1; }
  };

  struct Found
  {
    std::vector<Counterpart> Same;   ///< in the input's turn, at most CopiesLimit
    std::vector<Counterpart> Turned; ///< in the opposite turn, likewise
    std::size_t SameCount = 0;       ///< all of them
    std::size_t TurnedCount = 0;
    std::size_t InputSame = 1; ///< triangles of the input with the same corners in the same turn, itself included
    std::size_t InputTurned = 0;
    std::size_t Rank = 0; ///< its place among InputSame
  };

  static constexpr std::size_t CopiesLimit = 8;

  /**
   * The keys of both surfaces, the places in model units that the input's were made of, and both surfaces in a frame in
   * which distances can be calculated; allowed: how far corners may be apart, the frame's units. All are kept by
   * reference.
   */
  vtkMTCounterparts(const vtkMTLatticeKeys& inputKeys, const std::vector<vtkMTRealPoint>& inputPlaces,
    const vtkMTLatticeKeys& modelKeys, const vtkMTSampledSurface& input, const vtkMTSampledSurface& model,
    double allowed)
    : InputKeys(inputKeys)
    , InputPlaces(inputPlaces)
    , ModelKeys(modelKeys)
    , Input(input)
    , Model(model)
    , Allowed(allowed)
  {
  }

  Found Find(std::uint32_t triangle) const;

private:
  bool Match(std::uint32_t input, std::uint32_t model, Counterpart& counterpart) const;
  void Add(std::uint32_t input, const vtkMTLatticeKeys::Copies& copies, Found& found) const;
  void Count(std::uint32_t input, Found& found) const;

  const vtkMTLatticeKeys& InputKeys;
  const std::vector<vtkMTRealPoint>& InputPlaces;
  const vtkMTLatticeKeys& ModelKeys;
  const vtkMTSampledSurface& Input;
  const vtkMTSampledSurface& Model;
  const double Allowed;
};

#endif
