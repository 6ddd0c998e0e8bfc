// SPDX-License-Identifier: BSD-3-Clause
// A triangle stream over a file that is read in pieces, each a small mesh by itself. Not installed.
#ifndef vtkMTPieceStream_h
#define vtkMTPieceStream_h

#include "vtkMTPolyDataStream.h"
#include "vtkMTTriangleStream.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <memory>

/**
 * The pieces go through the format's reader and vtkMTPolyDataStream as the whole file would: so arrays, types and
 * values are the same whether a file is streamed or read whole. Derived classes say what the pieces are.
 */
class vtkMTPieceStream : public vtkMTTriangleStream
{
public:
  const std::vector<vtkMTArrayInfo>& GetArrays() const override { return this->Arrays; }
  std::uint64_t GetNumberOfPoints() const override { return this->Points; }
  std::uint64_t GetNumberOfTriangles() const override { return this->Triangles; }
  const std::map<std::string, std::int64_t>& GetReport() const override { return this->Report; }
  bool Rewind() override;
  bool NextPoints(PointBlock& block) override;
  bool NextTriangles(TriangleBlock& block) override;

protected:
  using Corners = std::array<std::uint64_t, 3>;
  static constexpr std::uint64_t PieceSize = 65535; // a multiple of three

  ///@{
  /// The next `count` points, or triangles, as a mesh by itself. Triangles come with their corners in the whole file;
  /// in the mesh they may have any.
  virtual bool RewindFile() = 0;
  virtual bool ReadPoints(std::uint64_t count, vtkPolyData* piece) = 0;
  virtual bool ReadTriangles(std::uint64_t count, vtkPolyData* piece, std::vector<Corners>& corners) = 0;
  ///@}

  bool Fail(const std::string& error)
  {
    this->Error = error;
    return false;
  }

  std::vector<vtkMTArrayInfo> Arrays;
  std::uint64_t Points = 0;
  std::uint64_t Triangles = 0;

private:
  bool BeginPiece();

  std::map<std::string, std::int64_t> Report;
  vtkNew<vtkPolyData> Piece;
  std::unique_ptr<vtkMTPolyDataStream> Stream; // of the piece
  std::vector<Corners> PieceCorners;
  std::uint64_t PointsRead = 0;    // all pieces together
  std::uint64_t TrianglesRead = 0; // all pieces together
  std::uint64_t FirstOfPiece = 0;
};

#endif
