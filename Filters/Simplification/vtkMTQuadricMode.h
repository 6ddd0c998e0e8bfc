// SPDX-License-Identifier: BSD-3-Clause
/// @brief memoryless quadrics as CGAL's cost and placement policies
#ifndef vtkMTQuadricMode_h
#define vtkMTQuadricMode_h

#include "vtkMTCollapsePolicies.h"
#include "vtkMTQuadrics.h"

namespace vtkMTCollapse
{
struct QuadricMode
{
  const vtkMTQuadrics* Q;
  template <class Profile>
  Place GetPlace(const Profile& profile, Region::Rule rule) const
  {
    return this->Q->GetPlace(profile.v0_v1(), rule);
  }
};

struct QuadricCost
{
  using Update_tag = CGAL::Tag_true;
  Region* R;
  vtkMTQuadrics* Q;

  template <class Mesh, class PointMap, class GeomTraits>
  void initialize(const Mesh&, const PointMap&, const GeomTraits&) const
  {
    this->Q->Initialize();
  }
  template <class Profile>
  void update_after_collapse(const Profile&, Region::Vertex kept) const
  {
    this->Q->Update(kept);
  }
  template <class Profile>
  Cost operator()(const Profile& profile, const Place& place) const
  {
    this->R->Step();
    return place ? Cost(this->Q->GetCost(profile.v0_v1(), *place)) : Cost();
  }
};
}

#endif
