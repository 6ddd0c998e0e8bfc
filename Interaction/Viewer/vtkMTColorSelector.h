// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTColorSelector
 * @brief what the models of a renderer are coloured by, the same for all of them
 *
 * By nothing (the colours and textures of the data), by the cut (level, patch, error), or by an array, over one range
 * for all models that have it: that of their finest levels, where the models know it. A model that lacks the array has
 * the colour of its property. Arrays with three or four components that are colours are drawn as they are unless a
 * component is chosen.
 */
#ifndef vtkMTColorSelector_h
#define vtkMTColorSelector_h

#include "vtkMTInteractionModule.h" // For export macro
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkDataArray;
class vtkLookupTable;
class vtkMultiTriangulationMapper;
class vtkProperty;
class vtkRenderer;
class vtkScalarsToColors;
class vtkTexture;

class VTKMTINTERACTION_EXPORT vtkMTColorSelector
{
public:
  vtkMTColorSelector();
  ~vtkMTColorSelector();
  vtkMTColorSelector(const vtkMTColorSelector&) = delete;
  void operator=(const vtkMTColorSelector&) = delete;

  void SetRenderer(vtkRenderer* renderer);
  /// Those of its visible actors that draw models.
  static std::vector<std::pair<vtkActor*, vtkMultiTriangulationMapper*>> FindModels(vtkRenderer* renderer);

  /// The names of the models' arrays, each once: of points first. Ids by which picking finds the input are left out.
  std::vector<std::string> GetNames() const;
  /// What can be selected, for messages: "level, patch, error, Normals".
  std::string DescribeNames() const;

  /// "" (colours of the data), "level", "patch", "error" or the name of an array, also of one that GetNames leaves out.
  /// False, with nothing changed, where no model has such an array.
  bool Select(const std::string& name);
  const std::string& GetSelected() const { return this->Selected; }
  /// The next (1) or the previous (-1) of GetNames, and from the last one on to the colours of the data.
  void SelectNext(int step);
  /// Of the array that is selected; -1, the first one: all of them, by magnitude or as colours.
  void SelectNextComponent();
  int GetComponent() const { return this->Component; }

  ///@{
  /// Whether textures are drawn, with the colours of the data. Default on.
  void SetShowTextures(bool on);
  bool GetShowTextures() const { return this->ShowTextures; }
  ///@}

  /// Colours what has come since as what is there.
  void Apply();

  ///@{
  /// For a scalar bar: the table and its title; null where colours need none.
  vtkScalarsToColors* GetTable() const;
  std::string GetTitle() const;
  ///@}

private:
  std::array<double, 2> FindRange() const;
  int GetNumberOfComponents() const;
  void ApplyTo(vtkActor* actor, vtkMultiTriangulationMapper* mapper);
  void ApplyArray(vtkMultiTriangulationMapper* mapper);
  void HideTextures(vtkProperty* property);
  void RestoreTextures(vtkProperty* property);

  vtkWeakPointer<vtkRenderer> Renderer;
  std::string Selected;
  int Component = -1;
  bool ShowTextures = true;
  bool IsDirect = false; // colours as they are
  vtkSmartPointer<vtkLookupTable> Table;
  vtkSmartPointer<vtkScalarsToColors> Named; // that the array carries, where its values have names
  std::map<vtkProperty*, std::map<std::string, vtkSmartPointer<vtkTexture>>> Hidden;
};

#endif
