// SPDX-License-Identifier: BSD-3-Clause
// What both sides of the triangle codec follow: the front, and how steps at its gates are encoded. Not installed.
#ifndef vtkMTTriangleFront_h
#define vtkMTTriangleFront_h

#include "vtkMTTriangleCodec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

// The decoder keeps the front in registers, which only works where all that changes it is inlined.
#define vtkMTInlined [[gnu::always_inline]] inline

namespace vtkMTTriangleCodec
{
// Each side's own: of functions that others might share the compiler inlines fewer.
namespace
{
// How the third vertex of the triangle behind the present gate is found.
enum Step : unsigned char
{
  Ahead,   // it is the far end of the gate ahead
  New,     // it was not met yet
  Second,  // it is the far end of the second gate ahead
  Behind,  // it is the far end of the gate behind
  Named,   // it was met before and is named
  Nothing, // there is no triangle
  Impossible
};

// A step is encoded by so many ones and a zero. What they mean depends on what both sides of the codec know: what was
// done last, and whether the gates ahead and behind are open. These are bits of an index, with the ones as the lowest.
inline constexpr unsigned TooManyOnes = 7;
enum SituationType : std::uint32_t
{
  AheadIsClosed = 1 << 3,
  BehindIsClosed = 1 << 4,
  AfterAhead = 0 << 5,
  AfterNew = 1 << 5,
  AfterEnd = 2 << 5, // of a gate
  AfterOther = 3 << 5,
  NumberOfSituations = 4 << 5
};
using StepRow = std::array<Step, TooManyOnes + 1>;

// What comes oftenest is first, and what cannot be has no code.
constexpr StepRow GetSteps(std::uint32_t situation)
{
  const bool isBehindOpen = (situation & BehindIsClosed) == 0;
  if ((situation & AheadIsClosed) != 0)
  {
    return { Nothing, New, Named, isBehindOpen ? Behind : Second, isBehindOpen ? Second : Impossible, Impossible,
      Impossible, Impossible };
  }
  if (!isBehindOpen)
  {
    return { Nothing, New, Ahead, Named, Second, Impossible, Impossible, Impossible };
  }
  switch (situation & AfterOther)
  {
    case AfterAhead:
      return { New, Ahead, Nothing, Named, Behind, Second, Impossible, Impossible };
    case AfterNew:
      return { New, Ahead, Second, Nothing, Named, Behind, Impossible, Impossible };
    case AfterEnd:
      return { New, Behind, Ahead, Named, Nothing, Second, Impossible, Impossible };
    default:
      return { Ahead, New, Behind, Named, Second, Nothing, Impossible, Impossible };
  }
}
constexpr std::array<Step, NumberOfSituations> GetAllSteps()
{
  std::array<Step, NumberOfSituations> steps{};
  for (std::uint32_t i = 0; i < NumberOfSituations; ++i)
  {
    steps[i] = GetSteps(i)[i & TooManyOnes];
  }
  return steps;
}
inline constexpr std::array<Step, NumberOfSituations> Steps = GetAllSteps(); // by situation + ones

// How many gates are joined before the front turns. Longer sweeps take fewer bits, and leave the GPU's vertex cache.
inline constexpr std::uint32_t SweepLength = 8;

// A vertex that is named is mostly a few gates away along the front.
inline constexpr std::uint32_t MostWalk = 128;
inline constexpr unsigned MostNameBits = 31;
constexpr bool IsBehind(std::uint64_t walk)
{
  return walk > 0 && walk % 2 == 0;
}

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

// The border from its gates, of which there are `count`: from each to the latest one that starts where it ends, as far
// as none was passed before.
inline void FollowBorder(std::uint32_t count, Decoded& mesh)
{
  BorderGate* const gates = mesh.Work.BorderGates.data();
  // Only what is written here counts: a gate that is not the right one does not start at the vertex.
  std::uint32_t* const gateFrom = EnsureSize(mesh.Work.BorderFrom, mesh.NumberOfVertices);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    gateFrom[gates[i].From] = i;
  }
  mesh.Border.clear();
  for (std::uint32_t i = 0; i < count; ++i)
  {
    std::uint32_t from = gates[i].From;
    for (std::uint32_t gate = i; from != None && gate < count && gates[gate].From == from; gate = gateFrom[from])
    {
      mesh.Border.push_back(from);
      gates[gate].From = None;
      from = gates[gate].To;
    }
  }
}

//------------------------------------------------------------------------------
// The gates that wait on one side of the present one, the nearest last.
struct Side
{
  Gate* Last;
  Gate* First; // before the farthest one: the end of the side
  Gate* Memory;

