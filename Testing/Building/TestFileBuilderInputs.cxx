// SPDX-License-Identifier: BSD-3-Clause
// What vtkMultiTriangulationFileBuilder takes, and what comes of it: parts, volumes, terrain, models, arrays, textures.
#include "MTFileBuilderTest.h"

#include "vtkMTBuildError.h"
#include "vtkMTBuildInput.h"
#include "vtkMTFileBuildReport.h"
#include "vtkMTFileSource.h"
#include "vtkMTPatch.h"
#include "vtkMTScratchStore.h"
#include "vtkMTTriangleStream.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationReader.h"
#include "vtkMultiTriangulationWriter.h"

#include "vtkPolyData.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <set>

class FileBuilderInputs : public MTFileBuilderTest
{
protected:
  // Builds, and opens what was made.
  void Build(vtkMultiTriangulationFileBuilder* builder)
  {
    builder->SetOutputFileName((this->Folder / "out.bmt").c_str());
    std::string error;
    ASSERT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
    ASSERT_TRUE(this->Model.Open(this->Folder / "out.bmt", error)) << error;
  }

  std::set<std::string> GetArrays() const
  {
    std::set<std::string> names;
    for (const vtkMTArrayInfo& array : this->Model.GetGraph().Arrays)
    {
      names.insert(array.Name);
    }
    return names;
  }

  // A square with texture coordinates, colours and an image that it refers to.
  void WriteSquare() const
  {
    MTIOTest::WriteFile(this->Folder / "square.ply",
      std::string(
        "ply\nformat ascii 1.0\ncomment TextureFile leaves.png\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nproperty float s\nproperty float t\nproperty uchar red\nproperty uchar green\n"
        "property uchar blue\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 0 0 255 0 0\n1 0 0 1 0 0 255 0\n1 1 0 1 1 0 0 255\n0 1 0 0 1 9 9 9\n3 0 1 2\n3 0 2 3\n"));
    MTIOTest::WriteFile(this->Folder / "leaves.png", std::string("\x89PNG\r\n\x1a\n") + std::string(300, 'x'));
  }

  // Squared distances from the middle of 20 by 20 by 20 samples.
  // A block: flat sides and hard edges.
  void WriteBlock() const
  {
    std::string text = "# vtk DataFile Version 3.0\nblock\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 20 20 20\n"
                       "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 8000\nSCALARS values float 1\nLOOKUP_TABLE default\n";
    for (int i = 0; i < 8000; ++i)
    {
      const auto isInside = [](int x) { return x >= 5 && x < 15; };
      text += isInside(i % 20) && isInside(i / 20 % 20) && isInside(i / 400) ? "1\n" : "0\n";
    }
    MTIOTest::WriteFile(this->Folder / "block.vtk", text);
  }

  void WriteVolume() const
  {
    std::string text = "# vtk DataFile Version 3.0\nvolume\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 20 20 20\n"
                       "ORIGIN 0 0 0\nSPACING 1 1 1\nPOINT_DATA 8000\nSCALARS values float 1\nLOOKUP_TABLE default\n";
    for (int i = 0; i < 8000; ++i)
    {
      const int x = i % 20 - 10;
      const int y = i / 20 % 20 - 10;
      const int z = i / 400 - 10;
      text += std::to_string(x * x + y * y + z * z) + "\n";
    }
    MTIOTest::WriteFile(this->Folder / "volume.vtk", text);
  }

  void WriteLabels(int n) const;
  std::set<double> GetValues(const std::string& name) const;

  vtkMTFileSource Model;
};

