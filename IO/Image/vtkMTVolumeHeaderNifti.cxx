// SPDX-License-Identifier: BSD-3-Clause
// The header of NIfTI-1 (348 bytes) and NIfTI-2 (540 bytes).
#include "vtkMTVolumeHeader.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTInflate.h"
#include "vtkMTTextFormat.h"
#include "vtkMTVolumeFormat.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <iterator>

struct vtkMTVolumeHeader::Nifti
{
  std::vector<unsigned char> Bytes;
  bool IsSwapped = false;
  bool IsSecond = false; // NIfTI-2

  template <typename Number>
  double Take(std::size_t at) const
  {
    unsigned char bytes[sizeof(Number)];
    std::memcpy(bytes, this->Bytes.data() + at, sizeof(Number));
    if (this->IsSwapped)
    {
      std::reverse(std::begin(bytes), std::end(bytes));
    }
    Number number;
    std::memcpy(&number, bytes, sizeof(Number));
    return static_cast<double>(number);
  }

  // A field's place in either version, a real number of 32 or 64 bits, a whole one of 16 or 64 or of 32 bits.
  double Real(std::size_t first, std::size_t second, std::size_t index = 0) const
  {
    return this->IsSecond ? this->Take<double>(second + 8 * index) : this->Take<float>(first + 4 * index);
  }
  double Whole(std::size_t first, std::size_t second, std::size_t index = 0) const
  {
    return this->IsSecond ? this->Take<std::int64_t>(second + 8 * index) : this->Take<std::int16_t>(first + 2 * index);
  }
  int Code(std::size_t first, std::size_t second) const
  {
    return static_cast<int>(this->IsSecond ? this->Take<std::int32_t>(second) : this->Take<std::int16_t>(first));
  }
  int GetDatatype() const { return static_cast<int>(this->Take<std::int16_t>(this->IsSecond ? 12 : 70)); }
  int GetUnits() const { return this->IsSecond ? static_cast<int>(this->Take<std::int32_t>(500)) : this->Bytes[123]; }

  // The size of the header, which is its first number, in either order of bytes; 0 where it is neither.
  static std::size_t FindSize(const unsigned char* bytes, bool& isSwapped)
  {
    const std::uint32_t little = bytes[0] | bytes[1] << 8 | bytes[2] << 16 | std::uint32_t(bytes[3]) << 24;
    const std::uint32_t big = bytes[3] | bytes[2] << 8 | bytes[1] << 16 | std::uint32_t(bytes[0]) << 24;
    const std::uint16_t one = 1;
    unsigned char first = 0;
    std::memcpy(&first, &one, 1);
    for (const bool isBig : { false, true })
    {
      const std::uint32_t size = isBig ? big : little;
      if (size == 348 || size == 540)
      {
        isSwapped = isBig == (first == 1);
        return size;
      }
    }
    return 0;
  }

  bool Read(const vtkMTByteSource& source, bool isPacked, std::string& error)
  {
    this->Bytes.resize(348);
    const auto read = [&]
    {
      return isPacked ? vtkMTInflate(source, 0, 0, this->Bytes.size(), this->Bytes.data(), false, error)
                      : source.Read(0, this->Bytes.size(), this->Bytes.data(), error);
    };
    if (!read())
    {
      return false;
    }
    const std::size_t size = FindSize(this->Bytes.data(), this->IsSwapped);
    this->IsSecond = size == 540;
    this->Bytes.resize(std::max<std::size_t>(size, 348));
    if (size == 0 || (this->IsSecond && !read()))
    {
      error = size == 0 ? "is no NIfTI file: its first number is neither 348 nor 540" : error;
      return false;
    }
    const std::string magic(reinterpret_cast<const char*>(this->Bytes.data()) + (this->IsSecond ? 4 : 344), 3);
    if (magic != (this->IsSecond ? "n+2" : "n+1") && magic != (this->IsSecond ? "ni2" : "ni1"))
    {
      error = "has the header of ANALYZE 7.5, which does not say how the volume lies; convert it to NIfTI";
      return false;
    }
    return true;
  }
  /// Colours are not scaled.
  bool IsColor() const { return this->GetDatatype() == 128 || this->GetDatatype() == 2304; }
  /// Header and samples in one file; else these are in another one.
  bool IsWhole() const { return this->Bytes[(this->IsSecond ? 4 : 344) + 1] == '+'; }

