// SPDX-License-Identifier: BSD-3-Clause
// The checker's own reading of volumes: every form of header and samples gives the surface that the format's
// specification asks for. The volume is a box of 3 x 2 x 3 samples of 100 within zeros, so bounds and volume are known.
#include "MTVerifyFiles.h"

#include "vtkMTVerifyVolumeInput.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

using namespace MTVerifyFiles;

namespace
{
using Facts = vtkMTVerifyVolumeInput::Facts;
using Affine = std::array<double, 12>; ///< three rows

constexpr int Sizes[3] = { 8, 7, 6 };
/// Half way between samples of 0 and of 100: the box reaches half a step beyond its samples.
constexpr double IndexBounds[6] = { 1.5, 4.5, 1.5, 3.5, 0.5, 3.5 };
/// Core, slabs at the faces, bevels at the edges (1/8 a unit of length), corners (1/48).
constexpr double IndexVolume = 2 * 1 * 2 + (2 * 1 + 1 * 2 + 2 * 2) + 4 * (2 + 1 + 2) / 8.0 + 8 / 48.0;

std::vector<double> GetBox()
{
  std::vector<double> samples;
  for (int k = 0; k < Sizes[2]; ++k)
  {
    for (int j = 0; j < Sizes[1]; ++j)
    {
      for (int i = 0; i < Sizes[0]; ++i)
      {
        samples.push_back(i >= 2 && i <= 4 && j >= 2 && j <= 3 && k >= 1 && k <= 3 ? 100.0 : 0.0);
      }
    }
  }
  return samples;
}

double GetDeterminant(const Affine& m)
{
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
}

class VerifyVolumeInput : public FolderTest
{
protected:
  /// Reads it, and holds the surface to what the map makes of the box.
  Facts Expect(const std::string& path, const Affine& map, double isoValue = 50.0) const
  {
    SCOPED_TRACE(path);
    vtkNew<vtkPolyData> surface;
    Facts facts;
    std::string error;
    EXPECT_TRUE(vtkMTVerifyVolumeInput::Read(path, { isoValue }, surface, facts, error)) << error;
    double bounds[6] = { 1e300, -1e300, 1e300, -1e300, 1e300, -1e300 };
    for (int i = 0; i < 12; ++i)
    {
      EXPECT_NEAR(facts.IndexToWorld[static_cast<std::size_t>(i)], map[static_cast<std::size_t>(i)], 1e-5) << i;
    }
    // Bounds are known of maps that take axes to axes.
    int zeros = 0;
    for (const std::size_t i : { 0, 1, 2, 4, 5, 6, 8, 9, 10 })
    {
      zeros += std::abs(map[i]) < 1e-9 ? 1 : 0;
    }
    const bool isAligned = zeros == 6;
    for (int corner = 0; corner < 8; ++corner)
    {
      for (int row = 0; row < 3; ++row)
      {
        const double* r = &map[static_cast<std::size_t>(4 * row)];
        const double x = r[0] * IndexBounds[corner & 1] + r[1] * IndexBounds[2 + (corner >> 1 & 1)] +
          r[2] * IndexBounds[4 + (corner >> 2)] + r[3];
        bounds[2 * row] = std::min(bounds[2 * row], x);
        bounds[2 * row + 1] = std::max(bounds[2 * row + 1], x);
      }
    }
    for (int i = 0; i < 6 && isAligned; ++i)
    {
      EXPECT_NEAR(surface->GetBounds()[i], bounds[i], 1e-4) << i;
    }
    const double determinant = GetDeterminant(map);
    EXPECT_NEAR(GetSignedVolume(surface), IndexVolume * std::abs(determinant), 1e-3 * std::abs(determinant));
    EXPECT_EQ(facts.IsLeftHanded, determinant < 0.0);
    EXPECT_EQ(facts.Dimensions, (std::array<int, 3>{ { Sizes[0], Sizes[1], Sizes[2] } }));
    return facts;
  }

