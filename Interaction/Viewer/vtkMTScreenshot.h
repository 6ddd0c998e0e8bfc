// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTScreenshot
 * @brief what a window shows, as a PNG file
 */
#ifndef vtkMTScreenshot_h
#define vtkMTScreenshot_h

#include "vtkMTInteractionModule.h" // For export macro

#include <string>

class vtkRenderWindow;

struct VTKMTINTERACTION_EXPORT vtkMTScreenshot
{
  /// Writes the last frame into the file, whole or not at all; an earlier one is replaced. False on failure, with the
  /// reason.
  static bool Write(vtkRenderWindow* window, const std::string& path, std::string& error);

  /**
   * Writes it into a new file: prefix, "-", a number of at least four digits, ".png". The number is one more than the
   * largest one that is there, so that files are in the order in which they were made, and no file is ever replaced.
   * Gives the name; nothing on failure, with the reason.
   */
  static std::string WriteNext(vtkRenderWindow* window, const std::string& prefix, std::string& error);

  /// Makes an empty file with the next free number, as above, before the given ending (".png"), for the caller to
  /// replace. Nothing on failure, with the reason.
  static std::string ReserveNext(const std::string& prefix, const std::string& ending, std::string& error);
};

#endif
