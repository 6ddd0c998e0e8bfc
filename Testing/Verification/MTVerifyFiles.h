// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the checker's readers share: bytes of files as format specifications have them, a folder for each
// test, and what is measured of a surface.
#ifndef MTVerifyFiles_h
#define MTVerifyFiles_h

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace MTVerifyFiles
{
template <typename Value>
void Put(std::string& bytes, Value value, bool isBig)
{
  char text[sizeof(Value)];
  std::memcpy(text, &value, sizeof(Value));
  if (isBig)
  {
    std::reverse(text, text + sizeof(Value));
  }
  bytes.append(text, sizeof(Value));
}

template <typename Value>
std::string Encode(const std::vector<double>& samples, bool isBig = false)
{
  std::string bytes;
  for (const double sample : samples)
  {
    Put(bytes, static_cast<Value>(sample), isBig);
  }
  return bytes;
}

/// Encoders of samples in the byte order given (true: big-endian): 8, 16, 32 and 64 bits, of each the signed and the
/// unsigned numbers, then float and double.
const std::array<std::function<std::string(const std::vector<double>&, bool)>, 10>& GetEncoders();

/// windowBits: 15 for zlib's format, 31 for gzip's.
std::string Compress(std::string text, int windowBits);
std::string ToText(const std::vector<double>& samples);
std::string ToHex(const std::string& bytes);

double GetSignedVolume(vtkPolyData* surface);
double GetArea(vtkPolyData* surface);
/// Parts that are connected by points.
std::size_t CountComponents(vtkPolyData* surface);

/// A test with an empty folder of its own.
class FolderTest : public testing::Test
{
protected:
  void SetUp() override;
  std::string Write(const std::string& name, const std::string& bytes) const;

  std::string Folder;
};

/// A folder of the shared reports, or empty where it is not there.
std::string GetReports();

/// The fields that tests set; all others are 0. Written after nifti1.h, or nifti2.h.
struct Nifti
{
  int Version = 1;
  bool IsBig = false;
  bool IsSingle = true;
  std::vector<std::int64_t> Dim{ 3, 8, 7, 6 };
  std::int16_t Type = 4;
  std::array<double, 4> Pixdim{ { 1, 1, 1, 1 } };
  double Slope = 0.0, Intercept = 0.0;
  int Qform = 0, Sform = 0;
  std::array<double, 6> Quatern{}; ///< b, c, d and the offsets
  std::array<double, 12> Rows{};

  template <typename Value>
  void Set(std::string& header, std::size_t at, Value value) const
  {
    std::string bytes;
    Put(bytes, value, this->IsBig);
    header.replace(at, bytes.size(), bytes);
  }
  void SetReal(std::string& header, std::size_t first, std::size_t second, std::size_t i, double value) const
  {
    this->Version == 1 ? this->Set(header, first + 4 * i, static_cast<float>(value))
                       : this->Set(header, second + 8 * i, value);
  }

  std::string ToHeader() const
  {
    const bool isFirst = this->Version == 1;
    std::string header(isFirst ? 352 : 544, '\0');
    this->Set<std::int32_t>(header, 0, isFirst ? 348 : 540);
    const std::string magic = std::string(this->IsSingle ? "n+" : "ni") + (isFirst ? "1" : "2");
    header.replace(isFirst ? 344 : 4, 3, magic);
    for (std::size_t i = 0; i < this->Dim.size(); ++i)
    {
      isFirst ? this->Set(header, 40 + 2 * i, static_cast<std::int16_t>(this->Dim[i]))
              : this->Set(header, 16 + 8 * i, this->Dim[i]);
    }
    this->Set(header, isFirst ? 70 : 12, this->Type);
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->SetReal(header, 76, 104, i, this->Pixdim[i]);
    }
    const double offset = this->IsSingle ? (isFirst ? 352.0 : 544.0) : 0.0;
    isFirst ? this->Set(header, 108, static_cast<float>(offset))
            : this->Set(header, 168, static_cast<std::int64_t>(offset));
    this->SetReal(header, 112, 176, 0, this->Slope);
    this->SetReal(header, 116, 184, 0, this->Intercept);
    isFirst ? this->Set(header, 252, static_cast<std::int16_t>(this->Qform)) : this->Set(header, 344, this->Qform);
    isFirst ? this->Set(header, 254, static_cast<std::int16_t>(this->Sform)) : this->Set(header, 348, this->Sform);
    for (std::size_t i = 0; i < 6; ++i)
    {
      this->SetReal(header, 256, 352, i, this->Quatern[i]);
    }
    for (std::size_t i = 0; i < 12; ++i)
    {
      this->SetReal(header, 280, 400, i, this->Rows[i]);
    }
    return header;
  }
};
}

#endif