  std::string ExpectRefused(const std::string& path, bool isUnsupported) const
  {
    SCOPED_TRACE(path);
    vtkNew<vtkPolyData> surface;
    Facts facts;
    std::string error;
    EXPECT_FALSE(vtkMTVerifyVolumeInput::Read(path, { 50.0 }, surface, facts, error));
    EXPECT_EQ(facts.IsUnsupported, isUnsupported) << error;
    EXPECT_NE(error.find(std::filesystem::path(path).filename().string()), std::string::npos) << error;
    std::cout << error << "\n";
    return error;
  }
};

const Affine Unit = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
const std::string MetaImageHead = "ObjectType = Image\nNDims = 3\nDimSize = 8 7 6\n";
const std::string NrrdHead = "NRRD0005\n# a comment\ndimension: 3\nsizes: 8 7 6\nkey:=value: with colon\n";

}

TEST_F(VerifyVolumeInput, EveryTypeAndByteOrderOfSamplesIsTheSame)
{
  const char* const meta[10] = { "CHAR", "UCHAR", "SHORT", "USHORT", "LONG", "UINT", "LONG_LONG", "ULONG_LONG", "FLOAT",
    "DOUBLE" };
  const char* const nrrd[10] = { "int8", "uchar", "signed short int", "uint16_t", "int", "unsigned  int", "long long",
    "uint64", "float", "double" };
  const std::int16_t nifti[10] = { 256, 2, 4, 512, 8, 768, 1024, 1280, 16, 64 };
  for (std::size_t type = 0; type < 10; ++type)
  {
    for (const bool isBig : { false, true })
    {
      const std::string samples = GetEncoders()[type](GetBox(), isBig);
      const std::string name = std::to_string(type) + (isBig ? "big" : "little");
      const Facts facts =
        this->Expect(this->Write(name + ".mha",
                       MetaImageHead + "BinaryDataByteOrderMSB = " + (isBig ? "True" : "False") +
                         "\nElementType = MET_" + meta[type] + "\nElementDataFile = LOCAL\n" + samples),
          Unit);
      EXPECT_EQ(facts.Range, (std::array<double, 2>{ { 0.0, 100.0 } }));
      this->Expect(this->Write(name + ".nrrd",
                     NrrdHead + "type: " + nrrd[type] + "\nencoding: raw\nendian: " + (isBig ? "big" : "little") +
                       "\n\n" + samples),
        Unit);
      for (const int version : { 1, 2 })
      {
        Nifti header;
        header.Version = version;
        header.IsBig = isBig;
        header.Type = nifti[type];
        this->Expect(this->Write(name + std::to_string(version) + ".nii", header.ToHeader() + samples), Unit);
      }
    }
  }
}

TEST_F(VerifyVolumeInput, MetaImageIsPlacedAsWritten)
{
  const std::string samples = Encode<std::int16_t>(GetBox());
  const std::string end = "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" + samples;
  // Row i of the matrix is the direction of axis i: the first axis runs along y, the second against x.
  this->Expect(
    this->Write("turned.mha",
      MetaImageHead + "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nOffset = 10 20 30\nElementSpacing = 1 2 3\n" + end),
    { 0, -2, 0, 10, 1, 0, 0, 20, 0, 0, 3, 30 });
  const Facts left =
    this->Expect(this->Write("left.mha",
                   MetaImageHead + "Orientation = 1 0 0 0 1 0 0 0 -1\nPosition = 1 2 3\nElementSize = 0.5 1 2\n" +
                     "AnatomicalOrientation = RAI\nCenterOfRotation = 5 0 0\n" + end),
      { 0.5, 0, 0, 1, 0, 1, 0, 2, 0, 0, -2, 3 });
  EXPECT_EQ(left.Frame, "RAI");
  EXPECT_EQ(left.Notes.size(), 1U); // the centre of rotation
  // A shear, which VTK's image data cannot have.
  this->Expect(this->Write("shear.mha", MetaImageHead + "Rotation = 1 0 0 0.5 1 0 0 0 1\n" + end),
    { 1, 0.5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 });
}

