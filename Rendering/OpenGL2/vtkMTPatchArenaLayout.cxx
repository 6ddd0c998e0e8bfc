// SPDX-License-Identifier: BSD-3-Clause
// vtkMTPatchArena: how large its buffers are, and how slots get other places in them.
#include "vtkMTOpenGL.h"
#include "vtkMTPatchArena.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr std::uint64_t SmallestCapacity = 4096;

// The index binding belongs to whatever vertex array object is bound, so data goes through a target that no other code
// uses.
constexpr GLenum Target = GL_COPY_WRITE_BUFFER;

vtkOpenGLBufferObject::ObjectType GetObjectType(const vtkMTPatchArena::Format& format)
{
  return format.Domain == vtkMTPatchArena::Vertices ? vtkOpenGLBufferObject::ArrayBuffer
                                                    : vtkOpenGLBufferObject::TextureBuffer;
}
}

std::array<std::uint64_t, 2> vtkMTPatchArena::GetCapacities(std::uint64_t vertices, std::uint64_t triangles) const
{
  const std::array<std::uint64_t, 2> now{ this->VertexSpace.GetCapacity(), this->TriangleSpace.GetCapacity() };
  if (vertices <= now[0] && triangles <= now[1] && this->GetBytesOf(now[0], now[1]) <= this->Limit)
  {
    return now;
  }
  for (const std::uint64_t spare : { 4, 16, 64 })
  {
    const auto roomy = [spare](std::uint64_t present, std::uint64_t needed)
    { return needed > present ? std::max(needed + needed / spare, SmallestCapacity) : present; };
    const std::array<std::uint64_t, 2> capacities{ roomy(now[0], vertices), roomy(now[1], triangles) };
    if (this->GetPeak(capacities) <= this->Limit)
    {
      return capacities;
    }
  }
  // All that the limit allows, shared out as the frame needs it.
  const std::uint64_t needed = std::max<std::uint64_t>(this->GetBytesOf(vertices, triangles), 1);
  const double share = static_cast<double>(this->Limit) / static_cast<double>(needed);
  const auto scale = [share](std::uint64_t count)
  { return static_cast<std::uint64_t>(static_cast<double>(count) * share); };
  return { scale(vertices), scale(triangles) };
}

bool vtkMTPatchArena::BeginFrame(std::uint64_t vertices, std::uint64_t triangles)
{
  ++this->Frame;
  const std::array<std::uint64_t, 2> capacities = this->GetCapacities(vertices, triangles);
  if (capacities[0] != this->VertexSpace.GetCapacity() || capacities[1] != this->TriangleSpace.GetCapacity())
  {
    ++this->Changes;
    this->LayOut(capacities);
  }
  for (std::unique_ptr<Stream>& stream : this->Streams)
  {
    if (stream->Active && !stream->Buffer)
    {
      this->Rebuild(*stream, {}, capacities[stream->Layout.Domain]);
    }
  }
  return capacities[0] >= vertices && capacities[1] >= triangles;
}

std::uint64_t vtkMTPatchArena::GetPeak(const std::array<std::uint64_t, 2>& capacities) const
{
  std::uint64_t now = this->Bytes;
  std::uint64_t peak = now;
  for (const std::unique_ptr<Stream>& stream : this->Streams)
  {
    if (stream->Active)
    {
      now += stream->Layout.Bytes * capacities[stream->Layout.Domain];
      peak = std::max(peak, now);
      now -= stream->Layout.Bytes * stream->Capacity;
    }
  }
  return peak;
}

void vtkMTPatchArena::LayOut(const std::array<std::uint64_t, 2>& capacities)
{
  while ((this->VertexSpace.GetUsed() > capacities[0] || this->TriangleSpace.GetUsed() > capacities[1]) &&
    this->DropOldest())
  {
  }
  if (this->GetPeak(capacities) > this->Limit)
  {
    this->Clear();
    for (std::unique_ptr<Stream>& stream : this->Streams)
    {
      this->Release(*stream);
    }
  }
  const std::vector<Move> moves[2] = { this->Place(Vertices, capacities[0]), this->Place(Triangles, capacities[1]) };
  for (std::unique_ptr<Stream>& stream : this->Streams)
  {
    if (stream->Active)
    {
      this->Rebuild(*stream, moves[stream->Layout.Domain], capacities[stream->Layout.Domain]);
    }
  }
}

