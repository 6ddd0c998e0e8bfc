// SPDX-License-Identifier: BSD-3-Clause
// The codec's other side: from steps and names to triangles.
#include "vtkMTTriangleFront.h"

#include <cstring>

namespace
{
using namespace vtkMTTriangleCodec;

class StepReader
{
public:
  // Eight bytes behind the end are read and not looked at.
  StepReader(const unsigned char* bytes, std::size_t size)
    : Bytes(bytes)
    , Size(size)
  {
  }
  // How many ones; more than there may be when the bits have ended, or some time after.
  unsigned Get()
  {
    if (this->Have <= MostOnes)
    {
      if (this->At > this->Size)
      {
        return MostOnes + 1;
      }
      std::uint64_t more;
      std::memcpy(&more, this->Bytes + this->At, sizeof(more));
      this->Pending |= more << this->Have;
      this->At += (63 - this->Have) / 8;
      this->Have |= 56;
    }
    const auto ones = static_cast<unsigned>(__builtin_ctzll(~this->Pending | (std::uint64_t(1) << MostOnes)));
    const unsigned length = ones + (ones < MostOnes ? 1 : 0);
    this->Pending >>= length;
    this->Have -= length;
    return ones;
  }
  // Whether no more bits were taken than there are, and nothing but the zeros that fill the last byte are left.
  bool IsAtEnd() const
  {
    const std::size_t taken = 8 * this->At - this->Have;
    return (taken + 7) / 8 == this->Size && (taken % 8 == 0 || this->Bytes[this->Size - 1] >> (taken % 8) == 0);
  }

private:
  const unsigned char* Bytes;
  std::size_t Size;
  std::size_t At = 0;
  std::uint64_t Pending = 0;
  unsigned Have = 0;
};

// The names as vtkMTTriangleEncoder.cxx writes them.
class NameReader
{
public:
  // Eight bytes behind the end are read and not looked at.
  NameReader(const unsigned char* bytes, std::size_t size)
    : Bytes(bytes + (size >= 2 ? 2 : 0))
    , Size(size >= 2 ? 8 * (size - 2) : 0)
    , Parameters{ size >= 2 ? bytes[0] : MostNameBits + 1, size >= 2 ? bytes[1] : MostNameBits + 1 }
    , IsWhole(size != 1)
  {
  }
  // How long ago a vertex was met.
  bool GetBack(std::uint64_t& back) { return this->Get(this->Parameters[0], back); }
  // How far away it is.
  bool GetWalk(std::uint64_t& walk) { return this->Get(this->Parameters[1], walk); }
  // Whether nothing but the zeros that fill the last byte are left.
  bool IsAtEnd() const { return this->IsWhole && this->Size - this->At < 8 && this->Load() == 0; }

private:
  bool Get(unsigned parameter, std::uint64_t& name)
  {
    std::uint64_t ones = 0;
    std::uint64_t bits = this->Load();
    for (; ~bits == 0 || static_cast<std::size_t>(__builtin_ctzll(~bits)) >= LoadedBits; bits = this->Load())
    {
      ones += LoadedBits;
      this->At += LoadedBits;
    }
    const auto last = static_cast<unsigned>(__builtin_ctzll(~bits));
    this->At += last + 1;
    if (parameter > MostNameBits || this->At > this->Size || this->Size - this->At < parameter)
    {
      this->At = this->Size;
      return false;
    }
    name = ((ones + last) << parameter) | (this->Load() & ((std::uint64_t(1) << parameter) - 1));
    this->At += parameter;
    return true;
  }
  // The bits from here on, at least 57; those behind the end are 0.
  std::uint64_t Load() const
  {
    if (this->At >= this->Size)
    {
      return 0;
    }
    std::uint64_t bits;
    std::memcpy(&bits, this->Bytes + this->At / 8, sizeof(bits));
    bits >>= this->At % 8;
    const std::size_t left = this->Size - this->At;
    return left < 64 ? bits & ((std::uint64_t(1) << left) - 1) : bits;
  }
  static constexpr std::size_t LoadedBits = 57;

  const unsigned char* Bytes;
  std::size_t Size; // bits
  std::size_t At = 0;
  unsigned Parameters[2];
  bool IsWhole;
};

//------------------------------------------------------------------------------
// What is asked for at every gate.
struct Cursor
{
  Front Growing;
  StepReader Steps;
  std::uint32_t Done; // triangles
  std::uint32_t Met;  // vertices
  std::uint32_t Borders;
};

class Decoder
{
public:
  Decoder(StepReader steps, NameReader names, Decoded& out)
    : Now{ Front(out.NumberOfTriangles, out.NumberOfVertices, out.Work), steps, 0, 0, 0 }
    , Names(names)
    , Triangles(EnsureSize(out.Triangles, out.NumberOfTriangles))
    , Bases(EnsureSize(out.Bases, out.NumberOfVertices))
    , BorderGates(EnsureSize(out.Work.BorderGates, 3 * std::size_t(out.NumberOfTriangles)))
    , Out(out)
  {
    this->Out.Border.clear();
  }

  bool Run()
  {
    while (this->Now.Done < this->Out.NumberOfTriangles)
    {
      std::uint32_t gate = this->Now.Growing.Pop();
      if (gate == None ? !this->Start() : !this->Cross(gate))
      {
        return false;
      }
    }
    std::fill(this->Bases + this->Now.Met, this->Bases + this->Out.NumberOfVertices, Basis());
    this->TakeBorder();
    return this->Now.Steps.IsAtEnd() && this->Names.IsAtEnd();
  }

private:
  void TakeBorder()
  {
    for (std::uint32_t gate = this->Now.Growing.Pop(); gate != None; gate = this->Now.Growing.Pop())
    {
      this->BorderGates[this->Now.Borders++] = gate;
    }
    for (std::uint32_t i = 0; i < this->Now.Borders; ++i)
    {
      this->Now.Growing.TakeLoop(this->BorderGates[i], this->Out.Border);
    }
  }

