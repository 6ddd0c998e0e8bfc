// SPDX-License-Identifier: BSD-3-Clause
// What the readers of text formats share: buffered reading by lines or bytes, tokens and numbers. Not installed.
#ifndef vtkMTTextFormat_h
#define vtkMTTextFormat_h

#include "vtkMTByteSource.h"
#include "vtkMTIOCoreModule.h" // For export macro

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vtkMTTextFormat
{
/// What follows the last dot of the file's name, in lower case; empty when there is none.
VTKMTIOCORE_EXPORT std::string GetLowerCaseEnding(const std::string& path);

VTKMTIOCORE_EXPORT std::string ToLower(std::string_view text);

/// The next token, ended by white space, which is taken off the line; empty at the end.
VTKMTIOCORE_EXPORT std::string_view NextToken(std::string_view& line);

///@{
/// The whole token as a number, whatever the locale; false when it is none. A number too small becomes 0, one too large
/// is none. "1.#INF", "1.#IND", "1.#QNAN" and their like, which Windows writes, are infinity and NaN.
VTKMTIOCORE_EXPORT bool ToNumber(std::string_view token, double& value);
VTKMTIOCORE_EXPORT bool ToNumber(std::string_view token, float& value);
VTKMTIOCORE_EXPORT bool ToNumber(std::string_view token, std::int64_t& value);
///@}

/// Bytes of the byte order mark of UTF-8 that the text begins with: 3, or 0 where there is none.
VTKMTIOCORE_EXPORT std::size_t GetByteOrderMarkSize(std::string_view begin);

/// Whether a file that begins like this is text in UTF-16, with a byte order mark or without.
VTKMTIOCORE_EXPORT bool IsUtf16(std::string_view begin);

/// A byte source from front to end, in blocks.
class VTKMTIOCORE_EXPORT Stream
{
public:
  explicit Stream(const vtkMTByteSource& source);

  std::uint64_t GetPosition() const { return this->Offset + this->Next; }
  std::uint64_t GetLeft() const { return this->Source.GetSize() - this->GetPosition(); }
  bool IsAtEnd() const { return this->GetLeft() == 0; }

  /// The next count bytes, count being at most LargestPeek; valid until the next call. nullptr when there are not so
  /// many, or on failure.
  const unsigned char* Take(std::size_t count);
  bool Skip(std::uint64_t count);
  /// What has been read of the bytes that come next, perhaps nothing; valid until the next call.
  std::pair<const unsigned char*, std::size_t> GetBuffered() const
  {
    return { this->Buffer.data() + this->Next, this->Buffer.size() - this->Next };
  }

  /// The next line without its end (\n, \r\n or \r); valid until the next call. False at the end of the bytes, on
  /// failure and when the line is longer than LargestLine.
  bool TakeLine(std::string_view& line);

  enum LineEndType
  {
    NoEnd, ///< the bytes ended
    NewLine,
    Return,
    ReturnAndNewLine
  };
  /// How the last line ended.
  LineEndType GetLineEnd() const { return this->LineEnd; }
  /// Gives the newline back that was taken for a part of the last line's end.
  void GiveNewLineBack() { --this->Next; }

  /// Steps over a byte order mark of UTF-8, where one comes next.
  void SkipByteOrderMark();

  /// Why Take or TakeLine gave nothing; empty when the bytes are just at their end.
  const std::string& GetError() const { return this->Error; }

  static constexpr std::size_t LargestPeek = 256;
  static constexpr std::size_t LargestLine = std::size_t(1) << 24;

private:
  bool Fill();

  const vtkMTByteSource& Source;
  std::vector<unsigned char> Buffer;
  std::uint64_t Offset = 0; // of the buffer in the source
  std::size_t Next = 0;     // in the buffer
  LineEndType LineEnd = NoEnd;
  std::string Error;
};
}

#endif