std::vector<vtkMTPatchArena::Move> vtkMTPatchArena::Place(DomainType domain, std::uint64_t capacity)
{
  vtkMTRangeAllocator& space = domain == Vertices ? this->VertexSpace : this->TriangleSpace;
  space.Reset(capacity);
  std::vector<Move> moves;
  for (const auto& place : this->GetPlaces(domain))
  {
    Slot& slot = this->Slots.at(place.second);
    const std::uint64_t count = domain == Vertices ? slot.Vertices : slot.Triangles;
    const Move move{ place.first, space.Allocate(count), count };
    (domain == Vertices ? slot.FirstVertex : slot.FirstTriangle) = move.To;
    if (!moves.empty() && moves.back().From + moves.back().Count == move.From)
    {
      moves.back().Count += count;
    }
    else
    {
      moves.push_back(move);
    }
  }
  return moves;
}

void vtkMTPatchArena::CloseGaps(DomainType domain)
{
  constexpr std::uint64_t MostParts = 16;
  vtkMTRangeAllocator& space = domain == Vertices ? this->VertexSpace : this->TriangleSpace;
  space.Reset(space.GetCapacity());
  std::vector<std::pair<std::uint64_t, std::uint64_t>> gaps;
  std::uint64_t end = 0;
  for (const auto& place : this->GetPlaces(domain))
  {
    Slot& slot = this->Slots.at(place.second);
    const std::uint64_t count = domain == Vertices ? slot.Vertices : slot.Triangles;
    const std::uint64_t gap = place.first - end;
    if (gap > 0 && gap * MostParts >= count)
    {
      this->MoveDown(domain, { place.first, end, count });
      (domain == Vertices ? slot.FirstVertex : slot.FirstTriangle) = end;
    }
    else if (gap > 0)
    {
      gaps.emplace_back(space.Allocate(gap), gap);
      end += gap;
    }
    space.Allocate(count);
    end += count;
  }
  for (const auto& gap : gaps)
  {
    space.Free(gap.first, gap.second);
  }
}

void vtkMTPatchArena::MoveDown(DomainType domain, const Move& move)
{
  for (const std::unique_ptr<Stream>& stream : this->Streams)
  {
    if (!stream->Buffer || stream->Layout.Domain != domain)
    {
      continue;
    }
    const std::uint64_t size = stream->Layout.Bytes;
    const std::uint64_t part = move.From - move.To;
    glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(stream->Buffer->GetHandle()));
    glBindBuffer(Target, static_cast<GLuint>(stream->Buffer->GetHandle()));
    for (std::uint64_t done = 0; done < move.Count; done += part)
    {
      glCopyBufferSubData(GL_COPY_READ_BUFFER, Target, static_cast<GLintptr>((move.From + done) * size),
        static_cast<GLintptr>((move.To + done) * size),
        static_cast<GLsizeiptr>(std::min(part, move.Count - done) * size));
    }
  }
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  glBindBuffer(Target, 0);
}

void vtkMTPatchArena::Rebuild(Stream& stream, const std::vector<Move>& moves, std::uint64_t capacity)
{
  const std::uint64_t size = stream.Layout.Bytes;
  auto buffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
  buffer->GenerateBuffer(GetObjectType(stream.Layout));
  glBindBuffer(Target, static_cast<GLuint>(buffer->GetHandle()));
  glBufferData(Target, static_cast<GLsizeiptr>(capacity * size), nullptr, GL_DYNAMIC_DRAW);
  this->Bytes += capacity * size;
  this->MostBytes = std::max(this->MostBytes, this->Bytes + this->BytesElsewhere);
  if (stream.Buffer)
  {
    glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(stream.Buffer->GetHandle()));
    for (const Move& move : moves)
    {
      glCopyBufferSubData(GL_COPY_READ_BUFFER, Target, static_cast<GLintptr>(move.From * size),
        static_cast<GLintptr>(move.To * size), static_cast<GLsizeiptr>(move.Count * size));
    }
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
  }
  glBindBuffer(Target, 0);
  this->Release(stream);
  stream.Buffer = buffer;
  stream.Capacity = capacity;
}

void vtkMTPatchArena::Release(Stream& stream)
{
  if (stream.Buffer)
  {
    stream.Buffer->ReleaseGraphicsResources();
    stream.Buffer = nullptr;
  }
  this->Bytes -= stream.Layout.Bytes * stream.Capacity;
  stream.Capacity = 0;
}
