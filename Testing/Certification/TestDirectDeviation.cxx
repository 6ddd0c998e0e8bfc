// SPDX-License-Identifier: BSD-3-Clause
// Sums of steps that are too large, held against a finer mesh: what takes their place holds, for every point of both.
#include "MTTestMeshes.h"

#include "vtkMTBoxRuns.h"
#include "vtkMTDeviation.h"
#include "vtkMTDirectDeviation.h"
#include "vtkMTFinerRecord.h"
#include "vtkMTSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>

namespace
{
using Ball = vtkMTBoxRuns::Ball;
using Deviations = vtkMTDirectDeviation::Deviations;
using Random = MTTestMeshes::Random;
using Vector = vtkMTSurface::Vector;
const vtkMTPoint Origin{ 0, 0, 0 };

// Cells of side x side steps from (0, 0) on, with the heights that a field of them has there.
constexpr int Side = 100;
constexpr int FieldCells = 64;
struct Field
{
  // Rough: every point by itself. Otherwise the less, the finer, as what is added to the points of coarser fields.
  explicit Field(std::uint64_t seed, bool isRough = true)
  {
    Random random(seed);
    this->Heights.fill(0);
    for (int step = isRough ? 1 : 4; step >= 1; step /= 2)
    {
      const double most = isRough ? 60.0 : 15.0 * step;
      for (int j = 0; j <= FieldCells; j += step)
      {
        for (int i = 0; i <= FieldCells; i += step)
        {
          const int low = j - j % (2 * step);
          const int left = i - i % (2 * step);
          const int between =
            (this->Get(left, low) + this->Get(left + i % (2 * step) * 2, low + j % (2 * step) * 2)) / 2;
          this->Heights[j * (FieldCells + 1) + i] =
            (isRough ? 0 : between) + static_cast<std::int32_t>(most * (random.Uniform() - 0.5));
        }
      }
    }
  }
  std::int32_t Get(int i, int j) const { return this->Heights[j * (FieldCells + 1) + i]; }

  // Every so many of its points, columns of them from the first to the last one.
  vtkMTPatch MakeMesh(int step, int lastColumn = FieldCells) const
  {
    vtkMTPatch mesh;
    const int columns = lastColumn / step;
    const int rows = FieldCells / step;
    for (int j = 0; j <= rows; ++j)
    {
      for (int i = 0; i <= columns; ++i)
      {
        mesh.Points.push_back({ Side * step * i, Side * step * j, this->Get(step * i, step * j) });
      }
    }
    for (int j = 0; j < rows; ++j)
    {
      for (int i = 0; i < columns; ++i)
      {
        const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i);
        const std::uint32_t c = a + static_cast<std::uint32_t>(columns) + 1;
        mesh.Triangles.push_back({ a, a + 1, c + 1 });
        mesh.Triangles.push_back({ a, c + 1, c });
      }
    }
    return mesh;
  }

  std::array<std::int32_t, (FieldCells + 1) * (FieldCells + 1)> Heights;
};

Vector GetPlace(const vtkMTSurface& surface, std::uint32_t t, Random& random)
{
  const double a = random.Uniform();
  const double b = (1.0 - a) * random.Uniform();
  Vector x;
  for (int i = 0; i < 3; ++i)
  {
    x[i] = (1.0 - a - b) * surface.GetCorner(t, 0)[i] + a * surface.GetCorner(t, 1)[i] + b * surface.GetCorner(t, 2)[i];
  }
  return x;
}

// The least of distance and of what is added for each triangle.
template <class Added>
double FindLeast(const vtkMTSurface& surface, const Vector& x, const Added& added)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < surface.GetNumberOfTriangles(); ++t)
  {
    const double distance2 = surface.GetDistance2(x, t, std::numeric_limits<double>::infinity());
    least = std::min(least, std::sqrt(distance2) + added(t));
  }
  return least;
}

double GetLargest(const Deviations& deviations)
{
  double largest = 0.0;
  for (const vtkMTTriangleDeviation& deviation : deviations)
  {
    largest = std::max({ largest, double(deviation.ToInput), double(deviation.FromInput) });
  }
  return largest;
}

