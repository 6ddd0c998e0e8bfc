// SPDX-License-Identifier: BSD-3-Clause
// Says when a call's TimeLimit is over. Not installed.
#ifndef vtkMTFrameTimer_h
#define vtkMTFrameTimer_h

#include "vtkMTTargetCut.h"

#include <chrono>
#include <functional>

class vtkMTFrameTimer
{
public:
  explicit vtkMTFrameTimer(const vtkMTTargetCut::Settings& settings)
    : Budget(settings.TimeLimit)
    , Clock(settings.Clock)
    , Start(this->Budget > 0.0 ? this->Now() : 0.0)
  {
  }

  /// Or a share of it.
  bool IsOver(double share = 1.0) const
  {
    return this->Budget > 0.0 && this->Now() - this->Start >= share * this->Budget;
  }

private:
  double Now() const
  {
    return this->Clock ? this->Clock()
                       : std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  double Budget;
  const std::function<double()>& Clock;
  double Start;
};

#endif
