// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFigureOverlay
 * @brief figures of the frame, a text and a scalar bar over what a renderer shows
 *
 * They are drawn in a layer of their own, after the models: the figures are those of the frame in which they are seen.
 * Those of several models are summed; the error is the largest.
 */
#ifndef vtkMTFigureOverlay_h
#define vtkMTFigureOverlay_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <string>

class vtkCallbackCommand;
class vtkMTColorSelector;
class vtkRenderWindow;
class vtkRenderer;
class vtkScalarBarActor;
class vtkTextActor;

class vtkMTFigureOverlay
{
public:
  /// getText gives the lines below the figures; it is asked in every frame.
  vtkMTFigureOverlay(const vtkMTColorSelector& colors, std::function<std::string()> getText);
  ~vtkMTFigureOverlay();
  vtkMTFigureOverlay(const vtkMTFigureOverlay&) = delete;
  void operator=(const vtkMTFigureOverlay&) = delete;

  /// The renderer must be in a window already, or nothing is shown. Null: none.
  void SetRenderer(vtkRenderer* renderer);

  bool ShowFigures = true;
  bool ShowScalarBar = true;

  /// What is written in the last frame.
  std::string GetText() const;

private:
  void Update();
  void UpdateScalarBar();
  std::string MakeFigures() const;

  const vtkMTColorSelector& Colors;
  const std::function<std::string()> GetMore;
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Layer;
  vtkNew<vtkTextActor> Text;
  vtkNew<vtkScalarBarActor> Bar;
  vtkNew<vtkCallbackCommand> Command;
};

#endif
