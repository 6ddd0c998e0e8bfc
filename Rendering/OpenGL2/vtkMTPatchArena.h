// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchArena
 * @brief the patches on the GPU: a slot for each, and buffers of vertex and triangle data that share the slots
 *
 * A slot is a range of vertices and a range of triangles, from vtkMTRangeAllocator. Every stream (positions, normals,
 * colours, indices, cell colours ...) is one buffer in which a slot's vertices or triangles have the same place, so all
 * patches are drawn from one vertex array object with a base vertex each, and the place of a triangle in the arena is
 * its id for picking and for cell colours. Streams come and go without moving slots; a stream that is declared anew is
 * stale in every slot until uploaded.
 *
 * How large it is. BeginFrame says how much the frame draws. Where the arena is too small for that it is laid out anew,
 * with a quarter to spare: new buffers, into which the GPU copies what the old ones hold, so nothing is uploaded again
 * and the CPU waits for nothing. While a frame is assembled, room is made by dropping patches that the frame does
 * not use, the least recently used first, and at last by closing the gaps between slots, within the buffers.
 *
 * The limit is hard: all buffers together, the copies of a new layout included, never take more bytes. A layout that
 * would need more for its copies begins empty instead. What does not fit has no slot.
 *
 * All methods but the constructor need the OpenGL context of the window that the arena belongs to, current.
 */
#ifndef vtkMTPatchArena_h
#define vtkMTPatchArena_h

#include "vtkMTRangeAllocator.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

class vtkShaderProgram;

class vtkMTPatchArena
{
public:
  enum DomainType
  {
    Vertices,
    Triangles
  };

  struct Format
  {
    DomainType Domain = Vertices;
    std::size_t Bytes = 0; ///< of one vertex's or triangle's data
    int Components = 0;    ///< of a vertex attribute
    unsigned int Type = 0; ///< OpenGL's name of the component type
    bool Integer = false;  ///< the shader sees integers
    bool operator==(const Format& other) const
    {
      return this->Domain == other.Domain && this->Bytes == other.Bytes && this->Components == other.Components &&
        this->Type == other.Type && this->Integer == other.Integer;
    }
  };

  struct Slot
  {
    std::uint64_t FirstVertex = 0;
    std::uint64_t FirstTriangle = 0;
    std::uint32_t Vertices = 0;
    std::uint32_t Triangles = 0;
    std::uint64_t LastFrame = 0;
    std::vector<std::uint64_t> Revisions;        // by stream
    std::list<std::uint32_t>::iterator Position; // in Order
  };

  /// Bytes of all buffers together; no limit at first. It holds from the next BeginFrame on.
  void SetLimit(std::uint64_t limit) { this->Limit = limit; }

  ///@{
  /**
   * Streams are known by a number. Declare makes a stream, or makes an old one stale when the format or the revision is
   * another than before; those of vertices are named for the shader's attribute. Revisions begin at 1. Remove frees its
   * memory.
   */
  int Declare(const std::string& attribute, const Format& format, std::uint64_t revision);
  void Remove(const std::string& attribute);
  bool Has(const std::string& attribute) const;
  ///@}

  /// Starts a frame that draws patches of so many vertices and triangles in total. False where the limit does not hold
  /// that much.
  bool BeginFrame(std::uint64_t vertices, std::uint64_t triangles);
  /// The arc's slot, made if need be; used in this frame. Null where there is no room for it beside the others that the
  /// frame uses.
  Slot* Use(std::uint32_t arc, std::uint32_t vertices, std::uint32_t triangles);
  /// Makes the arc's patch, if it is there, the last one to go before those that the frame uses.
  void Touch(std::uint32_t arc);
  bool IsStale(const Slot& slot, int stream) const;
  /// False, and nothing done, unless there is exactly as much data as the slot has vertices or triangles.
  bool Upload(Slot& slot, int stream, const std::vector<unsigned char>& data);

  /// Drops all patches; buffers stay.
  void Clear();
  void ReleaseGraphicsResources();

  /// Binds the vertex array object, with the streams that the program uses; attributes in `constant` are left disabled.
  void Bind(vtkShaderProgram* program, const std::string& constant);
  static void Unbind();

  vtkOpenGLBufferObject* GetBuffer(const std::string& attribute);

  /// The arc's slot, or null.
  const Slot* Find(std::uint32_t arc) const;
  /// Gives the arc's slot back.
  void Drop(std::uint32_t arc);
  /// Where each patch begins: first vertex or triangle, and arc.
  std::map<std::uint64_t, std::uint32_t> GetPlaces(DomainType domain) const;

  std::uint64_t GetVertexCapacity() const { return this->VertexSpace.GetCapacity(); }
  std::uint64_t GetTriangleCapacity() const { return this->TriangleSpace.GetCapacity(); }
  /// Of all buffers, now and at most so far, the latter with what SetBytesElsewhere gave.
  std::uint64_t GetBytes() const { return this->Bytes; }
  std::uint64_t GetMostBytes() const { return this->MostBytes; }
  /// Bytes of other arenas that share a limit with this one.
  void SetBytesElsewhere(std::uint64_t bytes) { this->BytesElsewhere = bytes; }
  /// Of the data of so many vertices and triangles, in all streams that are declared.
  std::uint64_t GetBytesOf(std::uint64_t vertices, std::uint64_t triangles) const;
  std::size_t GetNumberOfPatches() const { return this->Slots.size(); }
  /// Another number than before when a patch has come, gone or been moved, or when its data may be stale.
  std::uint64_t GetChanges() const { return this->Changes; }
  std::uint64_t GetNumberOfUploadedBytes() const { return this->UploadedBytes; }

private:
  struct Stream
  {
    std::string Attribute;
    vtkMTPatchArena::Format Layout;
    std::uint64_t Revision = 0;
    std::uint64_t Capacity = 0; // vertices or triangles that the buffer holds
    bool Active = false;
    vtkSmartPointer<vtkOpenGLBufferObject> Buffer;
  };

  // Elements that lie side by side before and after a new layout.
  struct Move
  {
    std::uint64_t From = 0;
    std::uint64_t To = 0;
    std::uint64_t Count = 0;
  };

  std::array<std::uint64_t, 2> GetCapacities(std::uint64_t vertices, std::uint64_t triangles) const;
  std::uint64_t GetPeak(const std::array<std::uint64_t, 2>& capacities) const;
  void LayOut(const std::array<std::uint64_t, 2>& capacities);
  std::vector<Move> Place(DomainType domain, std::uint64_t capacity);
  void CloseGaps(DomainType domain);
  void MoveDown(DomainType domain, const Move& move);
  void Rebuild(Stream& stream, const std::vector<Move>& moves, std::uint64_t capacity);
  void Release(Stream& stream);
  bool Allocate(Slot& slot);
  bool DropOldest();

  std::vector<std::unique_ptr<Stream>> Streams;
  std::unordered_map<std::uint32_t, Slot> Slots;
  std::list<std::uint32_t> Order; // least recently used first
  vtkMTRangeAllocator VertexSpace;
  vtkMTRangeAllocator TriangleSpace;
  std::uint64_t Frame = 0;
  std::uint64_t Limit = ~std::uint64_t(0);
  std::uint64_t Bytes = 0;
  std::uint64_t MostBytes = 0;
  std::uint64_t BytesElsewhere = 0;
  std::uint64_t UploadedBytes = 0;
  std::uint64_t Changes = 0;
  unsigned int VertexArray = 0;
};

#endif