  void Clear()
  {
    this->First = this->Last = this->Memory;
    *this->First = { None, None, None, Gate::End };
  }
  bool IsEmpty() const { return this->Last == this->First; }
  bool IsOpen() const { return this->Last->State == Gate::Open; }
  bool IsOpenTo(std::uint32_t vertex) const { return this->IsOpen() && this->Last->Vertex == vertex; }
  bool IsClosed() const { return this->Last->State == Gate::Closed; }
  std::size_t GetCount() const { return static_cast<std::size_t>(this->Last - this->First); }

  // Field by field, here and where they are read: what was written in parts and is read as a whole has to wait.
  vtkMTInlined void Push(std::uint32_t vertex, std::uint32_t across, std::uint32_t owner, Gate::StateType state)
  {
    Gate* const gate = ++this->Last;
    gate->Vertex = vertex;
    gate->Across = across;
    gate->Owner = owner;
    gate->State = state;
  }
  // By gates that take so many bytes.
  void Shorten(std::size_t bytes) { this->Last = reinterpret_cast<Gate*>(reinterpret_cast<char*>(this->Last) - bytes); }
};

//------------------------------------------------------------------------------
// The front, a ring of gates around what is known, with a cursor: the present gate, whose *hinge* is the end about
// which triangles are laid, and whose *rear* is the other one. The others wait ahead, beyond the hinge, and behind,
// beyond the rear, and the ring is closed where both sides end. Gates next to each other that became border are one
// closed gate.
class Front
{
public:
  Front(std::size_t triangles, Workspace& workspace)
  {
    // A triangle makes the ring longer by one gate at most, a start by three.
    const std::size_t size = triangles + MostGone + 8;
    Gate* const gates = EnsureSize(workspace.Gates, 2 * size);
    this->AheadSide.Memory = gates;
    this->BehindSide.Memory = gates + size;
    this->AheadSide.Clear();
    this->BehindSide.Clear();
  }

  bool HasGate() const { return this->GetHinge() != None; }
  std::uint32_t GetHinge() const { return static_cast<std::uint32_t>(this->Ends >> 32); }
  std::uint32_t GetRear() const { return static_cast<std::uint32_t>(this->Ends); }
  // The rear in the low half, the hinge in the high one.
  std::uint64_t GetEnds() const { return this->Ends; }
  // Where the gate runs to in the low half, where it comes from in the high one: the ends as they are, or exchanged.
  std::uint64_t GetToAndFrom() const
  {
    return this->Ends >> this->Forward | this->Ends << ((64 - this->Forward) % 64); // without a branch
  }
  std::uint32_t GetAcross() const { return this->Across; }
  std::uint32_t GetOwner() const { return this->Owner; }
  std::uint32_t GetFrom() const { return static_cast<std::uint32_t>(this->GetToAndFrom() >> 32); }
  std::uint32_t GetTo() const { return static_cast<std::uint32_t>(this->GetToAndFrom()); }

  bool IsAheadOpen() const { return this->AheadSide.IsOpen(); }
  bool IsBehindOpen() const { return this->BehindSide.IsOpen(); }
  std::uint32_t GetSituation() const
  {
    return this->Past + (this->AheadSide.Last->State & AheadIsClosed) + (this->BehindSide.Last->State & BehindIsClosed);
  }

  // The far end of the gate ahead or behind; None when there is no gate.
  std::uint32_t GetAhead() const { return this->AheadSide.Last->Vertex; }
  std::uint32_t GetBehind() const { return this->BehindSide.Last->Vertex; }
  // The far end of a gate: 1, 3, 5 ... of the first, the second, the third one ahead, 2, 4, 6 ... of those behind. None
  // when there is no such gate.
  std::uint32_t Walk(std::uint32_t walk) const
  {
    const bool isAhead = walk % 2 != 0;
    const Gate* const last = isAhead ? this->AheadSide.Last : this->BehindSide.Last;
    const Gate* const first = isAhead ? this->AheadSide.First : this->BehindSide.First;
    const std::ptrdiff_t count = (std::ptrdiff_t(walk) + 1) / 2;
    return count > last - first ? None : last[1 - count].Vertex;
  }

