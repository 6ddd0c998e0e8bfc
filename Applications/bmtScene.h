// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class bmtScene
 * @brief models, their mappers and a window: what `bmt render` and `bmt view` have in common
 */
#ifndef bmtScene_h
#define bmtScene_h

#include "bmtCommon.h"

#include "vtkMTColorSelector.h"
#include "vtkMTScene.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

/// What the options of both commands say.
struct bmtSceneOptions
{
  std::array<int, 2> Size{ 1024, 768 };
  std::vector<double> Camera; ///< position, focal point, view up: nine numbers, or none for a view of the whole model
  double ViewAngle = 30.0;    ///< degrees, vertical
  double PixelError = 1.0;
  std::string Metric = "distance";
  std::int64_t Budget = 0;
  std::string ColorBy;
  std::string Texture;
};

void bmtAddSceneOptions(CLI::App& command, bmtSceneOptions& options);

class bmtScene
{
public:
  /// Sets up everything but the window, which nothing has opened yet. Throws bmtError.
  explicit bmtScene(const bmtSceneOptions& options);

  /**
   * Throws bmtError when a window of VTK's kind cannot be opened here: VTK itself would abort. To be called before the
   * first Render.
   */
  void RequireDisplay() const;

  /// Shows a model. Throws bmtError.
  void ShowModel(std::size_t item, const std::string& path);
  /// Throws bmtError where no model has such an array; it names those that there are.
  void RequireColors(const std::string& name);
  /// The figures of the last frame.
  bmtJson DescribeFrame() const;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  std::unique_ptr<vtkMTScene> Models;

private:
  const bmtSceneOptions Options;
};

#endif
