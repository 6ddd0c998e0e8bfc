// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTNormalDeviation.h"

#include "vtkMTSurface.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace vtkMTVector;

namespace
{
constexpr double Pi = vtkMTNormalDeviation::Pi;
constexpr double Units = 65535.0;

// Many times what a few dozen operations in double precision are off by.
constexpr double Rounding = 1e-14;

// Of angles that are not zero exactly: what the inverse functions, and sums, add to that.
constexpr double AngleSlack = 1e-7;

// asin(x) for x from 0 to 1, rounded up; a straight angle above, where vectors may be opposite.
double GetAngle(double sine)
{
  return sine < 1.0 ? (sine > 0.0 ? std::asin(sine) + AngleSlack : 0.0) : Pi;
}

// A triangle's corners' normals.
struct Corners
{
  std::array<Vector, 3> Normals;
  double Least = 0.0; // no interpolated normal is shorter

  explicit Corners(const std::array<float, 3>* normals)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Normals[c] = { normals[c][0], normals[c][1], normals[c][2] };
    }
    // Along any axis an interpolated normal reaches as far as the one that reaches least.
    const Vector sum = Add(Add(this->Normals[0], this->Normals[1]), this->Normals[2]);
    const double length = Norm(sum);
    if (length > 0.0)
    {
      const double along =
        std::min({ Dot(this->Normals[0], sum), Dot(this->Normals[1], sum), Dot(this->Normals[2], sum) });
      this->Least = std::max(0.0, along / length * (1.0 - Rounding));
    }
  }
};

// A triangle's normals as an affine map of the place, on its plane and at the feet of places beside it.
struct Field
{
  Vector Origin;
  std::array<Vector, 3> Slopes{}; // of the normal's three coordinates
  double Steepness = 0.0;         // the map changes by no more than this for a step
  double Slack = 0.0;             // rounding

  Field(const vtkMTSurface& surface, std::uint32_t triangle, const Corners& corners)
    : Origin(surface.GetCorner(triangle, 0))
  {
    const Vector u = Subtract(surface.GetCorner(triangle, 1), this->Origin);
    const Vector v = Subtract(surface.GetCorner(triangle, 2), this->Origin);
    const Vector alongU = Subtract(corners.Normals[1], corners.Normals[0]);
    const Vector alongV = Subtract(corners.Normals[2], corners.Normals[0]);
    const Vector& normal = surface.GetNormal(triangle);
    const double lengthU = Norm(alongU);
    const double lengthV = Norm(alongV);
    if (!(lengthU > 0.0 || lengthV > 0.0))
    {
      return;
    }
    const double twiceArea = Dot(Cross(normal, u), v);
    if (!(twiceArea > 0.0))
    {
      this->Steepness = std::numeric_limits<double>::infinity();
      return;
    }
    const Vector inwardV = Scale(Cross(v, normal), 1.0 / twiceArea); // the slope of the second corner's weight
    const Vector inwardU = Scale(Cross(normal, u), 1.0 / twiceArea);
    for (int i = 0; i < 3; ++i)
    {
      this->Slopes[i] = Add(Scale(inwardV, alongU[i]), Scale(inwardU, alongV[i]));
    }
    this->Steepness = (lengthU * Norm(v) + lengthV * Norm(u)) / twiceArea * (1.0 + Rounding);
    this->Slack = Rounding * 4.0 * surface.GetExtent() * this->Steepness;
  }
};

// At most the difference of the normals of any two points, one on the field's triangle and one on the other, that are
// no farther apart than distance.
double GetDifference(const Field& field, const Corners& normals, const vtkMTSurface& otherSurface, std::uint32_t other,
  const Corners& otherNormals, double distance)
{
  double largest2 = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    const Vector x = Subtract(otherSurface.GetCorner(other, c), field.Origin);
    double square = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const double d = Dot(field.Slopes[i], x) + (normals.Normals[0][i] - otherNormals.Normals[c][i]);
      square += d * d;
    }
    largest2 = std::max(largest2, square);
  }
  return std::sqrt(largest2) * (1.0 + Rounding) + field.Steepness * distance + field.Slack;
}

// The largest angle between corners, where all are below a right angle.
double GetLargestOfCorners(const Corners& a, const Corners& b)
{
  double least = 1.0;
  for (const Vector& n : a.Normals)
  {
    for (const Vector& m : b.Normals)
    {
      const double lengths = std::sqrt(Dot(n, n) * Dot(m, m));
      least = std::min(least, lengths > 0.0 ? Dot(n, m) / lengths : 0.0);
    }
  }
  return least > Rounding ? std::acos(std::max(0.0, least - Rounding)) + AngleSlack : Pi;
}

class Certifier
{
public:
  Certifier(const vtkMTNormalDeviation::Mesh& floor, const vtkMTNormalDeviation::Mesh& fragment)
    : Floor(floor)
    , Fragment(fragment)
  {
  }

  // Bounds that are at most enough need not be good.
  double GetBound(std::uint32_t t, const Corners& normalsOfT, std::uint32_t s, const Corners& normalsOfS,
    const Field& fieldOfS, double distance, double enough) const
  {
    const double least = std::max(normalsOfT.Least, normalsOfS.Least);
    const double byS = GetDifference(fieldOfS, normalsOfS, this->Floor.Surface, t, normalsOfT, distance);
    if (least > 0.0 && byS * (0.5 * Pi) <= enough * least)
    {
      return enough;
    }
    double angle = byS < least ? GetAngle(byS / least) : Pi;
    if (angle > enough)
    {
      const double byT = GetDifference(
        Field(this->Floor.Surface, t, normalsOfT), normalsOfT, this->Fragment.Surface, s, normalsOfS, distance);
      angle = byT < least ? std::min(angle, GetAngle(byT / least)) : angle;
    }
    return angle > enough ? std::min(angle, GetLargestOfCorners(normalsOfT, normalsOfS)) : angle;
  }

