// SPDX-License-Identifier: BSD-3-Clause
// Views of the plane that MTRandomGraph's graphs lie in.
#ifndef MTViews_h
#define MTViews_h

#include "vtkMTView.h"

#include <array>
#include <cmath>
#include <random>
#include <vector>

struct MTViews
{
  // From above the plane's point (x, y), height h, looking down and along +y by the angle.
  static vtkMTView LookAt(double x, double y, double height, double tilt, bool parallel = false)
  {
    vtkMTView view;
    const double c = std::cos(tilt);
    const double s = std::sin(tilt);
    // Eye axes: right (1, 0, 0), up (0, c, s), back (0, -s, c).
    const double axes[3][3] = { { 1.0, 0.0, 0.0 }, { 0.0, c, s }, { 0.0, -s, c } };
    const double eye[3] = { x, y, height };
    for (int i = 0; i < 3; ++i)
    {
      double shift = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        view.ModelToEye[4 * i + k] = axes[i][k];
        shift -= axes[i][k] * eye[k];
      }
      view.ModelToEye[4 * i + 3] = shift;
    }
    view.UpdateStretch();
    view.ParallelProjection = parallel;
    view.HalfSize = parallel ? std::array<double, 2>{ 0.3, 0.2 } : std::array<double, 2>{ 0.5, 0.3 };
    view.PixelsPerUnit = 400.0 / view.HalfSize[0];
    view.Near = 0.01;
    view.Far = 10.0;
    return view;
  }

  static std::vector<vtkMTView> MakeRandom(std::uint32_t seed, int count)
  {
    std::vector<vtkMTView> views;
    std::mt19937 random(seed);
    const auto draw = [&random] { return static_cast<double>(random() % 1000) / 1000.0; };
    for (int i = 0; i < count; ++i)
    {
      const double x = draw();
      const double y = draw();
      const double height = 0.05 + draw();
      views.push_back(LookAt(x, y, height, 1.3 * draw(), i % 4 == 3));
    }
    return views;
  }

  // A flight: far, approach, close above the ground, a turn, back.
  static std::vector<vtkMTView> MakePath(int frames)
  {
    std::vector<vtkMTView> views;
    for (int i = 0; i < frames; ++i)
    {
      const double t = static_cast<double>(i) / frames;
      const double height = 0.04 + 1.2 * std::pow(std::cos(3.14159 * t), 2.0);
      views.push_back(LookAt(0.2 + 0.6 * t, 0.5 + 0.3 * std::sin(6.28318 * t), height, 1.1 * std::sin(3.14159 * t)));
    }
    return views;
  }
};

#endif
