// SPDX-License-Identifier: BSD-3-Clause
// What the codecs of the file keep, and how small they make it.
#include "MTIOTest.h"
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTExactPoints.h"
#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMTPatchOrder.h"

#include "vtkType.h"

#include <cmath>
#include <cstring>
#include <numeric>
#include <set>

using namespace MTIOTest;

namespace
{
using MTTestMeshes::Random;

vtkMTArrayInfo MakeInfo(int type, int components, vtkMTArrayInfo::AssociationType association)
{
  vtkMTArrayInfo info;
  info.Name = "array " + std::to_string(type);
  info.Type = type;
  info.Components = components;
  info.Association = association;
  return info;
}

// A bumpy height field of n x n cells; every k-th column of points is a seam with two wedges when k > 0, a third of the
// points can be shared, all coordinates are multiples of 2^shift but for the shared ones, and triangles are shuffled.
vtkMTPatch MakeField(Random& random, int n, int seam, unsigned shift, std::int32_t scale)
{
  vtkMTPatch patch;
  const int across = n + 1;
  std::vector<std::uint32_t> order(static_cast<std::size_t>(across) * across);
  std::iota(order.begin(), order.end(), 0u);
  const std::size_t shared = order.size() / 3;
  patch.Points.resize(order.size());
  for (std::uint32_t p = 0; p < order.size(); ++p)
  {
    const auto x = static_cast<std::int32_t>(p) % across;
    const auto y = static_cast<std::int32_t>(p) / across;
    const double z = scale * (std::sin(0.3 * x) + std::cos(0.2 * y)) * 2.0;
    const auto jitter = [&]
    { return static_cast<std::int32_t>(random.Below(1 + static_cast<std::uint64_t>(scale) / 8)); };
    patch.Points[p] = { x * scale + jitter(), y * scale + jitter(), static_cast<std::int32_t>(z) + jitter() };
    if (p >= shared)
    {
      for (std::int32_t& k : patch.Points[p])
      {
        k = (k >> shift) * (1 << shift);
      }
    }
    else
    {
      patch.Ids.push_back((random.Below(3) << 58) | (random.Below(4) << 32) | random.Below(100000));
    }
  }
  const auto wedgesOf = [&](std::uint32_t p)
  { return seam > 0 && static_cast<int>(p) % across % seam == seam - 1 ? 2u : 1u; };
  std::vector<std::uint32_t> firstWedge;
  for (std::uint32_t p = 0; p < patch.Points.size(); ++p)
  {
    firstWedge.push_back(static_cast<std::uint32_t>(patch.WedgePoints.size()));
    patch.WedgePoints.insert(patch.WedgePoints.end(), wedgesOf(p), p);
  }
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      const auto left = [&](std::uint32_t p) { return firstWedge[p] + wedgesOf(p) - 1; };
      const auto a = static_cast<std::uint32_t>(y * across + x);
      const std::uint32_t c = a + static_cast<std::uint32_t>(across);
      patch.Triangles.push_back({ left(a), firstWedge[a + 1], firstWedge[c + 1] });
      patch.Triangles.push_back({ left(a), firstWedge[c + 1], left(c) });
    }
  }
  for (std::size_t i = patch.Triangles.size(); i > 1; --i)
  {
    std::swap(patch.Triangles[i - 1], patch.Triangles[random.Below(i)]);
  }
  if (seam == 0)
  {
    patch.WedgePoints.clear();
  }
  return patch;
}

void AddColumns(Random& random, const std::vector<vtkMTArrayInfo>& arrays, vtkMTPatch& patch)
{
  for (const vtkMTArrayInfo& info : arrays)
  {
    const bool ofPoints = info.Association == vtkMTArrayInfo::Point;
    vtkMTColumn column((ofPoints ? patch.GetNumberOfWedges() : patch.Triangles.size()) * info.GetTupleSize());
    const std::uint64_t limit = random.Below(2) ? 256 : 3;
    for (unsigned char& byte : column)
    {
      byte = static_cast<unsigned char>(random.Below(limit));
    }
    (ofPoints ? patch.PointColumns : patch.CellColumns).push_back(std::move(column));
  }
}

vtkMTGraph MakeGraph(const vtkMTPatch& patch, const std::vector<vtkMTArrayInfo>& arrays)
{
  vtkMTGraph graph;
  graph.Arrays = arrays;
  graph.Nodes.resize(2);
  graph.Arcs.resize(1);
  graph.Arcs[0].To = 1;
  MTTestModel::FillRecord(patch, graph.Lattice, graph.Arcs[0]);
  graph.Index();
  return graph;
}

