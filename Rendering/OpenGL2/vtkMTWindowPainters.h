// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTWindowPainters
 * @brief a mapper's painter for each window that it draws in
 *
 * VTK gives a mapper the resources of one window at a time and has it release them when another window draws it.
 * Patches are too much to be uploaded again for that, so each window has a painter, which lives until the window's
 * context goes or VTK has the mapper release that window's resources.
 *
 * The limit on bytes is that of all of them: each may take an equal share. One that has more when another begins a
 * frame gives everything back at once, and fills its share in its next frame.
 */
#ifndef vtkMTWindowPainters_h
#define vtkMTWindowPainters_h

#include <cstdint>
#include <memory>
#include <vector>

class vtkMTTrianglePainter;
class vtkMTWindowClock;
class vtkOpenGLRenderTimer;
class vtkRenderWindow;
class vtkWindow;

class vtkMTWindowPainters
{
public:
  vtkMTWindowPainters();
  ~vtkMTWindowPainters();
  vtkMTWindowPainters(const vtkMTWindowPainters&) = delete;
  vtkMTWindowPainters& operator=(const vtkMTWindowPainters&) = delete;

  /// The window's painter, made if need be, and the timer of its draw calls. The window's context must be current. What
  /// it gives is the window's until that is released; it is never an object that another window's patches are in.
  vtkMTTrianglePainter& Use(vtkRenderWindow* window);
  vtkOpenGLRenderTimer& GetTimer(vtkRenderWindow* window);
  /// The window's clock, shared with other mappers' painters.
  const std::shared_ptr<vtkMTWindowClock>& GetClock(vtkRenderWindow* window);
  /// Bytes that the painter of the window may take of a limit.
  std::uint64_t Share(vtkRenderWindow* window, std::uint64_t limit);

  /// Drops all patches; buffers stay.
  void Clear();
  /// Releases a window's resources; makes its context current for that. VTK says null where a renderer has no window
  /// any more: then nothing is released.
  void Release(vtkWindow* window);

  ///@{
  /// Of all painters together; Most: at any moment so far.
  std::uint64_t GetBytes() const;
  std::uint64_t GetMostBytes() const;
  std::uint64_t GetNumberOfUploadedBytes() const;
  ///@}

private:
  class Watch;
  struct Entry;

  Entry& Find(vtkRenderWindow* window);

  std::vector<std::unique_ptr<Entry>> Entries;
};

#endif
