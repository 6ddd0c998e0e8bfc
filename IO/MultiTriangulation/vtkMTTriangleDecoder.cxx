// SPDX-License-Identifier: BSD-3-Clause
// The codec's other side: from steps and names to triangles.
#include "vtkMTTriangleFront.h"

#include <algorithm>
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
  // How many ones; too many when the bits have ended, or some time after.
  unsigned Get()
  {
    const unsigned ones = this->See();
    this->Skip(ones);
    return ones;
  }
  // The same without going on.
  unsigned See()
  {
    if (this->Pending <= FewPending)
    {
      const std::size_t at = this->GetTaken();
      if (at / 8 > this->Size)
      {
        return TooManyOnes;
      }
      std::uint64_t more;
      std::memcpy(&more, this->Bytes + at / 8, sizeof(more));
      this->Pending = (~more | EndOfPending) >> (at % 8);
      this->Loaded = at - at % 8 + 63;
    }
    return static_cast<unsigned>(__builtin_ctzll(this->Pending | (std::uint64_t(1) << TooManyOnes)));
  }
  void Skip(unsigned ones) { this->Pending = this->Pending >> ones >> 1; }
  // Whether no more bits were taken than there are, and nothing but the zeros that fill the last byte are left.
  bool IsAtEnd() const
  {
    const std::size_t taken = this->GetTaken();
    return (taken + 7) / 8 == this->Size && (taken % 8 == 0 || this->Bytes[this->Size - 1] >> (taken % 8) == 0);
  }

private:
  std::size_t GetTaken() const
  {
    return this->Loaded - (63 - static_cast<std::size_t>(__builtin_clzll(this->Pending)));
  }

  static constexpr std::uint64_t EndOfPending = std::uint64_t(1) << 63;
  static constexpr std::uint64_t FewPending = (std::uint64_t(2) << TooManyOnes) - 1;

  const unsigned char* Bytes;
  std::size_t Size;
  std::size_t Loaded = 0;    // bits
  std::uint64_t Pending = 1; // those of them that are left, inverted, with a one behind the last
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
    : Now{ Front(out.NumberOfTriangles, out.Work), steps, 0, 0, 0 }
    , Names(names)
    , Triangles(EnsureSize(out.Triangles, out.NumberOfTriangles))
    , Bases(EnsureSize(out.Bases, std::size_t(out.NumberOfVertices) + out.NumberOfTriangles + 1))
    , BorderGates(EnsureSize(out.Work.BorderGates, 3 * std::size_t(out.NumberOfTriangles)))
    , Out(out)
  {
  }

  bool Run()
  {
    while (this->Now.Done < this->Out.NumberOfTriangles)
    {
      if (!(this->Now.Growing.HasGate() ? this->Cross() : this->Start()))
      {
        return false;
      }
    }
    std::fill(this->Bases + this->Now.Met, this->Bases + this->Out.NumberOfVertices, Basis());
    this->Now.Growing.SeeOpen([this](std::uint32_t from, std::uint32_t to) { this->PutBorder(this->Now, from, to); });
    FollowBorder(this->Now.Borders, this->Out);
    return this->Now.Steps.IsAtEnd() && this->Names.IsAtEnd();
  }

