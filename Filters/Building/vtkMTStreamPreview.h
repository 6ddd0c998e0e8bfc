// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTStreamPreview
 * @brief a coarse stand-in for a mesh of any size, from one pass over its stream
 *
 * Vertex clustering (Rossignac and Borrel 1993) on a grid whose cells double whenever more than ClusterLimit of them
 * have points: neither the bounds nor the number of points need to be known before. A cluster is at the mean of its
 * points; a triangle is kept where its corners are in three clusters, once. A mesh of fewer points than the limit is
 * drawn as it is, as a rule.
 *
 * Points come first, so that a part of them can be shown before a triangle is read. Memory: the clusters, and four
 * bytes for each point; where there are more than PointLimit of them, the triangles of the others are left out.
 * Nothing is certified: it is what is seen until the model is built.
 */
#ifndef vtkMTStreamPreview_h
#define vtkMTStreamPreview_h

#include "vtkMTBuildingModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

class vtkMTTriangleStream;
class vtkPolyData;

class VTKMTBUILDING_EXPORT vtkMTStreamPreview
{
public:
  static constexpr std::size_t PointLimit = std::size_t(1) << 28;

  /// At least 8 clusters.
  explicit vtkMTStreamPreview(std::size_t clusterLimit = 100000);

  /// Reads the whole stream, from its beginning. goesOn is asked after each block: false ends it. False on failure,
  /// with the reason, and where goesOn was false, without one.
  bool Read(vtkMTTriangleStream& stream, const std::function<bool()>& goesOn, std::string& error);

  /// Of what has been read: triangles, or as long as there are none points, each a vertex.
  void Make(vtkPolyData* output) const;

  std::size_t GetNumberOfClusters() const { return this->Clusters.size(); }
  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }

private:
  using Key = std::array<std::int64_t, 3>;
  using Triangle = std::array<std::uint32_t, 3>;
  struct Hash
  {
    template <class T>
    std::size_t operator()(const std::array<T, 3>& key) const;
  };
  struct Cluster
  {
    Key Place;
    std::array<double, 3> Sum; // of the points, from Origin
    double Count;
  };

  void AddPoint(const std::array<double, 3>& point);
  void AddTriangle(const std::array<std::uint64_t, 3>& corners);
  void StartGrid(const std::vector<std::array<double, 3>>& points);
  void Coarsen();

  const std::size_t ClusterLimit;
  bool HasGrid = false;
  std::array<double, 3> Origin{};
  double CellSize = 0.0;
  std::vector<Cluster> Clusters;
  std::unordered_map<Key, std::uint32_t, Hash> Places;
  std::vector<std::uint32_t> ClusterOfPoint;
  std::unordered_set<Triangle, Hash> Triangles;
};

#endif
