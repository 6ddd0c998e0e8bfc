// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSelectionIds
 * @brief turns places in the arena, as vtkHardwareSelector's pictures hold them, into ids of the model
 *
 * The selector's passes write ids in two pictures, the lower 24 bits in one and the higher ones in the other. For each
 * pixel Translate reads the place that the shader wrote, finds patch and tuple, and writes the value of the array
 * there; pixels whose patch has no such array keep the place.
 */
#ifndef vtkMTSelectionIds_h
#define vtkMTSelectionIds_h

#include "vtkMTPatchArena.h"
#include "vtkMTPatchCache.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <map>
#include <vector>

class vtkDataArray;
class vtkMTGraph;

class vtkMTSelectionIds
{
public:
  /// array: of the graph's Arrays, or -1. The cache must read that array.
  vtkMTSelectionIds(const vtkMTGraph& graph, const vtkMTPatchArena& arena, vtkMTPatchCache& cache, int array,
    vtkMTPatchArena::DomainType domain);
  ~vtkMTSelectionIds();

  /**
   * Rewrites one picture, at the pixels that begin at the offsets. lowPlaces and highPlaces hold what the shader wrote;
   * the second may be null. primitives: how many of the shader's ids one vertex or triangle takes. high: target is the
   * picture of the higher bits.
   */
  void Translate(const std::vector<unsigned int>& offsets, const unsigned char* lowPlaces,
    const unsigned char* highPlaces, std::uint64_t primitives, bool high, unsigned char* target);

private:
  vtkIdType GetId(std::uint64_t place);
  vtkDataArray* GetValues(std::uint32_t arc);

  const vtkMTGraph& Graph;
  vtkMTPatchCache& Cache;
  int Array;
  std::map<std::uint64_t, std::uint32_t> Places;
  struct Values
  {
    vtkMTPatchCache::PatchPointer Patch; // whose memory the array shares
    vtkSmartPointer<vtkDataArray> Array;
  };
  std::map<std::uint32_t, Values> Known; // by arc
};

#endif