// The left half of a field, simplified, whose finer mesh is all of the field; what is known of that is given.
class Half
{
public:
  Half(std::uint64_t seed, float known, bool isRough = true)
    : Heights(seed, isRough)
    , FinerMesh(this->Heights.MakeMesh(1))
    , Finer(this->FinerMesh, Origin)
    , Floor(this->Heights.MakeMesh(1, FieldCells / 2), Origin)
    , Fragment(this->Heights.MakeMesh(8, FieldCells / 2), Origin)
    , OfFiner(this->Finer.GetNumberOfTriangles(), { known, known, 0, 0 })
    , OfFloor(this->Floor.GetNumberOfTriangles(), { known, known, 0, 0 })
  {
    vtkMTDeviation::Findings findings;
    this->True = vtkMTDeviation::Between(this->Floor, this->Fragment, { {}, this->OfFloor }, findings).LowerBound;
    this->Known.assign(this->Fragment.GetNumberOfTriangles(), { 0, 0, 0, 0 });
    for (vtkMTTriangleDeviation& deviation : this->Known)
    {
      deviation.ToInput = deviation.FromInput = static_cast<float>(2.5 * this->True);
    }
  }

  // The finer mesh is so many levels below; what is nearer is a mesh of every second point.
  void Improve(const vtkMTSurface& floor, const Deviations& ofFloor, std::size_t levelsBelow = 2,
    std::size_t leastFloor = vtkMTDirectDeviation::LeastFloor)
  {
    const vtkMTPatch betweenMesh = this->Heights.MakeMesh(2);
    const vtkMTSurface between(betweenMesh, Origin);
    vtkMTDeviation::Findings ofBetween;
    if (levelsBelow > vtkMTDirectDeviation::NearLevels)
    {
      vtkMTDeviation::Between(this->Finer, between, { {}, this->OfFiner }, ofBetween);
    }
    const auto collect = [&](const vtkMTDirectDeviation::Neighbourhood& near, std::size_t below,
                           vtkMTDirectDeviation::FinerPart& part, std::string&)
    {
      const bool isFinest = below == levelsBelow;
      const vtkMTPatch& mesh = isFinest ? this->FinerMesh : betweenMesh;
      const vtkMTSurface& surface = isFinest ? this->Finer : between;
      const Deviations& known = isFinest ? this->OfFiner : ofBetween.Deviations;
      vtkMTFinerRecord::Bytes record;
      vtkMTFinerRecord::Encode(mesh, known, record);
      EXPECT_TRUE(vtkMTFinerRecord::Append(record, near, Origin, part));
      EXPECT_TRUE(this->HasAllThatIsNear(surface, known, near, part));
      ++this->Parts;
      this->Collected[isFinest ? 1 : 0] += part.Mesh.Triangles.size();
      return true;
    };
    std::string error;
    ASSERT_TRUE(vtkMTDirectDeviation::Improve({ floor, ofFloor }, this->Fragment, Origin,
      { levelsBelow, vtkMTDirectDeviation::Looseness, leastFloor }, collect, this->Known, error))
      << error;
  }

  // Whether a part has every triangle that touches a neighbourhood, with what is known of it.
  static bool HasAllThatIsNear(const vtkMTSurface& surface, const Deviations& known,
    const vtkMTDirectDeviation::Neighbourhood& near, const vtkMTDirectDeviation::FinerPart& part)
  {
    using Corners = std::array<Vector, 3>;
    std::map<Corners, std::pair<float, float>> taken;
    const vtkMTSurface ofPart(part.Mesh, Origin);
    for (std::uint32_t s = 0; s < part.Known.size(); ++s)
    {
      taken[{ ofPart.GetCorner(s, 0), ofPart.GetCorner(s, 1), ofPart.GetCorner(s, 2) }] = { part.Known[s].ToInput,
        part.Known[s].FromInput };
    }
    bool hasAll = taken.size() == part.Mesh.Triangles.size();
    for (std::uint32_t s = 0; s < surface.GetNumberOfTriangles(); ++s)
    {
      const Corners corners{ surface.GetCorner(s, 0), surface.GetCorner(s, 1), surface.GetCorner(s, 2) };
      const Ball ball = vtkMTDirectDeviation::GetBall(corners[0], corners[1], corners[2], known[s].FromInput);
      const auto found = taken.find(corners);
      const std::pair<float, float> expected{ known[s].ToInput, known[s].FromInput };
      hasAll = hasAll && (found == taken.end() ? !near.Touches(ball) : found->second == expected);
    }
    return hasAll;
  }

