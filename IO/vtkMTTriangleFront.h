// SPDX-License-Identifier: BSD-3-Clause
// What both sides of the triangle codec follow: the front, and how steps at its gates are said. Not installed.
#ifndef vtkMTTriangleFront_h
#define vtkMTTriangleFront_h

#include "vtkMTTriangleCodec.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vtkMTTriangleCodec
{
// Each side's own: as functions that others might share the compiler inlines fewer, and decoding takes 5 % longer.
namespace
{
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
inline constexpr unsigned MostOnes = 5;

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
inline constexpr StepRow Steps[8] = { GetSteps(false, false, false), GetSteps(true, false, false),
  GetSteps(false, true, false), GetSteps(true, true, false), GetSteps(false, false, true), GetSteps(true, false, true),
  GetSteps(false, true, true), GetSteps(true, true, true) };

// A vertex that is named is mostly a few gates away along the front.
inline constexpr std::uint32_t MostWalk = 16;
inline constexpr unsigned MostNameBits = 31;

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

  // A triangle makes three gates at most.
  Front(std::size_t triangles, std::size_t vertices, Workspace& workspace)
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
    while (this->TakenInCell < CellSize && this->Head < this->Count)
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
      GateRange& range = this->Waiting->back();
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
  std::uint32_t* GateFrom;         // the latest that leaves a vertex
  std::vector<GateRange>* Waiting; // of earlier cells
  std::uint32_t Count = 0;
  std::uint32_t Head = 0; // of the present cell's gates the first that was not asked
  std::uint32_t TakenInCell = 0;
};
}
}

#endif
