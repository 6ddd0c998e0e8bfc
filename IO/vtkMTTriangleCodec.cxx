// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTriangleCodec.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace
{
using vtkMTTriangleCodec::Basis;
using vtkMTTriangleCodec::None;

enum Step : unsigned char
{
  New,
  Right,   // the third vertex is the end of the next edge of the front
  Left,    // it is the start of the previous one
  Nothing, // no triangle is behind the gate
  Named,
  Both, // right and left at once
  Impossible
};

// A step is said by so many ones, then a zero, which the last one does without.
constexpr unsigned MostOnes = 5;

// What the ones mean depends on what both sides of the codec know of the gate. What comes oftenest there is first, and
// what cannot be has no code. That a vertex is new is one zero always: it is known before the gate has been looked at.
enum Situation : std::uint32_t
{
  LeansLeft = 1, // it is the left one of two, or took the place of the next one: it is rather joined to the previous
  NextIsOpen = 2,
  PreviousIsOpen = 4,
  BothAreOpen = NextIsOpen | PreviousIsOpen
};
using StepRow = std::array<Step, 8>;

constexpr StepRow GetSteps(bool leansLeft, bool isNextOpen, bool isPreviousOpen)
{
  if (isNextOpen && isPreviousOpen)
  {
    return { New, leansLeft ? Left : Right, leansLeft ? Right : Left, Named, Nothing, Both, Impossible, Impossible };
  }
  if (isNextOpen || isPreviousOpen)
  {
    return { New, Nothing, isNextOpen ? Right : Left, Named, Impossible, Impossible, Impossible, Impossible };
  }
  return { New, Nothing, Named, Impossible, Impossible, Impossible, Impossible, Impossible };
}

// By situation and number of ones.
constexpr StepRow Steps[8] = { GetSteps(false, false, false), GetSteps(true, false, false),
  GetSteps(false, true, false), GetSteps(true, true, false), GetSteps(false, false, true), GetSteps(true, false, true),
  GetSteps(false, true, true), GetSteps(true, true, true) };

// A vertex that is named is mostly a few gates away along the front.
constexpr std::uint32_t MostWalk = 16;
constexpr unsigned MostNameBits = 31;

// What is kept from patch to patch only grows.
template <class T>
T* EnsureSize(std::vector<T>& values, std::size_t size)
{
  if (values.size() < size)
  {
    values.resize(size);
  }
  return values.data();
}

//------------------------------------------------------------------------------
// The front: gates in doubly linked loops. They are asked in the order in which they were made: those of the present
// cell, which are the last ones, then what earlier cells have left, which is a stack of ranges. Gates behind which
// there is nothing stay in their loop as the border that they are.
class Front
{
public:
  enum StateType : std::uint32_t
  {
    Open,
    Border,
    Gone
  };
  using Gate = vtkMTTriangleCodec::Gate;

  // A triangle makes three gates at most.
  Front(std::size_t triangles, std::size_t vertices, vtkMTTriangleCodec::Workspace& workspace)
    : Gates(EnsureSize(workspace.Gates, 3 * triangles))
    , GateFrom(EnsureSize(workspace.GateFrom, vertices))
    , Waiting(&workspace.Waiting)
  {
    std::fill_n(this->GateFrom, vertices, None);
    this->Waiting->clear();
  }

  // The open gate whose turn it is; None when there is none.
  std::uint32_t Pop()
  {
    const std::uint32_t gate = this->PopOfCell();
    return gate == None ? this->BeginCell() : gate;
  }
  // The same as long as the cell lasts; None behind its end.
  std::uint32_t PopOfCell()
  {
    while (this->TakenInCell < vtkMTTriangleCodec::CellSize && this->Head < this->Count)
    {
      const std::uint32_t gate = this->Head++;
      if (this->IsOpen(gate))
      {
        ++this->TakenInCell;
        return gate;
      }
    }
    return None;
  }

  // What is left of the last cell waits with those before it, the oldest gate first, and the new one begins with the
  // first of these.
  std::uint32_t BeginCell()
  {
    if (this->Head < this->Count)
    {
      this->Waiting->push_back({ this->Head, this->Count });
    }
    this->Head = this->Count;
    this->TakenInCell = 1;
    for (; !this->Waiting->empty(); this->Waiting->pop_back())
    {
      vtkMTTriangleCodec::GateRange& range = this->Waiting->back();
      while (range.Begin < range.End)
      {
        const std::uint32_t gate = range.Begin++;
        if (this->IsOpen(gate))
        {
          return gate;
        }
      }
    }
    this->TakenInCell = 0;
    return None;
  }

  const Gate& Get(std::uint32_t gate) const { return this->Gates[gate]; }
  bool IsOpen(std::uint32_t gate) const { return this->Gates[gate].State == Open; }
  std::uint32_t GetRight(std::uint32_t gate) const { return this->Gates[this->Gates[gate].Next].To; }
  std::uint32_t GetLeft(std::uint32_t gate) const { return this->Gates[this->Gates[gate].Previous].From; }

  bool IsAlone(std::uint32_t gate) const { return this->Gates[gate].Next == gate; }
  bool HasTwoNeighbours(std::uint32_t gate) const
  {
    return !this->IsAlone(gate) && this->Gates[gate].Next != this->Gates[gate].Previous;
  }

  // The vertex that is so many gates away: 1 the end of the gate behind the next one, 2 the start of that before the
  // previous one, 3 and 4 those one farther, and so on.
  std::uint32_t Walk(std::uint32_t gate, std::uint32_t walk) const
  {
    const bool isRight = walk % 2 != 0;
    for (std::uint32_t i = 0; i < (walk + 3) / 2; ++i)
    {
      gate = this->GetNeighbour(gate, isRight);
    }
    return isRight ? this->Gates[gate].To : this->Gates[gate].From;
  }

  void Start(const vtkMTTriangle& t, std::uint32_t triangle)
  {
    const std::uint32_t first = this->Count;
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      const std::uint32_t gate = this->Add(t[c], t[(c + 1) % 3], t[(c + 2) % 3], triangle, BothAreOpen);
      this->Gates[gate].Previous = first + (c + 2) % 3;
      this->Gates[gate].Next = first + (c + 1) % 3;
    }
  }

  void MakeBorder(std::uint32_t gate)
  {
    this->Gates[gate].State = Border;
    this->Gates[this->Gates[gate].Next].Beside &= ~PreviousIsOpen;
    this->Gates[this->Gates[gate].Previous].Beside &= ~NextIsOpen;
  }

  // The gate gives way to two that go by the third vertex.
  void Split(std::uint32_t gate, std::uint32_t vertex, std::uint32_t triangle)
  {
    const std::uint32_t from = this->Gates[gate].From;
    const std::uint32_t to = this->Gates[gate].To;
    const std::uint32_t previous = this->Gates[gate].Previous;
    const std::uint32_t next = this->Gates[gate].Next;
    const std::uint32_t beside = this->Gates[gate].Beside;
    const std::uint32_t left =
      this->Add(from, vertex, to, triangle, LeansLeft | NextIsOpen | (beside & PreviousIsOpen));
    const std::uint32_t right = this->Add(vertex, to, from, triangle, PreviousIsOpen | (beside & NextIsOpen));
    this->Link(previous == gate ? right : previous, left);
    this->Link(left, right);
    this->Link(right, next == gate ? left : next);
    this->Gates[gate].State = Gone;
  }

  // The gate and the next or the previous one give way to one. Nobody can guess which of the two it is, so they are
  // told apart without a branch.
  std::uint32_t GetNeighbour(std::uint32_t gate, bool isRight) const
  {
    return isRight ? this->Gates[gate].Next : this->Gates[gate].Previous;
  }
  void Join(std::uint32_t gate, std::uint32_t neighbour, bool isRight, std::uint32_t triangle)
  {
    const std::uint32_t first = isRight ? gate : neighbour;
    const std::uint32_t second = isRight ? neighbour : gate;
    const std::uint32_t across = isRight ? this->Gates[gate].To : this->Gates[gate].From;
    const std::uint32_t before = this->Gates[first].Previous;
    const std::uint32_t after = this->Gates[second].Next;
    // The neighbour is the one that would be asked next more often than not; it is passed over.
    this->Head += neighbour == this->Head ? 1 : 0;
    const std::uint32_t beside = (this->Gates[first].Beside & PreviousIsOpen) |
      (this->Gates[second].Beside & NextIsOpen) | LeansLeft * static_cast<std::uint32_t>(isRight);
    const std::uint32_t joined = this->Add(this->Gates[first].From, this->Gates[second].To, across, triangle, beside);
    this->Link(before == second ? joined : before, joined);
    this->Link(joined, after == first ? joined : after);
    this->Gates[first].State = this->Gates[second].State = Gone;
  }

  // The third vertex is on the front already: the loop is cut in two there, or two loops become one.
  void SplitAt(std::uint32_t gate, std::uint32_t third, std::uint32_t triangle)
  {
    const std::uint32_t there = this->GateFrom[third];
    this->Split(gate, third, triangle);
    if (there != None && this->Gates[there].State != Gone)
    {
      const std::uint32_t right = this->Count - 1;
      this->Link(this->Gates[there].Previous, right);
      this->Link(right - 1, there);
      this->LookBeside(this->Gates[right].Previous);
      this->LookBeside(right);
      this->LookBeside(right - 1);
      this->LookBeside(there);
    }
  }

  // Three gates around the triangle are done with.
  void JoinBoth(std::uint32_t gate)
  {
    const Gate g = this->Gates[gate];
    const std::uint32_t before = this->Gates[g.Previous].Previous;
    const std::uint32_t after = this->Gates[g.Next].Next;
    this->Gates[gate].State = this->Gates[g.Previous].State = this->Gates[g.Next].State = Gone;
    this->Link(before, after);
    this->LookBeside(before);
    this->LookBeside(after);
  }

  // The starts of the gates that follow each other from this one, as far as they have not been asked for yet.
  void TakeLoop(std::uint32_t gate, std::vector<std::uint32_t>& vertices)
  {
    for (; this->Gates[gate].State != Gone; gate = this->Gates[gate].Next)
    {
      this->Gates[gate].State = Gone;
      vertices.push_back(this->Gates[gate].From);
    }
  }

private:
  // Field by field: a gate that was copied as a whole could not be read again before the copy is through.
  std::uint32_t Add(
    std::uint32_t from, std::uint32_t to, std::uint32_t across, std::uint32_t triangle, std::uint32_t beside)
  {
    const std::uint32_t gate = this->Count++;
    this->Gates[gate].From = from;
    this->Gates[gate].To = to;
    this->Gates[gate].Across = across;
    this->Gates[gate].Owner = triangle;
    this->Gates[gate].State = Open;
    this->Gates[gate].Beside = beside;
    this->GateFrom[from] = gate;
    return gate;
  }

  void Link(std::uint32_t a, std::uint32_t b)
  {
    this->Gates[a].Next = b;
    this->Gates[b].Previous = a;
  }

  // After it got other neighbours, of which it is not known that they are open.
  void LookBeside(std::uint32_t gate)
  {
    Gate& g = this->Gates[gate];
    g.Beside = (g.Beside & LeansLeft) | NextIsOpen * static_cast<std::uint32_t>(this->IsOpen(g.Next)) |
      PreviousIsOpen * static_cast<std::uint32_t>(this->IsOpen(g.Previous));
  }

  Gate* Gates;
  std::uint32_t* GateFrom;                             // the latest that leaves a vertex
  std::vector<vtkMTTriangleCodec::GateRange>* Waiting; // of earlier cells
  std::uint32_t Count = 0;
  std::uint32_t Head = 0; // of the present cell's gates the first that was not asked
  std::uint32_t TakenInCell = 0;
};