TEST_F(VerifyVolumeInput, MetaImageSamplesComeFromWhereTheHeaderNames)
{
  const std::string samples = Encode<float>(GetBox());
  const std::string head = MetaImageHead + "ElementType = MET_FLOAT\n";
  this->Write("raw.raw", samples);
  this->Write("junk.raw", std::string(37, 'x') + samples);
  this->Write("all.zraw", Compress(samples, 15));
  const std::size_t slice = samples.size() / 6;
  std::string list;
  for (std::size_t k = 0; k < 6; ++k)
  {
    list += this->Write("slice" + std::to_string(10 + k) + ".raw", samples.substr(k * slice, slice)) + "\n";
  }
  this->Expect(this->Write("a.mhd", head + "ElementDataFile = raw.raw\n"), Unit);
  this->Expect(this->Write("b.mhd", head + "HeaderSize = 37\nElementDataFile = junk.raw\n"), Unit);
  this->Expect(this->Write("c.mhd", head + "HeaderSize = -1\nElementDataFile = junk.raw\n"), Unit);
  this->Expect(this->Write("d.mhd", head + "CompressedData = True\nElementDataFile = all.zraw\n"), Unit);
  this->Expect(this->Write("e.mhd", head + "ElementDataFile = LIST\n" + list), Unit);
  this->Expect(this->Write("f.mhd", head + "ElementDataFile = slice%02d.raw 10 15 1\n"), Unit);
  this->Expect(this->Write("g.mha", head + "BinaryData = False\nElementDataFile = LOCAL\n" + ToText(GetBox())), Unit);
  this->Expect(
    this->Write("h.mha", head + "CompressedData = True\r\nElementDataFile = LOCAL\r\n" + Compress(samples, 15)), Unit);
  const Facts scaled =
    this->Expect(this->Write("i.mhd",
                   head + "ElementToIntensityFunctionSlope = -2\nElementToIntensityFunctionOffset = 300\n" +
                     "ElementDataFile = inverse.raw\n" +
                     (this->Write("inverse.raw",
                        Encode<float>(
                          []
                          {
                            std::vector<double> box = GetBox();
                            std::transform(box.begin(), box.end(), box.begin(), [](double x) { return 150.0 - x / 2; });
                            return box;
                          }())),
                       "")),
      Unit);
  EXPECT_EQ(scaled.Range, (std::array<double, 2>{ { 0.0, 100.0 } }));
}

TEST_F(VerifyVolumeInput, NrrdEncodingsAndFilesAreTheSame)
{
  const std::string samples = Encode<std::int16_t>(GetBox());
  const std::string head = NrrdHead + "type: short\nendian: little\n";
  this->Expect(this->Write("gz.nrrd", head + "encoding: gzip\n\n" + Compress(samples, 31)), Unit);
  this->Expect(this->Write("text.nrrd", head + "encoding: ascii\n\n" + ToText(GetBox())), Unit);
  this->Expect(this->Write("hex.nrrd", head + "encoding: hex\n\n" + ToHex(samples)), Unit);
  this->Write("skip.raw", "one line\nanother\nxyz" + samples);
  this->Expect(
    this->Write("skip.nhdr", head + "encoding: raw\nline skip: 2\nbyte skip: 3\ndata file: skip.raw\n"), Unit);
  this->Expect(this->Write("last.nhdr", head + "encoding: raw\nbyte skip: -1\ndatafile: skip.raw\n"), Unit);
  // Lines are passed over in the file, bytes in what was inflated.
  this->Write("skip.gz", "a line\n" + Compress("xyz" + samples, 31));
  this->Expect(
    this->Write("skipgz.nhdr", head + "encoding: gz\nline skip: 1\nbyte skip: 3\ndata file: skip.gz\n"), Unit);
  const std::size_t half = samples.size() / 2;
  this->Write("part1.raw", samples.substr(0, half));
  this->Write("part2.raw", samples.substr(half));
  this->Expect(this->Write("list.nhdr", head + "encoding: raw\ndata file: LIST\npart1.raw\npart2.raw\n"), Unit);
  this->Expect(this->Write("some.nhdr", head + "encoding: raw\ndata file: part%d.raw 1 2 1\n"), Unit);
}

