// SPDX-License-Identifier: BSD-3-Clause
// Where volumes lie: orientation, origin and handedness as the headers say, in the files' own frames.
#include "MTTestMeshes.h"
#include "MTVolumes.h"

#include "vtkImageData.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTVolumeReader.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShortArray.h"
#include "vtkXMLImageDataWriter.h"

#include <cmath>
#include <cstring>
#include <sstream>

using namespace MTIOTest;
using MTTestMeshes::Random;
using MTVolumes::ExpectEllipsoid;
using MTVolumes::Frame;
using MTVolumes::Vector;

namespace
{
const Bytes& GetShorts()
{
  static const Bytes shorts = MTVolumes::GetSamples<std::int16_t>();
  return shorts;
}

std::string Write(const Vector& v, const char* between = " ")
{
  std::ostringstream text;
  text.precision(17);
  text << v[0] << between << v[1] << between << v[2];
  return text.str();
}

// All 48 ways to lay three axes along those of the world.
std::vector<std::array<Vector, 3>> GetOrientations()
{
  std::vector<std::array<Vector, 3>> all;
  std::array<std::size_t, 3> order{ 0, 1, 2 };
  do
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      std::array<Vector, 3> axes{};
      for (std::size_t i = 0; i < 3; ++i)
      {
        axes[i][order[i]] = (signs >> i & 1) != 0 ? -1.0 : 1.0;
      }
      all.push_back(axes);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return all;
}

Frame Scale(const std::array<Vector, 3>& directions, const Vector& spacing, const Vector& origin)
{
  Frame frame{ directions, origin };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (double& number : frame.Axes[axis])
    {
      number *= spacing[axis];
    }
  }
  return frame;
}

// Any three axes that are not nearly in one plane.
Frame MakeRandomFrame(Random& random)
{
  Frame frame;
  do
  {
    for (Vector& axis : frame.Axes)
    {
      axis = { random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0) };
    }
  } while (std::abs(frame.GetDeterminant()) < 0.5);
  frame.Origin = { random.Uniform(-300.0, 300.0), random.Uniform(-300.0, 300.0), random.Uniform(-300.0, 300.0) };
  return frame;
}

std::string MakeMetaImage(const std::array<Vector, 3>& directions, const Vector& spacing, const Vector& origin)
{
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix = " +
    Write(directions[0]) + " " + Write(directions[1]) + " " + Write(directions[2]) + "\nOffset = " + Write(origin) +
    "\nElementSpacing = " + Write(spacing) + "\nDimSize = 20 21 16\nElementType = MET_SHORT\n";
}

// NIfTI-1 with a header of its own or before the samples.
struct Nifti
{
  Bytes Head = Bytes(352, 0);

  Nifti()
  {
    this->Put<std::int32_t>(0, 348);
    const std::int16_t dim[8] = { 3, 20, 21, 16, 1, 1, 1, 1 };
    const float pixdim[8] = { 1, 1, 2, 3, 0, 0, 0, 0 };
    for (std::size_t i = 0; i < 8; ++i)
    {
      this->Put<std::int16_t>(40 + 2 * i, dim[i]);
      this->Put<float>(76 + 4 * i, pixdim[i]);
    }
    this->Put<std::int16_t>(70, 4);
    this->Put<std::int16_t>(72, 16);
    this->Put<float>(108, 352);
    this->Head[123] = 2;
    std::memcpy(this->Head.data() + 344, "n+1", 3);
  }
  template <typename Number>
  void Put(std::size_t at, Number number)
  {
    std::memcpy(this->Head.data() + at, &number, sizeof(Number));
  }
  void PutQform(int code, const Vector& quaternion, const Vector& origin, float qfac)
  {
    this->Put<std::int16_t>(252, static_cast<std::int16_t>(code));
    this->Put<float>(76, qfac);
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Put<float>(256 + 4 * i, static_cast<float>(quaternion[i]));
      this->Put<float>(268 + 4 * i, static_cast<float>(origin[i]));
    }
  }
  void PutSform(int code, const Frame& frame)
  {
    this->Put<std::int16_t>(254, static_cast<std::int16_t>(code));
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->Put<float>(280 + 16 * row + 4 * axis, static_cast<float>(frame.Axes[axis][row]));
      }
      this->Put<float>(292 + 16 * row, static_cast<float>(frame.Origin[row]));
    }
  }
  std::string Write(const std::string& path) const
  {
    Bytes bytes = this->Head;
    MTVolumes::Append(bytes, GetShorts());
    WriteFile(path, bytes);
    return path;
  }
};
}

