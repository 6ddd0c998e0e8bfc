// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyVolumeBytes
 * @brief bytes of files, inflated where they are compressed, and words of text, for the checker's own readers
 *
 * Nothing here is shared with the readers that the builder uses.
 */
#ifndef vtkMTVerifyVolumeBytes_h
#define vtkMTVerifyVolumeBytes_h

#include "vtkMTVerificationModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace vtkMTVerifyVolumeBytes
{
using Bytes = std::vector<unsigned char>;

constexpr std::size_t NoLimit = std::numeric_limits<std::size_t>::max();

/// The first limit bytes of the file, all of it where it has fewer. False with the reason in error.
VTKMTVERIFICATION_EXPORT bool ReadFile(
  const std::string& path, Bytes& bytes, std::string& error, std::size_t limit = NoLimit);

/// Whether the bytes begin as gzip's format does.
VTKMTVERIFICATION_EXPORT bool IsGzip(const Bytes& bytes);

/**
 * Inflates gzip (also of several members) or zlib data, up to limit bytes. False with the reason in error where the
 * data is damaged or ends early; what was inflated until then is in out.
 */
VTKMTVERIFICATION_EXPORT bool Inflate(
  const unsigned char* data, std::size_t size, std::size_t limit, Bytes& out, std::string& error);

/// ReadFile, and Inflate where the file is gzip's.
VTKMTVERIFICATION_EXPORT bool ReadInflated(
  const std::string& path, std::size_t limit, Bytes& bytes, std::string& error);

/// The value of the bytes at place, which must be within, in the byte order given.
template <typename Value>
Value Get(const unsigned char* place, bool isBigEndian);

VTKMTVERIFICATION_EXPORT std::string Trim(const std::string& text);
VTKMTVERIFICATION_EXPORT std::string ToLower(std::string text);
/// The words between blanks.
VTKMTVERIFICATION_EXPORT std::vector<std::string> Split(const std::string& text);
/// All words as numbers; false where one is none.
VTKMTVERIFICATION_EXPORT bool ToNumbers(const std::vector<std::string>& words, std::vector<double>& numbers);
VTKMTVERIFICATION_EXPORT bool EndsWith(const std::string& path, const std::string& lowerCaseEnding);
/// A name in the folder of path, or the name itself where it is absolute.
VTKMTVERIFICATION_EXPORT std::string Beside(const std::string& path, const std::string& name);
/// One name for every number from first to last; the pattern is printf's with one %d, %i or %u. False where it is not.
VTKMTVERIFICATION_EXPORT bool ExpandPattern(
  const std::string& pattern, const std::int64_t (&firstLastStep)[3], std::vector<std::string>& names);
}

template <typename Value>
Value vtkMTVerifyVolumeBytes::Get(const unsigned char* place, bool isBigEndian)
{
  const std::uint16_t one = 1;
  const bool isHostBig = *reinterpret_cast<const unsigned char*>(&one) == 0;
  Value value;
  auto* bytes = reinterpret_cast<unsigned char*>(&value);
  for (std::size_t i = 0; i < sizeof(Value); ++i)
  {
    bytes[i] = place[isBigEndian == isHostBig ? i : sizeof(Value) - 1 - i];
  }
  return value;
}

#endif