// Which of the steps closes the gate with that vertex, if it is on the front beside it.
Step FindStep(const Front& front, std::uint32_t gate, std::uint32_t vertex)
{
  const Front::Gate& g = front.Get(gate);
  const bool isRight = !front.IsAlone(gate) && (g.Beside & NextIsOpen) != 0 && front.GetRight(gate) == vertex;
  const bool isLeft = !front.IsAlone(gate) && (g.Beside & PreviousIsOpen) != 0 && front.GetLeft(gate) == vertex;
  if (isRight && isLeft && front.HasTwoNeighbours(gate))
  {
    return Both;
  }
  return isRight ? Right : (isLeft ? Left : Named);
}

// By how many gates it is named; 0 when it is not near.
std::uint32_t FindWalk(const Front& front, std::uint32_t gate, std::uint32_t vertex)
{
  std::uint32_t walk = 1;
  while (walk <= MostWalk && front.Walk(gate, walk) != vertex)
  {
    ++walk;
  }
  return walk <= MostWalk ? walk : 0;
}

//------------------------------------------------------------------------------
class BitWriter
{
public:
  void Put(Step step, std::uint32_t situation)
  {
    unsigned ones = 0;
    for (; Steps[situation][ones] != step; ++ones)
    {
      this->PutBit(true);
    }
    if (ones < MostOnes)
    {
      this->PutBit(false);
    }
  }
  void PutRice(std::uint32_t number, unsigned parameter)
  {
    for (std::uint32_t ones = number >> parameter; ones > 0; --ones)
    {
      this->PutBit(true);
    }
    this->PutBit(false);
    for (unsigned i = 0; i < parameter; ++i)
    {
      this->PutBit((number >> i & 1) != 0);
    }
  }
  void PutBit(bool bit)
  {
    if (this->Count % 8 == 0)
    {
      this->Bytes.push_back(0);
    }
    if (bit)
    {
      this->Bytes.back() |= static_cast<unsigned char>(1u << (this->Count % 8));
    }
    ++this->Count;
  }
  std::vector<unsigned char> Bytes;

private:
  std::size_t Count = 0;
};

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

