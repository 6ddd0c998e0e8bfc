// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTriangleCodec.h"

#include "vtkMTNumberCode.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <numeric>

namespace
{
using vtkMTTriangleCodec::Basis;
using vtkMTTriangleCodec::None;

// In the order of their codes: as many ones as the step's number, then a zero, which the last one does without.
enum Step : unsigned
{
  New = 0,
  Right = 1,   // the third vertex is the end of the next edge of the front
  Left = 2,    // it is the start of the previous one
  Nothing = 3, // no triangle is behind the gate
  Named = 4,
  Both = 5 // right and left at once
};
constexpr unsigned NumberOfSteps = 6;

//------------------------------------------------------------------------------
// The front: gates in doubly linked loops, and those that were not asked yet: a queue with the ones of the present
// cell, and a stack with those that earlier cells have left. Gates behind which there is nothing stay in their loop as
// the border that they are.
class Front
{
public:
  enum StateType : std::uint32_t
  {
    Open,
    Border,
    Gone
  };
  struct Gate
  {
    std::uint32_t From;
    std::uint32_t To;
    std::uint32_t Across; // the third vertex of the gate's triangle
    std::uint32_t Previous;
    std::uint32_t Next;
    StateType State;
  };

  Front(std::size_t triangles, std::size_t vertices)
    : Gates(new Gate[3 * triangles]) // a triangle makes three at most
    , Queue(new std::uint32_t[3 * triangles])
    , Stack(new std::uint32_t[3 * triangles])
    , GateFrom(vertices, None)
  {
  }

  // The open gate whose turn it is; None when there is none.
  std::uint32_t Pop()
  {
    while (this->TakenInCell < vtkMTTriangleCodec::CellSize && this->QueueHead < this->QueueTail)
    {
      const std::uint32_t gate = this->Queue[this->QueueHead++];
      if (this->IsOpen(gate))
      {
        ++this->TakenInCell;
        return gate;
      }
    }
    return this->BeginCell();
  }

  const Gate& Get(std::uint32_t gate) const { return this->Gates[gate]; }
  bool IsOpen(std::uint32_t gate) const { return this->Gates[gate].State == Open; }
  std::uint32_t GetRight(std::uint32_t gate) const { return this->Gates[this->Gates[gate].Next].To; }
  std::uint32_t GetLeft(std::uint32_t gate) const { return this->Gates[this->Gates[gate].Previous].From; }

  void Start(const vtkMTTriangle& t)
  {
    const std::uint32_t first = this->Count;
    for (std::uint32_t c = 0; c < 3; ++c)
    {
      const std::uint32_t gate = this->Add(t[c], t[(c + 1) % 3], t[(c + 2) % 3]);
      this->Gates[gate].Previous = first + (c + 2) % 3;
      this->Gates[gate].Next = first + (c + 1) % 3;
    }
    this->Push(first);
    this->Push(first + 1);
    this->Push(first + 2);
  }

  void MakeBorder(std::uint32_t gate) { this->Gates[gate].State = Border; }

  // The gate gives way to two that go by the third vertex.
  void Split(std::uint32_t gate, std::uint32_t vertex)
  {
    const std::uint32_t from = this->Gates[gate].From;
    const std::uint32_t to = this->Gates[gate].To;
    const std::uint32_t previous = this->Gates[gate].Previous;
    const std::uint32_t next = this->Gates[gate].Next;
    const std::uint32_t left = this->Add(from, vertex, to);
    const std::uint32_t right = this->Add(vertex, to, from);
    this->Link(previous == gate ? right : previous, left);
    this->Link(left, right);
    this->Link(right, next == gate ? left : next);
    this->Gates[gate].State = Gone;
    this->Push(left);
    this->Push(right);
  }

  // The same where that vertex is on the front already: the loop is cut in two there, or two loops become one.
  void SplitAt(std::uint32_t gate, std::uint32_t vertex)
  {
    const std::uint32_t there = this->GateFrom[vertex];
    this->Split(gate, vertex);
    if (there != None && this->Gates[there].State != Gone)
    {
      const std::uint32_t right = this->Count - 1;
      this->Link(this->Gates[there].Previous, right);
      this->Link(right - 1, there);
    }
  }

  // The gate and the next one give way to one.
  void JoinRight(std::uint32_t gate)
  {
    const std::uint32_t next = this->Gates[gate].Next;
    this->Join(gate, next, this->Gates[gate].From, this->Gates[next].To, this->Gates[gate].To);
  }

  void JoinLeft(std::uint32_t gate)
  {
    const std::uint32_t previous = this->Gates[gate].Previous;
    this->Join(previous, gate, this->Gates[previous].From, this->Gates[gate].To, this->Gates[gate].From);
  }