TEST(VolumePlaces, MetaImageLiesInEachOfThe48OrientationsAsItsMatrixSays)
{
  const Folder folder;
  const Vector spacing{ 1, 2, 3 };
  const Vector offset{ 10, 20, 30 };
  WriteFile(folder / "samples.raw", GetShorts());
  int leftHanded = 0;
  for (const std::array<Vector, 3>& directions : GetOrientations())
  {
    WriteFile(folder / "volume.mhd", MakeMetaImage(directions, spacing, offset) + "ElementDataFile = samples.raw\n");
    const Frame frame = Scale(directions, spacing, offset);
    const MTVolumes::Read read = ExpectEllipsoid(folder / "volume.mhd", frame);
    EXPECT_EQ(read.Frame.Crs, "MetaImage");
    leftHanded += read.Report.count("turned_triangles") > 0 ? 1 : 0;
  }
  EXPECT_EQ(leftHanded, 24);
}

TEST(VolumePlaces, NiftiLiesAsItsQuaternionSaysAndTurnsItsThirdAxisByQfac)
{
  const Folder folder;
  Nifti nifti;
  const Vector origin{ 10, 20, 30 };
  nifti.PutQform(1, { 0, 0, 0 }, origin, 1.0f);
  const MTVolumes::Read plain =
    ExpectEllipsoid(nifti.Write(folder / "plain.nii"), { { { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } } }, origin });
  EXPECT_EQ(plain.Frame.Crs, "RAS scanner");
  EXPECT_EQ(plain.Frame.Units, "mm");
  nifti.PutQform(1, { 0, 0, 0 }, origin, 0.0f);
  ExpectEllipsoid(nifti.Write(folder / "zero.nii"), { { { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } } }, origin });
  nifti.PutQform(1, { 0, 0, 0 }, origin, -1.0f);
  ExpectEllipsoid(nifti.Write(folder / "left.nii"), { { { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, -3 } } }, origin });
  // A quarter turn about z: x to y, y to -x.
  const double half = std::sqrt(0.5);
  nifti.PutQform(3, { 0, 0, half }, origin, -1.0f);
  const MTVolumes::Read quarter =
    ExpectEllipsoid(nifti.Write(folder / "quarter.nii"), { { { { 0, 1, 0 }, { -2, 0, 0 }, { 0, 0, -3 } } }, origin });
  EXPECT_EQ(quarter.Frame.Crs, "RAS Talairach");
  // A half turn about the diagonal of x and y, where a is 0: x to y, y to x, z to -z.
  nifti.PutQform(2, { half, half, 0 }, origin, 1.0f);
  ExpectEllipsoid(nifti.Write(folder / "half.nii"), { { { { 0, 1, 0 }, { 2, 0, 0 }, { 0, 0, -3 } } }, origin });
}

TEST(VolumePlaces, NiftiLiesAsItsSformSaysBeforeItsQformAndByVoxelsWhereItHasNeither)
{
  const Folder folder;
  Nifti nifti;
  const Frame sheared{ { { { -1.0, 0.25, 0.0 }, { 0.5, 2.0, -0.25 }, { 0.0, 0.5, 3.0 } } }, { 90.5, -126.0, -72.0 } };
  nifti.PutSform(4, sheared);
  const MTVolumes::Read alone = ExpectEllipsoid(nifti.Write(folder / "sform.nii"), sheared);
  EXPECT_EQ(alone.Frame.Crs, "RAS MNI 152");
  EXPECT_EQ(alone.Report.count("volume_ignored_qform"), 0u);
  nifti.PutQform(1, { 0, 0, 0 }, { 1, 2, 3 }, 1.0f);
  EXPECT_EQ(ExpectEllipsoid(nifti.Write(folder / "both.nii"), sheared).Report.at("volume_ignored_qform"), 1);
  // A code without a matrix.
  nifti.PutSform(1, { {}, { 0, 0, 0 } });
  const Frame qform{ { { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } } }, { 1, 2, 3 } };
  EXPECT_EQ(ExpectEllipsoid(nifti.Write(folder / "empty.nii"), qform).Report.at("volume_ignored_sform"), 1);
  // qfac is the qform's alone.
  Nifti bare;
  bare.Put<float>(76, -1.0f);
  const Frame voxels{ { { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } } }, { 0, 0, 0 } };
  EXPECT_EQ(ExpectEllipsoid(bare.Write(folder / "bare.nii"), voxels).Frame.Crs, "");
}