TEST_F(VerifyVolumeInput, NrrdIsPlacedInItsDeclaredSpace)
{
  const std::string samples = Encode<std::uint8_t>(GetBox());
  const std::string end = "type: uchar\nencoding: raw\n\n" + samples;
  const Facts facts = this->Expect(
    this->Write("ras.nrrd",
      NrrdHead +
        "space: right-anterior-superior\nspace directions: (0, 2,0) (-1,0,0) (0,0,-3)\nspace origin: (1,2,3)\n" + end),
    { 0, -1, 0, 1, 2, 0, 0, 2, 0, 0, -3, 3 });
  EXPECT_EQ(facts.Frame, "right-anterior-superior");
  EXPECT_EQ(
    this
      ->Expect(
        this->Write("lps.nrrd", NrrdHead + "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n" + end), Unit)
      .Frame,
    "LPS");
  // Nodes are at the minimum, cells half a step behind it; a minimum and a maximum make the step.
  this->Expect(
    this->Write("steps.nrrd",
      NrrdHead + "spacings: 2 nan nan\naxis mins: 10 20 30\naxis maxs: nan 32 42\ncenters: node node cell\n" + end),
    { 2, 0, 0, 10, 0, 2, 0, 20, 0, 0, 2, 31 });
  // Axes that are none of space: of one sample, or of several volumes.
  this->Expect(this->Write("one.nrrd",
                 "NRRD0004\ndimension: 4\nsizes: 1 8 7 6\nkinds: scalar domain domain domain\n"
                 "space dimension: 3\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\n" +
                   end),
    Unit);
  const Facts two =
    this->Expect(this->Write("two.nrrd",
                   "NRRD0004\ndimension: 4\nsizes: 8 7 6 2\nkinds: domain domain domain list\n" + end + samples),
      Unit);
  EXPECT_EQ(two.Notes.size(), 1U);
}

TEST_F(VerifyVolumeInput, NiftiTakesSformThenQformThenVoxelSizes)
{
  const std::string samples = Encode<std::int16_t>(GetBox());
  Nifti header;
  header.Pixdim = { { 1, 1, 2, 3 } };
  EXPECT_EQ(this->Expect(this->Write("none.nii", header.ToHeader() + samples), { 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0 })
              .Notes.size(),
    1U);
  // A quarter turn about z (d = sin 45 degrees); qfac -1 reverses the third axis.
  header.Qform = 1;
  header.Quatern = { { 0, 0, std::sqrt(0.5), 10, 20, 30 } };
  header.Pixdim[0] = -1;
  const Affine turned = { 0, -2, 0, 10, 1, 0, 0, 20, 0, 0, -3, 30 };
  EXPECT_EQ(this->Expect(this->Write("q.nii", header.ToHeader() + samples), turned).Frame, "RAS");
  // Thirds of a turn about the diagonal: x to y to z to x.
  header.Quatern = { { 0.5, 0.5, 0.5, 1, 2, 3 } };
  header.Pixdim[0] = 0;
  this->Expect(this->Write("third.nii", header.ToHeader() + samples), { 0, 0, 3, 1, 1, 0, 0, 2, 0, 2, 0, 3 });
  header.Sform = 2;
  header.Rows = { { -1, 0, 0, 10, 0, 2, 0, 20, 0, 0, 3, 30 } };
  this->Expect(this->Write("s.nii", header.ToHeader() + samples), header.Rows);
  header.Version = 2;
  this->Expect(this->Write("s2.nii.gz", Compress(header.ToHeader() + samples, 31)), header.Rows);
  header.Sform = 0;
  this->Expect(this->Write("q2.nii", header.ToHeader() + samples), { 0, 0, 3, 1, 1, 0, 0, 2, 0, 2, 0, 3 });
}