Bytes Store(const vtkMTPatch& patch, const vtkMTGraph& graph, vtkMTFileSink::CompressionType compression)
{
  Folder folder;
  vtkMTFileSink sink(folder / "model.bmt", compression);
  EXPECT_TRUE(sink.Begin(graph.Arrays) && sink.WritePatch(vtkMTPatch(patch)) && sink.Finish(graph, { 0 }))
    << sink.GetError();
  return ReadFile(folder / "model.bmt");
}

// The patch as a file gives it back, and how many bytes it takes there.
vtkMTPatch StoreAndRead(
  const vtkMTPatch& patch, const vtkMTGraph& graph, vtkMTFileSink::CompressionType compression, std::uint64_t& size)
{
  vtkMTFileSource source;
  std::string error;
  vtkMTPatch result;
  EXPECT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(Store(patch, graph, compression)), error) &&
    source.ReadPatch(0, nullptr, result, error))
    << error;
  size = source.GetPatchSize(0);
  return result;
}

constexpr vtkMTFileSink::CompressionType Compressions[] = { vtkMTFileSink::None, vtkMTFileSink::Fast,
  vtkMTFileSink::Small };

// What a triangle is, whatever the order: its corners' places and ids and all values, turned so that the least comes
// first.
std::vector<std::vector<unsigned char>> Describe(const vtkMTPatch& patch, const std::vector<vtkMTArrayInfo>& arrays)
{
  std::vector<std::vector<unsigned char>> result;
  for (std::size_t t = 0; t < patch.Triangles.size(); ++t)
  {
    std::array<std::vector<unsigned char>, 3> corners;
    std::vector<unsigned char> values;
    for (int c = 0; c < 3; ++c)
    {
      const std::uint32_t w = patch.Triangles[t][c];
      const std::uint32_t p = patch.GetPointOfWedge(w);
      const std::uint64_t id = p < patch.Ids.size() ? patch.Ids[p] : ~std::uint64_t(0);
      const auto put = [&corners, c](const void* data, std::size_t size)
      {
        const auto* bytes = static_cast<const unsigned char*>(data);
        corners[c].insert(corners[c].end(), bytes, bytes + size);
      };
      put(patch.Points[p].data(), sizeof(patch.Points[p]));
      put(&id, sizeof(id));
      std::size_t column = 0;
      for (const vtkMTArrayInfo& info : arrays)
      {
        if (info.Association == vtkMTArrayInfo::Point)
        {
          put(patch.PointColumns[column++].data() + w * info.GetTupleSize(), info.GetTupleSize());
        }
      }
    }
    std::size_t column = 0;
    for (const vtkMTArrayInfo& info : arrays)
    {
      if (info.Association == vtkMTArrayInfo::Cell)
      {
        const unsigned char* value = patch.CellColumns[column++].data() + t * info.GetTupleSize();
        values.insert(values.end(), value, value + info.GetTupleSize());
      }
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    for (const auto& corner : corners)
    {
      values.insert(values.end(), corner.begin(), corner.end());
    }
    result.push_back(std::move(values));
  }
  std::sort(result.begin(), result.end());
  return result;
}
}

// Against a description that knows nothing of any order.
TEST(Codec, EveryTriangleComesBackWithAllThatBelongsToIt)
{
  const std::vector<vtkMTArrayInfo> arrays = { MakeInfo(VTK_FLOAT, 3, vtkMTArrayInfo::Point),
    MakeInfo(VTK_UNSIGNED_CHAR, 4, vtkMTArrayInfo::Point), MakeInfo(VTK_ID_TYPE, 1, vtkMTArrayInfo::Cell),
    MakeInfo(VTK_SHORT, 2, vtkMTArrayInfo::Cell), MakeInfo(VTK_DOUBLE, 1, vtkMTArrayInfo::Point) };
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    Random random(seed);
    vtkMTPatch patch = MakeField(random, 2 + static_cast<int>(random.Below(20)), static_cast<int>(random.Below(5)),
      static_cast<unsigned>(random.Below(8)), 1 + static_cast<std::int32_t>(random.Below(100000)));
    if (seed % 4 == 0) // the same triangle twice, a turned one, and one the other way round
    {
      const vtkMTTriangle t = patch.Triangles[1];
      patch.Triangles.insert(patch.Triangles.end(), { t, { t[1], t[2], t[0] }, { t[1], t[0], t[2] } });
    }
    AddColumns(random, arrays, patch);
    const vtkMTGraph graph = MakeGraph(patch, arrays);
    for (const auto compression : Compressions)
    {
      std::uint64_t size = 0;
      const vtkMTPatch read = StoreAndRead(patch, graph, compression, size);
      EXPECT_EQ(Describe(patch, arrays), Describe(read, arrays)) << "seed " << seed;
      EXPECT_EQ(read.Ids.size(), patch.Ids.size());
      EXPECT_TRUE(read.WedgePoints.empty() || std::is_sorted(read.WedgePoints.begin(), read.WedgePoints.end()));
    }
  }
}

