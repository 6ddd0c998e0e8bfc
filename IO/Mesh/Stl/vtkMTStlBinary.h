// SPDX-License-Identifier: BSD-3-Clause
// The binary form of STL. Not installed.
#ifndef vtkMTStlBinary_h
#define vtkMTStlBinary_h

#include "vtkMTInputReport.h"
#include "vtkMTStlSolids.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkMTByteSource;
class vtkPolyData;

/**
 * A header of 80 bytes, a count, and 50 bytes for each triangle; several such solids may follow each other. A count
 * that is zero, or less than what the size says, gives way to the size where the records that follow are triangles.
 *
 * The last two bytes of a triangle are its colour in two dialects, five bits for each channel. VisCAM and SolidView:
 * bit 15 says that there is one, blue is in the lowest bits. Magics, where the header has "COLOR=" and the colour of
 * the whole: bit 15 says that there is none, red is in the lowest bits.
 */
class vtkMTStlBinary
{
public:
  /// The source must outlive this.
  explicit vtkMTStlBinary(const vtkMTByteSource& bytes);

  /// Whether the file has the size that its counts ask for.
  bool HasSize() const { return this->IsExact; }
  /// Looks at all attributes. False, with the reason in error, when the file is truncated or none of this form.
  bool Open(std::string& error);

  std::uint64_t GetNumberOfTriangles() const { return this->Triangles; }
  const vtkMTInputReport& GetReport() const { return this->Report; }

  /// The coordinates of so many triangles, nine each.
  bool ReadCoordinates(std::uint64_t first, std::uint64_t count, float* to, std::string& error) const;
  /// Their solids, where there are several, and their colours, where there are any, as cell arrays.
  bool ReadCells(std::uint64_t first, std::uint64_t count, vtkPolyData* to, std::string& error) const;

  static constexpr std::uint64_t HeadSize = 84;
  static constexpr std::uint64_t RecordSize = 50;

private:
  using Color = std::array<unsigned char, 3>;
  enum DialectType
  {
    NoColors,
    VisCam,
    Magics
  };
  struct Solid
  {
    std::uint64_t Offset = 0; // of the first record
    std::uint64_t First = 0;  // triangle
    std::uint64_t Count = 0;
    std::string Head;
    DialectType Dialect = NoColors;
    bool HasOwnColors = true; // false: all have the colour of the whole
    Color Whole{ 255, 255, 255 };
  };

  bool ReadHead(std::uint64_t offset, Solid& solid, std::string& error) const;
  bool FindSolids();
  bool FindRecords(std::string& error);
  bool AreTriangles(std::uint64_t first, std::uint64_t count) const;
  bool LookAtAttributes(Solid& solid, std::string& error);
  static Color GetColor(const Solid& solid, unsigned attribute);
  // Calls use(triangle, record) for each.
  template <class Use>
  bool ForEachRecord(std::uint64_t first, std::uint64_t count, std::string& error, Use&& use) const;

  const vtkMTByteSource& Bytes;
  std::vector<Solid> Solids;
  vtkMTStlSolids Names;
  vtkMTInputReport Report;
  std::uint64_t Triangles = 0;
  bool IsExact = false;
  bool HasColors = false;
};

#endif
