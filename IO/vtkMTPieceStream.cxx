// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPieceStream.h"

#include <algorithm>

bool vtkMTPieceStream::Rewind()
{
  this->Error.clear();
  this->Stream.reset();
  this->PointsRead = 0;
  this->TrianglesRead = 0;
  return this->RewindFile();
}

// A file that says other things later than at its beginning must not be believed.
bool vtkMTPieceStream::BeginPiece()
{
  this->Stream = std::make_unique<vtkMTPolyDataStream>(this->Piece);
  return this->Stream->GetArrays() == this->Arrays || this->Fail("its arrays change within the file");
}

bool vtkMTPieceStream::NextPoints(PointBlock& block)
{
  block = PointBlock();
  for (;;)
  {
    if (this->Stream)
    {
      if (!this->Stream->NextPoints(block))
      {
        return this->Fail(this->Stream->GetError());
      }
      if (!block.Points.empty())
      {
        return true;
      }
      this->Stream.reset();
    }
    if (this->PointsRead == this->Points)
    {
      return true;
    }
    const std::uint64_t count = std::min(PieceSize, this->Points - this->PointsRead);
    this->Piece->Initialize();
    if (!this->ReadPoints(count, this->Piece) || !this->BeginPiece())
    {
      return false;
    }
    this->PointsRead += count;
  }
}

bool vtkMTPieceStream::NextTriangles(TriangleBlock& block)
{
  PointBlock skipped;
  while (this->PointsRead < this->Points)
  {
    if (!this->NextPoints(skipped))
    {
      return false;
    }
  }
  if (this->TrianglesRead == 0)
  {
    this->Stream.reset(); // of the last points
  }
  block = TriangleBlock();
  for (;;)
  {
    if (this->Stream)
    {
      if (!this->Stream->NextTriangles(block))
      {
        return this->Fail(this->Stream->GetError());
      }
      for (std::size_t t = 0; t < block.Triangles.size(); ++t)
      {
        block.Triangles[t] = this->PieceCorners[static_cast<std::size_t>(block.CellIds[t])];
        block.CellIds[t] += static_cast<std::int64_t>(this->FirstOfPiece);
      }
      if (!block.Triangles.empty())
      {
        return true;
      }
      this->Stream.reset();
    }
    if (this->TrianglesRead == this->Triangles)
    {
      return true;
    }
    const std::uint64_t count = std::min(PieceSize, this->Triangles - this->TrianglesRead);
    this->Piece->Initialize();
    this->PieceCorners.clear();
    if (!this->ReadTriangles(count, this->Piece, this->PieceCorners) || !this->BeginPiece())
    {
      return false;
    }
    this->FirstOfPiece = this->TrianglesRead;
    this->TrianglesRead += count;
  }
}