TEST(Codec, PointsOfNoTriangleAndPatchesOfNothingAreKept)
{
  vtkMTPatch patch;
  patch.Points = { { 5, 5, 5 }, { -2147483647 - 1, 0, 2147483647 }, { 1, 2, 3 } };
  patch.Ids = { 7 };
  for (const auto compression : Compressions)
  {
    std::uint64_t size = 0;
    const vtkMTPatch read = StoreAndRead(patch, MakeGraph(patch, {}), compression, size);
    EXPECT_EQ(read.Points, patch.Points);
    EXPECT_EQ(read.Ids, patch.Ids);
    EXPECT_TRUE(StoreAndRead(vtkMTPatch(), MakeGraph(vtkMTPatch(), {}), compression, size).Points.empty());
  }
}

TEST(Codec, AllVtkTypesKeepAllBits)
{
  std::vector<vtkMTArrayInfo> arrays;
  for (int type :
    { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG,
      VTK_UNSIGNED_LONG, VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG })
  {
    arrays.push_back(MakeInfo(type, 1 + type % 3, type % 2 ? vtkMTArrayInfo::Point : vtkMTArrayInfo::Cell));
  }
  Random random(9);
  vtkMTPatch patch = MakeField(random, 9, 3, 0, 1000);
  AddColumns(random, arrays, patch);
  const vtkMTPatch expected = vtkMTPatchOrder::Make(patch).Patch;
  for (const auto compression : Compressions)
  {
    std::uint64_t size = 0;
    const vtkMTPatch read = StoreAndRead(patch, MakeGraph(patch, arrays), compression, size);
    EXPECT_EQ(read.PointColumns, expected.PointColumns);
    EXPECT_EQ(read.CellColumns, expected.CellColumns);
  }
}

TEST(Codec, MadeNormalsComeBackWithinSixHundredthsOfADegreeAndEqualOnesStayEqual)
{
  vtkMTArrayInfo info = MakeInfo(VTK_FLOAT, 3, vtkMTArrayInfo::Point);
  info.Role = vtkMTArrayInfo::MadeNormals;
  Random random(4);
  vtkMTPatch patch = MakeField(random, 40, 0, 0, 100);
  std::vector<std::array<float, 3>> normals(patch.Points.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    double n[3] = { random.Uniform() - 0.5, random.Uniform() - 0.5, random.Uniform() - 0.5 };
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    normals[i] = { static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
      static_cast<float>(n[2] / length) };
  }
  normals[0] = { 0.0f, 0.0f, 0.0f };
  normals[1] = normals[2] = { 0.0f, 0.0f, -1.0f };
  normals[3] = { 1.0f, 0.0f, 0.0f };
  patch.PointColumns.emplace_back(normals.size() * sizeof(normals[0]));
  std::memcpy(patch.PointColumns[0].data(), normals.data(), patch.PointColumns[0].size());
  const vtkMTPatch expected = vtkMTPatchOrder::Make(patch).Patch;
  std::uint64_t size = 0;
  const vtkMTPatch read = StoreAndRead(patch, MakeGraph(patch, { info }), vtkMTFileSink::Fast, size);
  ASSERT_EQ(read.PointColumns[0].size(), expected.PointColumns[0].size());
  double worst = 0.0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    float a[3];
    float b[3];
    std::memcpy(a, expected.PointColumns[0].data() + i * sizeof(a), sizeof(a));
    std::memcpy(b, read.PointColumns[0].data() + i * sizeof(b), sizeof(b));
    if (a[0] == 0.0f && a[1] == 0.0f && a[2] == 0.0f)
    {
      EXPECT_TRUE(b[0] == 0.0f && b[1] == 0.0f && b[2] == 0.0f);
      continue;
    }
    const double cross[3] = { double(a[1]) * b[2] - double(a[2]) * b[1], double(a[2]) * b[0] - double(a[0]) * b[2],
      double(a[0]) * b[1] - double(a[1]) * b[0] };
    worst = std::max(worst, std::sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]));
    EXPECT_GT(a[0] * b[0] + a[1] * b[1] + a[2] * b[2], 0.0f);
  }
  std::cout << "largest angle " << worst * 57.29578 << " degrees\n";
  EXPECT_LT(worst, 0.06 / 57.29578);
}

