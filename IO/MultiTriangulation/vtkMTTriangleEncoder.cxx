// SPDX-License-Identifier: BSD-3-Clause
// The codec's one side: from triangles to steps and names.
#include "vtkMTBitWriter.h"
#include "vtkMTTriangleEdges.h"
#include "vtkMTTriangleFront.h"

#include <algorithm>

namespace
{
using namespace vtkMTTriangleCodec;

// How the third vertex is found when it was met before.
Step FindStep(const Front& front, std::uint32_t vertex)
{
  if (front.IsAheadOpen() && front.GetAhead() == vertex)
  {
    return Ahead;
  }
  if (front.IsBehindOpen() && front.GetBehind() == vertex)
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

// Of how many ones and a zero the code of a step is.
std::uint32_t CountOnes(Step step, std::uint32_t situation)
{
  std::uint32_t ones = 0;
  while (Steps[situation + ones] != step)
  {
    ++ones;
  }
  return ones;
}

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
  // They fall and then rise with the parameter.
  unsigned best = 0;
  std::uint64_t fewest = count(0);
  for (unsigned parameter = 1; parameter <= MostNameBits; ++parameter)
  {
    const std::uint64_t bits = count(parameter);
    if (bits >= fewest)
    {
      break;
    }
    best = parameter;
    fewest = bits;
  }
  return best;
}

// Names as Rice codes: two bytes with the parameters of the two kinds, then the bits.
std::vector<unsigned char> WriteNames(const std::vector<Name>& names)
{
  const unsigned parameters[2] = { ChooseNameParameter(names, false), ChooseNameParameter(names, true) };
  vtkMTBitWriter writer;
  writer.Put(parameters[0], 8);
  writer.Put(parameters[1], 8);
  for (const Name& name : names)
  {
    const unsigned parameter = parameters[name.IsWalk ? 1 : 0];
    writer.PutOnes(name.Number >> parameter);
    writer.Put(name.Number & ((1u << parameter) - 1), parameter);
  }
  return names.empty() ? std::vector<unsigned char>() : writer.Take();
}

//------------------------------------------------------------------------------
// The front is of vertices in order of use, as the decoder's is.
class Encoder
{
public:
  Encoder(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices, Decoded& out)
    : Triangles(triangles)
    , Lookup(triangles, vertices)
    , Growing(triangles.size(), out.Work)
    , Number(vertices, None)
    , Out(out)
  {
    out.NumberOfTriangles = static_cast<std::uint32_t>(triangles.size());
    out.NumberOfVertices = static_cast<std::uint32_t>(vertices);
    EnsureSize(out.Triangles, triangles.size());
    EnsureSize(out.Bases, vertices + 1);
    EnsureSize(out.Work.BorderGates, 3 * triangles.size());
    this->Result.Order.resize(triangles.size());
    this->Result.Vertices.resize(vertices);
  }

  Coded Run()
  {
    for (std::uint32_t seed = 0; this->Done < this->Out.NumberOfTriangles;)
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
    this->Growing.SeeOpen([this](std::uint32_t from, std::uint32_t to) { this->PutBorder(from, to); });
    FollowBorder(this->Borders, this->Out);
    std::fill(this->Out.Bases.begin() + this->Met, this->Out.Bases.begin() + this->Out.NumberOfVertices, Basis());
    std::uint32_t place = this->Met;
    for (std::uint32_t v = 0; v < this->Number.size(); ++v)
    {
      if (this->Number[v] == None)
      {
        this->Result.Vertices[place++] = v;
      }
    }
    this->Result.Steps = this->Steps.Take();
    this->Result.Names = WriteNames(this->Names);
    return std::move(this->Result);
  }

private:
  void StartAt(std::uint32_t triangle)
  {
    vtkMTTriangle t = this->Triangles[triangle];
    std::uint32_t before = None;
    for (std::uint32_t& v : t)
    {
      const std::uint32_t vertex = v;
      const bool isNew = this->Number[vertex] == None;
      this->Names.push_back({ isNew ? 0 : this->Met - this->Number[vertex], false });
      v = isNew ? this->Meet(vertex, { before, None, None }) : this->Number[vertex];
      before = v;
    }
    this->Growing.Start(t, this->Done);
    this->Put(triangle, { t[0], t[1], t[2], None });
  }

  std::uint32_t Meet(std::uint32_t vertex, const Basis& basis)
  {
    this->Out.Bases[this->Met] = basis;
    this->Result.Vertices[this->Met] = vertex;
    this->Number[vertex] = this->Met;
    return this->Met++;
  }

  void Put(std::uint32_t triangle, const std::array<std::uint32_t, 4>& decoded)
  {
    this->Lookup.Finish(triangle);
    this->Out.Triangles[this->Done] = decoded;
    this->Result.Order[this->Done] = triangle;
    ++this->Done;
  }

  void PutBorder(std::uint32_t from, std::uint32_t to) { this->Out.Work.BorderGates[this->Borders++] = { from, to }; }

  // Returns the walk, or 0 when the vertex is named by how long ago it was met.
  std::uint32_t PutWalk(std::uint32_t number)
  {
    const std::uint32_t walk = FindWalk(this->Growing, number);
    this->Names.push_back({ walk, true });
    if (walk == 0)
    {
      this->Names.push_back({ this->Met - number, false });
    }
    return walk;
  }

  void Cross()
  {
    const std::uint32_t from = this->Growing.GetFrom();
    const std::uint32_t to = this->Growing.GetTo();
    const std::uint32_t situation = this->Growing.GetSituation();
    const std::uint32_t* const vertices = this->Result.Vertices.data();
    const vtkMTTriangleEdges::Corner behind = this->Lookup.Find(vertices[to], vertices[from]);
    if (behind.Triangle == None)
    {
      this->Steps.PutOnes(CountOnes(Nothing, situation));
      this->PutBorder(from, to);
      this->Growing.MakeBorder();
      return;
    }
    const std::uint32_t vertex = this->Triangles[behind.Triangle][behind.Index == 0 ? 2 : behind.Index - 1];
    std::uint32_t third = this->Number[vertex];
    Step step = New;
    if (third == None)
    {
      third = this->Meet(vertex, { this->Growing.GetRear(), this->Growing.GetHinge(), this->Growing.GetAcross() });
    }
    else
    {
      step = FindStep(this->Growing, third);
    }
    this->Steps.PutOnes(CountOnes(step, situation));
    const std::uint32_t triangle = this->Done;
    this->Put(behind.Triangle, { to, from, third, this->Growing.GetOwner() });
    this->Follow(step, third, triangle);
  }

  void Follow(Step step, std::uint32_t third, std::uint32_t triangle)
  {
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
  Front Growing;
  std::vector<std::uint32_t> Number; // of the caller's vertices in order of use
  std::uint32_t Met = 0;
  std::uint32_t Done = 0;
  std::uint32_t Borders = 0;
  vtkMTBitWriter Steps;
  std::vector<Name> Names;
  Coded Result;
  Decoded& Out;
};
}

namespace vtkMTTriangleCodec
{
Coded Encode(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices, Decoded& decoded)
{
  return Encoder(triangles, vertices, decoded).Run();
}
}
