// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchArena.h"

#include "vtkShaderProgram.h"

#include "vtk_glew.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
constexpr std::uint64_t SmallestCapacity = 4096;

// The index binding belongs to whatever vertex array object is bound, so data goes through a target that nobody else
// uses.
constexpr GLenum Target = GL_COPY_WRITE_BUFFER;

vtkOpenGLBufferObject::ObjectType GetObjectType(const vtkMTPatchArena::Format& format)
{
  return format.Domain == vtkMTPatchArena::Vertices ? vtkOpenGLBufferObject::ArrayBuffer
                                                    : vtkOpenGLBufferObject::TextureBuffer;
}
}

int vtkMTPatchArena::Declare(const std::string& attribute, const Format& format, std::uint64_t revision)
{
  auto found = std::find_if(this->Streams.begin(), this->Streams.end(),
    [&attribute](const std::unique_ptr<Stream>& stream) { return stream->Attribute == attribute; });
  if (found == this->Streams.end())
  {
    this->Streams.push_back(std::make_unique<Stream>());
    found = std::prev(this->Streams.end());
    (*found)->Attribute = attribute;
  }
  Stream& stream = **found;
  if (stream.Active && !(stream.Layout == format))
  {
    this->Remove(attribute);
  }
  if (!stream.Active)
  {
    stream.Active = true;
    stream.Layout = format;
    stream.Revision = 0;
  }
  this->Changes += stream.Revision != revision ? 1 : 0;
  stream.Revision = revision;
  return static_cast<int>(found - this->Streams.begin());
}

void vtkMTPatchArena::Remove(const std::string& attribute)
{
  for (std::size_t i = 0; i < this->Streams.size(); ++i)
  {
    Stream& stream = *this->Streams[i];
    if (stream.Attribute == attribute && stream.Active)
    {
      stream.Active = false;
      ++this->Changes;
      this->Release(stream);
      for (auto& slot : this->Slots)
      {
        slot.second.Revisions.resize(this->Streams.size(), 0);
        slot.second.Revisions[i] = 0;
      }
    }
  }
}

bool vtkMTPatchArena::Has(const std::string& attribute) const
{
  return std::any_of(this->Streams.begin(), this->Streams.end(),
    [&attribute](const std::unique_ptr<Stream>& s) { return s->Attribute == attribute && s->Active; });
}

std::uint64_t vtkMTPatchArena::GetBytesOf(std::uint64_t vertices, std::uint64_t triangles) const
{
  std::uint64_t bytes = 0;
  for (const std::unique_ptr<Stream>& stream : this->Streams)
  {
    if (stream->Active)
    {
      bytes += stream->Layout.Bytes * (stream->Layout.Domain == Vertices ? vertices : triangles);
    }
  }
  return bytes;
}

// What the arena should hold for a frame of that size.
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

vtkMTPatchArena::Slot* vtkMTPatchArena::Use(std::uint32_t arc, std::uint32_t vertices, std::uint32_t triangles)
{
  auto found = this->Slots.find(arc);
  if (found == this->Slots.end())
  {
    Slot slot;
    slot.Vertices = vertices;
    slot.Triangles = triangles;
    if (!this->Allocate(slot))
    {
      return nullptr;
    }
    slot.Position = this->Order.insert(this->Order.end(), arc);
    found = this->Slots.emplace(arc, std::move(slot)).first;
    ++this->Changes;
  }
  Slot& slot = found->second;
  this->Order.splice(this->Order.end(), this->Order, slot.Position);
  slot.LastFrame = this->Frame;
  slot.Revisions.resize(this->Streams.size(), 0);
  return &slot;
}

bool vtkMTPatchArena::IsStale(const Slot& slot, int stream) const
{
  // A slot that has not been used since the stream was declared knows nothing of it.
  return static_cast<std::size_t>(stream) >= slot.Revisions.size() ||
    slot.Revisions[stream] != this->Streams[stream]->Revision;
}

bool vtkMTPatchArena::Upload(Slot& slot, int index, const std::vector<unsigned char>& data)
{
  Stream& stream = *this->Streams[index];
  const bool perVertex = stream.Layout.Domain == Vertices;
  const std::uint64_t first = perVertex ? slot.FirstVertex : slot.FirstTriangle;
  const std::uint64_t count = perVertex ? slot.Vertices : slot.Triangles;
  if (data.size() != count * stream.Layout.Bytes)
  {
    return false;
  }
  glBindBuffer(Target, static_cast<GLuint>(stream.Buffer->GetHandle()));
  glBufferSubData(
    Target, static_cast<GLintptr>(first * stream.Layout.Bytes), static_cast<GLsizeiptr>(data.size()), data.data());
  glBindBuffer(Target, 0);
  slot.Revisions[index] = stream.Revision;
  this->UploadedBytes += data.size();
  return true;
}

