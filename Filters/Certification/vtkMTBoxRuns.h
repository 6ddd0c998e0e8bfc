// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBoxRuns
 * @brief which of many boxes touch something, where neighbours in order are mostly near in space as well
 *
 * So triangles of a patch are. A box around each eight in a row, one around each eight of these, and so on, cost next
 * to nothing to make, and a question looks at what is within those that are touched.
 *
 * Threads: const and safe.
 */
#ifndef vtkMTBoxRuns_h
#define vtkMTBoxRuns_h

#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTSurface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class VTKMTCERTIFICATION_EXPORT vtkMTBoxRuns
{
public:
  using Vector = vtkMTSurface::Vector;

  struct Ball
  {
    Vector Middle;
    double Radius;
  };
  struct Box
  {
    Vector Low;
    Vector High;
  };

  explicit vtkMTBoxRuns(std::vector<Box> boxes);

  const Box& GetBox(std::size_t index) const { return this->Levels[0][index]; }
  /// Whether one of those that are touched is accepted: touches(box) is asked of boxes and of those around several, and
  /// accept(index) of what is touched, until it is.
  template <typename Touches, typename Accept>
  bool HasTouched(const Touches& touches, const Accept& accept) const
  {
    const std::size_t top = this->Levels.size() - 1;
    return this->HasTouched(top, 0, this->Levels[top].size(), touches, accept);
  }

  /// One of the boxes near a place, about the nearest: by the nearest of the boxes around several, and so on down.
  /// There must be boxes.
  std::uint32_t FindNear(const Vector& x) const;

  /// Around a triangle, and so much wider.
  static Box GetBox(const vtkMTSurface& surface, std::uint32_t triangle, double wider);
  static bool Touch(const Box& a, const Box& b)
  {
    return a.Low[0] <= b.High[0] && b.Low[0] <= a.High[0] && a.Low[1] <= b.High[1] && b.Low[1] <= a.High[1] &&
      a.Low[2] <= b.High[2] && b.Low[2] <= a.High[2];
  }
  static bool Touch(const Box& box, const Ball& ball)
  {
    return GetDistance2(box, ball.Middle) <= ball.Radius * ball.Radius;
  }
  static bool Touch(const Ball& a, const Ball& b)
  {
    const double x = a.Middle[0] - b.Middle[0];
    const double y = a.Middle[1] - b.Middle[1];
    const double z = a.Middle[2] - b.Middle[2];
    const double reach = a.Radius + b.Radius;
    return x * x + y * y + z * z <= reach * reach;
  }
  static double GetDistance2(const Box& box, const Vector& x)
  {
    double distance2 = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double away = std::max({ box.Low[i] - x[i], x[i] - box.High[i], 0.0 });
      distance2 += away * away;
    }
    return distance2;
  }

private:
  static constexpr std::size_t Length = 8;

  template <typename Touches, typename Accept>
  bool HasTouched(
    std::size_t level, std::size_t begin, std::size_t end, const Touches& touches, const Accept& accept) const
  {
    for (std::size_t i = begin; i < end; ++i)
    {
      if (!touches(this->Levels[level][i]))
      {
        continue;
      }
      if (level == 0 ? accept(static_cast<std::uint32_t>(i))
                     : this->HasTouched(level - 1, Length * i,
                         std::min(Length * (i + 1), this->Levels[level - 1].size()), touches, accept))
      {
        return true;
      }
    }
    return false;
  }

  std::vector<std::vector<Box>> Levels; // the boxes themselves first
};

#endif