//------------------------------------------------------------------------------
// What is named, in order: how far away along the front, and how long ago a vertex was met.
struct Name
{
  std::uint32_t Number;
  bool IsWalk;
};

unsigned ChooseNameParameter(const std::vector<Name>& names, bool ofWalks)
{
  const auto count = [&](unsigned parameter)
  {
    std::uint64_t bits = 0;
    for (const Name& name : names)
    {
      bits += name.IsWalk == ofWalks ? (name.Number >> parameter) + 1 + parameter : 0;
    }
    return bits;
  };
  unsigned best = 0;
  for (unsigned parameter = 1; parameter <= MostNameBits; ++parameter)
  {
    best = count(parameter) < count(best) ? parameter : best;
  }
  return best;
}

// Names as Rice codes: two bytes with the parameters of the two kinds, then the bits.
std::vector<unsigned char> WriteNames(const std::vector<Name>& names)
{
  const unsigned parameters[2] = { ChooseNameParameter(names, false), ChooseNameParameter(names, true) };
  BitWriter writer;
  writer.Bytes = { static_cast<unsigned char>(parameters[0]), static_cast<unsigned char>(parameters[1]) };
  for (const Name& name : names)
  {
    writer.PutRice(name.Number, parameters[name.IsWalk ? 1 : 0]);
  }
  return names.empty() ? std::vector<unsigned char>() : std::move(writer.Bytes);
}

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
// The triangles that have an edge in a given direction.
class Edges
{
public:
  Edges(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices)
    : First(vertices + 1, 0)
    , Corners(3 * triangles.size())
    , Triangles(triangles)
    , IsDone(triangles.size(), 0)
    , Reverse(triangles.size(), Unknown)
  {
    for (const vtkMTTriangle& t : triangles)
    {
      for (std::uint32_t v : t)
      {
        ++this->First[v + std::size_t(1)];
      }
    }
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    std::vector<std::size_t> next(this->First.begin(), this->First.end() - 1);
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
    {
      for (std::uint32_t c = 0; c < 3; ++c)
      {
        this->Corners[next[triangles[t][c]]++] = { t, c };
      }
    }
  }

