// SPDX-License-Identifier: BSD-3-Clause
// Polygons as triangles: areas that are right, or reported as wrong.
#include "MTTestMeshes.h"
#include "Polygons/vtkMTPolygonTriangulation.h"
#include "vtkMTVector.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

namespace
{
using Vector = vtkMTVector::Vector;
using Outline = std::vector<Vector>;

constexpr double Pi = 3.14159265358979323846;

// What became of a polygon.
struct Split
{
  explicit Split(const Outline& outline)
  {
    vtkMTPolygonTriangulation triangulation;
    this->IsGood = triangulation.Triangulate(outline);
    this->Triangles = triangulation.GetTriangles();
    Vector sum = { 0.0, 0.0, 0.0 };
    std::vector<Vector> normals;
    for (const auto& t : this->Triangles)
    {
      const Vector& a = outline.at(t[0]);
      const Vector normal = vtkMTVector::Scale(
        vtkMTVector::Cross(vtkMTVector::Subtract(outline.at(t[1]), a), vtkMTVector::Subtract(outline.at(t[2]), a)),
        0.5);
      normals.push_back(normal);
      sum = vtkMTVector::Add(sum, normal);
    }
    const double length = vtkMTVector::Norm(sum);
    for (const Vector& normal : normals)
    {
      const double area = vtkMTVector::Dot(normal, sum) / length;
      this->Area += std::abs(area);
      this->Smallest = std::min(this->Smallest, area);
    }
  }
  bool IsGood = false;
  double Area = 0.0;     // of all triangles, turned over ones too
  double Smallest = 1e9; // of a triangle; negative where it is turned over
  std::vector<vtkMTPolygonTriangulation::Triangle> Triangles;
};

Outline Flat(const std::vector<std::array<double, 2>>& places)
{
  Outline outline;
  for (const auto& place : places)
  {
    outline.push_back({ place[0], place[1], 0.0 });
  }
  return outline;
}

// The same polygon in other planes, far away, large and small, and from another corner on.
std::vector<Outline> Variants(const Outline& outline)
{
  std::vector<Outline> all(8);
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Vector& p = outline[i];
    all[0].push_back(p);
    all[1].push_back({ p[2], p[0], p[1] });
    all[2].push_back({ p[1], p[2], p[0] });
    all[3].push_back({ c * p[0] - s * p[1], s * c * p[0] + c * c * p[1], s * s * p[0] + s * c * p[1] }); // tilted
    all[4].push_back({ p[0] + 4e6, p[1] - 3e5, p[2] + 100.0 });
    all[5].push_back({ p[0] * 0x1p600, p[1] * 0x1p600, 0.0 });
    all[6].push_back({ p[0] * 0x1p-500, p[1] * 0x1p-500, 0.0 });
    all[7].push_back(outline[(i + outline.size() / 2) % outline.size()]);
  }
  return all;
}

void ExpectCovered(const Outline& outline, double area, const char* name)
{
  const double scales[8] = { 1.0, 1.0, 1.0, 1.0, 1.0, 0x1p600, 0x1p-500, 1.0 };
  const std::vector<Outline> variants = Variants(outline);
  for (std::size_t v = 0; v < variants.size(); ++v)
  {
    Outline scaled = variants[v];
    const Split split(variants[v]);
    EXPECT_TRUE(split.IsGood) << name << ", variant " << v;
    EXPECT_EQ(split.Triangles.size(), outline.size() - 2) << name << ", variant " << v;
    if (scales[v] == 1.0)
    {
      EXPECT_NEAR(split.Area, area, 1e-8 * area) << name << ", variant " << v;
      EXPECT_GT(split.Smallest, -1e-8 * area) << name << ", variant " << v;
    }
    else
    {
      EXPECT_EQ(split.Triangles, Split(outline).Triangles) << name << ": the scale changes nothing";
    }
  }
}

// k square holes in a row, each joined to the one before by a bridge.
Outline Plate(int k)
{
  std::vector<std::array<double, 2>> there = { { 0, 0 }, { 2.0 * k + 1, 0 }, { 2.0 * k + 1, 3 }, { 0, 3 }, { 0, 0 } };
  std::vector<std::array<double, 2>> back;
  for (int i = 0; i < k; ++i)
  {
    const double x = 2.0 * i + 1.0;
    there.insert(there.end(), { { x, 1 }, { x, 2 }, { x + 1, 2 }, { x + 1, 1 } });
    back.insert(back.begin(), { { x + 1, 1 }, { x, 1 } });
  }
  back.erase(back.begin()); // the last hole has no bridge behind it
  there.insert(there.end(), back.begin(), back.end());
  return Flat(there);
}