  // Three gates around the triangle are done with.
  void JoinBoth(std::uint32_t gate)
  {
    const Gate g = this->Gates[gate];
    const std::uint32_t before = this->Gates[g.Previous].Previous;
    const std::uint32_t after = this->Gates[g.Next].Next;
    this->Gates[gate].State = this->Gates[g.Previous].State = this->Gates[g.Next].State = Gone;
    this->Link(before, after);
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
  void Push(std::uint32_t gate) { this->Queue[this->QueueTail++] = gate; }
  // What is left of the last cell goes onto the stack, the oldest gate last, and the new one begins at its top.
  std::uint32_t BeginCell()
  {
    while (this->QueueTail > this->QueueHead)
    {
      const std::uint32_t gate = this->Queue[--this->QueueTail];
      this->Stack[this->StackSize] = gate;
      this->StackSize += this->IsOpen(gate) ? 1 : 0;
    }
    this->TakenInCell = 1;
    while (this->StackSize > 0)
    {
      const std::uint32_t gate = this->Stack[--this->StackSize];
      if (this->IsOpen(gate))
      {
        return gate;
      }
    }
    this->TakenInCell = 0;
    return None;
  }
  // Field by field: a gate that was copied as a whole could not be read again before the copy is through.
  std::uint32_t Add(std::uint32_t from, std::uint32_t to, std::uint32_t across)
  {
    const std::uint32_t gate = this->Count++;
    this->Gates[gate].From = from;
    this->Gates[gate].To = to;
    this->Gates[gate].Across = across;
    this->Gates[gate].State = Open;
    this->GateFrom[from] = gate;
    return gate;
  }
  void Link(std::uint32_t a, std::uint32_t b)
  {
    this->Gates[a].Next = b;
    this->Gates[b].Previous = a;
  }
  void Join(std::uint32_t first, std::uint32_t second, std::uint32_t from, std::uint32_t to, std::uint32_t across)
  {
    const std::uint32_t before = this->Gates[first].Previous;
    const std::uint32_t after = this->Gates[second].Next;
    const std::uint32_t joined = this->Add(from, to, across);
    this->Link(before == second ? joined : before, joined);
    this->Link(joined, after == first ? joined : after);
    this->Gates[first].State = this->Gates[second].State = Gone;
    this->Push(joined);
  }

  std::unique_ptr<Gate[]> Gates;
  std::unique_ptr<std::uint32_t[]> Queue; // every gate goes through it once
  std::unique_ptr<std::uint32_t[]> Stack;
  std::uint32_t Count = 0;
  std::uint32_t TakenInCell = 0;
  std::size_t QueueHead = 0;
  std::size_t QueueTail = 0;
  std::size_t StackSize = 0;
  std::vector<std::uint32_t> GateFrom; // the latest that leaves a vertex
};

// Which of the steps closes the gate with that vertex, if it is on the front beside it. The front's links are a help
// only: both sides of the codec follow the same ones, whatever the triangles are.
unsigned FindStep(const Front& front, std::uint32_t gate, std::uint32_t vertex)
{
  const Front::Gate& g = front.Get(gate);
  const bool isRight = g.Next != gate && front.IsOpen(g.Next) && front.GetRight(gate) == vertex;
  const bool isLeft = g.Previous != gate && front.IsOpen(g.Previous) && front.GetLeft(gate) == vertex;
  if (isRight && isLeft && g.Next != g.Previous)
  {
    return Both;
  }
  return isRight ? Right : (isLeft ? Left : Named);
}

// Steps as the decoder may take them: the neighbour must be an open gate of its own.
bool MayJoin(const Front& front, std::uint32_t gate, unsigned step)
{
  const Front::Gate& g = front.Get(gate);
  const bool hasRight = g.Next != gate && front.IsOpen(g.Next);
  const bool hasLeft = g.Previous != gate && front.IsOpen(g.Previous);
  return step == Right ? hasRight : (step == Left ? hasLeft : hasRight && hasLeft && g.Next != g.Previous);
}

//------------------------------------------------------------------------------
class StepWriter
{
public:
  void Put(unsigned step)
  {
    for (unsigned i = 0; i < step; ++i)
    {
      this->PutBit(true);
    }
    if (step + 1 < NumberOfSteps)
    {
      this->PutBit(false);
    }
  }
  std::vector<unsigned char> Bytes;

private:
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
  std::size_t Count = 0;
};

class StepReader
{
public:
  StepReader(const unsigned char* bytes, std::size_t size)
    : Bytes(bytes)
    , Size(size)
  {
  }
  // NumberOfSteps when the bits have ended.
  unsigned Get()
  {
    if (this->Have < NumberOfSteps)
    {
      this->Fill();
    }
    const auto ones =
      static_cast<unsigned>(__builtin_ctzll(~this->Pending | (std::uint64_t(1) << (NumberOfSteps - 1))));
    const unsigned length = ones + (ones + 1 < NumberOfSteps ? 1 : 0);
    if (length > this->Have)
    {
      return NumberOfSteps;
    }
    this->Pending >>= length;
    this->Have -= length;
    return ones;
  }
  // Whether nothing but the zeros that fill the last byte are left.
  bool IsAtEnd() const { return this->At == this->Size && this->Have < 8 && this->Pending == 0; }

private:
  void Fill()
  {
    if (this->At + sizeof(std::uint32_t) <= this->Size)
    {
      std::uint32_t more;
      std::memcpy(&more, this->Bytes + this->At, sizeof(more));
      this->Pending |= std::uint64_t(more) << this->Have;
      this->At += sizeof(more);
      this->Have += 8 * sizeof(more);
      return;
    }
    while (this->Have <= 56 && this->At < this->Size)
    {
      this->Pending |= std::uint64_t(this->Bytes[this->At++]) << this->Have;
      this->Have += 8;
    }
  }
  const unsigned char* Bytes;
  std::size_t Size;
  std::size_t At = 0;
  std::uint64_t Pending = 0;
  unsigned Have = 0;
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
  // A triangle that is not done and runs from a to b, which is its corner `Index` to the next; the first of them.
  Corner Find(std::uint32_t a, std::uint32_t b) const
  {
    for (std::size_t i = this->First[a]; i < this->First[a + std::size_t(1)]; ++i)
    {
      const Corner& corner = this->Corners[i];
      if (!this->IsDone[corner.Triangle] && this->Triangles[corner.Triangle][(corner.Index + 1) % 3] == b)
      {
        return corner;
      }
    }
    return {};
  }
  void Finish(std::uint32_t triangle) { this->IsDone[triangle] = 1; }
  bool IsFinished(std::uint32_t triangle) const { return this->IsDone[triangle] != 0; }

private:
  std::vector<std::size_t> First;
  std::vector<Corner> Corners;
  const std::vector<vtkMTTriangle>& Triangles;
  std::vector<unsigned char> IsDone;
};

class Encoder
{
public:
  Encoder(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices)
    : Triangles(triangles)
    , Behind(triangles, vertices)
    , Growing(triangles.size(), vertices)
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
    return std::move(this->Result);
  }

private:
  void StartAt(std::uint32_t triangle)
  {
    const vtkMTTriangle& t = this->Triangles[triangle];
    for (std::uint32_t v : t)
    {
      this->Name(v);
    }
    this->Behind.Finish(triangle);
    this->Result.Triangles.push_back(t);
    this->Result.Order.push_back(triangle);
    this->Growing.Start(t);
  }

