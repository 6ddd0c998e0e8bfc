// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTLineHit
 * @brief where a line first meets patches
 */
#ifndef vtkMTLineHit_h
#define vtkMTLineHit_h

#include "vtkMTArrayInfo.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkMTPatchSource;
struct vtkMTPatch;

struct vtkMTLineHit
{
  using Place = std::array<double, 3>;

  double T = 0.0;                  ///< 0 at the line's begin, 1 at its end
  std::array<double, 2> Weights{}; ///< of the triangle's second and third corner
  std::array<Place, 3> Triangle{}; ///< model units
  vtkIdType InputCell = 0;         ///< 0 where the model keeps no ids
  vtkIdType InputPoint = -1;       ///< the nearest one; -1 where the model keeps no ids of points

  /// A patch that is in memory, with whatever arrays, or null.
  using Resident = std::function<std::shared_ptr<const vtkMTPatch>(std::uint32_t arc)>;

  /// False when the line meets none of the arcs' patches. Patches that are not in memory are read, if the line meets
  /// their boxes; those that cannot be read are passed by, and error says which.
  bool Find(const vtkMTPatchSource& source, const std::vector<std::uint32_t>& arcs, const Place& begin,
    const Place& end, const Resident& resident, std::string& error);

  /// Whose patch was hit.
  std::uint32_t GetArc() const { return this->Arc; }

private:
  // Where the nearest hit so far is.
  bool Found = false;
  std::shared_ptr<const vtkMTPatch> Patch;
  std::uint32_t Arc = 0;
  std::size_t Index = 0;

  void FindInPatch(const vtkMTPatchSource& source, std::uint32_t arc, const std::shared_ptr<const vtkMTPatch>& patch,
    const Place& begin, const Place& way);
  void FindInputCell(const vtkMTPatchSource& source, std::string& error);
  void FindNearestInput(const vtkMTPatchSource& source, vtkMTArrayInfo::RoleType role, const Place& x,
    const Resident& resident, vtkIdType& id, std::string& error) const;
};

#endif