  bool TakeName(std::uint32_t before, std::uint32_t& vertex)
  {
    std::uint64_t back = 0;
    if (!this->Names.GetBack(back) || back > this->Now.Met ||
      (back == 0 && this->Now.Met == this->Out.NumberOfVertices))
    {
      return false;
    }
    vertex = this->Now.Met - static_cast<std::uint32_t>(back);
    if (back == 0)
    {
      this->Bases[this->Now.Met++] = { before, None, None };
    }
    return true;
  }

  bool Start()
  {
    vtkMTTriangle t;
    std::uint32_t before = None;
    for (std::uint32_t& vertex : t)
    {
      if (!this->TakeName(before, vertex))
      {
        return false;
      }
      before = vertex;
    }
    this->Now.Growing.Start(t, this->Now.Done);
    this->Triangles[this->Now.Done++] = { t[0], t[1], t[2], None };
    return true;
  }

  // From this gate on as far as the cell goes, or to a vertex that is named. What is asked for all the time is in
  // local variables meanwhile, which nothing that is written can change.
  bool Cross(std::uint32_t gate)
  {
    Cursor now = this->Now;
    Step step = New;
    const std::uint32_t end = this->Out.NumberOfTriangles;
    for (; gate != None; gate = now.Done < end ? now.Growing.PopOfCell() : None)
    {
      const unsigned ones = now.Steps.Get();
      const std::uint32_t situation = now.Growing.Get(gate).Beside;
      step = Steps[situation][ones];
      if (ones == 0 && now.Met < this->Out.NumberOfVertices)
      {
        this->TakeNew(now, gate);
      }
      else if (ones - 1 < 2 && situation >= BothAreOpen && !now.Growing.IsAlone(gate))
      {
        this->TakeJoin(now, gate, ones - 1 == (situation & LeansLeft));
      }
      else if (!this->TakeOther(now, gate, step))
      {
        break;
      }
    }
    this->Now = now;
    return gate == None || (step == Named && this->CrossToNamed(gate));
  }

  void TakeNew(Cursor& now, std::uint32_t gate)
  {
    const Gate& g = now.Growing.Get(gate);
    Basis& basis = this->Bases[now.Met];
    basis.A = g.From;
    basis.B = g.To;
    basis.C = g.Across;
    this->Put(now, g, now.Met);
    now.Growing.Split(gate, now.Met++, now.Done++);
  }

  void TakeJoin(Cursor& now, std::uint32_t gate, bool isRight)
  {
    const std::uint32_t neighbour = now.Growing.GetNeighbour(gate, isRight);
    const Gate& other = now.Growing.Get(neighbour);
    this->Put(now, now.Growing.Get(gate), isRight ? other.To : other.From);
    now.Growing.Join(gate, neighbour, isRight, now.Done++);
  }

  // What comes less often. False when the vertex is named, and when the step is impossible. Inlined, as the cursor
  // would have to be in memory for a call.
  [[gnu::always_inline]] bool TakeOther(Cursor& now, std::uint32_t gate, Step step)
  {
    if (step == Nothing)
    {
      now.Growing.MakeBorder(gate);
      this->BorderGates[now.Borders++] = gate;
      return true;
    }
    if (step == Both && now.Growing.HasTwoNeighbours(gate))
    {
      this->Put(now, now.Growing.Get(gate), now.Growing.GetRight(gate));
      now.Growing.JoinBoth(gate);
      ++now.Done;
      return true;
    }
    const bool isJoin = (step == Right || step == Left) && !now.Growing.IsAlone(gate);
    if (isJoin)
    {
      this->TakeJoin(now, gate, step == Right);
    }
    return isJoin;
  }

  // The triangle behind a gate.
  void Put(const Cursor& now, const Gate& gate, std::uint32_t third)
  {
    std::array<std::uint32_t, 4>& triangle = this->Triangles[now.Done];
    triangle[0] = gate.To;
    triangle[1] = gate.From;
    triangle[2] = third;
    triangle[3] = gate.Owner;
  }

  bool CrossToNamed(std::uint32_t gate)
  {
    std::uint64_t walk = 0;
    std::uint64_t back = 0;
    if (!this->Names.GetWalk(walk) || walk > MostWalk ||
      (walk == 0 && (!this->Names.GetBack(back) || back == 0 || back > this->Now.Met)))
    {
      return false;
    }
    const std::uint32_t third = walk == 0 ? this->Now.Met - static_cast<std::uint32_t>(back)
                                          : this->Now.Growing.Walk(gate, static_cast<std::uint32_t>(walk));
    this->Put(this->Now, this->Now.Growing.Get(gate), third);
    this->Now.Growing.SplitAt(gate, third, this->Now.Done++);
    return true;
  }

  Cursor Now;
  NameReader Names;
  std::array<std::uint32_t, 4>* Triangles;
  Basis* Bases;
  std::uint32_t* BorderGates;
  Decoded& Out;
};
}

namespace vtkMTTriangleCodec
{
bool Decode(const unsigned char* steps, std::size_t stepsSize, const unsigned char* names, std::size_t namesSize,
  std::size_t triangles, std::size_t vertices, Decoded& decoded)
{
  decoded.NumberOfTriangles = static_cast<std::uint32_t>(triangles);
  decoded.NumberOfVertices = static_cast<std::uint32_t>(vertices);
  return Decoder(StepReader(steps, stepsSize), NameReader(names, namesSize), decoded).Run();
}
}
