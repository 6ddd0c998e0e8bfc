// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSelectionIds
 * @brief turns places in the arena, as vtkHardwareSelector's pictures hold them, into ids of the model
 *
 * The selector's passes write ids in two pictures, the lower 24 bits in one and the higher ones in the other. Find
 * looks at the pixels that the shader wrote, finds patch and tuple, and the value of the array there. Where the array
 * is one of the input's ids, the patch is a coarse one and only the finest level has ids, the input's cell nearest to
 * the triangle's barycentre, or its point nearest to the vertex, is looked for: for all pixels together, by threads of
 * its own (vtkMTInputIdFinder). Translate then writes what was found.
 *
 * What was found is kept from one picture to the next, and to the next selection of the same model.
 */
#ifndef vtkMTSelectionIds_h
#define vtkMTSelectionIds_h

#include "vtkMTInputIdFinder.h"
#include "vtkMTPatchArena.h"
#include "vtkMTPatchCache.h"
#include "vtkType.h"

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

class vtkMTGraph;
class vtkMTPatchSource;

class vtkMTSelectionIds
{
public:
  /// Ids by arc (above) and tuple (below), of one array of one model.
  struct Memory
  {
    std::weak_ptr<const vtkMTPatchSource> Source;
    int Array = -1;
    std::unordered_map<std::uint64_t, vtkIdType> Ids;
  };

  /// What the shader wrote, and how.
  struct Pictures
  {
    const unsigned char* Low = nullptr;
    const unsigned char* High = nullptr; ///< or null
    std::uint64_t Primitives = 1;        ///< how many of the shader's ids one vertex or triangle takes
  };

  /// array: of the graph's Arrays. arrays: those that patches are drawn with, one flag for each.
  vtkMTSelectionIds(std::shared_ptr<const vtkMTPatchSource> source, vtkMTPatchCache& cache, int array,
    const std::vector<unsigned char>& arrays, Memory& memory);
  ~vtkMTSelectionIds();

  /// Which patches are where.
  void SetPlaces(const vtkMTPatchArena& arena, vtkMTPatchArena::DomainType domain);

  /// Finds what the pixels that begin at the offsets need. False where some could not be found, with the reason in
  /// error; without one, progress stopped it.
  bool Find(const std::vector<unsigned int>& offsets, const Pictures& pictures,
    const vtkMTInputIdFinder::Progress& progress, std::string& error);

  /// Writes one picture at these pixels: the ids' lower bits, or the higher ones. Where no id was found the pixel is
  /// taken out of actors, the picture of what is hit.
  void Translate(const std::vector<unsigned int>& offsets, const Pictures& pictures, bool high, unsigned char* target,
    unsigned char* actors) const;

private:
  static constexpr std::uint64_t Nowhere = ~std::uint64_t(0);
  std::uint64_t GetKey(const Pictures& pictures, unsigned int at) const;
  bool HasColumn(std::uint32_t arc) const;
  vtkMTPatchCache::PatchPointer GetPatch(std::uint32_t arc, bool withIds);
  void TakeValues(std::uint32_t arc, const std::vector<std::uint32_t>& tuples);
  void AddQueries(std::uint32_t arc, const std::vector<std::uint32_t>& tuples);
  bool FindQueries(const vtkMTInputIdFinder::Progress& progress, std::string& error);

  const std::shared_ptr<const vtkMTPatchSource> Source;
  const vtkMTGraph& Graph;
  vtkMTPatchCache& Cache;
  const int Array;
  const std::vector<unsigned char> Arrays;
  Memory& Known;
  std::map<std::uint64_t, std::uint32_t> Places;
  std::vector<vtkMTInputIdFinder::Query> Queries;
  std::vector<std::uint64_t> Keys; // of the queries
};

#endif