  vtkMTInlined void Start(const vtkMTTriangle& t, std::uint32_t triangle)
  {
    this->AheadSide.Clear();
    this->BehindSide.Clear();
    this->Forward = 32;
    this->Joined = 0;
    this->Set(t[0], t[1], t[2], triangle, AfterAhead);
    this->AheadSide.Push(t[0], t[1], triangle, Gate::Open);
    this->AheadSide.Push(t[2], t[0], triangle, Gate::Open);
    this->Settle();
  }

  // The gate gives way to two that go by the third vertex; the one at the hinge is the next.
  vtkMTInlined void Split(std::uint32_t vertex, std::uint32_t triangle, SituationType past)
  {
    this->BehindSide.Push(this->GetRear(), this->GetHinge(), triangle, Gate::Open);
    this->Set(vertex, this->GetHinge(), this->GetRear(), triangle, past);
    this->Settle();
  }
  // The third vertex is on the front behind: what is between it and the rear is gone around first.
  vtkMTInlined void SplitBehind(std::uint32_t vertex, std::uint32_t triangle)
  {
    this->AheadSide.Push(this->GetHinge(), this->GetRear(), triangle, Gate::Open);
    this->Set(this->GetRear(), vertex, this->GetHinge(), triangle, AfterOther);
    this->Turn();
    this->Settle();
  }
  // The gate and the one ahead or behind give way to one.
  vtkMTInlined void JoinAhead(std::uint32_t triangle)
  {
    this->Set(this->GetRear(), this->AheadSide.Last->Vertex, this->GetHinge(), triangle, AfterAhead);
    --this->AheadSide.Last;
    ++this->Joined;
    this->Settle();
  }
  vtkMTInlined void JoinBehind(std::uint32_t triangle)
  {
    this->Set(this->BehindSide.Last->Vertex, this->GetHinge(), this->GetRear(), triangle, AfterOther);
    --this->BehindSide.Last;
    this->Settle();
  }

  // Split, after which the vertex is the rear, or join ahead (isJoin is 1), after which the vertex is the hinge and
  // which is taken from there: unpredictable, so both take the same steps. It is to be settled after that. Returns the
  // vertex.
  vtkMTInlined std::uint32_t Grow(std::uint32_t isJoin, std::uint32_t vertex, std::uint32_t triangle)
  {
    Gate* const behind = this->BehindSide.Last + 1; // just memory when this is a join
    const std::uint64_t open = triangle;
    static_assert(Gate::Open == 0);
    std::memcpy(&behind->Vertex, &this->Ends, sizeof(this->Ends)); // and Across
    std::memcpy(&behind->Owner, &open, sizeof(open));              // and State
    const std::uint32_t third = vertex ^ ((vertex ^ this->AheadSide.Last->Vertex) & (0u - isJoin));
    const std::size_t joined = isJoin * sizeof(Gate);
    this->AheadSide.Shorten(joined);
    this->BehindSide.Last = behind;
    this->BehindSide.Shorten(joined);
    // The end that is replaced is across the new gate.
    const std::uint32_t place = 32 * isJoin;
    this->Across = static_cast<std::uint32_t>(this->Ends >> place);
    this->Ends ^= std::uint64_t(this->Across ^ third) << place;
    this->Owner = triangle;
    this->Joined += isJoin;
    this->Past = AfterNew ^ place;
    return third;
  }

  // Whether Settle has something to do after Grow.
  bool IsUnsettled() const
  {
    const Gate& ahead = *this->AheadSide.Last;
    return ahead.Vertex == this->GetRear() || this->BehindSide.Last->Vertex == this->GetHinge() ||
      ahead.State == Gate::End || this->Joined >= SweepLength;
  }
  bool IsBetweenOpen() const { return (this->AheadSide.Last->State | this->BehindSide.Last->State) == Gate::Open; }
  vtkMTInlined void Settle()
  {
    this->Refill();
    std::uint32_t here = None;
    if (this->Meet(here))
    {
      this->Take(here);
    }
    else if (this->Joined >= SweepLength)
    {
      this->Turn();
      this->Past = AfterOther;
    }
  }

  // There is nothing behind the gate: it is closed, and one with those beside it that are closed too.
  vtkMTInlined void MakeBorder()
  {
    const bool isAhead = this->AheadSide.IsClosed();
    const bool isBehind = this->BehindSide.IsClosed();
    this->AheadSide.Push(this->GetHinge(), None, None, Gate::Closed);
    this->AheadSide.Last -= static_cast<std::ptrdiff_t>(isAhead | isBehind);
    this->Take(static_cast<std::uint32_t>(this->Ends >> (!isAhead & isBehind ? 32 : 0)));
  }