TEST_F(VerifyVolumeInput, NiftiPairsScalesAndTimePoints)
{
  const std::string samples = Encode<std::int16_t>(GetBox());
  Nifti header;
  header.IsSingle = false;
  const std::string path = this->Write("pair.hdr", header.ToHeader().substr(0, 348));
  this->Write("pair.img", samples);
  this->Expect(path, Unit);
  this->Expect(this->Folder + "/pair.img", Unit);
  this->Write("packed.hdr.gz", Compress(header.ToHeader().substr(0, 348), 31));
  this->Write("packed.img.gz", Compress(samples, 31));
  this->Expect(this->Folder + "/packed.hdr.gz", Unit);
  header.IsSingle = true;
  header.Slope = 2.0;
  header.Intercept = -1000.0;
  const Facts scaled = this->Expect(this->Write("slope.nii", header.ToHeader() + samples), Unit, -900.0);
  EXPECT_EQ(scaled.Range, (std::array<double, 2>{ { -1000.0, -800.0 } }));
  header.Slope = 0.0; // no scaling: the intercept counts for nothing
  header.Dim = { 4, 8, 7, 6, 3 };
  const Facts first = this->Expect(this->Write("time.nii", header.ToHeader() + samples + samples + samples), Unit);
  EXPECT_EQ(first.Notes.size(), 2U);
}

TEST_F(VerifyVolumeInput, VtkImageDataKeepsDirectionAndExtent)
{
  const std::string path = this->Write("left.vti",
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "<ImageData WholeExtent=\"3 10 0 6 0 5\" Origin=\"10 20 30\" Spacing=\"1 2 3\" Direction=\"0 1 0 1 0 0 0 0 1\">\n"
    "<Piece Extent=\"3 10 0 6 0 5\"><PointData Scalars=\"v\">\n<DataArray type=\"Float32\" Name=\"v\" "
    "format=\"ascii\">\n" +
      ToText(GetBox()) + "</DataArray></PointData></Piece></ImageData></VTKFile>\n");
  // The first sample has index (3, 0, 0): three steps along the first axis, which runs along y.
  this->Expect(path, { 0, 2, 0, 10, 1, 0, 0, 23, 0, 0, 3, 30 });
  this->Expect(this->Write("points.vtk",
                 "# vtk DataFile Version 3.0\nbox\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 8 7 6\nORIGIN 1 2 3\n"
                 "SPACING 1 1 2\nPOINT_DATA 336\nSCALARS v float 1\nLOOKUP_TABLE default\n" +
                   ToText(GetBox())),
    { 1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 2, 3 });
}

TEST_F(VerifyVolumeInput, WhatIsNotReadHereIsNoDamage)
{
  const std::string samples = Encode<std::uint8_t>(GetBox());
  this->ExpectRefused(this->Write("bz.nrrd", NrrdHead + "type: uchar\nencoding: bzip2\n\n" + samples), true);
  this->ExpectRefused(this->Write("vector.nrrd",
                        "NRRD0004\ndimension: 4\nsizes: 3 8 7 6\nkinds: vector domain domain domain\ntype: uchar\n"
                        "encoding: raw\n\n" +
                          samples + samples + samples),
    true);
  this->ExpectRefused(
    this->Write("rgb.mha",
      MetaImageHead + "ElementNumberOfChannels = 3\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + samples +
        samples + samples),
    true);
  Nifti header;
  header.Type = 128; // RGB
  this->ExpectRefused(this->Write("rgb.nii", header.ToHeader() + samples + samples + samples), true);
  this->ExpectRefused(this->Write("mesh.ply", "ply\n"), true);
}

