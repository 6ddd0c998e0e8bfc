// SPDX-License-Identifier: BSD-3-Clause
// The header of a PLY file. Not installed.
#ifndef vtkMTPlyHeader_h
#define vtkMTPlyHeader_h

#include "vtkMTInputReport.h"
#include "vtkMTTextFormat.h"

#include <cstdint>
#include <string>
#include <vector>

struct vtkMTPlyProperty
{
  std::string Name;
  int Type = 0;      // VTK_FLOAT and so on; of a list's items
  int CountType = 0; // of a list's count; 0: no list
  bool IsList() const { return this->CountType != 0; }
};

struct vtkMTPlyElement
{
  std::string Name;
  std::uint64_t Count = 0;
  std::vector<vtkMTPlyProperty> Properties;

  /// nullptr when there is none of that name.
  const vtkMTPlyProperty* Find(const std::string& name) const;
  /// The property vertex_indices, or vertex_index; nullptr when there is neither.
  const vtkMTPlyProperty* FindCorners() const;
};

struct vtkMTPlyHeader
{
  enum FormatType
  {
    Ascii,
    LittleEndian,
    BigEndian
  };
  FormatType Format = Ascii;
  std::vector<vtkMTPlyElement> Elements;
  std::vector<std::string> TextureFiles; ///< of lines "comment TextureFile NAME"
  std::uint64_t IgnoredLines = 0;        ///< that begin with no keyword of PLY
  std::uint64_t RenamedProperties = 0;   ///< of a name that the element has already: an underscore was appended

  /// Takes the header off the stream. False, with the reason and the line in error.
  bool Parse(vtkMTTextFormat::Stream& stream, std::string& error);

  /// Whether there is all that a mesh takes: places of vertices, corners of faces and strips. False with the reason in
  /// error.
  bool CheckIsMesh(std::string& error) const;

  /// What of it was ignored or changed.
  vtkMTInputReport GetReport() const;

  const vtkMTPlyElement* Find(const std::string& name) const;
  /// Bytes that a row takes at least.
  std::uint64_t GetSmallestRow(const vtkMTPlyElement& element) const;

  /// Bytes of a type in the binary formats.
  static std::size_t GetSize(int type);
  /// The format's word for a type; empty where it has none, as for integers of 64 bits.
  static const char* GetTypeName(int type);

private:
  bool ParseLines(vtkMTTextFormat::Stream& stream, std::string& error);
  bool ParseLine(std::string_view line, bool& isAtEnd, std::string& error);
  bool ParseFormat(std::string_view line, std::string& error);
  bool ParseElement(std::string_view line, std::string& error);
  bool ParseProperty(std::string_view line, std::string& error);

  bool HasFormat = false;
};

#endif
