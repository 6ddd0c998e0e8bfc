// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFractalSphereSource
 * @brief a sphere with a fractal surface, of any size, for tests and demonstrations
 *
 * A unit icosphere about the origin, whose points are moved along their radii by eight octaves of improved Perlin noise
 * (K. Perlin, "Improving Noise", SIGGRAPH 2002), the amplitude 0.25 * 0.47^o and the frequency 1.7 * 2.03^o in octave
 * o. It is a closed manifold of genus 0, oriented outward, with detail at every scale down to 1/140 of the radius.
 *
 * The points are single precision and shared by their triangles; there are no other arrays. The source reports progress
 * and can be aborted; then, and when memory runs out (an error event with an error code), its output is empty.
 */
#ifndef vtkMTFractalSphereSource_h
#define vtkMTFractalSphereSource_h

#include "vtkMTSourcesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKMTSOURCES_EXPORT vtkMTFractalSphereSource : public vtkPolyDataAlgorithm
{
public:
  static vtkMTFractalSphereSource* New();
  vtkTypeMacro(vtkMTFractalSphereSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// How many triangles are wanted; there are 20 * 4^k, with the k from 0 to 14 whose number is nearest. Default 81920;
  /// clamped to [1, 4294967295].
  vtkSetClampMacro(NumberOfTriangles, vtkIdType, 1, 4294967295);
  vtkGetMacro(NumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /// Chooses the noise: the same seed gives the same surface on every machine. Any number; default 0, which is the
  /// permutation of Perlin's paper.
  vtkSetMacro(Seed, vtkIdType);
  vtkGetMacro(Seed, vtkIdType);
  ///@}

protected:
  vtkMTFractalSphereSource();
  ~vtkMTFractalSphereSource() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMTFractalSphereSource(const vtkMTFractalSphereSource&) = delete;
  void operator=(const vtkMTFractalSphereSource&) = delete;

  vtkIdType NumberOfTriangles = 81920;
  vtkIdType Seed = 0;
};

#endif