TEST_F(FileBuilderInputs, ModelIsTakenAtThePlaceOfItsFrame)
{
  this->MakeSphere(1280);
  {
    const vtkNew<vtkMultiTriangulationFileBuilder> builder;
    builder->AddFileName((this->Folder / "sphere.ply").c_str());
    this->Build(builder);
  }
  double before[6];
  this->Model.GetGraph().GetBounds(before);
  const vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName((this->Folder / "out.bmt").c_str());
  const vtkNew<vtkMultiTriangulation> moved;
  reader->Update();
  moved->ShallowCopy(reader->GetOutput());
  const double frame[16] = { -2, 0, 0, 10, 0, 2, 0, 0, 0, 0, 2, -5, 0, 0, 0, 1 };
  ASSERT_TRUE(moved->ApplyTransform(frame));
  const vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputData(moved);
  writer->SetFileName((this->Folder / "moved.bmt").c_str());
  ASSERT_EQ(writer->Write(), 1);

  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->AddFileName((this->Folder / "moved.bmt").c_str());
  this->Build(builder);
  double after[6];
  this->Model.GetGraph().GetBounds(after);
  std::printf("x %g to %g became %g to %g\n", before[0], before[1], after[0], after[1]);
  const double expected[6] = { 10 - 2 * before[1], 10 - 2 * before[0], 2 * before[2], 2 * before[3], 2 * before[4] - 5,
    2 * before[5] - 5 };
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(after[i], expected[i], 1e-3);
  }
  EXPECT_EQ(this->Model.GetGraph().InputCounts.Triangles, 1280u);
  EXPECT_FALSE(this->Model.GetGraph().Frame);
}

TEST_F(FileBuilderInputs, SeveralMeshesBecomeParts)
{
  this->MakeSphere(1280);
  this->WriteSquare();
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->AddFileName((this->Folder / "sphere.ply").c_str());
  builder->AddFileName((this->Folder / "square.ply").c_str());
  ASSERT_EQ(builder->GetNumberOfFileNames(), 2);
  EXPECT_EQ(builder->GetFileName(1), this->Folder / "square.ply");
  EXPECT_EQ(builder->GetFileName(2), nullptr);
  this->Build(builder);
  EXPECT_EQ(this->Model.GetGraph().InputCounts.Triangles, 1282u);
  EXPECT_EQ(this->GetArrays().count("PartId"), 1u);
  const std::vector<vtkMTBuildInput::Part>& parts = builder->GetReport().Input.Parts;
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[1].Cells, 2u);
  ASSERT_EQ(this->Model.GetGraph().Blobs.size(), 1u);
  EXPECT_EQ(this->Model.GetGraph().Blobs[0].Properties.at("part"), "1");
}

TEST_F(FileBuilderInputs, TexturesAreBlobsByteForByte)
{
  this->WriteSquare();
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->SetFileName((this->Folder / "square.ply").c_str());
  this->Build(builder);
  ASSERT_EQ(this->Model.GetGraph().Blobs.size(), 1u);
  EXPECT_EQ(this->Model.GetGraph().Blobs[0].Name, "leaves.png");
  std::vector<unsigned char> bytes;
  std::string error;
  ASSERT_TRUE(this->Model.ReadBlob(0, bytes, error)) << error;
  EXPECT_TRUE(bytes == MTIOTest::ReadFile(this->Folder / "leaves.png"));
}

TEST_F(FileBuilderInputs, OnlyTheNamedArraysAreKept)
{
  this->WriteSquare();
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->SetFileName((this->Folder / "square.ply").c_str());
  builder->MakeNormalsOff();
  this->Build(builder);
  EXPECT_EQ(this->GetArrays(), (std::set<std::string>{ "RGB", "TCoords", "vtkMTInputCellIds" }));
  builder->AddArrayName("TCoords");
  builder->SetInputIds(vtkMultiTriangulationBuilder::NoInputIds);
  this->Build(builder);
  EXPECT_EQ(this->GetArrays(), std::set<std::string>{ "TCoords" });
  builder->RemoveAllArrayNames();
  this->Build(builder);
  EXPECT_TRUE(this->GetArrays().empty());
  builder->KeepAllArraysOn();
  this->Build(builder);
  EXPECT_EQ(this->GetArrays(), (std::set<std::string>{ "RGB", "TCoords" }));
}

// A wavy square with labels of bytes and of integers, an intensity and a real array of two values.
void FileBuilderInputs::WriteLabels(int n) const
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(n * n) +
    "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar part\nproperty int zone\n"
    "property uchar intensity\nproperty float side\nelement face " +
    std::to_string(2 * (n - 1) * (n - 1)) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < n * n; ++i)
  {
    const bool isLeft = i % n < n / 2;
    text += std::to_string(i % n) + " " + std::to_string(i / n) + " " +
      std::to_string(std::sin(0.2 * (i % n)) * std::cos(0.17 * (i / n))) + (isLeft ? " 7 -3" : " 200 12") +
      (isLeft ? " 7 0.5\n" : " 200 1.5\n");
  }
  for (int i = 0; i + n + 1 < n * n; ++i)
  {
    if (i % n < n - 1)
    {
      text += "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + n + 1) + "\n3 " +
        std::to_string(i) + " " + std::to_string(i + n + 1) + " " + std::to_string(i + n) + "\n";
    }
  }
  MTIOTest::WriteFile(this->Folder / "labels.ply", text);
}

