// SPDX-License-Identifier: BSD-3-Clause
// What `bmt build` puts into a file and leaves out of it.
#include "MTRunBmt.h"

#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"

#include <filesystem>
#include <iostream>
#include <map>
#include <set>

class BuildOptions : public MTBmtTest
{
protected:
  std::set<std::string> Build(const std::string& input, const std::vector<std::string>& options) const
  {
    std::vector<std::string> call = { "build", this->Path(input), "-o", this->Path("out.bmt") };
    call.insert(call.end(), options.begin(), options.end());
    const nlohmann::json built = this->BmtJson(call);
    std::set<std::string> names;
    for (const auto& array : built["arrays"])
    {
      names.insert(array["name"].get<std::string>());
    }
    return names;
  }

  // A square with texture coordinates, a colour and a quality, and an image that it refers to.
  void WriteSquare() const
  {
    this->WriteFile("square.ply",
      "ply\nformat ascii 1.0\ncomment TextureFile leaves.png\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nproperty float s\nproperty float t\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 255 0 0\n1 0 0 1 0 0 255 0\n1 1 0 1 1 0 0 255\n0 1 0 0 1 9 9 9\n3 0 1 2\n3 0 2 3\n");
    this->WriteFile("leaves.png", Picture);
  }

  static const std::string Picture;
};

const std::string BuildOptions::Picture = std::string("\x89PNG\r\n\x1a\n") + std::string(300, 'x');

TEST_F(BuildOptions, TexturesAreCarriedByteForByte)
{
  this->WriteSquare();
  this->Build("square.ply", {});
  const nlohmann::json info = this->BmtJson({ "info", this->Path("out.bmt") });
  ASSERT_EQ(info["blobs"].size(), 1u) << info.dump(2);
  EXPECT_EQ(info["blobs"][0]["name"], "leaves.png");
  EXPECT_EQ(info["blobs"][0]["type"], "image/png");
  EXPECT_EQ(info["blobs"][0]["coordinates"], "TCoords");
  vtkMTFileSource source;
  std::string error;
  std::vector<unsigned char> bytes;
  ASSERT_TRUE(source.Open(this->Path("out.bmt"), error) && source.ReadBlob(0, bytes, error)) << error;
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), Picture);
  EXPECT_EQ(this->Bmt({ "verify", this->Path("out.bmt"), "--input", this->Path("square.ply") }).Exit, 0);
}

TEST_F(BuildOptions, ADamagedTextureIsNamedByVerify)
{
  this->WriteSquare();
  this->Build("square.ply", {});
  std::string bytes = this->ReadFile("out.bmt");
  bytes[bytes.size() - 30] ^= 1; // the blob comes last
  this->WriteFile("out.bmt", bytes);
  const MTRun run = this->Bmt({ "verify", this->Path("out.bmt") });
  EXPECT_NE(run.Exit, 0);
  EXPECT_NE((run.Out + run.Err).find("blob 0"), std::string::npos) << run.Out << run.Err;
}

TEST_F(BuildOptions, OnlyTheNamedArraysAreKept)
{
  this->WriteSquare();
  const std::set<std::string> all = this->Build("square.ply", { "--no-normals" });
  EXPECT_EQ(all.size(), 3u); // texture coordinates, colours, input cell ids
  EXPECT_EQ(this->Build("square.ply", { "--no-normals", "--no-ids", "--arrays", "TCoords" }),
    (std::set<std::string>{ "TCoords" }));
  EXPECT_EQ(this->Build("square.ply", { "--no-normals", "--arrays", "TCoords" }).count("vtkMTInputCellIds"), 1u);
  const MTRun run =
    this->Bmt({ "build", this->Path("square.ply"), "-o", this->Path("other.bmt"), "--arrays", "TCoords,Wrong" });
  EXPECT_NE(run.Exit, 0);
  EXPECT_NE(run.Err.find("\"Wrong\""), std::string::npos) << run.Err;
}

