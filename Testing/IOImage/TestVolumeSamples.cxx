// SPDX-License-Identifier: BSD-3-Clause
// How volumes are stored: types, orders of bytes, encodings, files, axes that are not of space, scaling of values.
#include "MTVolumes.h"

#include "vtkMTTriangleStream.h"
#include "vtkMTVolumeReader.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstring>
#include <sstream>

using namespace MTIOTest;
using MTVolumes::Append;
using MTVolumes::ExpectEllipsoid;
using MTVolumes::GetSamples;
using MTVolumes::Gzip;

namespace
{
const MTVolumes::Frame Plain;

std::string WriteAll(const std::string& path, const std::string& head, const Bytes& samples)
{
  Bytes bytes;
  Append(bytes, head);
  Append(bytes, samples);
  WriteFile(path, bytes);
  return path;
}

std::string MakeMeta(const std::string& type, const std::string& more)
{
  return "NDims = 3\nDimSize = 20 21 16\nElementType = " + type + "\n" + more;
}

std::string MakeNrrd(const std::string& type, const std::string& more)
{
  return "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: 20 21 16\n" + more;
}

// Numbers, and hexadecimal octets, as text.
std::string MakeText(bool isHexadecimal)
{
  std::ostringstream text;
  const Bytes octets = GetSamples<std::int16_t>();
  for (std::size_t i = 0; i < octets.size() / 2; ++i)
  {
    std::int16_t number = 0;
    std::memcpy(&number, octets.data() + 2 * i, 2);
    char hexadecimal[8];
    std::snprintf(hexadecimal, sizeof(hexadecimal), "%02x%02X", octets[2 * i], octets[2 * i + 1]);
    text << (isHexadecimal ? hexadecimal : std::to_string(number)) << (i % 20 == 19 ? "\n" : isHexadecimal ? "" : " ");
  }
  return text.str();
}

// Every sample several times, the first of each being the sample: the components of a vector.
Bytes Repeat(std::size_t count)
{
  const Bytes once = GetSamples<std::int16_t>();
  Bytes bytes;
  for (std::size_t i = 0; i < once.size(); i += 2)
  {
    bytes.push_back(once[i]);
    bytes.push_back(once[i + 1]);
    bytes.resize(bytes.size() + 2 * (count - 1), 0x77);
  }
  return bytes;
}

template <typename Number>
void Put(Bytes& bytes, std::size_t at, Number number, bool isSwapped = false)
{
  unsigned char octets[sizeof(Number)];
  std::memcpy(octets, &number, sizeof(Number));
  for (std::size_t i = 0; i < sizeof(Number); ++i)
  {
    bytes[at + i] = octets[isSwapped ? sizeof(Number) - 1 - i : i];
  }
}

Bytes MakeNiftiHead(int type, bool isSwapped, float slope, float intercept)
{
  Bytes head(352, 0);
  Put<std::int32_t>(head, 0, 348, isSwapped);
  const std::int16_t dim[5] = { 3, 20, 21, 16, 1 };
  for (std::size_t i = 0; i < 5; ++i)
  {
    Put<std::int16_t>(head, 40 + 2 * i, dim[i], isSwapped);
    Put<float>(head, 76 + 4 * i, 1.0f, isSwapped);
  }
  Put<std::int16_t>(head, 70, static_cast<std::int16_t>(type), isSwapped);
  Put<float>(head, 108, 352.0f, isSwapped);
  Put<float>(head, 112, slope, isSwapped);
  Put<float>(head, 116, intercept, isSwapped);
  std::memcpy(head.data() + 344, "n+1", 3);
  return head;
}

std::string WriteNifti(const std::string& path, const Bytes& head, const Bytes& samples, bool isPacked = false)
{
  Bytes bytes = head;
  Append(bytes, samples);
  WriteFile(path, isPacked ? Gzip(bytes) : bytes);
  return path;
}
}

