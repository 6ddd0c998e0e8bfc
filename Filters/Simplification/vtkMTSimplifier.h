// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSimplifier
 * @brief how a region's floor is made into its fragment
 *
 * A simplifier replaces a mesh by one with fewer triangles and the same locked points. It works on the lattice: the
 * fragment's points are integers, so what is certified afterwards is what is drawn. It sees geometry, wedges and locks
 * only; the builder carries the attribute values over.
 */
#ifndef vtkMTSimplifier_h
#define vtkMTSimplifier_h

#include "vtkMTPatch.h"
#include "vtkMTSimplificationModule.h" // For export macro
#include "vtkObject.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

/// What a simplifier makes of a floor.
struct VTKMTSIMPLIFICATION_EXPORT vtkMTSimplification
{
  std::vector<vtkMTPoint> Points;         ///< [n] the fragment's points
  std::vector<std::uint32_t> PointOrigin; ///< [n] the floor's point whose identity each point carries on; all different
  std::vector<unsigned char> Moved;       ///< [n] 1 where the point is not where its origin was
  std::vector<std::uint32_t> WedgePoints; ///< [w] the fragment's point of each wedge
  /// [w] the floor's wedge whose attribute values each wedge takes; where its point has moved they are a first guess
  /// only.
  std::vector<std::uint32_t> WedgeOrigin;
  std::vector<vtkMTTriangle> Triangles; ///< [t] of wedge indices
  /// [the floor's points] the fragment's point that each has been merged into, NoHeir where nothing is left of it. A
  /// guess of what lies where, for those who compare the two meshes; empty when the simplifier does not know.
  std::vector<std::uint32_t> Heirs;
  /// When the target was not reached: edges left that could not be collapsed, by cause ("locked", "non_manifold",
  /// "seam", "valence", "topology", "fold", "chord", "steps"), and triangles of components that were left out
  /// ("component_triangles").
  std::map<std::string, std::int64_t> Blocked;
  std::int64_t RemovedComponents = 0; ///< whole components left out because the target could not be reached with them

  static constexpr std::uint32_t NoHeir = ~std::uint32_t(0);
};

class VTKMTSIMPLIFICATION_EXPORT vtkMTSimplifier : public vtkObject
{
public:
  vtkTypeMacro(vtkMTSimplifier, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Simplifies floor to about target triangles, as near as its locks, topology and seams allow. locked has one entry
   * per point: such a point keeps its place and, while a triangle outside could use it, its identity, and edges between
   * locked points that have one triangle in the floor stay. Every component that touches a locked point stays; the
   * result is never empty. Every input is taken: non-manifold, degenerate, with repeated triangles, of any winding.
   * False on failure inside (out of memory, a watchdog), with the reason in error.
   *
   * Threads: may be called from any number of threads at once.
   */
  virtual bool Simplify(const vtkMTPatch& floor, const std::vector<unsigned char>& locked, std::size_t target,
    vtkMTSimplification& result, std::string& error) const = 0;

  /// Names the simplifier and its mode, as the model's settings keep it.
  virtual const char* GetSimplifierName() const = 0;
  /// Name and every setting that has an influence on the result.
  virtual std::string GetSettings() const = 0;

protected:
  vtkMTSimplifier();
  ~vtkMTSimplifier() override;

private:
  vtkMTSimplifier(const vtkMTSimplifier&) = delete;
  void operator=(const vtkMTSimplifier&) = delete;
};

#endif
