// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTriangleEdges
 * @brief the triangles of a patch by their directed edges, for the encoder of triangles
 *
 * The corners of most vertices are looked through. Those of hubs, vertices of more than 64 corners, are in groups of
 * one edge, in which what is preferred comes first and what is done is passed over once: a hub of n corners takes O(n
 * log n). Not installed.
 */
#ifndef vtkMTTriangleEdges_h
#define vtkMTTriangleEdges_h

#include "vtkMTIOModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class VTKMTIO_EXPORT vtkMTTriangleEdges
{
public:
  static constexpr std::uint32_t None = ~std::uint32_t(0);
  struct Corner
  {
    std::uint32_t Triangle = None;
    std::uint32_t Index = 0;
  };

  /// The triangles must outlive this object and not change; their indices are below `vertices`.
  vtkMTTriangleEdges(const std::vector<vtkMTTriangle>& triangles, std::size_t vertices);

  /// A triangle that is not done and runs from a to b, which is its corner `Index` to the next; the first of them, but
  /// rather one that is there a second time the other way round: one goes to it and back by the other one, while
  /// nothing would lead there later, where the surface goes on past it.
  Corner Find(std::uint32_t a, std::uint32_t b)
  {
    return this->IsHub(a) ? this->FindOfHub(a, b) : this->FindOfFew(this->First[a], this->First[a + std::size_t(1)], b);
  }
  void Finish(std::uint32_t triangle) { this->IsDone[triangle] = 1; }
  bool IsFinished(std::uint32_t triangle) const { return this->IsDone[triangle] != 0; }

  /// How many corners of hubs were looked at so far, for tests.
  std::size_t GetNumberOfLooks() const { return this->Looks; }

private:
  enum ReverseType : unsigned char
  {
    Unknown,
    Some,
    Lone
  };
  static constexpr std::size_t LargestValence = 64;

  bool IsHub(std::uint32_t vertex) const
  {
    return this->First[vertex + std::size_t(1)] - this->First[vertex] > LargestValence;
  }
  void GroupHubs();
  void FindReverses();
  Corner FindOfHub(std::uint32_t a, std::uint32_t b);
  // Among the corners from begin to end.
  Corner FindOfFew(std::size_t begin, std::size_t end, std::uint32_t b)
  {
    Corner found;
    const std::uint32_t* const ends = this->Ends.get();
    for (std::size_t i = begin; i < end; ++i)
    {
      if (ends[i] == b && !this->IsDone[this->Corners[i].Triangle])
      {
        found = found.Triangle == None ? Corner(this->Corners[i]) : this->Prefer(found, this->Corners[i]);
      }
    }
    return found;
  }
  // Of two triangles of an edge.
  Corner Prefer(const Corner& first, const Corner& second)
  {
    return !this->HasReverse(first) && this->HasReverse(second) ? second : first;
  }
  bool HasReverse(const Corner& corner);
  bool FindReverse(const Corner& corner) const;
  std::uint32_t Get(const Corner& corner, std::uint32_t offset) const
  {
    const std::uint32_t index = corner.Index + offset;
    return this->Triangles[corner.Triangle][index < 3 ? index : index - 3];
  }

  std::vector<std::size_t> First;
  // A corner, of which an array is not filled before it is written to.
  struct Entry
  {
    std::uint32_t Triangle;
    std::uint32_t Index;
    operator Corner() const { return { this->Triangle, this->Index }; }
  };
  std::unique_ptr<Entry[]> Corners;
  std::unique_ptr<std::uint32_t[]> Ends; // where the edges of the corners end, for vertices that are no hubs
  const std::vector<vtkMTTriangle>& Triangles;
  std::vector<unsigned char> IsDone;
  std::vector<ReverseType> Reverse;
  std::vector<std::uint32_t> Skipped; // at the first corner of each group of a hub; empty when there is no hub
  std::size_t Looks = 0;
};

#endif
