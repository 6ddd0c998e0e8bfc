// SPDX-License-Identifier: BSD-3-Clause
#include "MTMapperStates.h"

std::ostream& operator<<(std::ostream& os, const MTMapperState& state)
{
  return os << state.Name;
}

std::vector<MTMapperState> MTMapperStates::GetAll()
{
  MTMapperStates states;
  states.AddColours();
  states.AddShading();
  states.AddLines();
  states.AddViews();
  return states.States;
}

void MTMapperStates::Add(
  const std::string& name, const std::function<void(MTScene&)>& change, double allowed, const MTGridModel& model)
{
  this->States.push_back({ name, change, model, allowed });
}
