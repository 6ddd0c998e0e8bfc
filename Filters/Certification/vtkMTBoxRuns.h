// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBoxRuns
 * @brief which of many boxes touch something, where neighbours in order are mostly near in space as well
 *
 * So triangles of a patch are. A box around each eight in a row, one around each eight of these, and so on, cost next
 * to nothing to make, and a question looks at what is within those that are touched. Eight boxes are compared at once,
 * in single precision that is rounded outwards, so that none is left out; what is left is asked exactly.
 *
 * Threads: const and safe.
 */
#ifndef vtkMTBoxRuns_h
#define vtkMTBoxRuns_h

#include "vtkMTCertificationModule.h" // For export macro
#include "vtkMTSurface.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  /// accept(index) of what is touched, in order, until it is. Nothing is touched outside of around.
  template <typename Touches, typename Accept>
  bool HasTouched(const Box& around, const Touches& touches, const Accept& accept) const
  {
    return this->HasTouched(this->Levels.size() - 1, 0, Outwards(around), touches, accept);
  }

  /// One of the boxes near a place, about the nearest: by the nearest of the boxes around several, and so on down.
  /// There must be boxes.
  std::uint32_t FindNear(const Vector& x) const;

  /// Around a triangle, and so much wider.
  static Box GetBox(const vtkMTSurface& surface, std::uint32_t triangle, double wider);
  /// Around a ball, and wider by far more than what Touch and GetDistance2 round.
  static Box GetBox(const Ball& ball);
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

  using Four = float __attribute__((vector_size(16), may_alias));
  using FourAnswers = std::int32_t __attribute__((vector_size(16)));

  struct SmallBox
  {
    std::array<float, 3> Low;
    std::array<float, 3> High;
  };
  struct alignas(16) Run
  {
    float Low[3][8];
    float High[3][8];
  };

  // In single precision and no smaller: a value is moved by more than rounding it can move it back, which is 2^-24 of
  // it or less than 2^-149. No lower end is above the range of floats and no upper end below it, as coordinates are
  // not.
  static SmallBox Outwards(const Box& box)
  {
    SmallBox small;
    for (int c = 0; c < 3; ++c)
    {
      small.Low[c] = static_cast<float>(box.Low[c] - GetMargin(std::abs(box.Low[c])));
      small.High[c] = static_cast<float>(box.High[c] + GetMargin(std::abs(box.High[c])));
    }
    return small;
  }
  static double GetMargin(double size) { return size * 0x1p-22 + 0x1p-100; }

  // A bit for each box of a run.
  static unsigned int FindTouched(const Run& run, const SmallBox& around)
  {
    unsigned int touched = 0;
    for (int half = 0; half < 2; ++half)
    {
      const auto get = [half](const float* numbers) { return reinterpret_cast<const Four*>(numbers)[half]; };
      const FourAnswers answers = (get(run.Low[0]) <= around.High[0]) & (get(run.High[0]) >= around.Low[0]) &
        (get(run.Low[1]) <= around.High[1]) & (get(run.High[1]) >= around.Low[1]) &
        (get(run.Low[2]) <= around.High[2]) & (get(run.High[2]) >= around.Low[2]);
      touched |= GetBits(answers) << (4 * half);
    }
    return touched;
  }
  static unsigned int GetBits(const FourAnswers& answers)
  {
#ifdef __SSE__
    using Signs = float __attribute__((vector_size(16)));
    return static_cast<unsigned int>(__builtin_ia32_movmskps((Signs)answers));
#else
    const FourAnswers bits = answers & FourAnswers{ 1, 2, 4, 8 };
    return static_cast<unsigned int>(bits[0] | bits[1] | bits[2] | bits[3]);
#endif
  }

  template <typename Touches, typename Accept>
  bool HasTouched(
    std::size_t level, std::size_t run, const SmallBox& around, const Touches& touches, const Accept& accept) const
  {
    for (unsigned int left = FindTouched(this->Runs[level][run], around); left != 0; left &= left - 1)
    {
      const std::size_t i = Length * run + static_cast<std::size_t>(__builtin_ctz(left));
      if (touches(this->Levels[level][i]) &&
        (level == 0 ? accept(static_cast<std::uint32_t>(i)) : this->HasTouched(level - 1, i, around, touches, accept)))
      {
        return true;
      }
    }
    return false;
  }

  static std::vector<Run> MakeRuns(const std::vector<Box>& boxes, double margin);

  std::vector<std::vector<Box>> Levels; // the boxes themselves first
  std::vector<std::vector<Run>> Runs;   // the same
};

#endif