  // 0 is a new vertex, k the k-th last one that was met.
  void Name(std::uint32_t vertex)
  {
    const bool isNew = this->Number[vertex] == None;
    vtkMTNumberCode::Append(this->Result.Names, isNew ? 0 : this->Met - this->Number[vertex]);
    this->Number[vertex] = isNew ? this->Met++ : this->Number[vertex];
  }

  void Cross(std::uint32_t gate)
  {
    const Front::Gate g = this->Growing.Get(gate);
    const Edges::Corner behind = this->Behind.Find(g.To, g.From);
    if (behind.Triangle == None)
    {
      this->Steps.Put(Nothing);
      this->Growing.MakeBorder(gate);
      return;
    }
    const std::uint32_t third = this->Triangles[behind.Triangle][(behind.Index + 2) % 3];
    this->Behind.Finish(behind.Triangle);
    this->Result.Triangles.push_back({ g.To, g.From, third });
    this->Result.Order.push_back(behind.Triangle);
    if (this->Number[third] == None)
    {
      this->Steps.Put(New);
      this->Number[third] = this->Met++;
      this->Growing.Split(gate, third);
      return;
    }
    const unsigned step = FindStep(this->Growing, gate, third);
    this->Steps.Put(step);
    switch (step)
    {
      case Right:
        return this->Growing.JoinRight(gate);
      case Left:
        return this->Growing.JoinLeft(gate);
      case Both:
        return this->Growing.JoinBoth(gate);
      default:
        this->Name(third);
        this->Growing.SplitAt(gate, third);
    }
  }

