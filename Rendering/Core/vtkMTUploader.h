// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTUploader
 * @brief where a frame's patches are drawn from: what vtkMTFrame knows of a GPU
 *
 * A painter implements this for one window: buffers for triangles or points, a pool of bricks for volumes. vtkMTFrame
 * says which patches a frame draws and brings those that are missing; how they are laid out, and how they are drawn, is
 * the painter's matter. Tests implement it without a GPU.
 *
 * In a frame: Begin, then for each patch Reserve and, unless IsUploaded, Upload. All calls come from the thread that
 * draws. Arcs are those of the graph that the painter was made for.
 */
#ifndef vtkMTUploader_h
#define vtkMTUploader_h

#include "vtkMTRenderingCoreModule.h" // For export macro

#include <cstdint>
#include <vector>

struct vtkMTPatch;

class VTKMTRENDERINGCORE_EXPORT vtkMTUploader
{
public:
  virtual ~vtkMTUploader();

  /// Bytes that a patch takes for each of its wedges and for each of its triangles, with what is drawn of it now.
  struct Cost
  {
    std::uint32_t BytesPerVertex = 0;
    std::uint32_t BytesPerTriangle = 0;
  };
  virtual Cost GetCost() const = 0;

  /// The arrays that Upload looks at, one flag per array of the graph.
  virtual std::vector<unsigned char> GetArrays() const = 0;

  /// Whether the arc's patch is there, with everything that is drawn of it now.
  virtual bool IsUploaded(std::uint32_t arc) const = 0;

  /**
   * Begins a frame that draws these arcs, ascending. `kept` are those that other views draw: there should be room for
   * them as well, and they go after anything else but `drawn`. All buffers together never take more bytes than the
   * limit; what does not fit is refused by Reserve. The coarsest patches take no more than the limit and always fit.
   */
  virtual void Begin(
    const std::vector<std::uint32_t>& drawn, const std::vector<std::uint32_t>& kept, std::uint64_t limit) = 0;

  /// Makes room for an arc's patch, or finds the room that it has. False where there is none beside what has been
  /// reserved since Begin.
  virtual bool Reserve(std::uint32_t arc) = 0;

  /// Brings a patch up to date for which there is room. False when it is not what the graph says.
  virtual bool Upload(std::uint32_t arc, const vtkMTPatch& patch) = 0;

  /// Gives the arc's room back.
  virtual void Drop(std::uint32_t arc) = 0;

  /// Another number than before when a patch has come, gone or been moved, or may have to be uploaded again.
  virtual std::uint64_t GetChanges() const = 0;
};

#endif
