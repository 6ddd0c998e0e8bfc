// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerifyText
 * @brief bytes, lines, words and numbers of an input file, for the verification's own readers
 *
 * A file may be compressed by gzip, whatever its name. Lines end with LF, CR or both; a byte order mark of UTF-8 is
 * skipped. Numbers are those of C in the "C" locale, in double precision, and what runtimes print for NaN and infinity
 * ("nan", "-inf", "1.#QNAN", "-1.#IND").
 */
#ifndef vtkMTVerifyText_h
#define vtkMTVerifyText_h

#include "vtkMTVerificationModule.h" // For export macro

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

class VTKMTVERIFICATION_EXPORT vtkMTVerifyText
{
public:
  /// The whole file. False when it cannot be read, which error says.
  static bool Load(const std::string& path, std::string& bytes, std::string& error);
  /// False, with the reason in error, when the text is none that is read here: UTF-16.
  static bool IsReadable(std::string_view bytes, std::string& error);
  static std::string_view SkipMark(std::string_view bytes);

  static std::vector<std::string_view> Split(std::string_view line);
  static bool ParseNumber(std::string_view word, double& value);
  static bool ParseInteger(std::string_view word, long long& value);
  static std::string ToLower(std::string_view text);
  /// The ending of a file's name without its dot, in lower case, without ".gz".
  static std::string GetEnding(const std::string& path);
  static std::string GetFolder(const std::string& path); ///< with the slash, or empty

  /// Goes through the lines of a text; the text must outlive it.
  explicit vtkMTVerifyText(std::string_view text)
    : Text(text)
  {
  }
  /// False at the end.
  bool Next(std::string_view& line);
  /// Where the next line begins.
  std::size_t GetPosition() const { return this->Position; }

private:
  std::string_view Text;
  std::size_t Position = 0;
};

#endif
