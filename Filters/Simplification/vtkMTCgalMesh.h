// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTCgalMesh
 * @brief a region's mesh as CGAL's, for its collapse loop
 *
 * Both meshes number vertices, half-edges and faces alike. CGAL's loop works on its own; after each of its collapses,
 * what has changed around the edge is copied to the region's mesh, by which the rules are decided.
 */
#ifndef vtkMTCgalMesh_h
#define vtkMTCgalMesh_h

#include "vtkMTCollapseMesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

class vtkMTCgalMesh
{
public:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;
  using Surface = CGAL::Surface_mesh<Point>;
  using Vertex = Surface::Vertex_index;
  using Halfedge = Surface::Halfedge_index;
  using Edge = Surface::Edge_index;
  using Face = Surface::Face_index;

  explicit vtkMTCgalMesh(vtkMTCollapseMesh& mesh);

  Surface Mesh;

  static Point ToPoint(const vtkMTCollapseMesh::Vector& p) { return Point(p[0], p[1], p[2]); }
  static vtkMTCollapseMesh::Vector ToVector(const Point& p) { return { p.x(), p.y(), p.z() }; }

  ///@{
  /// Around a collapse in Mesh.
  void BeginCollapse(Halfedge h);
  void EndCollapse(Vertex kept);
  ///@}

private:
  void Remember(Halfedge h);
  void CopyHalfedge(Halfedge h);

  vtkMTCollapseMesh& Copy;
  std::vector<Halfedge> Around; // half-edges that a collapse may change
  std::vector<Vertex> Ends;
};

#endif
