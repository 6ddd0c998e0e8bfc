// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPiece.h"

#include <cmath>

using namespace vtkMTVector;

//------------------------------------------------------------------------------
Vector vtkMTPiece::GetMiddle() const
{
  Vector sum{ 0.0, 0.0, 0.0 };
  for (int i = 0; i < this->Count; ++i)
  {
    sum = Add(sum, this->Corners[i]);
  }
  return Scale(sum, 1.0 / this->Count);
}

//------------------------------------------------------------------------------
double vtkMTPiece::GetRadius() const
{
  const Vector middle = this->GetMiddle();
  double radius2 = 0.0;
  for (int i = 0; i < this->Count; ++i)
  {
    const Vector way = Subtract(this->Corners[i], middle);
    radius2 = std::max(radius2, Dot(way, way));
  }
  return std::sqrt(radius2);
}

//------------------------------------------------------------------------------
vtkMTPiece::Diagonal vtkMTPiece::GetDiagonal() const
{
  Diagonal longest;
  for (int i = 0; i < this->Count; ++i)
  {
    for (int j = i + 1; j < this->Count; ++j)
    {
      const Vector d = Subtract(this->Corners[j], this->Corners[i]);
      if (Dot(d, d) > longest.Length2)
      {
        longest = { i, j, Dot(d, d) };
      }
    }
  }
  return longest;
}

//------------------------------------------------------------------------------
vtkMTPiece vtkMTPiece::MakePart() const
{
  vtkMTPiece part;
  part.Depth = this->Depth + 1;
  part.Triangle = this->Triangle;
  return part;
}

//------------------------------------------------------------------------------
bool vtkMTPiece::Split(
  const Vector& on, const Vector& normal, double thin, vtkMTPiece& inside, vtkMTPiece& outside) const
{
  inside = this->MakePart();
  outside = inside;
  std::array<double, Capacity> side;
  double innermost = 0.0;
  double outermost = 0.0;
  int in = 0;
  int out = 0;
  for (int i = 0; i < this->Count; ++i)
  {
    side[i] = Dot(Subtract(this->Corners[i], on), normal);
    innermost = std::max(innermost, side[i]);
    outermost = std::min(outermost, side[i]);
    in += side[i] > 0.0 ? 1 : 0;
    out += side[i] < 0.0 ? 1 : 0;
  }
  int crossings = 0;
  for (int i = 0; i < this->Count; ++i)
  {
    const double next = side[(i + 1) % this->Count];
    crossings += (side[i] > 0.0 && next < 0.0) || (side[i] < 0.0 && next > 0.0) ? 1 : 0;
  }
  const double tolerance = thin * Norm(normal);
  const bool isWhole = innermost <= tolerance || outermost >= -tolerance;
  // Corners that are nearly in line may be on the two sides by turns.
  if (isWhole || crossings > 2 || this->Count - std::min(in, out) + crossings > Capacity)
  {
    (outermost < -tolerance ? outside : inside) = *this;
    return false;
  }
  for (int i = 0; i < this->Count; ++i)
  {
    const int j = (i + 1) % this->Count;
    if (side[i] >= 0.0)
    {
      inside.Append(this->Corners[i]);
    }
    if (side[i] <= 0.0)
    {
      outside.Append(this->Corners[i]);
    }
    if ((side[i] > 0.0 && side[j] < 0.0) || (side[i] < 0.0 && side[j] > 0.0))
    {
      const Vector cut = Lerp(this->Corners[i], this->Corners[j], side[i] / (side[i] - side[j]));
      inside.Append(cut);
      outside.Append(cut);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTPiece::Halve(double thin, vtkMTPiece& one, vtkMTPiece& other) const
{
  const Diagonal longest = this->GetDiagonal();
  const Vector& from = this->Corners[longest.From];
  const Vector& to = this->Corners[longest.To];
  return longest.Length2 > 0.0 && this->Split(Lerp(from, to, 0.5), Subtract(to, from), thin, one, other);
}

//------------------------------------------------------------------------------
bool vtkMTPiece::SplitOff(const Chord& chord, vtkMTPiece& part, vtkMTPiece& rest) const
{
  part = this->MakePart();
  rest = part;
  const int others = this->Count - chord.Count;
  if (chord.Count + 2 > Capacity || others + 2 > Capacity)
  {
    return false;
  }
  part.Append(chord.Before);
  for (int i = 0; i < chord.Count; ++i)
  {
    part.Append(this->Corners[(chord.First + i) % this->Count]);
  }
  part.Append(chord.After);
  rest.Append(chord.After);
  for (int i = 0; i < others; ++i)
  {
    rest.Append(this->Corners[(chord.First + chord.Count + i) % this->Count]);
  }
  rest.Append(chord.Before);
  return true;
}