TEST(Codec, PackedPatchesAreSmallAndCoarseOnesSmaller)
{
  Random random(1);
  std::array<std::uint64_t, 3> bytes{};
  std::uint64_t coarse = 0;
  const vtkMTPatch patch = MakeField(random, 24, 0, 0, 20000);
  const vtkMTPatch coarsePatch = MakeField(random, 24, 0, 10, 20000);
  for (std::size_t i = 0; i < 3; ++i)
  {
    StoreAndRead(patch, MakeGraph(patch, {}), Compressions[i], bytes[i]);
  }
  StoreAndRead(coarsePatch, MakeGraph(coarsePatch, {}), vtkMTFileSink::Fast, coarse);
  const auto perTriangle = [&](std::uint64_t size)
  { return static_cast<double>(size) / static_cast<double>(patch.Triangles.size()); };
  std::cout << patch.Triangles.size() << " triangles, bytes each: none " << perTriangle(bytes[0]) << ", fast "
            << perTriangle(bytes[1]) << ", small " << perTriangle(bytes[2]) << ", fast with coarse points "
            << perTriangle(coarse) << "\n";
  EXPECT_LT(bytes[1], bytes[0] / 2);
  EXPECT_LE(bytes[2], bytes[1]);
  EXPECT_LT(coarse, bytes[1] * 9 / 10);
}

TEST(Codec, IdentitiesThatFollowEachOtherAlongTheBorderCostNearlyNothing)
{
  Random random(8);
  const int n = 30;
  vtkMTPatch field = MakeField(random, n, 0, 0, 1000);
  // The border first, along it, then what is inside.
  std::vector<std::uint32_t> order;
  for (int i = 0; i < 4 * n; ++i)
  {
    const int along = i % n;
    const int sides[4][2] = { { along, 0 }, { n, along }, { n - along, n }, { 0, n - along } };
    order.push_back(static_cast<std::uint32_t>(sides[i / n][1] * (n + 1) + sides[i / n][0]));
  }
  std::vector<std::uint32_t> place(field.Points.size(), ~std::uint32_t(0));
  for (std::uint32_t p = 0; p < order.size(); ++p)
  {
    place[order[p]] = p;
  }
  for (std::uint32_t p = 0; p < place.size(); ++p)
  {
    if (place[p] == ~std::uint32_t(0))
    {
      place[p] = static_cast<std::uint32_t>(order.size());
      order.push_back(p);
    }
  }
  vtkMTPatch patch;
  for (const std::uint32_t p : order)
  {
    patch.Points.push_back(field.Points[p]);
  }
  for (const vtkMTTriangle& t : field.Triangles)
  {
    patch.Triangles.push_back({ place[t[0]], place[t[1]], place[t[2]] });
  }
  std::uint64_t size[3] = {};
  StoreAndRead(patch, MakeGraph(patch, {}), vtkMTFileSink::Fast, size[0]);
  for (const bool isRandom : { false, true })
  {
    patch.Ids.clear();
    for (std::uint64_t i = 0; i < 4 * n; ++i)
    {
      const std::uint64_t piece = i / 40; // of three neighbours; one of them goes round the other way
      patch.Ids.push_back(isRandom ? random.Next() : (piece << 40) + (piece == 1 ? 90000 - i : 500 + i));
    }
    const vtkMTPatch read = StoreAndRead(patch, MakeGraph(patch, {}), vtkMTFileSink::Fast, size[isRandom ? 2 : 1]);
    EXPECT_EQ(std::set<std::uint64_t>(read.Ids.begin(), read.Ids.end()),
      std::set<std::uint64_t>(patch.Ids.begin(), patch.Ids.end()));
  }
  std::cout << 4 * n << " shared points, bytes for their identities: " << size[1] - size[0] << " in runs, "
            << size[2] - size[0] << " at random\n";
  EXPECT_LT(size[1] - size[0], 64u);
}

