// SPDX-License-Identifier: BSD-3-Clause
#include "FlightPath.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>

namespace
{
using Vector = std::array<double, 3>;

Vector Add(const Vector& a, double t, const Vector& b)
{
  return { a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2] };
}

// Where the camera is at one moment, seen from the point of the surface that the path leads to.
struct Key
{
  double Time;     // share of the path
  double Distance; // shares of the model's radius
  double Lift;     // degrees above the surface's horizon
  double Around;   // degrees
  double Ahead;    // the focal point: 0 the target, 1 the model's centre, -1 the horizon before the camera
};

constexpr Key Keys[] = {
  { 0.00, 9.0, 60.0, 0.0, 1.0 },
  { 0.15, 6.0, 55.0, 10.0, 1.0 },
  { 0.45, 0.50, 45.0, 30.0, 0.0 },
  { 0.58, 0.16, 45.0, 45.0, 0.0 },
  { 0.66, 0.14, 40.0, 60.0, -1.0 },
  { 0.80, 0.16, 40.0, 220.0, -1.0 },
  { 0.88, 0.50, 45.0, 260.0, 0.0 },
  { 1.00, 5.0, 55.0, 300.0, 1.0 },
};

constexpr std::pair<double, const char*> Parts[] = { { 0.15, "far" }, { 0.45, "approach" }, { 0.66, "close" },
  { 0.80, "turn" }, { 2.0, "back" } };

Key GetKey(double time)
{
  const Key* next = std::find_if(
    std::begin(Keys), std::end(Keys), [time](const Key& key) { return key.Time >= time && key.Time > 0.0; });
  next = next == std::end(Keys) ? std::prev(next) : next;
  const Key& a = *std::prev(next);
  const Key& b = *next;
  const double s = std::clamp((time - a.Time) / (b.Time - a.Time), 0.0, 1.0);
  const double t = s * s * (3.0 - 2.0 * s);
  const auto mix = [t](double x, double y) { return (1.0 - t) * x + t * y; };
  // Distances by their logarithms: so the surface comes nearer at an even pace.
  return { time, std::exp(mix(std::log(a.Distance), std::log(b.Distance))), mix(a.Lift, b.Lift),
    mix(a.Around, b.Around), mix(a.Ahead, b.Ahead) };
}

// The point of the mesh that lies nearest to the ray.
Vector FindTarget(vtkPolyData* mesh, const Vector& center, const Vector& direction)
{
  Vector target = center;
  double nearest = VTK_DOUBLE_MAX;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    Vector point;
    mesh->GetPoint(i, point.data());
    const Vector from = Add(point, -1.0, center);
    const double along = vtkMath::Dot(from.data(), direction.data());
    const Vector off = Add(from, -along, direction);
    const double distance = vtkMath::Norm(off.data());
    if (along >= 0.0 && distance < nearest)
    {
      nearest = distance;
      target = point;
    }
  }
  return target;
}
}

FlightPath FlightPath::Make(const double bounds[6], vtkPolyData* mesh, int frames)
{
  // "Up" is along the thinnest side, so a terrain is flown over and not into.
  Vector center;
  Vector side;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = 0.5 * (bounds[2 * i] + bounds[2 * i + 1]);
    side[i] = bounds[2 * i + 1] - bounds[2 * i];
  }
  const int up = static_cast<int>(std::min_element(side.begin(), side.end()) - side.begin());
  const bool flat = side[up] < 0.5 * std::max({ side[0], side[1], side[2] });
  Vector axes[3] = {}; // two across, then up
  for (int i = 0; i < 3; ++i)
  {
    axes[i][(up + 1 + i) % 3] = 1.0;
  }
  const double radius = 0.5 * vtkMath::Norm(side.data());
  Vector outwards = Add(Add(axes[2], 0.35, axes[0]), -0.5, axes[1]);
  vtkMath::Normalize(outwards.data());
  const Vector target = FindTarget(mesh, center, outwards);
  const Vector normal = flat ? axes[2] : outwards;
  Vector across[2];
  vtkMath::Perpendiculars(normal.data(), across[0].data(), across[1].data(), 0.0);

  FlightPath path;
  for (int frame = 0; frame < frames; ++frame)
  {
    const Key key = GetKey(frames > 1 ? double(frame) / (frames - 1) : 0.0);
    const double lift = vtkMath::RadiansFromDegrees(key.Lift);
    const double around = vtkMath::RadiansFromDegrees(key.Around);
    Vector horizon = { 0.0, 0.0, 0.0 };
    horizon = Add(Add(horizon, std::cos(around), across[0]), std::sin(around), across[1]);
    Vector away = { 0.0, 0.0, 0.0 };
    away = Add(Add(away, std::cos(lift), horizon), std::sin(lift), normal);
    const Vector position = Add(target, key.Distance * radius, away);
    const Vector toCenter = Add(center, -1.0, target);
    const Vector focus = key.Ahead >= 0.0 ? Add(target, key.Ahead, toCenter)
                                          : Add(target, 0.5 * key.Ahead * key.Distance * radius, horizon);
    path.Views.push_back(
      { position[0], position[1], position[2], focus[0], focus[1], focus[2], normal[0], normal[1], normal[2] });
  }
  return path;
}

bool FlightPath::Read(const std::string& file, std::string& error)
{
  std::ifstream in(file);
  this->Views.clear();
  View view;
  for (std::size_t i = 0; in >> view[i % 9]; ++i)
  {
    if (i % 9 == 8)
    {
      this->Views.push_back(view);
    }
  }
  if (!in.eof() || this->Views.empty())
  {
    error = file + ": no lines of nine numbers";
    return false;
  }
  return true;
}

bool FlightPath::Write(const std::string& file, std::string& error) const
{
  std::ofstream out(file);
  out << std::setprecision(17);
  for (const View& view : this->Views)
  {
    for (std::size_t i = 0; i < view.size(); ++i)
    {
      out << view[i] << (i + 1 < view.size() ? ' ' : '\n');
    }
  }
  out.close();
  error = out ? "" : file + ": cannot be written";
  return static_cast<bool>(out);
}

void FlightPath::Apply(int frame, vtkRenderer* renderer) const
{
  const View& view = this->Views[frame];
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(view[0], view[1], view[2]);
  camera->SetFocalPoint(view[3], view[4], view[5]);
  camera->SetViewUp(view[6], view[7], view[8]);
  renderer->ResetCameraClippingRange();
}

std::string FlightPath::GetPart(int frame) const
{
  const double time = this->Views.size() > 1 ? double(frame) / double(this->Views.size() - 1) : 0.0;
  return std::find_if(std::begin(Parts), std::end(Parts), [time](const auto& part) { return time <= part.first; })
    ->second;
}
