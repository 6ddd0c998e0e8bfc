// SPDX-License-Identifier: BSD-3-Clause
// The codec's one side: from triangles to steps and names.
#include "vtkMTTriangleEdges.h"
#include "vtkMTTriangleFront.h"

namespace
{
using namespace vtkMTTriangleCodec;

// How the third vertex is found when it was met before.
Step FindStep(const Front& front, std::uint32_t vertex)
{
  if (front.IsAheadOpen() && front.Walk(1) == vertex)
  {
    return Ahead;
  }
  if (front.IsBehindOpen() && front.Walk(2) == vertex)
  {
    return Behind;
  }
  return front.Walk(3) == vertex ? Second : Named;
}

// The walk that leads to it; 0 when it is not near.
std::uint32_t FindWalk(const Front& front, std::uint32_t vertex)
{
  std::uint32_t walk = 1;
  while (walk <= MostWalk && front.Walk(walk) != vertex)
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
    for (std::uint32_t at = situation; Steps[at] != step; ++at)
    {
      this->PutBit(true);
    }
    this->PutBit(false);
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

//------------------------------------------------------------------------------
class Encoder
{
public:
  Encoder(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices)
    : Triangles(triangles)
    , Lookup(triangles, vertices)
    , Growing(triangles.size(), this->Work)
    , Number(vertices, None)
  {
    this->Result.Triangles.reserve(triangles.size());
    this->Result.Order.reserve(triangles.size());
  }

  Coded Run()
  {
    for (std::uint32_t seed = 0; this->Result.Triangles.size() < this->Triangles.size();)
    {
      if (this->Growing.HasGate())
      {
        this->Cross();
        continue;
      }
      while (this->Lookup.IsFinished(seed))
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
    this->Lookup.Finish(triangle);
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

  // Returns the walk.
  std::uint32_t PutWalk(std::uint32_t vertex)
  {
    const std::uint32_t walk = FindWalk(this->Growing, vertex);
    this->Names.push_back({ walk, true });
    if (walk == 0)
    {
      this->PutName(vertex);
    }
    return walk;
  }

  void Cross()
  {
    const std::uint32_t from = this->Growing.GetFrom();
    const std::uint32_t to = this->Growing.GetTo();
    const std::uint32_t situation = this->Growing.GetSituation();
    const vtkMTTriangleEdges::Corner behind = this->Lookup.Find(to, from);
    if (behind.Triangle == None)
    {
      this->Steps.Put(Nothing, situation);
      this->Growing.MakeBorder();
      return;
    }
    const std::uint32_t third = this->Triangles[behind.Triangle][(behind.Index + 2) % 3];
    const bool isNew = this->Number[third] == None;
    const Step step = isNew ? New : FindStep(this->Growing, third);
    this->Steps.Put(step, situation);
    this->Follow(step, third);
    this->Number[third] = isNew ? this->Met++ : this->Number[third];
    this->Lookup.Finish(behind.Triangle);
    this->Result.Triangles.push_back({ to, from, third });
    this->Result.Order.push_back(behind.Triangle);
  }

  void Follow(Step step, std::uint32_t third)
  {
    const std::uint32_t triangle = this->GetDone();
    switch (step)
    {
      case Ahead:
        this->Growing.JoinAhead(triangle);
        break;
      case Behind:
        this->Growing.JoinBehind(triangle);
        break;
      case New:
        this->Growing.Split(third, triangle, AfterNew);
        break;
      case Named:
        if (IsBehind(this->PutWalk(third)))
        {
          this->Growing.SplitBehind(third, triangle);
          break;
        }
        [[fallthrough]];
      default:
        this->Growing.Split(third, triangle, AfterOther);
    }
  }

  const std::vector<vtkMTTriangle>& Triangles;
  vtkMTTriangleEdges Lookup;
  Workspace Work;
  Front Growing;
  std::vector<std::uint32_t> Number;
  std::uint32_t Met = 0;
  BitWriter Steps;
  std::vector<Name> Names;
  Coded Result;
};
}

namespace vtkMTTriangleCodec
{
Coded Encode(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices)
{
  return Encoder(triangles, vertices).Run();
}
}
