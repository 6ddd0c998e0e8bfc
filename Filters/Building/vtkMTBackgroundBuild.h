// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBackgroundBuild
 * @brief meshes that are built while something else is done, in one child process, one after the other
 *
 * First there are previews (vtkMTStreamPreview) of each mesh, the first one after a second and a half if it takes
 * longer, then the models. It is a child (vtkMTChildProcess), because the memory limit of a build is that of its
 * process, because a child can be ended at any time, and because the objects of a window belong to one thread; it gives
 * way to other processes. Models are written as vtkMultiTriangulationFileBuilder does it, with its defaults: whole or
 * not at all.
 */
#ifndef vtkMTBackgroundBuild_h
#define vtkMTBackgroundBuild_h

#include "vtkMTBuildingModule.h" // For export macro
#include "vtkMTChildProcess.h"
#include "vtkMTInputSettings.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

struct vtkMTBuildEvent
{
  enum KindType : char
  {
    Progress = 'p', ///< Text: how far it is
    Preview = 'v',  ///< Mesh
    Model = 'm',    ///< Text: the Multi-Triangulation file
    Failure = 'f'   ///< Text: why there will be no model; Code of vtkMultiTriangulationFileBuilder
  };
  KindType Kind = Progress;
  std::size_t Index = 0; ///< of the mesh
  std::string Text;
  vtkSmartPointer<vtkPolyData> Mesh;
  unsigned long Code = 0;
};

class VTKMTBUILDING_EXPORT vtkMTBackgroundBuild
{
public:
  vtkMTBackgroundBuild();
  /// Ends what is running. What is not finished leaves nothing but the checkpoint of a build that has an output: with
  /// that a later one goes on.
  ~vtkMTBackgroundBuild();
  vtkMTBackgroundBuild(const vtkMTBackgroundBuild&) = delete;
  void operator=(const vtkMTBackgroundBuild&) = delete;

  /**
   * Starts with them, once; each of the settings is a mesh of its own. output is the file of the model where there is
   * one mesh, and a model of it that is there already is taken as it is; where it is empty, models are in a temporary
   * folder (TMPDIR), which goes with this object. To be called while this process has one thread. False on failure,
   * with the reason.
   */
  bool Start(const std::vector<vtkMTInputSettings>& meshes, const std::string& output, std::string& error);

  /// What has happened since. Never waits.
  std::vector<vtkMTBuildEvent> Poll();
  /// Until Poll has given a model or a failure for each mesh.
  bool IsRunning() const { return this->Unfinished > 0; }

private:
  vtkMTBuildEvent ToEvent(const std::string& line) const;

  std::string Folder;
  std::string Output;
  std::vector<bool> IsDone; // of each mesh
  std::size_t Unfinished = 0;
  vtkMTChildProcess Child;
};

#endif
