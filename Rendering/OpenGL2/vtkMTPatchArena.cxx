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
      stream.Capacity = 0;
      stream.Buffer->ReleaseGraphicsResources();
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

void vtkMTPatchArena::BeginFrame(std::uint64_t vertices, std::uint64_t triangles)
{
  ++this->Frame;
  // Some room to spare, or every frame that needs a little more than the last one would copy everything.
  const auto reserve = [](vtkMTRangeAllocator& space, std::uint64_t needed)
  {
    if (needed > space.GetCapacity())
    {
      vtkMTPatchArena::Grow(space, needed + needed / 4);
    }
  };
  reserve(this->VertexSpace, vertices);
  reserve(this->TriangleSpace, triangles);
}

vtkMTPatchArena::Slot& vtkMTPatchArena::Use(std::uint32_t arc, std::uint32_t vertices, std::uint32_t triangles)
{
  auto found = this->Slots.find(arc);
  if (found == this->Slots.end())
  {
    Slot slot;
    slot.Vertices = vertices;
    slot.Triangles = triangles;
    slot.FirstVertex = this->Allocate(this->VertexSpace, vertices);
    slot.FirstTriangle = this->Allocate(this->TriangleSpace, triangles);
    found = this->Slots.emplace(arc, std::move(slot)).first;
  }
  found->second.LastFrame = this->Frame;
  found->second.Revisions.resize(this->Streams.size(), 0);
  return found->second;
}

bool vtkMTPatchArena::IsStale(const Slot& slot, int stream) const
{
  return slot.Revisions[stream] != this->Streams[stream]->Revision;
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
  this->Fit(stream);
  glBindBuffer(Target, static_cast<GLuint>(stream.Buffer->GetHandle()));
  glBufferSubData(
    Target, static_cast<GLintptr>(first * stream.Layout.Bytes), static_cast<GLsizeiptr>(data.size()), data.data());
  glBindBuffer(Target, 0);
  slot.Revisions[index] = stream.Revision;
  this->UploadedBytes += data.size();
  return true;
}

void vtkMTPatchArena::Fit(Stream& stream)
{
  const std::uint64_t capacity =
    stream.Layout.Domain == Vertices ? this->VertexSpace.GetCapacity() : this->TriangleSpace.GetCapacity();
  if (stream.Capacity >= capacity)
  {
    return;
  }
  // The buffer keeps its name, so whatever refers to it stays right: its content goes away and comes back.
  stream.Buffer->GenerateBuffer(GetObjectType(stream.Layout));
  const auto name = static_cast<GLuint>(stream.Buffer->GetHandle());
  const auto oldSize = static_cast<GLsizeiptr>(stream.Capacity * stream.Layout.Bytes);
  GLuint copy = 0;
  if (oldSize > 0)
  {
    glGenBuffers(1, &copy);
    glBindBuffer(Target, copy);
    glBufferData(Target, oldSize, nullptr, GL_STREAM_COPY);
    glBindBuffer(GL_COPY_READ_BUFFER, name);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, Target, 0, 0, oldSize);
  }
  glBindBuffer(Target, name);
  glBufferData(Target, static_cast<GLsizeiptr>(capacity * stream.Layout.Bytes), nullptr, GL_DYNAMIC_DRAW);
  if (oldSize > 0)
  {
    glBindBuffer(GL_COPY_READ_BUFFER, copy);
    glCopyBufferSubData(GL_COPY_READ_BUFFER, Target, 0, 0, oldSize);
    glDeleteBuffers(1, &copy);
  }
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  glBindBuffer(Target, 0);
  stream.Capacity = capacity;
}

void vtkMTPatchArena::Grow(vtkMTRangeAllocator& space, std::uint64_t needed)
{
  space.Grow(std::max(needed, SmallestCapacity));
}

std::uint64_t vtkMTPatchArena::Allocate(vtkMTRangeAllocator& space, std::uint32_t size)
{
  std::uint64_t place = space.Allocate(size);
  while (place == vtkMTRangeAllocator::Nowhere && this->DropOldest())
  {
    place = space.Allocate(size);
  }
  if (place == vtkMTRangeAllocator::Nowhere)
  {
    this->Grow(space, space.GetCapacity() + std::max<std::uint64_t>(size, space.GetCapacity() / 2));
    place = space.Allocate(size);
  }
  return place;
}

bool vtkMTPatchArena::DropOldest()
{
  auto oldest = this->Slots.end();
  for (auto slot = this->Slots.begin(); slot != this->Slots.end(); ++slot)
  {
    if (slot->second.LastFrame < this->Frame &&
      (oldest == this->Slots.end() || slot->second.LastFrame < oldest->second.LastFrame ||
        (slot->second.LastFrame == oldest->second.LastFrame && slot->first < oldest->first)))
    {
      oldest = slot;
    }
  }
  if (oldest == this->Slots.end())
  {
    return false;
  }
  this->Drop(oldest->first);
  return true;
}

void vtkMTPatchArena::Drop(std::uint32_t arc)
{
  const auto found = this->Slots.find(arc);
  if (found == this->Slots.end())
  {
    return;
  }
  this->VertexSpace.Free(found->second.FirstVertex, found->second.Vertices);
  this->TriangleSpace.Free(found->second.FirstTriangle, found->second.Triangles);
  this->Slots.erase(found);
}

void vtkMTPatchArena::Clear()
{
  this->Slots.clear();
  this->VertexSpace.Reset(this->VertexSpace.GetCapacity());
  this->TriangleSpace.Reset(this->TriangleSpace.GetCapacity());
}

void vtkMTPatchArena::ReleaseGraphicsResources()
{
  for (std::unique_ptr<Stream>& stream : this->Streams)
  {
    stream->Buffer->ReleaseGraphicsResources();
  }
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
  this->Streams.clear();
  this->Slots.clear();
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

std::uint64_t vtkMTPatchArena::GetBytes() const
{
  std::uint64_t bytes = 0;
  for (const std::unique_ptr<Stream>& stream : this->Streams)
  {
    bytes += stream->Capacity * stream->Layout.Bytes;
  }
  return bytes;
}