// A star whose corners lie at random distances: concave, but simple.
Outline Star(int n, MTTestMeshes::Random& random, double least)
{
  std::vector<std::array<double, 2>> places;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2.0 * Pi * i / n;
    const double radius = least + (1.0 - least) * static_cast<double>(random.Below(1000000)) / 1e6;
    places.push_back({ radius * std::cos(angle), radius * std::sin(angle) });
  }
  return Flat(places);
}

double GetArea(const Outline& outline)
{
  double area = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Vector& a = outline[i];
    const Vector& b = outline[(i + 1) % outline.size()];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return area;
}
}

TEST(PolygonTriangulation, ConvexPolygonsGetTheTrianglesOfVtkPolygon)
{
  MTTestMeshes::Random random(3);
  const vtkNew<vtkPolygon> polygon;
  const vtkNew<vtkIdList> ids;
  int compared = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const int n = 5 + static_cast<int>(random.Below(30));
    Outline outline = Star(n, random, i % 3 == 0 ? 0.3 : 1.0); // every third one is concave, the others are regular
    for (Vector& p : outline)
    {
      p = { 3.0 * p[0] + p[1], p[1], i % 2 == 0 ? 0.0 : 0.3 * p[0] - 0.2 * p[1] };
    }
    polygon->PointIds->SetNumberOfIds(n);
    polygon->Points->SetDataTypeToDouble();
    polygon->Points->SetNumberOfPoints(n);
    for (int p = 0; p < n; ++p)
    {
      polygon->PointIds->SetId(p, p);
      polygon->Points->SetPoint(p, outline[static_cast<std::size_t>(p)].data());
    }
    if (!polygon->Triangulate(ids))
    {
      continue;
    }
    ++compared;
    const Split split(outline);
    ASSERT_EQ(ids->GetNumberOfIds(), static_cast<vtkIdType>(3 * split.Triangles.size()));
    for (vtkIdType t = 0; t < ids->GetNumberOfIds(); ++t)
    {
      ASSERT_EQ(ids->GetId(t), split.Triangles[static_cast<std::size_t>(t / 3)][static_cast<std::size_t>(t % 3)]);
    }
  }
  std::cout << compared << " of 3000 compared\n";
  EXPECT_GT(compared, 2000);
}

TEST(PolygonTriangulation, HolesByBridgeEdgesStayHoles)
{
  for (const int holes : { 1, 2, 7, 40, 400 })
  {
    ExpectCovered(Plate(holes), 3.0 * (2 * holes + 1) - holes, "plate");
  }
  // A bridge with a bend, inside of the polygon; and one outside, which joins two squares.
  ExpectCovered(Flat({ { 0, 0 }, { 6, 0 }, { 6, 6 }, { 0, 6 }, { 0, 0 }, { 2, 1 }, { 2, 2 }, { 2, 4 }, { 4, 4 },
                  { 4, 2 }, { 2, 2 }, { 2, 1 } }),
    32.0, "bent bridge");
  ExpectCovered(Flat({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 3, 1 }, { 3, 3 }, { 4, 3 }, { 4, 4 }, { 3, 4 }, { 3, 3 },
                  { 3, 1 }, { 1, 1 }, { 0, 1 } }),
    2.0, "bridge between squares");
  ExpectCovered(Flat({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 1, 3 }, { 3, 3 }, { 4, 3 }, { 4, 4 }, { 3, 4 }, { 3, 3 },
                  { 1, 3 }, { 1, 1 }, { 0, 1 } }),
    2.0, "bridge between squares, bent the other way");
  // Several bridges to one corner.
  ExpectCovered(Flat({ { 0, 0 }, { 9, 0 }, { 9, 9 }, { 0, 9 }, { 0, 0 }, { 1, 4 }, { 1, 5 }, { 2, 5 }, { 2, 4 },
                  { 1, 4 }, { 0, 0 }, { 4, 1 }, { 4, 2 }, { 5, 2 }, { 5, 1 }, { 4, 1 } }),
    79.0, "two bridges to one corner");
}

TEST(PolygonTriangulation, OutlinesThatTouchThemselvesAreCoveredOnce)
{
  ExpectCovered(
    Flat({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 }, { 1, 1 }, { 0, 1 } }), 2.0, "corner to corner");
  ExpectCovered(Flat({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 2, 0 }, { 0, 4 } }), 8.0, "corner to edge");
  ExpectCovered(
    Flat({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 0, 0 }, { 1, 2 }, { 2, 3 }, { 3, 2 }, { 2, 1 }, { 1, 2 } }), 14.0,
    "a hole at a bridge of two corners");
  ExpectCovered(Flat({ { 0, 0 }, { 2, 0 }, { 2, 1 }, { 3, 1 }, { 3, 0 }, { 2, 0 }, { 5, 0 }, { 5, 3 }, { 0, 3 } }),
    14.0, "a hole at the border");
  ExpectCovered(
    Flat({ { 0, 0 }, { 4, 0 }, { 6, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 }, { 0, 6 }, { 0, 4 } }), 16.0, "spikes");
  ExpectCovered(
    Flat({ { 0, 0 }, { 4, 0 }, { 4, 0 }, { 4, 4 }, { 4, 4 }, { 0, 4 }, { 0, 0 } }), 16.0, "repeated corners");
}