  struct Corner
  {
    std::uint32_t Triangle = None;
    std::uint32_t Index = 0;
  };
  // A triangle that is not done and runs from a to b, which is its corner `Index` to the next; the first of them, but
  // rather one that is there a second time the other way round: one goes to it and back by the other one, while nothing
  // would lead there later, where the surface goes on past it.
  Corner Find(std::uint32_t a, std::uint32_t b)
  {
    Corner found;
    for (std::size_t i = this->First[a]; i < this->First[a + std::size_t(1)]; ++i)
    {
      const Corner& corner = this->Corners[i];
      if (this->IsDone[corner.Triangle] || this->Get(corner, 1) != b)
      {
        continue;
      }
      if (found.Triangle == None)
      {
        found = corner;
      }
      else if (!this->HasReverse(found) && this->HasReverse(corner))
      {
        return corner;
      }
    }
    return found;
  }
  void Finish(std::uint32_t triangle) { this->IsDone[triangle] = 1; }
  bool IsFinished(std::uint32_t triangle) const { return this->IsDone[triangle] != 0; }

private:
  std::uint32_t Get(const Corner& corner, std::uint32_t offset) const
  {
    return this->Triangles[corner.Triangle][(corner.Index + offset) % 3];
  }
  // Done or not; looked for once, as there may be any number of triangles at a vertex.
  bool HasReverse(const Corner& corner)
  {
    ReverseType& reverse = this->Reverse[corner.Triangle];
    if (reverse == Unknown)
    {
      reverse = this->FindReverse(corner) ? Some : Lone;
    }
    return reverse == Some;
  }
  bool FindReverse(const Corner& corner) const
  {
    const std::uint32_t a = this->Get(corner, 0);
    for (std::size_t i = this->First[a]; i < this->First[a + std::size_t(1)]; ++i)
    {
      const Corner& other = this->Corners[i];
      if (this->Get(other, 1) == this->Get(corner, 2) && this->Get(other, 2) == this->Get(corner, 1))
      {
        return true;
      }
    }
    return false;
  }