TEST(VolumePlaces, NrrdLiesAsItsDirectionsSayInItsDeclaredSpace)
{
  const Folder folder;
  const std::string head = "NRRD0005\n# a comment\ntype: short\ndimension: 3\nsizes: 20 21 16\nendian: little\n"
                           "encoding: raw\n";
  const auto write = [&](const std::string& name, const std::string& fields)
  {
    Bytes bytes;
    MTVolumes::Append(bytes, head + fields + "\n");
    MTVolumes::Append(bytes, GetShorts());
    WriteFile(folder / name, bytes);
    return folder / name;
  };
  // i up, j to the left, k to the front.
  const Frame permuted{ { { { 0, 0, 1 }, { 2, 0, 0 }, { 0, -3, 0 } } }, { 5, 6, 7 } };
  const MTVolumes::Read read = ExpectEllipsoid(
    write("permuted.nrrd",
      "space: left-posterior-superior\nspace directions: (0,0,1) (2,0,0) (0,-3,0)\nspace origin: (5,6,7)\n"
      "space units: \"mm\" \"mm\" \"mm\"\nkey:=value of a user\n"),
    permuted);
  EXPECT_EQ(read.Frame.Crs, "LPS");
  EXPECT_EQ(read.Frame.Units, "mm");
  // A space that is left-handed itself: coordinates are those of the file.
  const Frame left{ { { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, -3 } } }, { 0, 0, 0 } };
  EXPECT_EQ(
    ExpectEllipsoid(write("left.nrrd", "space: LAS\nspace directions: (1,0,0) (0,2,0) (0,0,-3)\n"), left).Frame.Crs,
    "LAS");
  // Without a space: borders of cells, or nodes.
  const Frame cells{ { { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } } }, { 10.5, 21, 31.5 } };
  ExpectEllipsoid(write("cells.nrrd", "spacings: 1 2 3\naxis mins: 10 20 30\n"), cells);
  const Frame nodes{ { { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } } }, { 10, 20, 30 } };
  ExpectEllipsoid(write("nodes.nrrd", "axis mins: 10 20 30\naxis maxs: 29 60 75\ncenterings: node node node\n"), nodes);
}

TEST(VolumePlaces, EveryVertexObeysTheFormulaOfItsFormatInRandomFrames)
{
  const Folder folder;
  Random random(7);
  int leftHanded = 0;
  for (int round = 0; round < 12; ++round)
  {
    const Frame frame = MakeRandomFrame(random);
    leftHanded += frame.GetDeterminant() < 0.0 ? 1 : 0;
    Bytes meta;
    MTVolumes::Append(meta, MakeMetaImage(frame.Axes, { 1, 1, 1 }, frame.Origin) + "ElementDataFile = LOCAL\n");
    MTVolumes::Append(meta, GetShorts());
    WriteFile(folder / "random.mha", meta);
    ExpectEllipsoid(folder / "random.mha", frame);

    Bytes nrrd;
    MTVolumes::Append(nrrd,
      "NRRD0004\ntype: int16\ndimension: 3\nspace: RAS\nsizes: 20 21 16\nspace directions: (" +
        Write(frame.Axes[0], ",") + ") (" + Write(frame.Axes[1], ",") + ") (" + Write(frame.Axes[2], ",") +
        ")\nspace origin: (" + Write(frame.Origin, ",") + ")\nendian: little\nencoding: raw\n\n");
    MTVolumes::Append(nrrd, GetShorts());
    WriteFile(folder / "random.nrrd", nrrd);
    ExpectEllipsoid(folder / "random.nrrd", frame);

    Nifti nifti;
    nifti.PutSform(2, frame);
    Frame rounded = frame; // to single precision, as the header has it
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (double& number : rounded.Axes[axis])
      {
        number = static_cast<float>(number);
      }
      rounded.Origin[axis] = static_cast<float>(rounded.Origin[axis]);
    }
    ExpectEllipsoid(nifti.Write(folder / "random.nii"), rounded);
  }
  std::printf("%d of 12 frames are left-handed\n", leftHanded);
  EXPECT_GT(leftHanded, 2);
  EXPECT_LT(leftHanded, 10);
}