  // Calls see(from, to) for the gates that are not closed: the present one, those ahead, those behind, nearest first.
  template <class See>
  void SeeOpen(const See& see) const
  {
    if (this->HasGate())
    {
      see(this->GetFrom(), this->GetTo());
      SeeOpen(this->AheadSide, this->GetHinge(), this->Forward != 0, see);
      SeeOpen(this->BehindSide, this->GetRear(), this->Forward == 0, see);
    }
  }

private:
  // So many gates are gone from the far end of a side before the others are moved there.
  static constexpr std::ptrdiff_t MostGone = 64;

  vtkMTInlined void Set(
    std::uint32_t rear, std::uint32_t hinge, std::uint32_t across, std::uint32_t owner, std::uint32_t past)
  {
    this->Ends = rear | std::uint64_t(hinge) << 32;
    this->Across = across;
    this->Owner = owner;
    this->Past = past;
  }

  vtkMTInlined void Turn()
  {
    std::swap(this->AheadSide, this->BehindSide);
    this->Ends = this->Ends >> 32 | this->Ends << 32;
    this->Forward ^= 32;
    this->Joined = 0;
  }

  // Behind the end of a side comes the farthest gate of the other one.
  vtkMTInlined void Refill()
  {
    this->Refill(this->AheadSide, this->BehindSide);
    this->Refill(this->BehindSide, this->AheadSide);
  }
  vtkMTInlined void Refill(Side& side, Side& other)
  {
    if (!side.IsEmpty() || other.GetCount() < 2)
    {
      return;
    }
    const Gate* const gate = other.First + 1;
    side.Clear();
    side.Push(other.First[2].Vertex, gate->Across, gate->Owner, static_cast<Gate::StateType>(gate->State));
    *++other.First = { None, None, None, Gate::End };
    if (other.First - other.Memory > MostGone)
    {
      const std::size_t count = other.GetCount();
      std::memmove(other.Memory, other.First, (count + 1) * sizeof(Gate));
      other.First = other.Memory;
      other.Last = other.First + count;
    }
  }

  // Two gates that go back and forth between the same vertices are behind each other: both are done with. here: the
  // vertex at which what is left meets.
  vtkMTInlined bool Meet(std::uint32_t& here)
  {
    if (this->AheadSide.IsOpenTo(this->GetRear()))
    {
      --this->AheadSide.Last;
      here = this->GetRear();
      return true;
    }
    if (this->BehindSide.IsOpenTo(this->GetHinge()))
    {
      --this->BehindSide.Last;
      here = this->GetHinge();
      return true;
    }
    return false;
  }

  // Goes on with the open gate that is next, rather ahead, from the vertex at which both sides meet.
  vtkMTInlined void Take(std::uint32_t here)
  {
    do
    {
      this->Refill();
      while (!this->AheadSide.IsOpen() && !this->BehindSide.IsOpen())
      {
        if (this->AheadSide.IsEmpty() || this->BehindSide.IsEmpty())
        {
          this->Ends = NoEnds;
          return;
        }
        here = this->BehindSide.Last->Vertex; // what is closed on both sides becomes one
        --this->BehindSide.Last;
        this->Refill();
      }
      if (!this->AheadSide.IsOpen())
      {
        this->Turn();
      }
      const Gate* const gate = this->AheadSide.Last--;
      this->Set(here, gate->Vertex, gate->Across, gate->Owner, AfterEnd);
      this->Refill();
    } while (this->Meet(here));
  }

  template <class See>
  static void SeeOpen(const Side& side, std::uint32_t near, bool isForward, const See& see)
  {
    for (const Gate* gate = side.Last; gate != side.First; near = gate->Vertex, --gate)
    {
      if (gate->State == Gate::Open)
      {
        see(isForward ? near : gate->Vertex, isForward ? gate->Vertex : near);
      }
    }
  }

  Side AheadSide;
  Side BehindSide;
  static constexpr std::uint64_t NoEnds = ~std::uint64_t(0);
  std::uint64_t Ends = NoEnds;
  std::uint32_t Across = None;
  std::uint32_t Owner = None;
  std::uint32_t Past = AfterAhead;
  std::uint32_t Joined = 0;   // since the last turn
  std::uint32_t Forward = 32; // the gate runs from its rear to its hinge; 0: the other way round
};
}
}

#undef vtkMTInlined

#endif