  // The type of elements and how many of them are one sample.
  bool FindType(int& type, double& elements, std::string& error) const
  {
    static const struct
    {
      int Code;
      int Type;
      int Elements;
    } types[] = { { 2, VTK_UNSIGNED_CHAR, 1 }, { 4, VTK_SHORT, 1 }, { 8, VTK_INT, 1 }, { 16, VTK_FLOAT, 1 },
      { 32, VTK_FLOAT, 2 }, { 64, VTK_DOUBLE, 1 }, { 128, VTK_UNSIGNED_CHAR, 3 }, { 256, VTK_SIGNED_CHAR, 1 },
      { 512, VTK_UNSIGNED_SHORT, 1 }, { 768, VTK_UNSIGNED_INT, 1 }, { 1024, VTK_LONG_LONG, 1 },
      { 1280, VTK_UNSIGNED_LONG_LONG, 1 }, { 1792, VTK_DOUBLE, 2 }, { 2304, VTK_UNSIGNED_CHAR, 4 } };
    const int code = this->GetDatatype();
    for (const auto& known : types)
    {
      if (known.Code == code)
      {
        type = known.Type;
        elements = known.Elements;
        return true;
      }
    }
    error = "its datatype " + std::to_string(code) + " is none that is read (bits and numbers of 128 bits are not)";
    return false;
  }

  // Method 3 of the format: the matrix as it stands.
  vtkMTVolumePlace GetSform() const
  {
    vtkMTVolumePlace place;
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        place.Axes[axis][row] = this->Real(280, 400, 4 * row + axis);
      }
      place.Origin[row] = this->Real(280, 400, 4 * row + 3);
    }
    return place;
  }

  // Method 2: a rotation by a quaternion of length 1, the third axis reversed where qfac, pixdim[0], is negative.
  vtkMTVolumePlace GetQform(const std::array<double, 3>& steps) const
  {
    double b = this->Real(256, 352, 0);
    double c = this->Real(256, 352, 1);
    double d = this->Real(256, 352, 2);
    const double square = b * b + c * c + d * d;
    double a = 0.0;
    if (square < 1.0 - 1e-7)
    {
      a = std::sqrt(1.0 - square);
    }
    else // a half turn, rounded
    {
      const double length = std::sqrt(square);
      b /= length;
      c /= length;
      d /= length;
    }
    const double qfac = this->Real(76, 104) < 0.0 ? -1.0 : 1.0;
    const double r[3][3] = { { a * a + b * b - c * c - d * d, 2 * b * c - 2 * a * d, 2 * b * d + 2 * a * c },
      { 2 * b * c + 2 * a * d, a * a + c * c - b * b - d * d, 2 * c * d - 2 * a * b },
      { 2 * b * d - 2 * a * c, 2 * c * d + 2 * a * b, a * a + d * d - c * c - b * b } };
    vtkMTVolumePlace place;
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        place.Axes[axis][row] = r[row][axis] * steps[axis] * (axis == 2 ? qfac : 1.0);
      }
      place.Origin[row] = this->Real(268, 376, row);
    }
    return place;
  }

  static std::string GetFrameName(int code)
  {
    static const char* const names[] = { "RAS", "RAS scanner", "RAS aligned", "RAS Talairach", "RAS MNI 152",
      "RAS template" };
    return names[code >= 1 && code <= 5 ? code : 0];
  }

  void FindPlace(vtkMTVolumeHeader& header) const
  {
    std::array<double, 3> steps{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      steps[axis] = std::abs(header.UseSpacing(this->Real(76, 104, axis + 1)));
    }
    const int qcode = this->Code(252, 344);
    const int scode = this->Code(254, 348);
    const vtkMTVolumePlace qform = this->GetQform(steps);
    const vtkMTVolumePlace sform = this->GetSform();
    const bool isSform = scode > 0 && sform.IsSound();
    const bool isQform = qcode > 0 && qform.IsSound();
    if (isSform || isQform)
    {
      header.Place = isSform ? sform : qform;
      header.Place.World.Crs = GetFrameName(isSform ? scode : qcode);
      header.Report.erase(isSform ? "volume_filled_spacings" : ""); // the matrix has its own
    }
    else // method 1: the voxels' sizes alone
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        header.Place.Axes[axis][axis] = steps[axis];
      }
    }
    const auto ignore = [&header](const char* name, bool isIgnored)
    {
      if (isIgnored)
      {
        header.Report[name] = 1;
      }
    };
    ignore("volume_ignored_sform", scode > 0 && !isSform);
    ignore("volume_ignored_qform", qcode > 0 && (isSform ? this->Differ(sform, qform) : !isQform));
    const char* const units[] = { "", "m", "mm", "um" };
    const int unit = this->GetUnits() & 7;
    header.Place.World.Units = unit < 4 ? units[unit] : "";
  }

  // By more than a thousandth of a voxel, anywhere in the volume.
  bool Differ(const vtkMTVolumePlace& a, const vtkMTVolumePlace& b) const
  {
    double most = 0.0;
    const double voxel = std::sqrt(vtkMTVolumePlace::Dot(a.Axes[0], a.Axes[0]));
    for (int corner = 0; corner < 8; ++corner)
    {
      const vtkMTVolumePlace::Vector index{ corner & 1 ? this->Whole(40, 16, 1) : 0.0,
        corner & 2 ? this->Whole(40, 16, 2) : 0.0, corner & 4 ? this->Whole(40, 16, 3) : 0.0 };
      const vtkMTVolumePlace::Vector p = a.ToWorld(index);
      const vtkMTVolumePlace::Vector q = b.ToWorld(index);
      for (std::size_t i = 0; i < 3; ++i)
      {
        most = std::max(most, std::abs(p[i] - q[i]));
      }
    }
    return !(most <= 1e-3 * voxel);
  }

  bool FindSizes(double elements, std::vector<double>& sizes, std::string& error) const
  {
    const double axes = this->Whole(40, 16);
    if (!(axes >= 3.0 && axes <= 7.0))
    {
      error = "is no volume: dim[0] must give three axes or more, at most seven";
      return false;
    }
    sizes.push_back(elements);
    for (std::size_t axis = 1; axis <= static_cast<std::size_t>(axes); ++axis)
    {
      sizes.push_back(axis > 3 ? std::max(this->Whole(40, 16, axis), 1.0) : this->Whole(40, 16, axis));
    }
    return true;
  }
};