  const std::vector<vtkMTTriangle>& Triangles;
  Edges Behind;
  Front Growing;
  std::vector<std::uint32_t> Number;
  std::uint32_t Met = 0;
  StepWriter Steps;
  vtkMTTriangleCodec::Coded Result;
};

class Decoder
{
public:
  Decoder(StepReader steps, vtkMTNumberCode::Reader names, std::size_t triangles, std::size_t vertices,
    std::vector<Basis>& bases, std::vector<std::uint32_t>& border)
    : Steps(steps)
    , Names(names)
    , Bases(bases)
    , Border(border)
    , Growing(triangles, vertices)
  {
  }

  bool Run(std::vector<vtkMTTriangle>& triangles)
  {
    vtkMTTriangle* const end = triangles.data() + triangles.size();
    for (vtkMTTriangle* next = triangles.data(); next != end;)
    {
      const std::uint32_t gate = this->Growing.Pop();
      if (!(gate == None ? this->Start(*next++) : this->Cross(gate, next)))
      {
        return false;
      }
    }
    this->Bases.resize(this->Met);
    this->TakeBorder();
    return this->Steps.IsAtEnd() && this->Names.IsAtEnd();
  }

private:
  void TakeBorder()
  {
    for (std::uint32_t gate = this->Growing.Pop(); gate != None; gate = this->Growing.Pop())
    {
      this->BorderGates.push_back(gate);
    }
    for (const std::uint32_t gate : this->BorderGates)
    {
      this->Growing.TakeLoop(gate, this->Border);
    }
  }

  bool Meet(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    if (this->Met == this->Bases.size())
    {
      return false;
    }
    Basis& basis = this->Bases[this->Met++];
    basis.A = a;
    basis.B = b;
    basis.C = c;
    return true;
  }

  bool Name(std::uint32_t before, std::uint32_t& vertex)
  {
    std::uint64_t back = 0;
    if (!this->Names.Get(back) || back > this->Met)
    {
      return false;
    }
    vertex = this->Met - static_cast<std::uint32_t>(back);
    return back > 0 || this->Meet(before, None, None);
  }

  bool Start(vtkMTTriangle& t)
  {
    std::uint32_t before = None;
    for (std::uint32_t& vertex : t)
    {
      if (!this->Name(before, vertex))
      {
        return false;
      }
      before = vertex;
    }
    this->Growing.Start(t);
    return true;
  }

  bool Cross(std::uint32_t gate, vtkMTTriangle*& next)
  {
    const std::uint32_t from = this->Growing.Get(gate).From;
    const std::uint32_t to = this->Growing.Get(gate).To;
    const std::uint32_t across = this->Growing.Get(gate).Across;
    const unsigned step = this->Steps.Get();
    if (step == Nothing)
    {
      this->Growing.MakeBorder(gate);
      this->BorderGates.push_back(gate);
      return true;
    }
    vtkMTTriangle& triangle = *next++;
    triangle = { to, from, this->Met };
    if (step == New)
    {
      if (!this->Meet(from, to, across))
      {
        return false;
      }
      this->Growing.Split(gate, triangle[2]);
      return true;
    }
    if (step == Named)
    {
      std::uint64_t back = 0;
      if (!this->Names.Get(back) || back == 0 || back > this->Met)
      {
        return false;
      }
      triangle[2] -= static_cast<std::uint32_t>(back);
      this->Growing.SplitAt(gate, triangle[2]);
      return true;
    }
    return step < NumberOfSteps && MayJoin(this->Growing, gate, step) && this->Join(gate, step, triangle[2]);
  }

  bool Join(std::uint32_t gate, unsigned step, std::uint32_t& third)
  {
    third = step == Left ? this->Growing.GetLeft(gate) : this->Growing.GetRight(gate);
    if (step == Both)
    {
      this->Growing.JoinBoth(gate);
    }
    else if (step == Right)
    {
      this->Growing.JoinRight(gate);
    }
    else
    {
      this->Growing.JoinLeft(gate);
    }
    return true;
  }

  StepReader Steps;
  vtkMTNumberCode::Reader Names;
  std::vector<Basis>& Bases; // one for every vertex that there may be
  std::vector<std::uint32_t>& Border;
  std::vector<std::uint32_t> BorderGates; // as they became that, then those that are still open
  std::uint32_t Met = 0;
  Front Growing;
};
}

namespace vtkMTTriangleCodec
{
Coded Encode(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices)
{
  return Encoder(triangles, vertices).Run();
}

bool Decode(const unsigned char* steps, std::size_t stepsSize, const unsigned char* names, std::size_t namesSize,
  std::size_t vertices, std::vector<vtkMTTriangle>& triangles, std::vector<Basis>& bases,
  std::vector<std::uint32_t>& border)
{
  bases.assign(vertices, Basis());
  border.clear();
  return Decoder(
    StepReader(steps, stepsSize), vtkMTNumberCode::Reader(names, namesSize), triangles.size(), vertices, bases, border)
    .Run(triangles);
}
}