TEST_F(VerifyVolumeInput, DamageIsAnErrorThatNamesTheFile)
{
  const std::string samples = Encode<std::uint8_t>(GetBox());
  const std::string meta = MetaImageHead + "ElementType = MET_UCHAR\n";
  this->ExpectRefused(this->Folder + "/missing.nii", false);
  this->ExpectRefused(this->Write("short.mha", meta + "ElementDataFile = LOCAL\n" + samples.substr(1)), false);
  const std::string packed = Compress(samples, 31);
  this->ExpectRefused(
    this->Write("short.nrrd", NrrdHead + "type: uchar\nencoding: gzip\n\n" + packed.substr(0, packed.size() / 2)),
    false);
  this->ExpectRefused(this->Write("gone.mhd", meta + "ElementDataFile = gone.raw\n"), false);
  this->ExpectRefused(
    this->Write("flat.mha", meta + "TransformMatrix = 1 0 0 1 0 0 0 0 1\nElementDataFile = LOCAL\n" + samples), false);
  this->ExpectRefused(
    this->Write(
      "huge.nrrd", "NRRD0001\ndimension: 3\nsizes: 100000 100000 100000\ntype: uchar\nencoding: gzip\n\n" + packed),
    false);
  this->ExpectRefused(this->Write("words.nrrd", NrrdHead + "type: uchar\nencoding: ascii\n\n1 2 three"), false);
  this->ExpectRefused(this->Write("damaged.vti", "<VTKFile type=\"ImageData\"><ImageData"), false);
}

TEST_F(VerifyVolumeInput, ReportsHaveTheirRightValues)
{
  const std::string folder = GetReports();
  if (folder.empty())
  {
    GTEST_SKIP() << "no ../shared/reports";
  }
  struct Report
  {
    const char* Name;
    double IsoValue;
    std::array<double, 6> Bounds;
  };
  const Report reports[] = { { "i_plain.mhd", 50, { { 13, 23, 28, 48, 36, 66 } } },
    { "i_rot.mhd", 50, { { -18, 2, 23, 33, 36, 66 } } }, { "i_flip.mhd", 50, { { -3, 7, -8, 12, 36, 66 } } },
    { "i_q.nii", 50, { { 13, 23, 28, 48, 36, 66 } } }, { "i_s.nii", 50, { { -3, 7, 28, 48, 36, 66 } } },
    { "i_left.vti", 50, {} }, { "i_slope.nii", -850, {} } };
  for (const Report& report : reports)
  {
    vtkNew<vtkPolyData> surface;
    Facts facts;
    std::string error;
    ASSERT_TRUE(vtkMTVerifyVolumeInput::Read(folder + report.Name, { report.IsoValue }, surface, facts, error))
      << error;
    const double* b = surface->GetBounds();
    const double volume = GetSignedVolume(surface);
    std::cout << report.Name << ": " << surface->GetNumberOfCells() << " triangles, signed volume " << volume
              << ", bounds " << b[0] << " " << b[1] << " " << b[2] << " " << b[3] << " " << b[4] << " " << b[5]
              << ", values " << facts.Range[0] << ".." << facts.Range[1] << ", " << facts.Reader << "\n";
    EXPECT_GT(volume, 0.0);
    for (std::size_t i = 0; i < 6 && report.Bounds[1] != 0.0; ++i)
    {
      EXPECT_NEAR(b[i], report.Bounds[i], 0.5) << report.Name; // given as whole numbers
    }
    if (std::string(report.Name) == "i_left.vti")
    {
      EXPECT_NEAR(volume, 3053, 0.5);
    }
    if (std::string(report.Name) == "i_slope.nii")
    {
      EXPECT_EQ(facts.Range, (std::array<double, 2>{ { -1194.0, -800.0 } }));
      EXPECT_GT(surface->GetNumberOfCells(), 0);
    }
  }
}