TEST(VolumeSamples, TypesAndOrdersOfBytesAreThoseOfTheHeader)
{
  const Folder folder;
  for (const bool isBig : { false, true })
  {
    const std::string order = std::string("ElementByteOrderMSB = ") + (isBig ? "True\n" : "False\n");
    const std::string local = order + "ElementDataFile = LOCAL\n";
    const std::string end = std::string("endian: ") + (isBig ? "big" : "little") + "\nencoding: raw\n\n";
    ExpectEllipsoid(
      WriteAll(folder / "short.mha", MakeMeta("MET_SHORT", local), GetSamples<std::int16_t>(isBig)), Plain);
    ExpectEllipsoid(WriteAll(folder / "long.mha", MakeMeta("MET_LONG", local), GetSamples<std::int32_t>(isBig)), Plain);
    ExpectEllipsoid(WriteAll(folder / "float.mha", MakeMeta("MET_FLOAT", local), GetSamples<float>(isBig)), Plain);
    ExpectEllipsoid(WriteAll(folder / "double.nrrd", MakeNrrd("double", end), GetSamples<double>(isBig)), Plain);
    ExpectEllipsoid(
      WriteAll(folder / "long.nrrd", MakeNrrd("long long int", end), GetSamples<std::int64_t>(isBig)), Plain);
    ExpectEllipsoid(
      WriteNifti(folder / "int.nii", MakeNiftiHead(8, isBig, 0, 0), GetSamples<std::int32_t>(isBig)), Plain);
    ExpectEllipsoid(
      WriteNifti(folder / "packed.nii.gz", MakeNiftiHead(16, isBig, 1, 0), GetSamples<float>(isBig), true), Plain);
  }
}

TEST(VolumeSamples, EncodingsAreDecoded)
{
  const Folder folder;
  const Bytes shorts = GetSamples<std::int16_t>();
  const std::string little = "endian: little\n";
  ExpectEllipsoid(
    WriteAll(folder / "gzip.nrrd", MakeNrrd("short", little + "encoding: gzip\n\n"), Gzip(shorts)), Plain);
  // Two members one behind the other are one.
  Bytes members = Gzip(Bytes(shorts.begin(), shorts.begin() + 5001));
  Append(members, Gzip(Bytes(shorts.begin() + 5001, shorts.end())));
  ExpectEllipsoid(WriteAll(folder / "members.nrrd", MakeNrrd("short", little + "encoding: gz\n\n"), members), Plain);
  const Bytes none;
  ExpectEllipsoid(
    WriteAll(folder / "text.nrrd", MakeNrrd("short", "encoding: ascii\n\n") + MakeText(false), none), Plain);
  ExpectEllipsoid(
    WriteAll(folder / "hex.nrrd", MakeNrrd("short", little + "encoding: hex\n\n") + MakeText(true), none), Plain);
  ExpectEllipsoid(WriteAll(folder / "text.mha",
                    MakeMeta("MET_INT", "BinaryData = False\nElementDataFile = LOCAL\n") + MakeText(false), none),
    Plain);
  ExpectEllipsoid(WriteAll(folder / "packed.mha",
                    MakeMeta("MET_SHORT", "CompressedData = True\nElementDataFile = LOCAL\n"), Gzip(shorts)),
    Plain);
}

TEST(VolumeSamples, DataInFilesOfTheirOwnAreFound)
{
  const Folder folder;
  const Bytes shorts = GetSamples<std::int16_t>();
  const std::size_t slice = shorts.size() / 16;
  std::string names;
  for (std::size_t k = 0; k < 16; ++k)
  {
    const std::string name = "slice_" + std::string(k < 9 ? "0" : "") + std::to_string(k + 1) + ".raw";
    Bytes bytes(11, '\n'); // lines, to be skipped
    Append(bytes,
      Bytes(shorts.begin() + static_cast<std::ptrdiff_t>(k * slice),
        shorts.begin() + static_cast<std::ptrdiff_t>((k + 1) * slice)));
    WriteFile(folder / name, bytes);
    names += name + "\n";
  }
  const Bytes none;
  const std::string little = "endian: little\nencoding: raw\n";
  ExpectEllipsoid(
    WriteAll(folder / "list.mhd", MakeMeta("MET_SHORT", "HeaderSize = 11\nElementDataFile = LIST\n" + names), none),
    Plain);
  ExpectEllipsoid(WriteAll(folder / "numbered.mhd",
                    MakeMeta("MET_SHORT", "HeaderSize = -1\nElementDataFile = slice_%02d.raw 1 16 1\n"), none),
    Plain);
  ExpectEllipsoid(
    WriteAll(folder / "list.nhdr", MakeNrrd("short", little + "line skip: 11\ndata file: LIST 2\n" + names), none),
    Plain);
  ExpectEllipsoid(WriteAll(folder / "numbered.nhdr",
                    MakeNrrd("short", little + "byte skip: 11\ndata file: slice_%02d.raw 1 16 1 2\n"), none),
    Plain);
  // A header of NIfTI beside its samples, packed or not; either file names the pair.
  Bytes head = MakeNiftiHead(4, false, 0, 0);
  head.resize(348);
  Put<float>(head, 108, 0.0f);
  head[345] = 'i';
  WriteFile(folder / "pair.hdr", head);
  WriteFile(folder / "pair.img", shorts);
  WriteFile(folder / "packed.hdr.gz", Gzip(head));
  WriteFile(folder / "packed.img.gz", Gzip(shorts));
  for (const char* name : { "pair.hdr", "pair.img", "packed.hdr.gz", "packed.img.gz" })
  {
    EXPECT_TRUE(vtkMTVolumeReader::CanRead(folder / name)) << name;
    ExpectEllipsoid(folder / name, Plain);
  }
  WriteFile(folder / "picture.hdr", std::string("#?RADIANCE\n"));
  EXPECT_FALSE(vtkMTVolumeReader::CanRead(folder / "picture.hdr"));
}