private:
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

  // As long as there is a gate. What is asked for all the time is in local variables meanwhile, which nothing that is
  // written can change.
  bool Cross()
  {
    Cursor now = this->Now;
    const std::uint32_t end = this->Out.NumberOfTriangles;
    const std::uint32_t most = this->Out.NumberOfVertices;
    while (now.Done < end)
    {
      const unsigned ones = now.Steps.Get();
      const Step step = Steps[now.Growing.GetSituation() + ones];
      if (__builtin_expect(step <= New, 1))
      {
        static_assert(Ahead == 0 && New == 1);
        this->Grow(now, step ^ New);
        this->GrowOn(now, end);
        if (now.Met > most)
        {
          return false;
        }
        if (!now.Growing.IsUnsettled())
        {
          continue;
        }
        now.Growing.Settle();
      }
      else if (!this->TakeOther(now, step))
      {
        return false;
      }
      if (!now.Growing.HasGate())
      {
        break;
      }
    }
    this->Now = now;
    return true;
  }

  // To the next vertex or, where isJoin is 1, to the one ahead.
  [[gnu::always_inline]] void Grow(Cursor& now, std::uint32_t isJoin)
  {
    asm("" : "+r"(isJoin)); // otherwise the compiler makes a branch of it, which is guessed wrong half of the time
    const Front& front = now.Growing;
    std::array<std::uint32_t, 4>& triangle = this->Triangles[now.Done];
    Basis& basis = this->Bases[now.Met];
    const std::uint64_t ends = front.GetEnds();
    const std::uint64_t toAndFrom = front.GetToAndFrom();
    const std::uint64_t owner = front.GetOwner();
    std::memcpy(&basis.A, &ends, sizeof(ends)); // and B
    basis.C = front.GetAcross();
    const std::uint64_t third = now.Growing.Grow(isJoin, now.Met, now.Done++) | owner << 32;
    std::memcpy(triangle.data(), &toAndFrom, sizeof(toAndFrom));
    std::memcpy(triangle.data() + 2, &third, sizeof(third));
    now.Met += 1 - isJoin;
  }

  // While the gate is between two that are open, and grew last, that it does so again is one bit or two, and nothing
  // else has to be known of the front. So what is next does not wait for what was done.
  [[gnu::always_inline]] void GrowOn(Cursor& now, std::uint32_t end)
  {
    static_assert(Steps[AfterAhead] == New && Steps[AfterAhead + 1] == Ahead);
    static_assert(Steps[AfterNew] == New && Steps[AfterNew + 1] == Ahead);
    while (now.Growing.IsBetweenOpen() && !now.Growing.IsUnsettled() && now.Done < end)
    {
      const unsigned ones = now.Steps.See();
      if (__builtin_expect(ones > 1, 0))
      {
        break;
      }
      now.Steps.Skip(ones);
      this->Grow(now, ones);
    }
  }

  [[gnu::always_inline]] bool TakeOther(Cursor& now, Step step)
  {
    const std::uint32_t from = now.Growing.GetFrom();
    const std::uint32_t to = now.Growing.GetTo();
    if (step == Nothing)
    {
      this->PutBorder(now, from, to);
      now.Growing.MakeBorder();
      return true;
    }
    if (step == Impossible)
    {
      return false;
    }
    std::uint32_t walk = step == Behind ? 2 : 3;
    std::uint32_t third = None;
    if (step != Named)
    {
      third = now.Growing.Walk(walk);
    }
    else if (!this->TakeThird(now, walk, third))
    {
      return false;
    }
    if (third == None)
    {
      return false;
    }
    this->PutTriangle(now, to, from, third);
    if (step == Behind)
    {
      now.Growing.JoinBehind(now.Done++);
    }
    else if (step == Named && IsBehind(walk))
    {
      now.Growing.SplitBehind(third, now.Done++);
    }
    else
    {
      now.Growing.Split(third, now.Done++, AfterOther);
    }
    return true;
  }

  [[gnu::always_inline]] bool TakeThird(const Cursor& now, std::uint32_t& steps, std::uint32_t& third)
  {
    std::uint64_t walk = 0;
    std::uint64_t back = 0;
    if (!this->Names.GetWalk(walk) || walk > MostWalk ||
      (walk == 0 && (!this->Names.GetBack(back) || back == 0 || back > now.Met)))
    {
      return false;
    }
    steps = static_cast<std::uint32_t>(walk);
    third = walk == 0 ? now.Met - static_cast<std::uint32_t>(back) : now.Growing.Walk(steps);
    return true;
  }

  [[gnu::always_inline]] void PutTriangle(const Cursor& now, std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    std::array<std::uint32_t, 4>& triangle = this->Triangles[now.Done];
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
    triangle[3] = now.Growing.GetOwner();
  }

  [[gnu::always_inline]] void PutBorder(Cursor& now, std::uint32_t from, std::uint32_t to)
  {
    BorderGate& gate = this->BorderGates[now.Borders++];
    gate.From = from;
    gate.To = to;
  }

  Cursor Now;
  NameReader Names;
  std::array<std::uint32_t, 4>* Triangles;
  Basis* Bases;
  BorderGate* BorderGates;
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
