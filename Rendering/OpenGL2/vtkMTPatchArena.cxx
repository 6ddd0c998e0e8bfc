// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchArena.h"

#include "vtkMTOpenGL.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
// The index binding belongs to whatever vertex array object is bound, so data goes through a target that no other code
// uses.
constexpr GLenum Target = GL_COPY_WRITE_BUFFER;
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

void vtkMTPatchArena::Touch(std::uint32_t arc)
{
  const auto found = this->Slots.find(arc);
  if (found != this->Slots.end())
  {
    this->Order.splice(this->Order.end(), this->Order, found->second.Position);
  }
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

// Gives the arena these capacities. Only at the begin of a frame: the new arena may be empty.

// Gives all slots new places, side by side, in their present order.

// Moves slots down within their buffers, so that no more bytes are needed than there are. A slot that would move by a

// small share of its size only stays, for its copy would be split into many parts: source and target may not overlap.

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