bool vtkMTPatchArena::Allocate(Slot& slot)
{
  const auto attempt = [this, &slot]()
  {
    slot.FirstVertex = this->VertexSpace.Allocate(slot.Vertices);
    slot.FirstTriangle = this->TriangleSpace.Allocate(slot.Triangles);
    if (slot.FirstVertex != vtkMTRangeAllocator::Nowhere && slot.FirstTriangle != vtkMTRangeAllocator::Nowhere)
    {
      return true;
    }
    if (slot.FirstVertex != vtkMTRangeAllocator::Nowhere)
    {
      this->VertexSpace.Free(slot.FirstVertex, slot.Vertices);
    }
    if (slot.FirstTriangle != vtkMTRangeAllocator::Nowhere)
    {
      this->TriangleSpace.Free(slot.FirstTriangle, slot.Triangles);
    }
    return false;
  };
  bool done = attempt();
  while (!done && this->DropOldest())
  {
    done = attempt();
  }
  const auto hasRoom = [](const vtkMTRangeAllocator& space, std::uint64_t size)
  { return space.GetCapacity() - space.GetUsed() >= size; };
  if (!done && hasRoom(this->VertexSpace, slot.Vertices) && hasRoom(this->TriangleSpace, slot.Triangles))
  {
    this->CloseGaps(Vertices);
    this->CloseGaps(Triangles);
    done = attempt();
  }
  return done;
}

bool vtkMTPatchArena::DropOldest()
{
  if (this->Order.empty() || this->Slots.at(this->Order.front()).LastFrame == this->Frame)
  {
    return false;
  }
  this->Drop(this->Order.front());
  return true;
}

// The most bytes at any moment while the streams are moved, one after the other, into buffers of that size.
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

// Gives the arena these capacities. Only at the begin of a frame: the new arena may be empty.
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

// Gives all slots new places, side by side, in their present order.
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

// Moves slots down within their buffers, so that no more bytes are needed than there are. A slot that would move by a
// small share of its size only stays, for its copy would be cut into many parts: source and target may not overlap.
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
  this->MostBytes = std::max(this->MostBytes, this->Bytes);
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

void vtkMTPatchArena::Drop(std::uint32_t arc)
{
  const auto found = this->Slots.find(arc);
  if (found == this->Slots.end())
  {
    return;
  }
  ++this->Changes;
  this->VertexSpace.Free(found->second.FirstVertex, found->second.Vertices);
  this->TriangleSpace.Free(found->second.FirstTriangle, found->second.Triangles);
  this->Order.erase(found->second.Position);
  this->Slots.erase(found);
}

void vtkMTPatchArena::Clear()
{
  ++this->Changes;
  this->Slots.clear();
  this->Order.clear();
  this->VertexSpace.Reset(this->VertexSpace.GetCapacity());
  this->TriangleSpace.Reset(this->TriangleSpace.GetCapacity());
}

void vtkMTPatchArena::ReleaseGraphicsResources()
{
  ++this->Changes;
  for (std::unique_ptr<Stream>& stream : this->Streams)
  {
    this->Release(*stream);
  }
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
  this->Streams.clear();
  this->Slots.clear();
  this->Order.clear();
  this->VertexSpace.Reset(0);
  this->TriangleSpace.Reset(0);
}

void vtkMTPatchArena::Bind(vtkShaderProgram* program, const std::string& constant)
{
  if (!this->VertexArray)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  GLint enabled = 0;
  glGetIntegerv(GL_MAX_VERTEX_ATTRIBS, &enabled);
  for (GLint i = 0; i < enabled; ++i)
  {
    glDisableVertexAttribArray(static_cast<GLuint>(i));
  }
  for (const std::unique_ptr<Stream>& stream : this->Streams)
  {
    if (!stream->Active || stream->Layout.Domain != Vertices || stream->Capacity == 0 || stream->Attribute == constant)
    {
      continue;
    }
    const GLint location = glGetAttribLocation(static_cast<GLuint>(program->GetHandle()), stream->Attribute.c_str());
    if (location < 0)
    {
      continue;
    }
    const auto where = static_cast<GLuint>(location);
    glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(stream->Buffer->GetHandle()));
    if (stream->Layout.Integer)
    {
      glVertexAttribIPointer(
        where, stream->Layout.Components, stream->Layout.Type, static_cast<GLsizei>(stream->Layout.Bytes), nullptr);
    }
    else
    {
      glVertexAttribPointer(where, stream->Layout.Components, stream->Layout.Type,
        stream->Layout.Type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE, static_cast<GLsizei>(stream->Layout.Bytes),
        nullptr);
    }
    glEnableVertexAttribArray(where);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void vtkMTPatchArena::Unbind()
{
  glBindVertexArray(0);
}

vtkOpenGLBufferObject* vtkMTPatchArena::GetBuffer(const std::string& attribute)
{
  for (const std::unique_ptr<Stream>& stream : this->Streams)
  {
    if (stream->Attribute == attribute && stream->Active)
    {
      return stream->Buffer;
    }
  }
  return nullptr;
}

const vtkMTPatchArena::Slot* vtkMTPatchArena::Find(std::uint32_t arc) const
{
  const auto found = this->Slots.find(arc);
  return found != this->Slots.end() ? &found->second : nullptr;
}

std::map<std::uint64_t, std::uint32_t> vtkMTPatchArena::GetPlaces(DomainType domain) const
{
  std::map<std::uint64_t, std::uint32_t> places;
  for (const auto& slot : this->Slots)
  {
    places.emplace(domain == Vertices ? slot.second.FirstVertex : slot.second.FirstTriangle, slot.first);
  }
  return places;
}