  enum ReverseType : unsigned char
  {
    Unknown,
    Some,
    Lone
  };
  std::vector<std::size_t> First;
  std::vector<Corner> Corners;
  const std::vector<vtkMTTriangle>& Triangles;
  std::vector<unsigned char> IsDone;
  std::vector<ReverseType> Reverse;
};

class Encoder
{
public:
  Encoder(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices)
    : Triangles(triangles)
    , Behind(triangles, vertices)
    , Growing(triangles.size(), vertices, this->Work)
    , Number(vertices, None)
  {
    this->Result.Triangles.reserve(triangles.size());
    this->Result.Order.reserve(triangles.size());
  }

  vtkMTTriangleCodec::Coded Run()
  {
    for (std::uint32_t seed = 0; this->Result.Triangles.size() < this->Triangles.size();)
    {
      const std::uint32_t gate = this->Growing.Pop();
      if (gate != None)
      {
        this->Cross(gate);
        continue;
      }
      while (this->Behind.IsFinished(seed))
      {
        ++seed;
      }
      this->StartAt(seed);
    }
    this->Result.Steps = std::move(this->Steps.Bytes);
    this->Result.Names = WriteNames(this->Names);
    return std::move(this->Result);
  }

private:
  std::uint32_t GetDone() const { return static_cast<std::uint32_t>(this->Result.Triangles.size()); }