TEST(Codec, ResidualsOfExactPointsAreSmallAndReadOnlyWhenAskedFor)
{
  const vtkMTArrayInfo info = vtkMTExactPoints::MakeInfo(false, {});
  Random random(3);
  vtkMTPatch patch = MakeField(random, 40, 0, 0, 1000);
  std::vector<std::int64_t> residuals(3 * patch.Points.size());
  for (std::int64_t& residual : residuals)
  {
    residual = static_cast<std::int64_t>(random.Below(200)) - 100;
  }
  patch.PointColumns.emplace_back(residuals.size() * sizeof(residuals[0]));
  std::memcpy(patch.PointColumns[0].data(), residuals.data(), patch.PointColumns[0].size());
  const vtkMTPatch expected = vtkMTPatchOrder::Make(patch).Patch;
  const vtkMTGraph graph = MakeGraph(patch, { info });
  for (const auto compression : Compressions)
  {
    vtkMTFileSource source;
    std::string error;
    vtkMTPatch read;
    ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(Store(patch, graph, compression)), error));
    ASSERT_TRUE(source.ReadPatch(0, nullptr, read, error)) << error;
    EXPECT_EQ(read.PointColumns, expected.PointColumns);
    const std::vector<unsigned char> none(1, 0);
    ASSERT_TRUE(source.ReadPatch(0, &none, read, error)) << error;
    EXPECT_TRUE(read.PointColumns[0].empty());
    const double bytes = static_cast<double>(source.GetSizeByKind()[1]) / static_cast<double>(residuals.size());
    std::cout << bytes << " bytes for a residual of 7.6 bits\n";
    EXPECT_LT(bytes, compression == vtkMTFileSink::None ? 8.1 : 1.1);
  }
  patch.PointColumns[0].clear();
  std::uint64_t size = 0;
  EXPECT_TRUE(StoreAndRead(patch, graph, vtkMTFileSink::Fast, size).PointColumns[0].empty());
}

TEST(Codec, BlobsComeBackAndAreCheckedAsEverythingElse)
{
  Folder folder;
  Random random(2);
  const vtkMTPatch patch = MakeField(random, 5, 0, 0, 10);
  vtkMTGraph graph = MakeGraph(patch, {});
  std::vector<Bytes> blobs = { Bytes(1000, 7), Bytes(), Bytes(17, 1) };
  for (std::size_t i = 0; i < blobs.size(); ++i)
  {
    graph.Blobs.push_back({ "picture " + std::to_string(i), "image/png", { { "texture_coordinates", "TCoords" } } });
  }
  vtkMTFileSink sink(folder / "model.bmt");
  ASSERT_TRUE(sink.Begin({}) && sink.WriteBlob(Bytes(blobs[0])) && sink.WritePatch(vtkMTPatch(patch)) &&
    sink.WriteBlob(Bytes(blobs[1])) && sink.WriteBlob(Bytes(blobs[2])) && sink.Finish(graph, { 0 }))
    << sink.GetError();
  Bytes bytes = ReadFile(folder / "model.bmt");
  vtkMTFileSource source;
  std::string error;
  ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(Bytes(bytes)), error)) << error;
  ASSERT_EQ(source.GetGraph().Blobs.size(), blobs.size());
  for (std::uint32_t i = 0; i < blobs.size(); ++i)
  {
    EXPECT_EQ(source.GetGraph().Blobs[i].Name, graph.Blobs[i].Name);
    EXPECT_EQ(source.GetGraph().Blobs[i].Properties, graph.Blobs[i].Properties);
    Bytes read;
    ASSERT_TRUE(source.ReadBlob(i, read, error)) << error;
    EXPECT_EQ(read, blobs[i]);
  }
  Bytes none;
  EXPECT_FALSE(source.ReadBlob(3, none, error));
  bytes[bytes.size() - 20] ^= 1;
  ASSERT_TRUE(source.Open(std::make_shared<vtkMTMemoryByteSource>(Bytes(bytes)), error)) << error;
  EXPECT_FALSE(source.ReadBlob(2, none, error));
  EXPECT_NE(error.find("blob 2"), std::string::npos) << error;

  vtkMTFileSink forgetful(folder / "other.bmt");
  EXPECT_FALSE(forgetful.Begin({}) && forgetful.WritePatch(vtkMTPatch(patch)) && forgetful.Finish(graph, { 0 }));
  EXPECT_NE(forgetful.GetError().find("blobs"), std::string::npos);
}

