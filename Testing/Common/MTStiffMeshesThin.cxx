// SPDX-License-Identifier: BSD-3-Clause
// Thin and sharp things.
#include "MTStiffMeshes.h"

namespace MTStiffMeshes
{
namespace
{
const double Pi = vtkMath::Pi();

//------------------------------------------------------------------------------
// A strip that goes up and down, once for each tooth, `steps` cells along each wall; move changes x by place on a wall.
template <class Function>
Mesh MakeComb(int triangles, int teeth, const Function& move)
{
  const int steps = std::max(2, static_cast<int>(std::lround(std::sqrt(triangles / (4.0 * teeth)))));
  const int rows = std::max(2, triangles / (4 * teeth * steps) + 1);
  const int columns = 2 * teeth * steps + 1;
  Parts parts;
  parts.AddGrid(columns, rows,
    [&](int i, int j)
    {
      const int wall = i / steps;
      const int tooth = wall / 2;
      const double along = static_cast<double>(i % steps) / steps;
      const double z = wall % 2 == 0 ? along : 1.0 - along;
      const double y = static_cast<double>(j) / (rows - 1);
      // A tooth is thin: its two walls are a hundredth of the way to the next one apart.
      const double x =
        (tooth + (wall % 2 == 0 ? 0.005 * z : 0.01 - 0.005 * z) + (i % steps == 0 ? 0.0 : move(y, z))) / teeth;
      return Place{ x, y, z };
    });
  return parts.Make();
}

// Two sheets of side x side points at -distance/2 and distance/2, the lower one reversed.
Parts MakeSheets(int side, double distance, double waves)
{
  Parts parts;
  for (const double sign : { 1.0, -1.0 })
  {
    parts.AddGrid(side, side,
      [&](int i, int j)
      {
        const double x = static_cast<double>(i) / (side - 1);
        const double y = static_cast<double>(j) / (side - 1);
        return Place{ x, y, 0.5 * sign * distance + waves * std::sin(5.0 * x) * std::cos(4.0 * y) };
      });
  }
  for (std::size_t t = parts.Triangles.size() / 2; t < parts.Triangles.size(); ++t)
  {
    std::swap(parts.Triangles[t][1], parts.Triangles[t][2]);
  }
  return parts;
}

// Whether a cell of a Menger sponge of side 3^k is filled.
bool IsFilled(int x, int y, int z)
{
  for (; x > 0 || y > 0 || z > 0; x /= 3, y /= 3, z /= 3)
  {
    if ((x % 3 == 1) + (y % 3 == 1) + (z % 3 == 1) > 1)
    {
      return false;
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
Mesh RoughComb(int triangles, int teeth)
{
  MTTestMeshes::Random random(11);
  return MakeComb(triangles, teeth, [&random](double, double) { return random.Uniform(-0.001, 0.001); });
}

//------------------------------------------------------------------------------
Mesh WavedComb(int triangles, int teeth)
{
  return MakeComb(triangles, teeth, [](double y, double z) { return 0.05 * std::sin(7.0 * y) * std::sin(Pi * z); });
}

//------------------------------------------------------------------------------
Mesh ThinPlate(int triangles, double thickness, double waves)
{
  const int side = GetSide(triangles / 2);
  Parts parts = MakeSheets(side, thickness, waves);
  const vtkIdType below = static_cast<vtkIdType>(side) * side;
  const auto addRim = [&](vtkIdType a, vtkIdType b)
  {
    parts.AddTriangle(a, below + a, below + b);
    parts.AddTriangle(a, below + b, b);
  };
  const vtkIdType last = side - 1;
  for (vtkIdType i = 0; i < last; ++i)
  {
    addRim(i, i + 1);
    addRim(last * side + i + 1, last * side + i);
    addRim((i + 1) * side, i * side);
    addRim(i * side + last, (i + 1) * side + last);
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh ThinSheets(int triangles, double distance)
{
  return MakeSheets(GetSide(triangles / 2), distance, 0.05).Make();
}

//------------------------------------------------------------------------------
Mesh Spikes(int triangles)
{
  Mesh sphere = BumpySphere(triangles);
  MTTestMeshes::Random random(12);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    if (random.Below(20) == 0)
    {
      Place p;
      sphere->GetPoint(i, p.data());
      const double factor = std::pow(30.0, random.Uniform());
      sphere->GetPoints()->SetPoint(i, factor * p[0], factor * p[1], factor * p[2]);
    }
  }
  return sphere;
}

//------------------------------------------------------------------------------
Mesh Sponge(int triangles)
{
  const int side = triangles < 500 ? 3 : triangles < 10000 ? 9 : 27;
  Parts parts;
  std::map<int, vtkIdType> known;
  const auto getPoint = [&](const std::array<int, 3>& x)
  {
    const auto found = known.insert({ x[0] + 100 * (x[1] + 100 * x[2]), static_cast<vtkIdType>(parts.Places.size()) });
    return found.second ? parts.Add(x[0], x[1], x[2]) : found.first->second;
  };
  const auto isThere = [side](const std::array<int, 3>& x) {
    return std::all_of(x.begin(), x.end(), [side](int k) { return k >= 0 && k < side; }) && IsFilled(x[0], x[1], x[2]);
  };
  for (int cell = 0; cell < side * side * side; ++cell)
  {
    const std::array<int, 3> low{ cell % side, cell / side % side, cell / side / side };
    for (int face = 0; face < 6 && isThere(low); ++face)
    {
      const int axis = face / 2;
      std::array<int, 3> beyond = low;
      beyond[axis] += face % 2 == 1 ? 1 : -1;
      if (isThere(beyond))
      {
        continue;
      }
      std::array<int, 3> corners[4] = { low, low, low, low };
      for (int c = 0; c < 4; ++c)
      {
        corners[c][axis] += face % 2;
        corners[c][(axis + 1) % 3] += c == 1 || c == 2;
        corners[c][(axis + 2) % 3] += c >= 2;
      }
      if (face % 2 == 0)
      {
        std::swap(corners[1], corners[3]);
      }
      const vtkIdType first = getPoint(corners[0]);
      const vtkIdType third = getPoint(corners[2]);
      parts.AddTriangle(first, getPoint(corners[1]), third);
      parts.AddTriangle(first, third, getPoint(corners[3]));
    }
  }
  return parts.Make();
}

//------------------------------------------------------------------------------
Mesh Crumpled(int triangles)
{
  const int side = GetSide(triangles);
  MTTestMeshes::Random random(13);
  Parts parts;
  parts.AddGrid(side, side,
    [side](int i, int j) {
      return Place{ static_cast<double>(i) / (side - 1) - 0.5, static_cast<double>(j) / (side - 1) - 0.5, 0.0 };
    });
  for (int fold = 0; fold < 14; ++fold)
  {
    Place normal{ random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0) };
    vtkMath::Normalize(normal.data());
    const double offset = random.Uniform(-0.15, 0.15);
    for (Place& p : parts.Places)
    {
      const double height = vtkMath::Dot(p.data(), normal.data()) - offset;
      for (int i = 0; i < 3 && height > 0.0; ++i)
      {
        p[i] -= 2.0 * height * normal[i];
      }
    }
  }
  return parts.Make();
}
}