TEST(VolumeSamples, AxesThatAreNotOfSpaceAreCountedAndPassedOver)
{
  const Folder folder;
  const MTVolumes::Read channels =
    ExpectEllipsoid(WriteAll(folder / "channels.mha",
                      MakeMeta("MET_SHORT", "ElementNumberOfChannels = 3\nElementDataFile = LOCAL\n"), Repeat(3)),
      Plain);
  EXPECT_EQ(channels.Report.at("volume_ignored_components"), 2);
  const std::string nrrd = "NRRD0004\ntype: short\ndimension: 4\nspace dimension: 3\nendian: little\nencoding: raw\n";
  const MTVolumes::Read vectors = ExpectEllipsoid(
    WriteAll(folder / "vectors.nrrd",
      nrrd +
        "sizes: 2 20 21 16\nspace directions: none (1,0,0) (0,1,0) (0,0,1)\nkinds: vector domain domain domain\n\n",
      Repeat(2)),
    Plain);
  EXPECT_EQ(vectors.Report.at("volume_ignored_components"), 1);
  Bytes frames = GetSamples<std::int16_t>();
  frames.resize(4 * frames.size(), 0x11);
  const MTVolumes::Read times =
    ExpectEllipsoid(WriteAll(folder / "times.nrrd",
                      nrrd + "sizes: 20 21 16 4\nspace directions: (1,0,0) (0,1,0) (0,0,1) none\n\n", frames),
      Plain);
  EXPECT_EQ(times.Report.at("volume_ignored_frames"), 3);
  Bytes head = MakeNiftiHead(4, false, 0, 0);
  Put<std::int16_t>(head, 40, 4);
  Put<std::int16_t>(head, 48, 4);
  EXPECT_EQ(
    ExpectEllipsoid(WriteNifti(folder / "times.nii.gz", head, frames, true), Plain).Report.at("volume_ignored_frames"),
    3);
}

TEST(VolumeSamples, ValuesAreScaledAsTheHeaderSays)
{
  const Folder folder;
  const Bytes shorts = GetSamples<std::int16_t>();
  const double scaled = 2.0 * MTVolumes::IsoValue - 1000.0;
  ExpectEllipsoid(WriteNifti(folder / "slope.nii", MakeNiftiHead(4, false, 2, -1000), shorts), Plain, scaled);
  ExpectEllipsoid(
    WriteNifti(folder / "slope.nii.gz", MakeNiftiHead(4, true, 2, -1000), GetSamples<std::int16_t>(true), true), Plain,
    scaled);
  // A slope of 0, or none at all, means none, whatever the intercept.
  ExpectEllipsoid(WriteNifti(folder / "zero.nii", MakeNiftiHead(4, false, 0, -1000), shorts), Plain);
  ExpectEllipsoid(WriteNifti(folder / "nan.nii", MakeNiftiHead(4, false, NAN, 5), shorts), Plain);
  ExpectEllipsoid(
    WriteAll(folder / "slope.mha",
      MakeMeta("MET_SHORT",
        "ElementToIntensityFunctionSlope = 2\nElementToIntensityFunctionOffset = -1000\nElementDataFile = LOCAL\n"),
      shorts),
    Plain, scaled);
  vtkNew<vtkPolyData> mesh;
  std::string error;
  EXPECT_FALSE(vtkMTVolumeReader::ReadIsosurface(folder / "slope.nii", 900.0, false, mesh, error));
  EXPECT_NE(error.find("and -200.000000"), std::string::npos) << error;
}