// What Documentation/file-format.md says suffices to write a reader: one in Python shares no code with this one.
TEST(Codec, AReaderWrittenFromTheTablesReadsTheSame)
{
  Folder folder;
  Random random(12);
  vtkMTArrayInfo normals = MakeInfo(VTK_FLOAT, 3, vtkMTArrayInfo::Point);
  normals.Name = "normals";
  normals.Role = vtkMTArrayInfo::MadeNormals;
  const std::vector<vtkMTArrayInfo> arrays = { normals, MakeInfo(VTK_FLOAT, 3, vtkMTArrayInfo::Point),
    MakeInfo(VTK_UNSIGNED_CHAR, 4, vtkMTArrayInfo::Point), MakeInfo(VTK_ID_TYPE, 1, vtkMTArrayInfo::Cell),
    MakeInfo(VTK_SHORT, 2, vtkMTArrayInfo::Cell), vtkMTExactPoints::MakeInfo(true, {}) };
  for (int round = 0; round < 12; ++round)
  {
    vtkMTPatch patch = MakeField(random, 2 + round, round % 4, static_cast<unsigned>(round), 1 + round * 5000);
    if (round % 3 == 0) // a part of it alone, with holes and points of no triangle
    {
      patch.Triangles.resize(patch.Triangles.size() / 2);
    }
    AddColumns(random, arrays, patch);
    for (std::size_t w = 0; w < patch.GetNumberOfWedges(); ++w) // smooth ones, where random bytes would not be packed
    {
      const float x = 0.01f * static_cast<float>(w % 50) + 0.003f * static_cast<float>(random.Below(round + 1));
      const std::array<float, 3> normal = { x, 0.1f, std::sqrt(0.99f - x * x) };
      std::memcpy(patch.PointColumns[0].data() + w * sizeof(normal), normal.data(), sizeof(normal));
    }
    if (round % 2 == 0) // as on all levels but the finest
    {
      patch.PointColumns.back().clear();
    }
    vtkMTGraph graph = MakeGraph(patch, arrays);
    graph.Blobs.push_back({ "a picture", "image/png", {} });
    const std::string path = folder / "model.bmt";
    vtkMTFileSink sink(path, Compressions[round % 3]);
    ASSERT_TRUE(sink.Begin(arrays) && sink.WritePatch(vtkMTPatch(patch)) && sink.WriteBlob(Bytes(5, 9)) &&
      sink.Finish(graph, { 0 }));
    const std::string command = std::string("python3 ") + MT_SOURCE_DIRECTORY + "/Testing/IO/read_model.py " + path +
      " " + (folder / "dump") + " > " + (folder / "log") + " 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0)
      << std::string(reinterpret_cast<const char*>(ReadFile(folder / "log").data()), ReadFile(folder / "log").size());
    vtkMTFileSource source;
    std::string error;
    vtkMTPatch read;
    ASSERT_TRUE(source.Open(path, error) && source.ReadPatch(0, nullptr, read, error)) << error;
    Bytes expected;
    const auto put = [&expected](const void* data, std::size_t size)
    {
      const auto* bytes = static_cast<const unsigned char*>(data);
      expected.insert(expected.end(), bytes, bytes + size);
    };
    const std::uint32_t counts[4] = { static_cast<std::uint32_t>(read.Points.size()),
      static_cast<std::uint32_t>(read.Ids.size()), static_cast<std::uint32_t>(read.WedgePoints.size()),
      static_cast<std::uint32_t>(read.Triangles.size()) };
    put(counts, sizeof(counts));
    put(read.Points.data(), read.Points.size() * sizeof(vtkMTPoint));
    put(read.Ids.data(), read.Ids.size() * sizeof(std::uint64_t));
    put(read.WedgePoints.data(), read.WedgePoints.size() * sizeof(std::uint32_t));
    put(read.Triangles.data(), read.Triangles.size() * sizeof(vtkMTTriangle));
    std::size_t next[2] = { 0, 0 };
    for (const vtkMTArrayInfo& info : arrays)
    {
      const vtkMTColumn& column =
        info.Association == vtkMTArrayInfo::Point ? read.PointColumns[next[0]++] : read.CellColumns[next[1]++];
      put(column.data(), column.size());
    }
    put("\t\t\t\t\t", 5);
    EXPECT_TRUE(ReadFile(folder / "dump") == expected) << "round " << round;
  }
}
