// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTTrianglePainter
 * @brief triangle patches on one window's GPU: a vtkMTUploader, and draw calls
 *
 * Patches are in a vtkMTPatchArena, with the data that a plan says (vtkMTPatchStreams); a plan that differs from its
 * user's one before makes what changed stale, and nothing else. Draws are of the arcs of a cut, all patches in one call
 * where nothing differs between them.
 *
 * All methods but the constructor need the OpenGL context of the window, current.
 */
#ifndef vtkMTTrianglePainter_h
#define vtkMTTrianglePainter_h

#include "vtkMTPatchArena.h"
#include "vtkMTPatchStreams.h"
#include "vtkMTUploader.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

class vtkMTGraph;
class vtkOpenGLBufferObject;
class vtkShaderProgram;

class vtkMTTrianglePainter : public vtkMTUploader
{
public:
  /// What is drawn from now on, and for whom: see vtkMTPatchStreams. The graph must live as long as it is drawn;
  /// another one needs Clear before.
  void Apply(const vtkMTGraph& graph, const vtkMTPatchStreams::Plan& plan, const void* user,
    const vtkMTPatchStreams::Mapping& mapping);
  /// Drops all patches.
  void Clear();
  void ReleaseGraphicsResources() { this->Arena.ReleaseGraphicsResources(); }

  ///@{
  /// vtkMTUploader's.
  Cost GetCost() const override;
  std::vector<unsigned char> GetArrays() const override;
  bool IsUploaded(std::uint32_t arc) const override;
  void Begin(
    const std::vector<std::uint32_t>& drawn, const std::vector<std::uint32_t>& kept, std::uint64_t limit) override;
  bool Reserve(std::uint32_t arc) override;
  bool Upload(std::uint32_t arc, const vtkMTPatch& patch) override;
  void Drop(std::uint32_t arc) override { this->Arena.Drop(arc); }
  std::uint64_t GetChanges() const override { return this->Arena.GetChanges(); }
  ///@}

  /// Whether there is anything to draw from.
  bool HasBuffers();

  struct Colors
  {
    /// Everything has this colour, which takes the place of the attribute of the streams; none: null.
    const std::array<unsigned char, 4>* All = nullptr;
    /// Or each patch has a colour of its own.
    std::function<std::array<unsigned char, 4>(std::uint32_t arc)> OfPatch;
  };
  /// Draws triangles, or what OpenGL's mode makes of the plan's indices. The program must be in use.
  void Draw(vtkShaderProgram* program, unsigned int mode, const std::vector<std::uint32_t>& arcs, const Colors& colors);
  /// Draws the patches' vertices as points.
  void DrawVertices(vtkShaderProgram* program, const std::vector<std::uint32_t>& arcs);

  /// What the shader counts as one triangle's primitives in that mode.
  std::uint64_t GetPrimitivesPerTriangle(unsigned int mode) const;
  std::uint64_t GetIndicesPerTriangle() const { return this->Streams.GetPlan().Edges ? 6 : 3; }
  vtkMTPatchArena& GetArena() { return this->Arena; }
  const vtkMTPatchArena& GetArena() const { return this->Arena; }

private:
  vtkOpenGLBufferObject* GetIndices();
  const void* GetPlace(const vtkMTPatchArena::Slot& slot) const;
  unsigned int GetIndexType() const;
  void DrawAtOnce(unsigned int mode, const std::vector<std::uint32_t>& arcs);
  void DrawOneByOne(
    vtkShaderProgram* program, unsigned int mode, const std::vector<std::uint32_t>& arcs, const Colors& colors);

  const vtkMTGraph* Graph = nullptr;
  vtkMTPatchArena Arena;
  vtkMTPatchStreams Streams;
  vtkMTPatchStreams::Mapping Mapping;
};

#endif
