// SPDX-License-Identifier: BSD-3-Clause
// One accessor of a glTF file: its description, checked, and its values, block by block. Not installed.
//
// Values of all types come as double, which holds every one of them exactly; normalized integers come as numbers from 0
// or -1 to 1. Interleaved and sparse accessors, and those without a view (zeros), are read the same way. Everything is
// checked against the lengths of views and buffers before a value is read: an accessor without a view may not be longer
// than the buffers have bytes. All functions throw vtkMTGltfJson::Error.
#ifndef vtkMTGltfAccessor_h
#define vtkMTGltfAccessor_h

#include "vtkMTGltfFile.h"

#include <functional>

class vtkMTGltfAccessor
{
public:
  /// Called with the first element of a block, the number of elements, and their values.
  using Consumer = std::function<void(std::uint64_t first, std::size_t count, const double* values)>;

  /// glTF's numbers of types.
  enum ComponentType
  {
    Byte = 5120,
    UnsignedByte = 5121,
    Short = 5122,
    UnsignedShort = 5123,
    Int = 5124, // of Draco's attributes alone
    UnsignedInt = 5125,
    Float = 5126
  };

  /// How elements lie in their bytes.
  struct Layout
  {
    int Type = Float;
    bool IsNormalized = false;
    std::size_t Rows = 1; // of a matrix; a vector is one column
    std::size_t Columns = 1;
    std::uint64_t Stride = 0;

    static std::size_t GetSize(int type);
    std::size_t GetComponents() const { return this->Rows * this->Columns; }
    /// Columns of matrices begin at multiples of four bytes.
    std::size_t GetColumnSize() const;
    std::size_t GetElementSize() const;
    void Convert(const unsigned char* from, std::size_t count, double* to) const;
  };

  vtkMTGltfAccessor(vtkMTGltfFile& file, std::size_t index);

  const std::string& GetName() const { return this->Where; }
  std::uint64_t GetCount() const { return this->Count; }
  const Layout& GetLayout() const { return this->Values.How; }
  std::size_t GetComponents() const { return this->Values.How.GetComponents(); }
  /// Whether values have a fraction: floating point, or normalized.
  bool IsReal() const { return this->Values.How.Type == Float || this->Values.How.IsNormalized; }
  /// The bounds that it states of itself, as values are read; false where it states none.
  bool GetBounds(std::vector<double>& least, std::vector<double>& largest) const;
  bool HasView() const { return this->Values.View != None; }

  void Read(vtkMTGltfFile& file, const Consumer& consumer) const;

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  // Elements in a view.
  struct Elements
  {
    std::size_t View = None;
    std::uint64_t Offset = 0;
    Layout How;
  };
  static void SetType(const vtkMTGltfJson::Json& object, Layout& layout, const std::string& where);
  Elements FindElements(
    vtkMTGltfFile& file, const vtkMTGltfJson::Json& object, Layout layout, std::uint64_t count, bool isStrided) const;
  void AddSparse(vtkMTGltfFile& file, const vtkMTGltfJson::Json& sparse);
  void ReadElements(vtkMTGltfFile& file, const Elements& elements, std::uint64_t count, const Consumer& consumer) const;
  void ReadSparse(vtkMTGltfFile& file, std::vector<std::uint64_t>& indices, std::vector<double>& values) const;

  std::string Where;
  std::uint64_t Count = 0;
  Elements Values;
  std::uint64_t SparseCount = 0;
  Elements SparseIndices;
  Elements SparseValues;
  std::vector<double> Least;
  std::vector<double> Largest;
};

#endif