// Of all patches, as doubles.
std::set<double> FileBuilderInputs::GetValues(const std::string& name) const
{
  std::set<double> values;
  const std::vector<vtkMTArrayInfo>& arrays = this->Model.GetGraph().Arrays;
  for (std::uint32_t arc = 0; arc < this->Model.GetGraph().Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    std::string error;
    EXPECT_TRUE(this->Model.ReadPatch(arc, nullptr, patch, error)) << error;
    std::size_t column = 0;
    for (const vtkMTArrayInfo& array : arrays)
    {
      if (array.Association == vtkMTArrayInfo::Cell)
      {
        continue;
      }
      const vtkMTColumn& bytes = patch.PointColumns[column++];
      const auto size = static_cast<std::ptrdiff_t>(array.GetTupleSize());
      for (auto at = bytes.begin(); array.Name == name && at != bytes.end(); at += size)
      {
        values.insert(array.GetRanges(vtkMTColumn(at, at + size))[0].Minimum);
      }
    }
  }
  return values;
}

TEST_F(FileBuilderInputs, LabelsNeverMix)
{
  this->WriteLabels(60);
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->SetFileName((this->Folder / "labels.ply").c_str());
  builder->SetPatchTriangles(100);
  this->Build(builder);
  EXPECT_EQ(this->GetValues("part"), (std::set<double>{ 7, 200 }));
  EXPECT_EQ(this->GetValues("zone"), (std::set<double>{ -3, 12 }));
  EXPECT_GT(this->GetValues("intensity").size(), 2u); // a channel of a colour
  EXPECT_GT(this->GetValues("side").size(), 2u);
  builder->AddLabelArrayName("side");
  builder->AddLabelArrayName("zone");
  builder->AddValueArrayName("zone"); // the last holds
  this->Build(builder);
  EXPECT_EQ(this->GetValues("side"), (std::set<double>{ 0.5, 1.5 }));
  EXPECT_GT(this->GetValues("zone").size(), 2u);
  std::map<std::string, std::string> meanings;
  for (const vtkMTArrayInfo& array : this->Model.GetGraph().Arrays)
  {
    meanings[array.Name] = array.GetMeaning();
  }
  EXPECT_EQ(meanings,
    (std::map<std::string, std::string>{ { "part", "labels" }, { "zone", "values" }, { "intensity", "colors" },
      { "side", "labels" }, { "Normals", "directions" }, { "vtkMTInputCellIds", "ids" } }));
  builder->RemoveAllLabelArrayNames();
  builder->AddLabelArrayName("nothing");
  Events events;
  Observe(builder, events);
  EXPECT_EQ(builder->Write(), 0);
  EXPECT_EQ(builder->GetErrorCode(), vtkMultiTriangulationFileBuilder::ArrayError);
}

TEST_F(FileBuilderInputs, IsosurfacesAreNoCadUnlessItIsSaid)
{
  this->WriteBlock();
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->SetFileName((this->Folder / "block.vtk").c_str());
  builder->SetIsoValue(0.5);
  const auto build = [&](double angle)
  {
    builder->SetFeatureAngle(angle);
    this->Build(builder);
    EXPECT_EQ(builder->GetFeatureAngle(), angle);
    return MTIOTest::ReadFile(this->Folder / "out.bmt");
  };
  const MTIOTest::Bytes smooth = build(180.0);
  EXPECT_TRUE(build(vtkMultiTriangulationBuilder::AutomaticFeatureAngle) == smooth);
  EXPECT_FALSE(build(30.0) == smooth);
  EXPECT_EQ(this->Model.GetGraph().Settings.at("feature_angle_auto"), "30") << "the mesh itself looks like CAD";
}

