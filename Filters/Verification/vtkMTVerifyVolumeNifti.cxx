// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyVolumeNifti.h"

#include "vtkMTVerifyVolumeBytes.h"

#include <cmath>
#include <cstring>
#include <fstream>

using namespace vtkMTVerifyVolumeBytes;

namespace
{
constexpr std::size_t FirstSize = 348;
constexpr std::size_t SecondSize = 540;

/// VTK's type for the format's code of one; VTK_VOID for those that are no plain number.
int GetType(std::int64_t code)
{
  switch (code)
  {
    case 2:
      return VTK_TYPE_UINT8;
    case 4:
      return VTK_TYPE_INT16;
    case 8:
      return VTK_TYPE_INT32;
    case 16:
      return VTK_TYPE_FLOAT32;
    case 64:
      return VTK_TYPE_FLOAT64;
    case 256:
      return VTK_TYPE_INT8;
    case 512:
      return VTK_TYPE_UINT16;
    case 768:
      return VTK_TYPE_UINT32;
    case 1024:
      return VTK_TYPE_INT64;
    case 1280:
      return VTK_TYPE_UINT64;
    default:
      return VTK_VOID;
  }
}
}

vtkMTVerifyVolumeNifti::vtkMTVerifyVolumeNifti(const std::string& path, vtkMTVerifyVolumeHeader& header)
  : Path(path)
  , Header(header)
{
}

bool vtkMTVerifyVolumeNifti::Parse(std::string& error)
{
  // Of a pair the header's file is read, whichever was named.
  std::string path = this->Path;
  if (EndsWith(path, ".img") || EndsWith(path, ".img.gz"))
  {
    const std::size_t letters = path.size() - (EndsWith(path, ".gz") ? 6 : 3);
    path.replace(letters, 3, path[letters] == 'I' ? "HDR" : "hdr");
  }
  this->Header.Facts.Reader = "the checker's NIfTI reader";
  this->Path = path;
  // A truncated gzip file is found when its samples are read; what was inflated of the header counts here.
  if (!ReadInflated(path, SecondSize, this->Bytes, error) && this->Bytes.size() < FirstSize)
  {
    return false;
  }
  error.clear();
  return this->FindVersion(error) && this->ParseSizes(error) && this->ParseType(error) && this->ParsePlace(error) &&
    this->ParseFiles(error);
}

bool vtkMTVerifyVolumeNifti::FindVersion(std::string& error)
{
  const std::size_t size = this->Bytes.size();
  for (const bool isBig : { false, true })
  {
    const std::int32_t length = size < FirstSize ? 0 : Get<std::int32_t>(this->Bytes.data(), isBig);
    if (length == static_cast<std::int32_t>(FirstSize) ||
      (length == static_cast<std::int32_t>(SecondSize) && size >= SecondSize))
    {
      this->Header.IsBigEndian = isBig;
      this->IsSecond = length == static_cast<std::int32_t>(SecondSize);
      const char* magic = reinterpret_cast<const char*>(this->Bytes.data()) + (this->IsSecond ? 4 : 344);
      const char version = this->IsSecond ? '2' : '1';
      if (magic[0] == 'n' && (magic[1] == '+' || magic[1] == 'i') && magic[2] == version && magic[3] == '\0')
      {
        this->IsSingle = magic[1] == '+';
        return true;
      }
      return this->Header.Refuse("Analyze 7.5 (a header without NIfTI's magic)", error);
    }
  }
  error = "its header is not NIfTI's";
  return false;
}

double vtkMTVerifyVolumeNifti::GetReal(std::size_t inFirst, std::size_t inSecond, std::size_t index) const
{
  const bool isBig = this->Header.IsBigEndian;
  return this->IsSecond ? Get<double>(this->Bytes.data() + inSecond + 8 * index, isBig)
                        : Get<float>(this->Bytes.data() + inFirst + 4 * index, isBig);
}

std::int64_t vtkMTVerifyVolumeNifti::GetSize(std::size_t index) const
{
  const bool isBig = this->Header.IsBigEndian;
  return this->IsSecond ? Get<std::int64_t>(this->Bytes.data() + 16 + 8 * index, isBig)
                        : Get<std::int16_t>(this->Bytes.data() + 40 + 2 * index, isBig);
}

std::int64_t vtkMTVerifyVolumeNifti::GetCode(std::size_t inFirst, std::size_t inSecond) const
{
  const bool isBig = this->Header.IsBigEndian;
  return this->IsSecond ? Get<std::int32_t>(this->Bytes.data() + inSecond, isBig)
                        : Get<std::int16_t>(this->Bytes.data() + inFirst, isBig);
}

bool vtkMTVerifyVolumeNifti::ParseSizes(std::string& error)
{
  const std::int64_t dimensions = this->GetSize(0);
  if (dimensions < 1 || dimensions > 7)
  {
    error = "dim[0] is " + std::to_string(dimensions) + ", not 1 to 7";
    return false;
  }
  std::vector<std::int64_t> sizes;
  for (std::int64_t i = 1; i <= dimensions; ++i)
  {
    sizes.push_back(this->GetSize(static_cast<std::size_t>(i)));
  }
  // The fifth size is that of the values of one sample.
  if (dimensions > 4 && sizes[4] > 1)
  {
    return this->Header.Refuse("NIfTI with several values for each sample", error);
  }
  return this->Header.SetSizes(sizes, error);
}