TEST_F(BuildOptions, IdsOfTheFinestLevelTakeLessThanHalfOfThoseOfAllLevels)
{
  this->MakeSphere(20480);
  std::map<std::string, double> bytes;
  std::map<std::string, double> ofIds;
  for (const std::string which : { "none", "finest", "all", "points" })
  {
    const bool ofPoints = which == "points";
    this->Build(
      "sphere.ply", ofPoints ? std::vector<std::string>{ "--point-ids" } : std::vector<std::string>{ "--ids", which });
    const nlohmann::json info = this->BmtJson({ "info", this->Path("out.bmt") });
    bytes[which] = info["bytes_per_triangle"];
    for (const char* name : { "vtkMTInputCellIds", "vtkMTInputPointIds" })
    {
      ofIds[which] += info["bytes_of"].value(name, 0.0) / info["triangles"].get<double>();
    }
    std::cout << which << ": " << bytes[which] << " bytes per triangle, " << ofIds[which] << " for ids\n";
    EXPECT_EQ(this->Bmt({ "verify", this->Path("out.bmt"), "--input", this->Path("sphere.ply") }).Exit, 0);
  }
  EXPECT_EQ(ofIds["none"], 0.0);
  EXPECT_LT(ofIds["finest"], 0.5 * ofIds["all"]);
  EXPECT_GT(ofIds["points"], ofIds["finest"]);
  EXPECT_NEAR(bytes["all"] - bytes["finest"], ofIds["all"] - ofIds["finest"], 0.1); // and the sections' records
  EXPECT_NE(this->Bmt({ "build", this->Path("sphere.ply"), "-o", this->Path("other.bmt"), "--ids", "some" }).Exit, 0);
}

TEST_F(BuildOptions, NoPointMovesByMoreThanThePrecision)
{
  this->MakeSphere(5120);
  for (const double precision : { 1e-2, 1e-4, 1e-6, 1e-8 })
  {
    this->Build("sphere.ply", { "--precision", std::to_string(precision * 1e9) + "e-9" });
    const nlohmann::json info = this->BmtJson({ "info", this->Path("out.bmt") });
    const double shift = info["largest_shift"];
    std::cout << "precision " << precision << ": largest shift " << shift << ", " << info["bytes_per_triangle"]
              << " bytes per triangle\n";
    EXPECT_LE(shift, precision);
    EXPECT_EQ(this->Bmt({ "verify", this->Path("out.bmt"), "--input", this->Path("sphere.ply") }).Exit, 0);
  }
  const MTRun run =
    this->Bmt({ "build", this->Path("sphere.ply"), "-o", this->Path("other.bmt"), "--precision", "1e-30" });
  EXPECT_NE(run.Exit, 0);
  EXPECT_NE(run.Err.find("the least is"), std::string::npos) << run.Err;
}

TEST_F(BuildOptions, EveryCompressionHoldsTheSameModel)
{
  this->MakeSphere(20480);
  std::vector<double> bytes;
  for (const char* compression : { "none", "fast", "small" })
  {
    this->Build("sphere.ply", { "--compression", compression });
    const nlohmann::json info = this->BmtJson({ "info", this->Path("out.bmt") });
    bytes.push_back(info["bytes_per_triangle"]);
    std::cout << compression << ": " << bytes.back() << " bytes per triangle, of which geometry "
              << info["bytes_of"]["geometry"].get<double>() / info["triangles"].get<double>() << "\n";
    EXPECT_EQ(this->Bmt({ "verify", this->Path("out.bmt"), "--input", this->Path("sphere.ply") }).Exit, 0);
  }
  EXPECT_LT(bytes[1], 0.5 * bytes[0]);
  EXPECT_LE(bytes[2], bytes[1]);
}