TEST_F(FileBuilderInputs, AVolumeNeedsAnIsoValue)
{
  this->WriteVolume();
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->SetFileName((this->Folder / "volume.vtk").c_str());
  builder->SetOutputFileName((this->Folder / "out.bmt").c_str());
  Events events;
  Observe(builder, events);
  EXPECT_EQ(builder->Write(), 0);
  EXPECT_EQ(builder->GetErrorCode(), vtkMultiTriangulationFileBuilder::IsoValueError);
  builder->SetIsoValue(60.0);
  this->Build(builder);
  double bounds[6];
  this->Model.GetGraph().GetBounds(bounds);
  EXPECT_NEAR(bounds[1] - bounds[0], 2.0 * std::sqrt(60.0), 0.1);
  std::printf("%llu triangles\n", static_cast<unsigned long long>(this->Model.GetGraph().InputCounts.Triangles));
  EXPECT_TRUE(builder->GetReport().Input.IsStreamed);
  builder->GradientNormalsOn();
  this->Build(builder);
  EXPECT_FALSE(builder->GetReport().Input.IsStreamed);
}

TEST_F(FileBuilderInputs, AModelIsItsFinestLevel)
{
  this->MakeSphere(5120);
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  this->Configure(builder, "first.bmt");
  ASSERT_EQ(builder->Write(), 1) << builder->GetErrorMessage();
  builder->SetFileName((this->Folder / "first.bmt").c_str());
  this->Build(builder);
  EXPECT_EQ(this->Model.GetGraph().InputCounts.Triangles, 5120u);
}

TEST_F(FileBuilderInputs, NoPointMovesByMoreThanThePrecision)
{
  this->MakeSphere(5120);
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  this->Configure(builder);
  for (const double precision : { 1e-2, 1e-5, 1e-8 })
  {
    builder->SetPrecision(precision);
    this->Build(builder);
    const double shift = this->Model.GetGraph().Lattice.MaximumShift;
    std::printf("precision %g: largest shift %g\n", precision, shift);
    EXPECT_LE(shift, precision);
    EXPECT_GT(8.0 * shift, precision) << "bits are not wasted";
  }
}

TEST_F(FileBuilderInputs, WarningsOfTheBuilderAreItsOwn)
{
  std::string text = "ply\nformat ascii 1.0\nelement vertex 10003\nproperty double x\nproperty double y\n"
                     "property double z\nelement face 9999\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 10000; ++i)
  {
    text += std::to_string(i % 100) + " " + std::to_string(i / 100) + " " + std::to_string(i % 7) + "\n";
  }
  text += "1e30 0 0\n1e30 1 0\n1e30 0 1\n";
  for (int i = 0; i < 9998; ++i)
  {
    text += "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string((i + 100) % 10000) + "\n";
  }
  MTIOTest::WriteFile(this->Folder / "far.ply", text + "3 10000 10001 10002\n");
  const vtkNew<vtkMultiTriangulationFileBuilder> builder;
  builder->SetFileName((this->Folder / "far.ply").c_str());
  Events events;
  Observe(builder, events);
  this->Build(builder);
  ASSERT_EQ(events.Warnings.size(), 1u);
  EXPECT_NE(events.Warnings[0].find("far outlier"), std::string::npos) << events.Warnings[0];
}

TEST_F(FileBuilderInputs, ReadWholeIsWhatIsRead)
{
  this->MakeSphere(1280);
  vtkMTInputSettings settings;
  settings.Paths = { this->Folder / "sphere.ply" };
  vtkMTBuildInput input(settings);
  const vtkNew<vtkPolyData> mesh;
  vtkMTBuildError error;
  ASSERT_TRUE(input.Read(mesh, error)) << error.Message;
  EXPECT_FALSE(input.GetResult().IsStreamed);
  vtkMTScratchStore scratch(this->Folder / "");
  const auto stream = input.Open(scratch, 1 << 30, error);
  ASSERT_TRUE(stream) << error.Message;
  EXPECT_TRUE(input.GetResult().IsStreamed);
  EXPECT_EQ(stream->GetNumberOfPoints(), static_cast<std::uint64_t>(mesh->GetNumberOfPoints()));
  EXPECT_EQ(stream->GetNumberOfTriangles(), static_cast<std::uint64_t>(mesh->GetNumberOfPolys()));
  // Between files it can be stopped.
  vtkMTBuildInput stopped(settings, [] { return false; });
  EXPECT_FALSE(stopped.Read(mesh, error));
  EXPECT_EQ(error.Code, vtkMultiTriangulationFileBuilder::AbortError);
}
