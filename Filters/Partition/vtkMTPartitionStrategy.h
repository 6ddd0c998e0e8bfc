// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPartitionStrategy
 * @brief how the regions of a partition are placed
 *
 * Strategies differ in nothing else; crossing, simplification, DAG, file and drawing do not know which one was used
 * (BMT section 4). Results depend on the barycentres, their order, the settings and the level alone: not on threads or
 * time.
 */
#ifndef vtkMTPartitionStrategy_h
#define vtkMTPartitionStrategy_h

#include "vtkMTPartition.h"
#include "vtkMTPartitionModule.h" // For export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class VTKMTPARTITION_EXPORT vtkMTPartitionStrategy : public vtkObject
{
public:
  vtkTypeMacro(vtkMTPartitionStrategy, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Makes the partition of the given mesh with about `target` triangles in a region (mean; > 0). No region holds more
   * than MaximumOverload times the target, except where barycentres coincide. A target of at least the number of
   * triangles gives one region. level tells which partition of the sequence this is (0 the finest): strategies that
   * alternate use it, so that successive partitions do not share borders. Null when the scan failed.
   */
  virtual std::unique_ptr<vtkMTPartition> Build(vtkMTBarycentreScan& scan, double target, int level) const = 0;

  /// Bound on triangles in a region over the target.
  static constexpr double MaximumOverload = 4.0;

  /// Triangles of a level over those of the next coarser one, above 1: by this the target grows from one partition of a
  /// sequence to the next, and floors are simplified. 2 here.
  virtual double GetReduction() const { return 2.0; }

  /// Into how many patches a region is split by the next partition of a sequence, once slivers are merged, in the mean.
  /// 2.9 here, as measured with Voronoi regions on scans and fractal spheres: Testing/Construction prints the mean
  /// patch of every model that it builds.
  virtual double GetPatchesPerRegion() const { return 2.9; }

  /**
   * The strategy of a short name, with its default settings: "v" (vtkMTVoronoiPartition), "regular"
   * (vtkMTRegularPartition), "kd" (vtkMTKdPartition), "quad" (vtkMTQuadPartition), "hexagon" (vtkMTHexagonPartition);
   * the last two with a domain as well: "quad-plane", "quad-sphere", "hexagon-plane", "hexagon-sphere". Null for any
   * other name.
   */
  static vtkSmartPointer<vtkMTPartitionStrategy> MakeByName(const std::string& name);
  /// All of these.
  static std::vector<std::string> GetNames();

  /// Short name for settings and messages, one of the above without a domain.
  virtual const char* GetStrategyName() const = 0;
  /// Name and every setting that has an influence on the result, for the model's settings.
  virtual std::string GetSettings() const = 0;

protected:
  vtkMTPartitionStrategy();
  ~vtkMTPartitionStrategy() override;

private:
  vtkMTPartitionStrategy(const vtkMTPartitionStrategy&) = delete;
  void operator=(const vtkMTPartitionStrategy&) = delete;
};

#endif