namespace
{
bool IsPacked(const std::string& path)
{
  return vtkMTTextFormat::GetLowerCaseEnding(path) == "gz";
}

// The other file of a pair, in the same case, packed or not; empty where there is none.
std::string FindPartner(const std::string& path, const std::string& ending)
{
  const std::string stem = path.substr(0, path.size() - vtkMTVolumeFormat::GetEnding(path).size());
  std::string upper = ending;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
  for (const std::string& name : { ending, ending + ".gz", upper, upper + ".gz", upper + ".GZ" })
  {
    std::error_code code;
    if (std::filesystem::is_regular_file(stem + name, code))
    {
      return stem + name;
    }
  }
  return "";
}
}

bool vtkMTVolumeHeader::CanRead(const std::string& path)
{
  static const char* const endings[] = { "mhd", "mha", "nrrd", "nhdr", "nii", "nii.gz" };
  const std::string ending = vtkMTVolumeFormat::GetEnding(path);
  if (std::find(std::begin(endings), std::end(endings), ending) != std::end(endings))
  {
    return true;
  }
  const std::string base = ending.substr(0, 3);
  if ((base != "hdr" && base != "img") || (ending != base && ending != base + ".gz"))
  {
    return false;
  }
  std::string error;
  const std::string header = base == "hdr" ? path : FindPartner(path, "hdr");
  const auto source = header.empty() ? nullptr : vtkMTFileByteSource::Open(header, error);
  unsigned char bytes[4];
  bool isSwapped = false;
  return source &&
    (IsPacked(header) ? vtkMTInflate(*source, 0, 0, 4, bytes, false, error) : source->Read(0, 4, bytes, error)) &&
    Nifti::FindSize(bytes, isSwapped) > 0;
}

bool vtkMTVolumeHeader::ReadNifti(const std::string& path, std::string& error)
{
  const std::string ending = vtkMTVolumeFormat::GetEnding(path);
  const std::string name = ending.rfind("img", 0) == 0 ? FindPartner(path, "hdr") : path;
  this->Path = name;
  const auto source = vtkMTFileByteSource::Open(name, error);
  Nifti fields;
  double elements = 1.0;
  std::vector<double> sizes;
  if (!source || !fields.Read(*source, IsPacked(name), error) || !fields.FindType(this->Type, elements, error) ||
    !fields.FindSizes(elements, sizes, error) || !this->SetAxes(sizes, { 1, 2, 3 }, error))
  {
    return false;
  }
  const std::string data = fields.IsWhole() ? name : ending.rfind("img", 0) == 0 ? path : FindPartner(name, "img");
  // A file of header and samples has four bytes of extension flags at least between them.
  const double least = fields.IsWhole() ? (fields.IsSecond ? 544.0 : 352.0) : 0.0;
  const double offset = std::max(fields.IsSecond ? fields.Take<std::int64_t>(168) : fields.Take<float>(108), least);
  if (data.empty() || !(offset < 1e15))
  {
    error = data.empty() ? "there is no .img file with its samples beside it" : "its vox_offset is no place in a file";
    return false;
  }
  this->Encoding = IsPacked(data) ? Deflated : Raw;
  this->DecodedSkip = this->Encoding == Deflated ? static_cast<std::uint64_t>(offset) : 0;
  this->Files.push_back({ data, this->Encoding == Raw ? static_cast<std::uint64_t>(offset) : 0 });
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  this->IsBigEndian = fields.IsSwapped == (first == 1);
  fields.FindPlace(*this);
  const double slope = fields.Real(112, 176);
  const double intercept = fields.Real(116, 184);
  if (std::isfinite(slope) && slope != 0.0 && !fields.IsColor())
  {
    this->Slope = slope;
    this->Intercept = std::isfinite(intercept) ? intercept : 0.0;
  }
  return true;
}
