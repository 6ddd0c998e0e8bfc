// SPDX-License-Identifier: BSD-3-Clause
// What `bmt build` puts into a file and leaves out of it.
#include "MTRunBmt.h"

#include "vtkMTFileSource.h"

#include <iostream>
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
