// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTRegionSpool
 * @brief the patches of a level by region of the next partition, and what each region must leave as it is, in a spool
 *
 * Patches are put one by one as fragments are split, locks once all of them are known (vtkMTLocks). Every record has
 * its kind in its first byte. Putting comes from one thread; after Seal, Take may be called by several.
 */
#ifndef vtkMTRegionSpool_h
#define vtkMTRegionSpool_h

#include "vtkMTCertifiedMesh.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTRecordSpool.h"

#include <cstdint>
#include <string>
#include <vector>

/// What a region is simplified from.
struct vtkMTRegionRecords
{
  std::vector<vtkMTCertifiedMesh> Patches; ///< of its floor, in the order in which they were put
  std::vector<std::uint64_t> Locks;        ///< ids of the points that other regions use as well, in increasing order
};

class VTKMTCONSTRUCTION_EXPORT vtkMTRegionSpool
{
public:
  using Bytes = std::vector<unsigned char>;

  ///@{
  /// False with a message in error. Put comes after Begin, Take after Seal or Open.
  bool Begin(vtkMTSpoolStore& store, const std::string& name, std::size_t regions, std::string& error);
  bool PutPatch(std::size_t region, const Bytes& patch, std::string& error);
  bool PutLocks(std::size_t region, const std::vector<std::uint64_t>& locks, std::string& error);
  bool Seal(std::string& error);
  bool Take(std::size_t region, vtkMTRegionRecords& records, std::string& error) const;
  bool Open(vtkMTSpoolStore& store, const std::string& name, const Bytes& state, std::string& error);
  ///@}
  /// The bytes of a patch for PutPatch; by any thread.
  static void EncodePatch(const vtkMTCertifiedMesh& patch, Bytes& bytes);

  std::size_t GetNumberOfRegions() const { return this->Records.GetNumberOfKeys(); }
  const vtkMTRecordSpool& GetRecords() const { return this->Records; } ///< for their sizes
  void Save(Bytes& state) const { this->Records.Save(state); }
  void Forget(std::size_t region) { this->Records.Forget(region); } ///< it will not be taken again
  void Remove() { this->Records.Remove(); }

private:
  vtkMTRecordSpool Records;
};

#endif
