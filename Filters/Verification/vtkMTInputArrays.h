// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputArrays
 * @brief holds the arrays of a model's finest level against those of its input
 *
 * Each array of the input must be in the model: one of its name, or else any one that holds the same; the own readers
 * of the verification call colours, materials and the like by names of their own. Values are compared at the corners
 * and cells of the pairs of triangles that vtkMTInputComparison found, then the ranges of all components or, of whole
 * numbers, the set of values. Colours may be stored as bytes or as numbers from 0 to 1, linear or sRGB, or as the
 * colours of a lookup table's annotations; names (groups, materials) may have any ids, but the same cells must have the
 * same name, and the names must be the annotations of the array's lookup table. Where the input has no value (NaN), any
 * will do. As many arrays may be missing as the model's report counts (arrays_left_out).
 */
#ifndef vtkMTInputArrays_h
#define vtkMTInputArrays_h

#include "vtkMTInputComparison.h"
#include "vtkMTVerificationModule.h" // For export macro

#include <functional>
#include <string>
#include <vector>

class vtkDataArray;
class vtkMTGraph;
class vtkPolyData;

class VTKMTVERIFICATION_EXPORT vtkMTInputArrays
{
public:
  using Describer = std::function<std::string(const vtkMTRealPoint& place)>;

  vtkMTInputArrays(vtkPolyData* inputMesh, const vtkMTSampledSurface& input, vtkPolyData* modelMesh,
    const vtkMTSampledSurface& model, const std::vector<vtkMTInputComparison::Pair>& pairs);

  vtkMTVerificationCheck Test(const vtkMTGraph& graph, const Describer& describe) const;

private:
  struct Column;
  struct Spread;
  bool IsSame(const Column& input, const Column& model, const Describer& describe, std::string& difference) const;
  bool IsSameAtPairs(
    const Column& input, const Column& model, const Describer& describe, std::string& difference) const;
  bool IsSameInRange(const Column& input, const Column& model, std::string& difference) const;
  bool HasSameNames(const Column& input, const Column& model, std::string& difference) const;
  /// Whether the model has it; else why not, empty where it has none of its name.
  bool IsThere(const Column& input, const Describer& describe, std::string& difference) const;
  bool Matches(const Column& input, vtkDataArray* model, const Describer& describe, std::string& difference) const;

  vtkPolyData* InputMesh;
  const vtkMTSampledSurface& Input;
  vtkPolyData* ModelMesh;
  const vtkMTSampledSurface& Model;
  const std::vector<vtkMTInputComparison::Pair>& Pairs;
};

#endif