  // Of random places: how many are farther than what is known allows.
  int CountViolations(std::uint64_t seed, int samples)
  {
    Random random(seed);
    int violations = 0;
    for (int i = 0; i < samples; ++i)
    {
      const auto t = static_cast<std::uint32_t>(random.Uniform() * this->Fragment.GetNumberOfTriangles());
      const double up = FindLeast(
        this->Finer, GetPlace(this->Fragment, t, random), [this](std::uint32_t s) { return this->OfFiner[s].ToInput; });
      violations += up > this->Known[t].ToInput ? 1 : 0;
      const auto f = static_cast<std::uint32_t>(random.Uniform() * this->Floor.GetNumberOfTriangles());
      const double down = FindLeast(this->Fragment, GetPlace(this->Floor, f, random),
        [this](std::uint32_t s) { return -this->Known[s].FromInput; });
      violations += down + this->OfFloor[f].FromInput > 0.0 ? 1 : 0;
    }
    return violations;
  }

  Field Heights;
  vtkMTPatch FinerMesh;
  vtkMTSurface Finer;
  vtkMTSurface Floor;
  vtkMTSurface Fragment;
  Deviations OfFiner;
  Deviations OfFloor;
  Deviations Known; // of the fragment
  double True = 0.0;
  int Parts = 0;
  std::array<std::size_t, 2> Collected{ 0, 0 }; // triangles of the mesh between and of the finest
};
}

TEST(DirectDeviation, TakesThePlaceOfLooseSumsAndHoldsForEveryPoint)
{
  for (const float known : { 0.0f, 5.0f })
  {
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
    {
      Half half(seed, known);
      half.Improve(half.Floor, half.OfFloor);
      const double ratio = GetLargest(half.Known) / half.True;
      const int violations = half.CountViolations(seed, 1500);
      std::cout << "known " << known << ", seed " << seed << ": " << half.True << " steps, certified " << ratio
                << " times that (2.5 before), " << violations << " violations\n";
      EXPECT_LE(ratio, 1.5) << "the other half, which is farther than that, is left out";
      EXPECT_EQ(violations, 0);
    }
  }
}

TEST(DirectDeviation, MostSumsBecomeSmallByANearerMesh)
{
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
  {
    Half alone(seed, 0.0f, false);
    alone.Improve(alone.Floor, alone.OfFloor);
    Half half(seed, 0.0f, false);
    half.Improve(half.Floor, half.OfFloor, vtkMTDirectDeviation::NearLevels + 2);
    const int violations = half.CountViolations(seed, 1500);
    std::cout << "seed " << seed << ": certified " << GetLargest(half.Known) / half.True << " (by the finest alone "
              << GetLargest(alone.Known) / half.True << "), " << half.Collected[0] << " triangles between and "
              << half.Collected[1] << " of the finest (" << alone.Collected[1] << "), " << violations
              << " violations\n";
    EXPECT_EQ(violations, 0);
    EXPECT_LE(GetLargest(half.Known), 1.02 * vtkMTDirectDeviation::Looseness * half.True);
    EXPECT_GT(half.Collected[0], 0u);
    EXPECT_LT(half.Collected[1], alone.Collected[1]);
  }
}

TEST(FinerRecord, ARecordThatIsDamagedIsNoMesh)
{
  const Half half(1, 3.0f);
  vtkMTFinerRecord::Bytes record;
  vtkMTFinerRecord::Encode(half.FinerMesh, half.OfFiner, record);
  const vtkMTDirectDeviation::Neighbourhood near(
    { half.Fragment, half.Known }, { 0, static_cast<std::uint32_t>(half.Known.size()) }, 0.0);
  Random random(5);
  int refused = 0;
  for (int i = 0; i < 2000; ++i)
  {
    vtkMTFinerRecord::Bytes damaged = record;
    damaged[static_cast<std::size_t>(random.Uniform() * static_cast<double>(record.size()))] ^=
      static_cast<unsigned char>(1 + 254 * random.Uniform());
    if (i % 2 == 0)
    {
      damaged.resize(static_cast<std::size_t>(random.Uniform() * static_cast<double>(record.size())));
    }
    vtkMTDirectDeviation::FinerPart part;
    refused += vtkMTFinerRecord::Append(damaged, near, Origin, part) ? 0 : 1;
  }
  std::cout << refused << " of 2000 refused\n";
  EXPECT_GE(refused, 1000) << "all that end early";
}

TEST(DirectDeviation, PointsThatStandFarFromTheirTriangleAreHandedOnToNearerOnes)
{
  Half half(2, 0.0f);
  double farthest = 0.0;
  for (std::uint32_t f = 0; f < half.Floor.GetNumberOfTriangles(); ++f)
  {
    const double distance2 =
      half.Fragment.GetDistance2(half.Floor.GetCorner(f, 0), 0, std::numeric_limits<double>::infinity());
    farthest = std::max(farthest, std::sqrt(distance2));
  }
  half.Known.assign(half.Known.size(), { static_cast<float>(1.2 * half.True), 0.0f, 0, 0 });
  half.Known[0].FromInput = static_cast<float>(farthest + 2.0 * Side); // all of them stand on the first one
  half.Improve(half.Floor, half.OfFloor);
  const double ratio = GetLargest(half.Known) / half.True;
  std::cout << "from " << farthest / half.True << " to " << ratio << " times the true distance\n";
  EXPECT_LE(ratio, 1.5);
  EXPECT_EQ(half.CountViolations(2, 1500), 0);
}