  void StartAt(std::uint32_t triangle)
  {
    const vtkMTTriangle& t = this->Triangles[triangle];
    for (std::uint32_t v : t)
    {
      this->PutName(v);
    }
    this->Behind.Finish(triangle);
    this->Growing.Start(t, this->GetDone());
    this->Result.Triangles.push_back(t);
    this->Result.Order.push_back(triangle);
  }

  // 0 is a new vertex, k the k-th last one that was met.
  void PutName(std::uint32_t vertex)
  {
    const bool isNew = this->Number[vertex] == None;
    this->Names.push_back({ isNew ? 0 : this->Met - this->Number[vertex], false });
    this->Number[vertex] = isNew ? this->Met++ : this->Number[vertex];
  }

  void PutWalk(std::uint32_t gate, std::uint32_t vertex)
  {
    const std::uint32_t walk = FindWalk(this->Growing, gate, vertex);
    this->Names.push_back({ walk, true });
    if (walk == 0)
    {
      this->PutName(vertex);
    }
  }

  void Cross(std::uint32_t gate)
  {
    const Front::Gate g = this->Growing.Get(gate);
    const Edges::Corner behind = this->Behind.Find(g.To, g.From);
    const std::uint32_t situation = g.Beside;
    if (behind.Triangle == None)
    {
      this->Steps.Put(Nothing, situation);
      this->Growing.MakeBorder(gate);
      return;
    }
    const std::uint32_t third = this->Triangles[behind.Triangle][(behind.Index + 2) % 3];
    const bool isNew = this->Number[third] == None;
    const Step step = isNew ? New : FindStep(this->Growing, gate, third);
    this->Steps.Put(step, situation);
    switch (step)
    {
      case New:
        this->Growing.Split(gate, third, this->GetDone());
        break;
      case Right:
      case Left:
        this->Growing.Join(gate, this->Growing.GetNeighbour(gate, step == Right), step == Right, this->GetDone());
        break;
      case Both:
        this->Growing.JoinBoth(gate);
        break;
      default:
        this->PutWalk(gate, third);
        this->Growing.SplitAt(gate, third, this->GetDone());
    }
    this->Number[third] = isNew ? this->Met++ : this->Number[third];
    this->Behind.Finish(behind.Triangle);
    this->Result.Triangles.push_back({ g.To, g.From, third });
    this->Result.Order.push_back(behind.Triangle);
  }

  const std::vector<vtkMTTriangle>& Triangles;
  Edges Behind;
  vtkMTTriangleCodec::Workspace Work;
  Front Growing;
  std::vector<std::uint32_t> Number;
  std::uint32_t Met = 0;
  BitWriter Steps;
  std::vector<Name> Names;
  vtkMTTriangleCodec::Coded Result;
};

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
  Decoder(StepReader steps, NameReader names, vtkMTTriangleCodec::Decoded& out)
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
    const Front::Gate& g = now.Growing.Get(gate);
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
    const Front::Gate& other = now.Growing.Get(neighbour);
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
  void Put(const Cursor& now, const Front::Gate& gate, std::uint32_t third)
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
  vtkMTTriangleCodec::Decoded& Out;
};
}

namespace vtkMTTriangleCodec
{
Coded Encode(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices)
{
  return Encoder(triangles, vertices).Run();
}

bool Decode(const unsigned char* steps, std::size_t stepsSize, const unsigned char* names, std::size_t namesSize,
  std::size_t triangles, std::size_t vertices, Decoded& decoded)
{
  decoded.NumberOfTriangles = static_cast<std::uint32_t>(triangles);
  decoded.NumberOfVertices = static_cast<std::uint32_t>(vertices);
  return Decoder(StepReader(steps, stepsSize), NameReader(names, namesSize), decoded).Run();
}
}