  vtkMTNormalDeviation::Angles Run(const vtkMTNormalDeviation::Settings& settings, vtkMTDeviation::Findings& findings)
  {
    const std::size_t triangles = findings.Deviations.size();
    std::vector<Corners> normals;
    std::vector<Field> fields;
    normals.reserve(triangles);
    fields.reserve(triangles);
    for (std::uint32_t s = 0; s < triangles; ++s)
    {
      normals.emplace_back(this->Fragment.Normals.data() + 3 * std::size_t(s));
      fields.emplace_back(this->Fragment.Surface, s, normals[s]);
    }
    std::uint32_t last = vtkMTSurface::None;
    Corners floor(this->Floor.Normals.data());
    for (const vtkMTDeviation::Pair& pair : findings.Pairs)
    {
      if (pair.Floor != last)
      {
        last = pair.Floor;
        floor = Corners(this->Floor.Normals.data() + 3 * std::size_t(last));
        this->Before = this->GetFloorAngles(settings, last);
      }
      this->AddPair(pair, floor, normals[pair.Fragment], fields[pair.Fragment], findings);
    }
    return this->Sum(findings);
  }

private:
  // Of the floor's triangle that is looked at.
  struct Known
  {
    double ToInput;
    double FromInput;
  };

  vtkMTNormalDeviation::Angles Sum(const vtkMTDeviation::Findings& findings) const
  {
    vtkMTNormalDeviation::Angles angles;
    double area = 0.0;
    for (std::uint32_t s = 0; s < findings.Deviations.size(); ++s)
    {
      const vtkMTTriangleDeviation& found = findings.Deviations[s];
      const double known = vtkMTNormalDeviation::ToRadians(std::max(found.NormalToInput, found.NormalFromInput));
      const double angle = std::min(known, Pi);
      const vtkMTSurface& surface = this->Fragment.Surface;
      const Vector u = Subtract(surface.GetCorner(s, 1), surface.GetCorner(s, 0));
      const Vector v = Subtract(surface.GetCorner(s, 2), surface.GetCorner(s, 0));
      const double twiceArea = Norm(Cross(u, v));
      area += twiceArea;
      angles.Mean += twiceArea * angle;
      angles.Largest = std::max(angles.Largest, angle);
    }
    angles.Mean = area > 0.0 ? std::min(angles.Mean / area, angles.Largest) : angles.Largest;
    return angles;
  }

  static Known GetFloorAngles(const vtkMTNormalDeviation::Settings& settings, std::uint32_t t)
  {
    const vtkMTTriangleDeviation& known = settings.FloorDeviations[t];
    return { vtkMTNormalDeviation::ToRadians(known.NormalToInput),
      vtkMTNormalDeviation::ToRadians(known.NormalFromInput) };
  }

  // A bound matters where it raises what is known of the fragment's triangle by other pairs.
  void AddPair(const vtkMTDeviation::Pair& pair, const Corners& floor, const Corners& normals, const Field& field,
    vtkMTDeviation::Findings& findings) const
  {
    vtkMTTriangleDeviation& found = findings.Deviations[pair.Fragment];
    double enough = Pi;
    if (pair.IsUp)
    {
      enough = std::min(enough, vtkMTNormalDeviation::ToRadians(found.NormalToInput) - this->Before.ToInput);
    }
    if (pair.IsDown)
    {
      enough = std::min(enough, vtkMTNormalDeviation::ToRadians(found.NormalFromInput) - this->Before.FromInput);
    }
    const double angle = this->GetBound(pair.Floor, floor, pair.Fragment, normals, field, pair.Distance, enough);
    if (!(angle > enough))
    {
      return;
    }
    const auto raise = [&](std::uint16_t known, double before)
    { return std::max(known, vtkMTNormalDeviation::RoundUp(std::min(Pi, before + angle))); };
    found.NormalToInput = pair.IsUp ? raise(found.NormalToInput, this->Before.ToInput) : found.NormalToInput;
    found.NormalFromInput = pair.IsDown ? raise(found.NormalFromInput, this->Before.FromInput) : found.NormalFromInput;
  }

  const vtkMTNormalDeviation::Mesh& Floor;
  const vtkMTNormalDeviation::Mesh& Fragment;
  Known Before{ 0.0, 0.0 }; // of the floor's triangle
};
}

std::uint16_t vtkMTNormalDeviation::RoundUp(double angle)
{
  // What is a whole number of units stays that: AngleSlack is much more than this.
  constexpr double share = 1e-6;
  return static_cast<std::uint16_t>(std::clamp(std::ceil(angle * (Units / Pi) - share), 0.0, Units));
}

vtkMTNormalDeviation::Angles vtkMTNormalDeviation::Add(
  const Mesh& floor, const Mesh& fragment, const Settings& settings, vtkMTDeviation::Findings& findings)
{
  return Certifier(floor, fragment).Run(settings, findings);
}

double vtkMTNormalDeviation::Between(
  const Mesh& floor, std::uint32_t floorTriangle, const Mesh& fragment, std::uint32_t triangle, double distance)
{
  const Corners t(floor.Normals.data() + 3 * std::size_t(floorTriangle));
  const Corners s(fragment.Normals.data() + 3 * std::size_t(triangle));
  const Field field(fragment.Surface, triangle, s);
  return Certifier(floor, fragment).GetBound(floorTriangle, t, triangle, s, field, distance, -1.0);
}
