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
  // The nearest gate becomes one that is so many bytes farther on in memory.
  void Move(std::size_t bytes) { this->Last = reinterpret_cast<Gate*>(reinterpret_cast<char*>(this->Last) + bytes); }
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

  bool HasGate() const { return this->Hinge != None; }
  std::uint32_t GetHinge() const { return this->Hinge; }
  std::uint32_t GetRear() const { return this->Rear; }
  std::uint32_t GetAcross() const { return this->Across; }
  std::uint32_t GetOwner() const { return this->Owner; }
  // 1: the gate runs from its rear to its hinge; 0: the other way round.
  std::uint32_t IsForward() const { return this->Forward; }
  // Without a branch, as the gate may run either way.
  std::uint32_t GetFrom() const { return this->Hinge ^ ((this->Hinge ^ this->Rear) & (0u - this->Forward)); }
  std::uint32_t GetTo() const { return this->Rear ^ ((this->Hinge ^ this->Rear) & (0u - this->Forward)); }

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
    this->Forward = 1;
    this->Joined = 0;
    this->Set(t[0], t[1], t[2], triangle, AfterAhead);
    this->AheadSide.Push(t[0], t[1], triangle, Gate::Open);
    this->AheadSide.Push(t[2], t[0], triangle, Gate::Open);
    this->Settle();
  }

  // The gate gives way to two that go by the third vertex; the one at the hinge is the next.
  vtkMTInlined void Split(std::uint32_t vertex, std::uint32_t triangle, SituationType past)
  {
    this->BehindSide.Push(this->Rear, this->Hinge, triangle, Gate::Open);
    this->Set(vertex, this->Hinge, this->Rear, triangle, past);
    this->Settle();
  }
  // The third vertex is on the front behind: what is between it and the rear is gone around first.
  vtkMTInlined void SplitBehind(std::uint32_t vertex, std::uint32_t triangle)
  {
    this->AheadSide.Push(this->Hinge, this->Rear, triangle, Gate::Open);
    this->Set(this->Rear, vertex, this->Hinge, triangle, AfterOther);
    this->Turn();
    this->Settle();
  }
  // The gate and the one ahead or behind give way to one.
  vtkMTInlined void JoinAhead(std::uint32_t triangle)
  {
    this->Set(this->Rear, this->AheadSide.Last->Vertex, this->Hinge, triangle, AfterAhead);
    --this->AheadSide.Last;
    ++this->Joined;
    this->Settle();
  }
  vtkMTInlined void JoinBehind(std::uint32_t triangle)
  {
    this->Set(this->BehindSide.Last->Vertex, this->Hinge, this->Rear, triangle, AfterOther);
    --this->BehindSide.Last;
    this->Settle();
  }

  // Split (after which the vertex is the rear) where all bits of the mask are set, join ahead (after which the vertex
  // is the hinge) where none is: unpredictable, so both take the same steps. It is to be settled after that.
  vtkMTInlined void Grow(std::uint32_t mask, std::uint32_t vertex, std::uint32_t triangle)
  {
    Gate* const behind = this->BehindSide.Last + 1; // just memory when this is a join
    behind->Vertex = this->Rear;
    behind->Across = this->Hinge;
    behind->Owner = triangle;
    behind->State = Gate::Open;
    const std::size_t pushed = mask & sizeof(Gate);
    this->BehindSide.Move(pushed);
    --this->AheadSide.Last;
    this->AheadSide.Move(pushed);
    this->Across = Pick(mask, this->Rear, this->Hinge);
    this->Rear = Pick(mask, vertex, this->Rear);
    this->Hinge = Pick(mask, this->Hinge, vertex);
    this->Owner = triangle;
    this->Joined += mask + 1;
    this->Past = mask & AfterNew;
  }
  // The first number where all bits of the mask are set, the second one where none is.
  static std::uint32_t Pick(std::uint32_t mask, std::uint32_t a, std::uint32_t b) { return b ^ ((a ^ b) & mask); }

  // Whether Settle has something to do after Grow.
  bool IsUnsettled() const
  {
    const Gate& ahead = *this->AheadSide.Last;
    return ahead.Vertex == this->Rear || this->BehindSide.Last->Vertex == this->Hinge || ahead.State == Gate::End ||
      this->Joined >= SweepLength;
  }
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
    this->AheadSide.Push(this->Hinge, None, None, Gate::Closed);
    this->AheadSide.Last -= static_cast<std::ptrdiff_t>(isAhead | isBehind);
    this->Take(Pick(0u - static_cast<std::uint32_t>(!isAhead & isBehind), this->Hinge, this->Rear));
  }

  // Calls see(from, to) for the gates that are not closed: the present one, those ahead, those behind, nearest first.
  template <class See>
  void SeeOpen(const See& see) const
  {
    if (this->HasGate())
    {
      see(this->GetFrom(), this->GetTo());
      SeeOpen(this->AheadSide, this->Hinge, this->Forward != 0, see);
      SeeOpen(this->BehindSide, this->Rear, this->Forward == 0, see);
    }
  }

private:
  // So many gates are gone from the far end of a side before the others are moved there.
  static constexpr std::ptrdiff_t MostGone = 64;

  vtkMTInlined void Set(
    std::uint32_t rear, std::uint32_t hinge, std::uint32_t across, std::uint32_t owner, std::uint32_t past)
  {
    this->Rear = rear;
    this->Hinge = hinge;
    this->Across = across;
    this->Owner = owner;
    this->Past = past;
  }

  vtkMTInlined void Turn()
  {
    std::swap(this->AheadSide, this->BehindSide);
    std::swap(this->Hinge, this->Rear);
    this->Forward ^= 1;
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
    if (this->AheadSide.IsOpenTo(this->Rear))
    {
      --this->AheadSide.Last;
      here = this->Rear;
      return true;
    }
    if (this->BehindSide.IsOpenTo(this->Hinge))
    {
      --this->BehindSide.Last;
      here = this->Hinge;
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
          this->Hinge = None;
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
  std::uint32_t Hinge = None;
  std::uint32_t Rear = None;
  std::uint32_t Across = None;
  std::uint32_t Owner = None;
  std::uint32_t Past = AfterAhead;
  std::uint32_t Joined = 0; // since the last turn
  std::uint32_t Forward = 1;
};
}
}

#undef vtkMTInlined

#endif
