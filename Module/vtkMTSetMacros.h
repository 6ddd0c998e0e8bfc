// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief bodies of setters of numbers that refuse what is not a number
 *
 * vtkSetMacro and vtkSetClampMacro let NaN through, since NaN is neither below nor above a limit. These define, in a
 * class's .cxx, a setter that its header declares as `void SetName(double)`: with NaN it invokes an error event and
 * changes nothing. Not installed.
 *
 *   vtkMTCxxSetMacro(vtkMTThing, Weight);                // void vtkMTThing::SetWeight(double)
 *   vtkMTCxxSetClampMacro(vtkMTThing, Error, 0.0, 1e9);  // likewise, clamped
 */
#ifndef vtkMTSetMacros_h
#define vtkMTSetMacros_h

#include "vtkSetGet.h"

#include <algorithm>
#include <cmath>
#include <limits>

#define vtkMTCxxSetClampMacro(Class, Name, Low, High)                                                                  \
  void Class::Set##Name(double value)                                                                                  \
  {                                                                                                                    \
    if (std::isnan(value))                                                                                             \
    {                                                                                                                  \
      vtkErrorMacro("Set" #Name ": the value is not a number; " #Name " stays " << this->Name << ".");                 \
      return;                                                                                                          \
    }                                                                                                                  \
    value = std::clamp(value, static_cast<double>(Low), static_cast<double>(High));                                    \
    if (this->Name != value)                                                                                           \
    {                                                                                                                  \
      this->Name = value;                                                                                              \
      this->Modified();                                                                                                \
    }                                                                                                                  \
  }                                                                                                                    \
  static_assert(true, "so that a semicolon follows")

#define vtkMTCxxSetMacro(Class, Name)                                                                                  \
  vtkMTCxxSetClampMacro(Class, Name, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity())

#endif