bool vtkMTVerifyVolumeNifti::ParseType(std::string& error)
{
  const bool isBig = this->Header.IsBigEndian;
  const std::int64_t code = Get<std::int16_t>(this->Bytes.data() + (this->IsSecond ? 12 : 70), isBig);
  this->Header.Type = GetType(code);
  if (this->Header.Type == VTK_VOID)
  {
    return this->Header.Refuse("NIfTI's datatype " + std::to_string(code), error);
  }
  const double slope = this->GetReal(112, 176);
  const double intercept = this->GetReal(116, 184);
  if (slope != 0.0 && std::isfinite(slope) && std::isfinite(intercept))
  {
    this->Header.Slope = slope;
    this->Header.Intercept = intercept;
  }
  return true;
}

bool vtkMTVerifyVolumeNifti::ParsePlace(std::string& error)
{
  double steps[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    steps[i] = this->GetReal(76, 104, i + 1);
  }
  vtkMTVerifyVolumeInput::Facts& facts = this->Header.Facts;
  const std::int64_t sform = this->GetCode(254, 348);
  const std::int64_t qform = this->GetCode(252, 344);
  if (sform > 0)
  {
    this->ParseRows();
    facts.Frame = "RAS";
  }
  else if (qform > 0)
  {
    this->ParseQuaternion(steps);
    facts.Frame = "RAS";
  }
  else
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Header.SetAxis(i, i == 0 ? steps[0] : 0.0, i == 1 ? steps[1] : 0.0, i == 2 ? steps[2] : 0.0);
    }
    facts.Notes.emplace_back("Neither sform_code nor qform_code is above 0: voxel sizes alone place the samples.");
  }
  for (const double value : facts.IndexToWorld)
  {
    if (!std::isfinite(value))
    {
      error = "the map from indices to the world is not finite";
      return false;
    }
  }
  return true;
}

void vtkMTVerifyVolumeNifti::ParseQuaternion(const double (&steps)[3])
{
  const double b = this->GetReal(256, 352);
  const double c = this->GetReal(260, 360);
  const double d = this->GetReal(264, 368);
  // a is what makes the quaternion one of length 1; where b, c, d are longer than that, they are normalized and a is 0.
  const double square = b * b + c * c + d * d;
  const double length = square > 1.0 ? std::sqrt(square) : 1.0;
  const double q[4] = { square > 1.0 ? 0.0 : std::sqrt(1.0 - square), b / length, c / length, d / length };
  const double rotation[3][3] = {
    { q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3], 2 * (q[1] * q[2] - q[0] * q[3]),
      2 * (q[1] * q[3] + q[0] * q[2]) },
    { 2 * (q[1] * q[2] + q[0] * q[3]), q[0] * q[0] + q[2] * q[2] - q[1] * q[1] - q[3] * q[3],
      2 * (q[2] * q[3] - q[0] * q[1]) },
    { 2 * (q[1] * q[3] - q[0] * q[2]), 2 * (q[2] * q[3] + q[0] * q[1]),
      q[0] * q[0] + q[3] * q[3] - q[1] * q[1] - q[2] * q[2] },
  };
  // pixdim[0] is qfac; 0 counts as 1.
  const double qfac = this->GetReal(76, 104) < 0.0 ? -1.0 : 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = axis == 2 ? qfac * steps[axis] : steps[axis];
    this->Header.SetAxis(axis, step * rotation[0][axis], step * rotation[1][axis], step * rotation[2][axis]);
  }
  this->Header.SetOrigin(this->GetReal(268, 376), this->GetReal(272, 384), this->GetReal(276, 392));
}

void vtkMTVerifyVolumeNifti::ParseRows()
{
  for (std::size_t i = 0; i < 12; ++i)
  {
    this->Header.Facts.IndexToWorld[i] = this->GetReal(280, 400, i);
  }
}

bool vtkMTVerifyVolumeNifti::ParseFiles(std::string& error)
{
  const bool isBig = this->Header.IsBigEndian;
  const double offset = this->IsSecond ? static_cast<double>(Get<std::int64_t>(this->Bytes.data() + 168, isBig))
                                       : static_cast<double>(Get<float>(this->Bytes.data() + 108, isBig));
  const double least = !this->IsSingle ? 0.0 : this->IsSecond ? 544.0 : 352.0;
  // Some writers leave 0: the samples of a single file begin behind the header all the same.
  const double from = offset == 0.0 ? least : offset;
  if (!(from >= (this->IsSingle ? (this->IsSecond ? 540.0 : 348.0) : 0.0) && from < 1e15))
  {
    error = "vox_offset is " + std::to_string(offset) + ", within the header";
    return false;
  }
  this->Header.ByteSkip = static_cast<std::int64_t>(from);
  std::string path = this->Path;
  if (!this->IsSingle)
  {
    const std::size_t letters = EndsWith(path, ".gz") ? path.size() - 6 : path.size() - 3;
    path.replace(letters, 3, path[letters] == 'H' ? "IMG" : "img");
    if (!std::ifstream(path).good() && !EndsWith(path, ".gz"))
    {
      path += ".gz";
    }
  }
  this->Header.Files.push_back({ path, 0 });
  vtkMTVerifyVolumeBytes::Bytes magic;
  if (!ReadFile(path, magic, error, 4))
  {
    return false;
  }
  this->Header.Encoding =
    IsGzip(magic) ? vtkMTVerifyVolumeHeader::Encodings::Deflate : vtkMTVerifyVolumeHeader::Encodings::Raw;
  return true;
}
