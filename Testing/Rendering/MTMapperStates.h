// SPDX-License-Identifier: BSD-3-Clause
// The states of actors, mappers, cameras and renderers in which vtkMultiTriangulationMapper is held against
// vtkPolyDataMapper.
#ifndef MTMapperStates_h
#define MTMapperStates_h

#include "MTGridModel.h"
#include "MTPicture.h"

#include <functional>
#include <ostream>
#include <string>
#include <vector>

class vtkTexture;

struct MTMapperState
{
  std::string Name;
  std::function<void(MTScene&)> Apply;
  MTGridModel Model;
  double Allowed = 0.0; // share of the drawn pixels that may be clearly off
};

std::ostream& operator<<(std::ostream& os, const MTMapperState& state);

class MTMapperStates
{
public:
  static std::vector<MTMapperState> GetAll();

private:
  // A silhouette may pass a pixel's centre on the other side: positions are rounded to floats in another way.
  static constexpr double Silhouettes = 1e-4;
  // Lines along an edge of two triangles have equal depths, so the one drawn first wins, and the order is another.
  static constexpr double EqualDepths = 2e-3;
  static constexpr double WideLines = 1e-2;
  // The shadow map is the light's own view, with a cut of its own: the edge of a shadow is a pixel off here and there.
  static constexpr double OtherCut = 1e-2;

  void AddColours();
  void AddShading();
  void AddLines();
  void AddViews();
  void Add(const std::string& name, const std::function<void(MTScene&)>& change, double allowed = Silhouettes,
    const MTGridModel& model = MTGridModel());

  // Without colours of an array.
  static void Plain(MTScene& scene);
  static void MakeTexture(vtkTexture* texture);

  std::vector<MTMapperState> States;
};

#endif
