// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFinestPatches
 * @brief patches of the finest level with the input's ids, and what is nearest to a place in them
 *
 * Patches are read with the one array of ids and kept within a limit; those that were not asked for longest go first,
 * and one that is asked for again is read again.
 *
 * Threads: Get, Read and Add may be called by any number of threads at once; no patch is read by two of them. Reading
 * happens on the calling thread, outside of the lock.
 */
#ifndef vtkMTFinestPatches_h
#define vtkMTFinestPatches_h

#include "vtkMTPatch.h"
#include "vtkMTRenderingCoreModule.h" // For export macro

#include "vtkType.h"

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

class vtkMTPatchSource;

class VTKMTRENDERINGCORE_EXPORT vtkMTFinestPatches
{
public:
  using Place = std::array<double, 3>;

  /// The nearest so far, in steps of the lattice; of equally near ones that with the smallest id.
  struct Nearest
  {
    double Distance2 = std::numeric_limits<double>::infinity();
    vtkIdType Id = -1;

    void Offer(double distance2, vtkIdType id)
    {
      if (distance2 < this->Distance2 || (distance2 == this->Distance2 && id < this->Id))
      {
        this->Distance2 = distance2;
        this->Id = id;
      }
    }
  };

  /// What is looked for.
  struct Search
  {
    Place X{};           ///< steps
    Place Direction{};   ///< triangles whose normals have a positive product with it are facing; zero: all are
    double Reach2 = 0.0; ///< the square of how far a facing triangle may be, where there is a direction
    bool HasDirection = false;
    Nearest Facing;
    Nearest Any;

    /// The square of how far away triangles still have to be looked at.
    double GetFarthest2() const
    {
      return this->Facing.Id >= 0 ? this->Facing.Distance2
        : this->HasDirection      ? std::max(this->Any.Distance2, this->Reach2)
                                  : this->Any.Distance2;
    }
    vtkIdType GetId() const { return this->Facing.Id >= 0 ? this->Facing.Id : this->Any.Id; }
  };

  class VTKMTRENDERINGCORE_EXPORT Patch
  {
  public:
    /// column: of the ids, in the patch's CellColumns or PointColumns.
    Patch(std::shared_ptr<const vtkMTPatch> mesh, bool ofPoints, std::size_t column);

    void Find(Search& search) const;
    std::size_t GetBytes() const { return this->Bytes; }

  private:
    vtkIdType GetId(std::size_t i) const;
    void FindTriangle(std::size_t triangle, Search& search) const;
    void FindPoints(Search& search) const;

    static constexpr std::size_t BlockSize = 16; // triangles that follow each other are near each other
    std::shared_ptr<const vtkMTPatch> Mesh;
    const vtkMTColumn& Ids;
    bool OfPoints;
    std::vector<vtkMTBox> Boxes; // of blocks of triangles
    std::size_t Bytes = 0;
  };
  using PatchPointer = std::shared_ptr<const Patch>;

  /// array: that of the ids, among the graph's. limit: bytes.
  vtkMTFinestPatches(const vtkMTPatchSource& source, std::size_t array, std::size_t limit);

  /// Null, with a message, when the patch cannot be read.
  PatchPointer Get(std::uint32_t arc, std::string& error);
  /// Reads those of the arcs, which are in the order of their places, that are not there. What fails shows in Get.
  void Read(const std::vector<std::uint32_t>& arcs);
  /// A patch that is in memory already; it is not read where it has the ids.
  void Add(std::uint32_t arc, const std::shared_ptr<const vtkMTPatch>& mesh);
  bool Has(std::uint32_t arc) const;

  /// What the patch takes, about.
  std::size_t GetBytes(std::uint32_t arc) const;
  std::size_t GetLimit() const { return this->Limit; }
  /// Patches read since construction.
  std::uint64_t GetNumberOfReads() const;

private:
  struct Entry
  {
    PatchPointer Known; // null while it is read, and where that failed
    std::string Error;
    std::uint64_t Tick = 0;
    bool IsBeingRead = true;
  };

  bool Claim(std::uint32_t arc);
  void Put(std::uint32_t arc, PatchPointer patch, const std::string& error);
  void Touch(std::uint32_t arc, Entry& entry);
  void MakeRoom();

  const vtkMTPatchSource& Source;
  const std::size_t Limit;
  std::vector<unsigned char> Arrays;
  bool OfPoints = false;
  std::size_t Column = 0;
  mutable std::mutex Lock;
  std::condition_variable News;
  std::unordered_map<std::uint32_t, Entry> Entries;
  std::map<std::uint64_t, std::uint32_t> Order; // of what is known, by when it was asked for
  std::size_t Bytes = 0;
  std::uint64_t Tick = 0;
  std::uint64_t Reads = 0;
};

#endif
