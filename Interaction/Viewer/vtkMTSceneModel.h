// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTSceneModel
 * @brief a model with its textures in an actor, or for the time until there is one a mesh in its place
 */
#ifndef vtkMTSceneModel_h
#define vtkMTSceneModel_h

#include "vtkActor.h"
#include "vtkMTInteractionModule.h" // For export macro
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"

#include <memory>
#include <string>
#include <vector>

class vtkMTPatchSource;
class vtkPolyData;

class VTKMTINTERACTION_EXPORT vtkMTSceneModel
{
public:
  vtkMTSceneModel();
  ~vtkMTSceneModel();
  vtkMTSceneModel(const vtkMTSceneModel&) = delete;
  void operator=(const vtkMTSceneModel&) = delete;

  /**
   * Puts the model into the actor, with its own textures, or with an image for all of it where a file is named. False
   * on failure, with the reason; name is how it calls the model.
   */
  bool SetSource(const std::shared_ptr<const vtkMTPatchSource>& source, const std::string& name,
    const std::string& texture, std::string& error);

  /// Puts a mesh into the actor as it is; false, with nothing changed, where there is a model or VTK cannot draw it.
  bool SetPreview(vtkPolyData* mesh);

  /// Whether there is a model.
  bool HasModel() const { return this->Model->GetSource() != nullptr; }
  /// Textures that are not drawn, and why.
  const std::vector<std::string>& GetTextureProblems() const { return this->TextureProblems; }

  vtkNew<vtkMultiTriangulation> Model;
  vtkNew<vtkMultiTriangulationMapper> Mapper;
  vtkNew<vtkActor> Actor; ///< without a mapper as long as there is nothing to be seen

private:
  std::vector<std::string> TextureProblems;
};

#endif
