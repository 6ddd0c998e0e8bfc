// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class bmtScene
 * @brief a model, its mapper and a window: what `bmt render` and `bmt view` have in common
 */
#ifndef bmtScene_h
#define bmtScene_h

#include "bmtCommon.h"

#include "vtkActor.h"
#include "vtkMTModelTextures.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <string>
#include <vector>

/// What the options of both commands say.
struct bmtSceneOptions
{
  std::string File;
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
  /// Opens the model and sets up everything but the window, which nothing has opened yet. Throws bmtError.
  explicit bmtScene(const bmtSceneOptions& options);

  /**
   * Throws bmtError when a window of VTK's kind cannot be opened here: VTK itself would abort. To be called before the
   * first Render.
   */
  void RequireDisplay() const;

  /// "level", "patch", "error", the name of an array of the model, or nothing for the model's colours and textures.
  void SetColorBy(const std::string& what);
  /// The figures of the last frame.
  bmtJson DescribeFrame() const;

  vtkNew<vtkMultiTriangulation> Model;
  vtkNew<vtkMultiTriangulationMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;

private:
  void SetCamera(const bmtSceneOptions& options);
  void ColorByArray(const std::string& name);

  vtkMTModelTextures Textures;
};

#endif