TEST(VolumePlaces, AnImageOfVtkLiesAsItsDirectionSays)
{
  const Folder folder;
  const std::string path = folder / "volume.vti";
  for (const std::array<Vector, 3>& directions : GetOrientations())
  {
    vtkNew<vtkImageData> image;
    // Its extent need not begin at 0: indices are those of the extent.
    image->SetExtent(5, 24, -3, 17, 2, 17);
    image->SetSpacing(1, 2, 3);
    image->SetOrigin(10, 20, 30);
    vtkNew<vtkMatrix3x3> matrix;
    Frame frame = Scale(directions, { 1, 2, 3 }, { 10, 20, 30 });
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double first = std::array<double, 3>{ 5, -3, 2 }[axis];
      for (std::size_t i = 0; i < 3; ++i)
      {
        matrix->SetElement(static_cast<int>(i), static_cast<int>(axis), directions[axis][i]);
        frame.Origin[i] += first * frame.Axes[axis][i];
      }
    }
    image->SetDirectionMatrix(matrix);
    vtkNew<vtkShortArray> samples;
    samples->SetNumberOfTuples(image->GetNumberOfPoints());
    std::memcpy(samples->GetVoidPointer(0), GetShorts().data(), GetShorts().size());
    samples->SetName("density");
    image->GetPointData()->SetScalars(samples);
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(path.c_str());
    ASSERT_EQ(writer->Write(), 1);
    ExpectEllipsoid(path, frame);
  }
}

TEST(VolumePlaces, AFrameThatSpansNoSpaceIsAnErrorThatSaysSo)
{
  const Folder folder;
  WriteFile(folder / "samples.raw", GetShorts());
  const std::array<Vector, 3> flat{ { { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } } };
  WriteFile(folder / "flat.mhd", MakeMetaImage(flat, { 1, 1, 1 }, { 0, 0, 0 }) + "ElementDataFile = samples.raw\n");
  vtkNew<vtkPolyData> mesh;
  std::string error;
  EXPECT_FALSE(vtkMTVolumeReader::ReadIsosurface(folder / "flat.mhd", MTVolumes::IsoValue, false, mesh, error));
  EXPECT_NE(error.find("flat.mhd: its header's directions span no space"), std::string::npos) << error;
  EXPECT_EQ(vtkMTVolumeReader::StreamIsosurface(folder / "flat.mhd", MTVolumes::IsoValue, error), nullptr);
  // A spacing of 0 is none: 1, and counted.
  const std::array<Vector, 3> straight{ { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  WriteFile(folder / "zero.mhd", MakeMetaImage(straight, { 1, 0, 2 }, { 0, 0, 0 }) + "ElementDataFile = samples.raw\n");
  const MTVolumes::Read read = ExpectEllipsoid(folder / "zero.mhd", Scale(straight, { 1, 1, 2 }, { 0, 0, 0 }));
  EXPECT_EQ(read.Report.at("volume_filled_spacings"), 1);
}

namespace
{
// The reports that each volume stands for, with the right bounds.
struct Report
{
  const char* Name;
  double IsoValue;
  std::array<double, 6> Bounds;
};
}

TEST(VolumePlaces, TheVolumesOfTheReportsHaveTheirRightBounds)
{
  const std::string folder = GetDataFolder() + "/../reports";
  if (!std::filesystem::exists(folder + "/i_plain.mhd"))
  {
    GTEST_SKIP() << "the folder of reports is not there";
  }
  const Report reports[] = { { "i_plain.mhd", 50, { 13, 23, 28, 48, 36, 66 } },
    { "i_rot.mhd", 50, { -18, 2, 23, 33, 36, 66 } }, { "i_flip.mhd", 50, { -3, 7, -8, 12, 36, 66 } },
    { "i_q.nii", 50, { 13, 23, 28, 48, 36, 66 } }, { "i_s.nii", 50, { -3, 7, 28, 48, 36, 66 } },
    { "i_left.vti", 50, { 13, 23, 28, 48, -6, 24 } } };
  for (const Report& report : reports)
  {
    vtkNew<vtkPolyData> mesh;
    std::string error;
    ASSERT_TRUE(vtkMTVolumeReader::ReadIsosurface(folder + "/" + report.Name, report.IsoValue, false, mesh, error))
      << error;
    std::array<double, 6> bounds;
    mesh->GetBounds(bounds.data());
    for (std::size_t i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(bounds[i], report.Bounds[i], 1e-5) << report.Name << ", bound " << i;
    }
    EXPECT_NEAR(MTVolumes::GetSignedVolume(mesh), 3053.0, 1.0) << report.Name;
  }
}
