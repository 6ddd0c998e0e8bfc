// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRankBoxes.h"

#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"

#include <algorithm>
#include <cstddef>

namespace
{
vtkPVRenderViewDataDeliveryManager* GetManager(vtkView* view)
{
  auto* renderView = vtkPVRenderView::SafeDownCast(view);
  return renderView ? vtkPVRenderViewDataDeliveryManager::SafeDownCast(renderView->GetDeliveryManager()) : nullptr;
}
}

//------------------------------------------------------------------------------
bool vtkMTRankBoxes::AreOrdered(vtkView* view)
{
  vtkPVRenderViewDataDeliveryManager* manager = GetManager(view);
  return manager && manager->GetUseRedistributedDataAsDeliveredData();
}

//------------------------------------------------------------------------------
std::vector<vtkBoundingBox> vtkMTRankBoxes::Get(vtkView* view)
{
  return vtkMTRankBoxes::AreOrdered(view) ? GetManager(view)->GetCuts() : std::vector<vtkBoundingBox>();
}

//------------------------------------------------------------------------------
bool vtkMTRankBoxes::AreApart(const std::vector<vtkBoundingBox>& boxes)
{
  const auto overlap = [](const vtkBoundingBox& a, const vtkBoundingBox& b)
  {
    bool all = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      all = all && a.GetMinPoint()[axis] < b.GetMaxPoint()[axis] && b.GetMinPoint()[axis] < a.GetMaxPoint()[axis];
    }
    return all;
  };
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (overlap(boxes[i], boxes[j]))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkMTRankBoxes::Plane> vtkMTRankBoxes::GetPlanes(const std::vector<vtkBoundingBox>& boxes, int rank)
{
  constexpr double beside = 1.03e-6;
  vtkBoundingBox all;
  for (const vtkBoundingBox& box : boxes)
  {
    all.AddBox(box);
  }
  const double shift = beside * all.GetMaxLength();
  const vtkBoundingBox& own = boxes[static_cast<std::size_t>(rank)];
  std::vector<Plane> planes;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto add = [&](double face, double side)
    {
      Plane plane{};
      plane[axis] = face + shift;
      plane[3 + axis] = side;
      planes.push_back(plane);
    };
    if (own.GetMinPoint()[axis] > all.GetMinPoint()[axis])
    {
      add(own.GetMinPoint()[axis], 1.0);
    }
    if (own.GetMaxPoint()[axis] < all.GetMaxPoint()[axis])
    {
      add(own.GetMaxPoint()[axis], -1.0);
    }
  }
  return planes;
}

//------------------------------------------------------------------------------
int vtkMTRankBoxes::GetMostPlanes(const std::vector<vtkBoundingBox>& boxes)
{
  std::size_t most = 0;
  for (std::size_t rank = 0; rank < boxes.size(); ++rank)
  {
    most = std::max(most, vtkMTRankBoxes::GetPlanes(boxes, static_cast<int>(rank)).size());
  }
  return static_cast<int>(most);
}