TEST(DirectDeviation, WorksPartByPartWhereTheFinerMeshIsLarge)
{
  Half whole(3, 0.0f);
  whole.Improve(whole.Floor, whole.OfFloor);
  Half half(3, 0.0f);
  const vtkMTSurface coarse(half.Heights.MakeMesh(4, FieldCells / 2), Origin);
  const Deviations ofCoarse(coarse.GetNumberOfTriangles(), { 0.0f, static_cast<float>(half.True), 0, 0 });
  // Of which there are so few that the finer mesh is too large for them, unless they count as more.
  Half counted = half;
  half.Improve(coarse, ofCoarse, 2, 1);
  counted.Improve(coarse, ofCoarse);
  std::cout << whole.Parts << " and " << half.Parts << " parts, " << GetLargest(whole.Known) << " and "
            << GetLargest(half.Known) << " steps\n";
  EXPECT_GT(half.Parts, whole.Parts);
  EXPECT_EQ(counted.Parts, whole.Parts);
  EXPECT_LT(GetLargest(half.Known), 2.4 * half.True);
  EXPECT_EQ(half.CountViolations(3, 1500), 0);
}

TEST(DirectDeviation, WithoutAFinerMeshSumsStand)
{
  Half half(1, 0.0f);
  half.FinerMesh.Triangles.clear();
  half.Finer = vtkMTSurface(half.FinerMesh, Origin);
  const double before = GetLargest(half.Known);
  half.Improve(half.Floor, half.OfFloor);
  EXPECT_EQ(GetLargest(half.Known), before);
}

TEST(DirectDeviation, AnErrorOfTheFinerMeshIsAnError)
{
  Half half(1, 0.0f);
  std::string error;
  EXPECT_FALSE(vtkMTDirectDeviation::Improve(
    { half.Floor, half.OfFloor }, half.Fragment, Origin, { 2, vtkMTDirectDeviation::Looseness },
    [](const auto&, std::size_t, auto&, std::string& why)
    {
      why = "the disk is gone";
      return false;
    },
    half.Known, error));
  EXPECT_EQ(error, "the disk is gone");
}

TEST(BoxRuns, FindWhatIsTouchedAndNothingElse)
{
  using Box = vtkMTBoxRuns::Box;
  std::size_t touching = 0;
  for (const std::size_t count : { 0, 1, 7, 8, 9, 500, 513 })
  {
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
    {
      Random random(seed);
      const auto makeBox = [&]
      {
        const double size = random.Uniform() < 0.03 ? 40.0 : 4.0; // a few are large
        const Vector low{ 100.0 * random.Uniform(), 100.0 * random.Uniform(), 100.0 * random.Uniform() };
        return Box{ low, { low[0] + size * random.Uniform(), low[1] + size * random.Uniform(), low[2] + 3.0 } };
      };
      std::vector<Box> boxes(count);
      std::generate(boxes.begin(), boxes.end(), makeBox);
      const vtkMTBoxRuns runs(boxes);
      for (int question = 0; question < 50; ++question)
      {
        const Box box = makeBox();
        const double endless = std::numeric_limits<double>::infinity();
        const Ball ball{ box.Low, question == 0 ? endless : 10.0 * random.Uniform() };
        const auto check = [&](const Box& around, const auto& touches)
        {
          std::vector<std::uint32_t> found;
          runs.HasTouched(around, touches,
            [&](std::uint32_t i)
            {
              found.push_back(i);
              return false;
            });
          std::vector<std::uint32_t> expected;
          for (std::uint32_t i = 0; i < count; ++i)
          {
            if (touches(boxes[i]))
            {
              expected.push_back(i);
            }
          }
          EXPECT_EQ(found, expected) << count << " boxes, seed " << seed;
          touching += expected.size();
        };
        check(box, [&](const Box& other) { return vtkMTBoxRuns::Touch(box, other); });
        check(vtkMTBoxRuns::GetBox(ball), [&](const Box& other) { return vtkMTBoxRuns::Touch(other, ball); });
      }
    }
  }
  std::cout << touching << " found\n";
  EXPECT_GT(touching, 1000u);
}