TEST_F(BuildOptions, BlobsAreExtractedIntoTheFolderAndNowhereElse)
{
  this->WriteSquare();
  this->Build("square.ply", {});
  std::filesystem::create_directory(this->Path("blobs"));
  nlohmann::json out = this->BmtJson({ "extract", this->Path("out.bmt"), "--blobs", this->Path("blobs") });
  ASSERT_EQ(out["blobs"].size(), 1u);
  EXPECT_EQ(out["blobs"][0]["file"], this->Path("blobs") + "/leaves.png");
  EXPECT_EQ(this->ReadFile("blobs/leaves.png"), Picture);
  out = this->BmtJson({ "extract", this->Path("out.bmt"), "--blobs", this->Path("blobs"), "--level", "0", "-o",
    this->Path("finest.ply") });
  EXPECT_EQ(out["triangles"], 2);
  EXPECT_NE(this->Bmt({ "extract", this->Path("out.bmt"), "--blobs", this->Path("nowhere") }).Exit, 0);
  EXPECT_NE(this->Bmt({ "extract", this->Path("out.bmt"), "--level", "0" }).Exit, 0);
  EXPECT_NE(this->Bmt({ "extract", this->Path("out.bmt"), "-o", this->Path("finest.ply") }).Exit, 0);

  // Names as a hostile file has them.
  vtkMTFileSink sink(this->Path("hostile.bmt"));
  vtkMTGraph graph;
  graph.Nodes.resize(2);
  const char* const names[] = { "../../up.png", "/etc/absolute.png", "..", "", "a/b\\c.png", "c.png", ".hidden",
    "new\nline" };
  ASSERT_TRUE(sink.Begin({})) << sink.GetError();
  for (const char* name : names)
  {
    graph.Blobs.push_back({ name, "image/png", {} });
    ASSERT_TRUE(sink.WriteBlob({ 1, 2, 3 })) << sink.GetError();
  }
  ASSERT_TRUE(sink.Finish(graph, {})) << sink.GetError();
  std::filesystem::create_directory(this->Path("hostile"));
  out = this->BmtJson({ "extract", this->Path("hostile.bmt"), "--blobs", this->Path("hostile") });
  std::set<std::string> written;
  for (const auto& entry : std::filesystem::directory_iterator(this->Path("hostile")))
  {
    written.insert(entry.path().filename().string());
  }
  EXPECT_EQ(written,
    (std::set<std::string>{
      "up.png", "absolute.png", "blob..", "blob", "c.png", "c-2.png", "blob.hidden", "new_line" }));
}

TEST_F(BuildOptions, ExactKeepsTheInputsCoordinates)
{
  this->MakeSphere(20480);
  this->Build("sphere.ply", { "--lattice-bits", "14", "--exact" });
  EXPECT_EQ(this->Bmt({ "verify", this->Path("out.bmt"), "--input", this->Path("sphere.ply") }).Exit, 0);
  const nlohmann::json info = this->BmtJson({ "info", this->Path("out.bmt") });
  std::cout << info["bytes_of"]["vtkMTExactPoints"].get<double>() / info["triangles"].get<double>()
            << " bytes per triangle for residuals\n";
  const nlohmann::json finest =
    this->BmtJson({ "extract", this->Path("out.bmt"), "--level", "0", "-o", this->Path("finest.ply") });
  EXPECT_EQ(finest["error"], 0.0);
  EXPECT_EQ(finest["exact"], true);
  const nlohmann::json coarser =
    this->BmtJson({ "extract", this->Path("out.bmt"), "--level", "1", "-o", this->Path("coarser.ply") });
  EXPECT_EQ(coarser["exact"], false);
  EXPECT_GE(coarser["error"], info["largest_shift"]);
  // Building from it again on a finer lattice finds nothing that the first lattice has left.
  this->Build("finest.ply", { "--lattice-bits", "31" });
  EXPECT_EQ(this->Bmt({ "verify", this->Path("out.bmt"), "--input", this->Path("sphere.ply") }).Exit, 0);
}
