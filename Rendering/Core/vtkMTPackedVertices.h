// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPackedVertices
 * @brief position and normal of a vertex in twelve bytes
 *
 * Three words of 32 bits, one for each coordinate: in the upper bits the lattice integer, counted from a corner of the
 * model's box, and in the lower ones a third of the normal. So a position stays exact, as it has to be where patches
 * meet, and the normal has what the lattice leaves: 24 bits where the box is at most 2^24 - 1 steps wide, as nearly
 * always by default, 21 where it takes one bit more. Where it takes still more nothing is packed.
 *
 * The normal is an octahedral code (Meyer, Suessmuth, Sussner, Stamminger, Greiner: On floating-point normal vectors,
 * 2010), two numbers of an even grid with a point in its middle, so that the six directions along the axes are exact.
 * With 12 bits for each it is off by 0.06 degrees at most, with 10 by 0.24. A normal that is zero or no number becomes
 * that along z.
 *
 * vtkMTPackedVertexDec.glsl and vtkMTPackedVertexImpl.glsl unpack it.
 */
#ifndef vtkMTPackedVertices_h
#define vtkMTPackedVertices_h

#include "vtkMTLattice.h"
#include "vtkMTPatch.h"
#include "vtkMTRenderingCoreModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>

struct VTKMTRENDERINGCORE_EXPORT vtkMTPackedVertices
{
  static constexpr std::size_t Bytes = 12; ///< of a vertex
  static constexpr int LeastShift = 7;
  static constexpr int MostShift = 10;

  vtkMTPoint Corner{ 0, 0, 0 }; ///< of the model's box, which positions are counted from
  int Shift = 0;                ///< bits of each word that belong to the normal; 0: vertices cannot be packed

  static vtkMTPackedVertices ForBox(const vtkMTBox& box);
  /// Bits of each of a normal's two numbers.
  int GetNormalBits() const { return 3 * this->Shift / 2; }
  /// The grid of each number goes from 0 to twice this.
  float GetHalf() const { return static_cast<float>((1 << (this->GetNormalBits() - 1)) - 1); }

  ///@{
  /// The code of a normal of any length, and the unit normal of a code.
  std::uint32_t EncodeNormal(const float normal[3]) const;
  std::array<float, 3> DecodeNormal(std::uint32_t code) const;
  ///@}

  /// Writes Bytes per wedge, from three floats per wedge. False where a point lies outside the box.
  bool Pack(const vtkMTPatch& patch, const float* normals, unsigned char* bytes) const;
};

#endif
