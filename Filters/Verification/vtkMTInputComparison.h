// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputComparison
 * @brief holds a model's finest level against its input: what was read, not how well it was simplified
 *
 * The checks: "input_triangles" (their number, with what the model's input report counts as dropped, each reason held
 * against the input's own count of it), "input_bounds", "input_area", "input_volume" (signed, about the middle of the
 * model), "input_orientation" (every triangle has its counterpart with the same corners in the same turn, of n copies
 * n, as many as the report does not count as turned: vtkMTCounterparts), "input_arrays" (vtkMTInputArrays) and "labels"
 * (vtkMTLabelCheck).
 *
 * What is allowed follows from the lattice: a point moves by at most MaximumShift, s, and by the rounding that its
 * reader states. So bounds may differ by s, the area by s (|u| + |v|) + 2 s^2 for each triangle with the sides u and v,
 * the volume by what its determinant changes when each corner moves by s. Polygons whose triangulation is open add what
 * vtkMTVerifyPolygons says.
 */
#ifndef vtkMTInputComparison_h
#define vtkMTInputComparison_h

#include "vtkMTCounterparts.h" // For vtkMTInputComparison::Pair
#include "vtkMTMeasuringFrame.h"
#include "vtkMTSampledSurface.h"
#include "vtkMTVerificationCheck.h"
#include "vtkMTVerificationModule.h" // For export macro
#include "vtkNew.h"
#include "vtkPolyData.h" // For a member
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTLatticeKeys;
class vtkMTPatchSource;

class VTKMTVERIFICATION_EXPORT vtkMTInputComparison
{
public:
  /// A triangle of the input and its counterpart in the model; several where faces lie on each other, which places
  /// alone do not tell apart.
  struct Pair
  {
    std::uint32_t Input;
    std::vector<vtkMTCounterparts::Counterpart> Models;
  };

  /// What was compared, and with which allowance; in the frame's units, in which no volume is beyond double precision.
  struct Figures
  {
    std::int64_t Triangles = 0;
    double Area = 0.0;
    double Volume = 0.0;
    double AreaAllowance = 0.0;
    double VolumeAllowance = 0.0;
  };

  /// rounding: of the input's coordinates, as a share of the largest; limit: triangles that are held against each other
  /// one by one.
  vtkMTInputComparison(const vtkMTPatchSource& source, vtkPolyData* input, double rounding, std::size_t limit);
  ~vtkMTInputComparison();

  /// False when the model cannot be read, which error says, and when progress stopped it; then error is empty.
  bool Test(const vtkMTVerificationProgress& progress, std::vector<vtkMTVerificationCheck>& checks, std::string& error);

  /// The input's triangles, for the sampling of errors; after Test.
  vtkMTSampledSurface TakeSurface() { return std::move(this->Original); }
  const Figures& GetInputFigures() const { return this->InputFigures; }
  /// A length, area or volume of the figures in model units; infinite where it is beyond double precision.
  double ToModel(double figure, int dimensions) const;
  /// How far coordinates may be apart, model units.
  double GetAllowance() const { return this->Allowance; }

private:
  bool Load(const vtkMTVerificationProgress& progress, std::string& error);
  std::int64_t CountSmall() const;
  Figures Measure(const vtkMTSampledSurface& surface) const;
  std::int64_t GetCount(const std::string& name) const;
  vtkMTVerificationCheck TestTriangles() const;
  vtkMTVerificationCheck TestBounds() const;
  vtkMTVerificationCheck TestArea() const;
  vtkMTVerificationCheck TestVolume() const;
  bool TestOrientation(const vtkMTVerificationProgress& progress, vtkMTVerificationCheck& check);
  bool IsUnclear(std::uint32_t t) const;
  void TestTriangle(std::uint32_t t, const vtkMTCounterparts& counterparts, vtkMTVerificationCheck& check);
  std::string Describe(const vtkMTRealPoint& local) const;

  const vtkMTPatchSource& Source;
  vtkSmartPointer<vtkPolyData> InputMesh;
  vtkNew<vtkPolyData> ModelMesh;
  double Rounding;
  std::size_t Limit;
  double Allowance = 0.0;
  vtkMTMeasuringFrame Frame;
  vtkMTSampledSurface Original; // in model units
  vtkMTSampledSurface Input;    // these two in the frame
  vtkMTSampledSurface Model;
  std::unique_ptr<vtkMTLatticeKeys> Keys; // of the model's surface
  std::unique_ptr<vtkMTLatticeKeys> InputKeys;
  std::int64_t OpenTriangles = 0;
  double OpenArea = 0.0;
  double OpenVolume = 0.0;
  Figures InputFigures;
  Figures ModelFigures;
  std::int64_t Turned = 0; // triangles
  std::vector<Pair> Pairs;
};

#endif
