// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTScene
 * @brief several models in a renderer, each of which may come later, with a preview first
 *
 * Whenever something is shown the camera is placed so that everything is seen, unless a view was set or the camera has
 * been moved since.
 */
#ifndef vtkMTScene_h
#define vtkMTScene_h

#include "vtkMTInteractionModule.h" // For export macro
#include "vtkMTSceneModel.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkRenderer;
struct vtkMTCameraView;

class VTKMTINTERACTION_EXPORT vtkMTScene
{
public:
  /// hasView: the view is to stay what it is.
  vtkMTScene(vtkRenderer* renderer, const vtkMTCameraView& view, bool hasView);
  ~vtkMTScene();
  vtkMTScene(const vtkMTScene&) = delete;
  void operator=(const vtkMTScene&) = delete;

  /// Something that is not seen yet; gives its index.
  std::size_t AddItem();
  ///@{
  /// See vtkMTSceneModel.
  bool ShowModel(std::size_t item, const std::shared_ptr<const vtkMTPatchSource>& source, const std::string& name,
    const std::string& texture, std::string& error);
  void ShowPreview(std::size_t item, vtkPolyData* mesh);
  ///@}

  const std::vector<std::unique_ptr<vtkMTSceneModel>>& GetItems() const { return this->Items; }
  /// Whether there is a model or a preview of each.
  bool IsAllSeen() const;

private:
  void Show(vtkActor* actor);

  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<std::unique_ptr<vtkMTSceneModel>> Items;
  vtkMTimeType CameraTime = 0; // when it was last placed here
};

#endif
