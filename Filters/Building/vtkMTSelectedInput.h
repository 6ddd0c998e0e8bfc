// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSelectedInput
 * @brief a stream in front of another one, for what a file is built from: only the arrays that are wanted
 *
 * What was counted while the input was opened is added to the report, and files that change while they are read are an
 * error: the model would be of neither state.
 */
#ifndef vtkMTSelectedInput_h
#define vtkMTSelectedInput_h

#include "vtkMTBuildingModule.h" // For export macro
#include "vtkMTInputFiles.h"
#include "vtkMTTriangleStream.h"

#include <memory>

class VTKMTBUILDING_EXPORT vtkMTSelectedInput : public vtkMTTriangleStream
{
public:
  vtkMTSelectedInput(std::unique_ptr<vtkMTTriangleStream> input, const vtkMTInputFiles& files,
    const std::map<std::string, std::int64_t>& counts);
  ~vtkMTSelectedInput() override;

  /// Keeps the arrays of these names alone and counts the others (arrays_left_out); to be called once, before anything
  /// is read. Gives a name of which there is
  /// no array; empty when there is none.
  std::string KeepArrays(const std::vector<std::string>& names);

  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Arrays; }
  std::uint64_t GetNumberOfPoints() const override { return this->Input->GetNumberOfPoints(); }
  std::uint64_t GetNumberOfTriangles() const override { return this->Input->GetNumberOfTriangles(); }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }
  bool Rewind() override { return this->Pass(this->Input->Rewind()); }
  bool NextPoints(PointBlock& block) override;
  bool NextTriangles(TriangleBlock& block) override;

private:
  bool Pass(bool good);

  std::unique_ptr<vtkMTTriangleStream> Input;
  const vtkMTInputFiles Files;
  std::vector<vtkMTArrayInfo> Arrays;
  std::vector<std::size_t> DroppedPointColumns; // from the last to the first
  std::vector<std::size_t> DroppedCellColumns;
  std::map<std::string, std::int64_t> Report;
};

#endif