TEST(PolygonTriangulation, CornersOnStraightEdgesGetTrianglesWithAnArea)
{
  const Split split(
    Flat({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 3, 1 }, { 3, 2 }, { 2, 2 }, { 1, 2 }, { 0, 2 }, { 0, 1 } }));
  EXPECT_TRUE(split.IsGood);
  EXPECT_NEAR(split.Area, 6.0, 1e-12);
  EXPECT_GT(split.Smallest, 0.0) << "else neighbours that share those corners would be joined by T-junctions";
  const Split triangle(Flat({ { 0, 0 }, { 1, 0 }, { 2, 0 }, { 3, 0 }, { 0, 3 } }));
  EXPECT_NEAR(triangle.Area, 4.5, 1e-12);
  EXPECT_GT(triangle.Smallest, 0.0);
}

TEST(PolygonTriangulation, OutlinesThatCrossThemselvesAreReported)
{
  Outline pentagram;
  for (int i = 0; i < 5; ++i)
  {
    pentagram.push_back({ std::cos(0.8 * Pi * i), std::sin(0.8 * Pi * i), 0.0 });
  }
  const Outline cases[] = { Flat({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }),
    Flat({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 3 } }), pentagram,
    Flat({ { 0, 0 }, { 4, 0 }, { 4, 4 }, { 1, 4 }, { 1, -1 }, { 0, -1 } }) };
  for (const Outline& outline : cases)
  {
    for (const Outline& variant : Variants(outline))
    {
      const Split split(variant);
      EXPECT_FALSE(split.IsGood) << outline.size();
      EXPECT_EQ(split.Triangles.size(), outline.size() - 2);
    }
  }
  // Without an area there is nothing to cross, nor to cover.
  EXPECT_TRUE(Split(Flat({ { 0, 0 }, { 1, 1 }, { 2, 2 }, { 1, 1 }, { 3, 3 } })).IsGood);
  EXPECT_TRUE(Split(Outline(6, Vector{ 1.0, 2.0, 3.0 })).IsGood);
}

TEST(PolygonTriangulation, BentAndRandomPolygonsKeepTheirArea)
{
  MTTestMeshes::Random random(11);
  for (int i = 0; i < 400; ++i)
  {
    const Outline star = Star(5 + static_cast<int>(random.Below(60)), random, 0.05);
    const Split split(star);
    EXPECT_TRUE(split.IsGood);
    EXPECT_NEAR(split.Area, GetArea(star), 1e-12);
    Outline bent = star;
    for (Vector& p : bent)
    {
      p[2] = 0.2 * p[0] * p[0] + 0.1 * p[1];
    }
    EXPECT_TRUE(Split(bent).IsGood);
  }
}

TEST(PolygonTriangulation, LargePolygonsAreSplitToo)
{
  MTTestMeshes::Random random(12);
  const Outline star = Star(30000, random, 0.5);
  constexpr int n = 10000;
  std::vector<std::array<double, 2>> comb = { { 0, -1 }, { n, -1 }, { n, 0 } };
  std::vector<std::array<double, 2>> inner;
  std::vector<std::array<double, 2>> spiral;
  for (int i = 0; i < n; ++i)
  {
    comb.insert(comb.end(), { { n - i - 0.5, 10.0 }, { n - i - 1.0, 0.0 } });
    const double angle = 0.01 * i;
    spiral.push_back({ (1.0 + angle) * std::cos(angle), (1.0 + angle) * std::sin(angle) });
    inner.push_back({ (0.5 + angle) * std::cos(angle), (0.5 + angle) * std::sin(angle) });
  }
  spiral.insert(spiral.end(), inner.rbegin(), inner.rend());
  for (Outline outline : { star, Flat(comb), Flat(spiral) })
  {
    if (GetArea(outline) < 0.0)
    {
      std::reverse(outline.begin(), outline.end());
    }
    const Split split(outline);
    EXPECT_TRUE(split.IsGood) << outline.size();
    EXPECT_NEAR(split.Area, GetArea(outline), 1e-8 * split.Area);
    std::cout << outline.size() << " corners, area " << split.Area << "\n";
  }
}