TEST(VolumeSamples, ANegativeSlopeTurnsWhatIsInsideOut)
{
  const Folder folder;
  const Bytes shorts = GetSamples<std::int16_t>();
  vtkNew<vtkPolyData> mesh;
  std::string error;
  const std::string path = WriteNifti(folder / "negative.nii", MakeNiftiHead(4, false, -1, 0), shorts);
  ASSERT_TRUE(vtkMTVolumeReader::ReadIsosurface(path, -MTVolumes::IsoValue, true, mesh, error)) << error;
  const double volume = MTVolumes::GetSignedVolume(mesh);
  std::printf("signed volume %g\n", volume);
  EXPECT_LT(volume, -900.0) << "the ellipsoid is a hollow in what is brighter";
}

TEST(VolumeSamples, DamagedFilesAreErrorsThatNameThem)
{
  const Folder folder;
  const Bytes shorts = GetSamples<std::int16_t>();
  const Bytes head = MakeNiftiHead(4, false, 0, 0);
  Bytes packed = Gzip(shorts);
  Bytes damaged = packed;
  damaged[damaged.size() / 2] ^= 0x40;
  Bytes checksum = packed;
  checksum[checksum.size() - 6] ^= 1;
  packed.resize(packed.size() / 2);
  const std::string gzip = MakeNrrd("short", "endian: little\nencoding: gzip\n\n");
  WriteAll(folder / "truncated.nrrd", gzip, packed);
  WriteAll(folder / "damaged.nrrd", gzip, damaged);
  WriteAll(folder / "checksum.nrrd", gzip, checksum);
  WriteAll(folder / "short.mha", MakeMeta("MET_INT", "ElementDataFile = LOCAL\n"), shorts);
  WriteAll(folder / "type.mha", MakeMeta("MET_STRING", "ElementDataFile = LOCAL\n"), shorts);
  WriteAll(folder / "text.nrrd", MakeNrrd("short", "encoding: text\n\n1 2 x"), Bytes(30000, ' '));
  WriteAll(folder / "bzip.nrrd", MakeNrrd("short", "encoding: bzip2\n\n"), shorts);
  WriteAll(folder / "pattern.mhd", MakeMeta("MET_SHORT", "ElementDataFile = %s%n%03d.raw 1 16 1\n"), Bytes());
  Bytes analyze = head;
  std::memset(analyze.data() + 344, 0, 4);
  WriteNifti(folder / "analyze.hdr", analyze, shorts);
  Bytes bits = head;
  Put<std::int16_t>(bits, 70, 1);
  WriteNifti(folder / "bits.nii", bits, shorts);
  Bytes alone = head;
  alone[345] = 'i';
  WriteFile(folder / "alone.hdr", alone);
  Bytes huge = head;
  Put<std::int16_t>(huge, 42, 32000);
  Put<std::int16_t>(huge, 44, 32000);
  Put<std::int16_t>(huge, 46, 32000);
  WriteNifti(folder / "huge.nii.gz", huge, shorts, true);
  vtkNew<vtkPolyData> mesh;
  for (const char* name : { "truncated.nrrd", "damaged.nrrd", "checksum.nrrd", "short.mha", "type.mha", "text.nrrd",
         "bzip.nrrd", "pattern.mhd", "analyze.hdr", "bits.nii", "alone.hdr", "huge.nii.gz" })
  {
    std::string error;
    EXPECT_FALSE(vtkMTVolumeReader::ReadIsosurface(folder / name, 200.0, false, mesh, error)) << name;
    EXPECT_NE(error.find(name), std::string::npos) << error;
    EXPECT_EQ(vtkMTVolumeReader::StreamIsosurface(folder / name, 200.0, error), nullptr) << name;
    std::printf("%s\n", error.substr(std::min(error.find(name), error.size())).c_str());
  }
  // Any octet of a header, set to something else: a surface or an error.
  for (std::size_t at = 0; at < 352; ++at)
  {
    Bytes other = head;
    other[at] = static_cast<unsigned char>(0x81 + 3 * at);
    std::string error;
    vtkMTVolumeReader::ReadIsosurface(
      WriteNifti(folder / "other.nii", other, shorts), MTVolumes::IsoValue, false, mesh, error);
  }
}
