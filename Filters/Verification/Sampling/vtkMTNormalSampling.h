// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTNormalSampling
 * @brief tests a model's certified angles between shading normals by sampling
 *
 * The data of a place (vtkMTJointSampling) is its shading normal, and a node says which angle there may be. Over one
 * triangle the distance from a place is convex, and so is |n| cos(a) - n . m, which is at most zero where the linearly
 * interpolated normal n is within the angle a, at most a right one, of the direction m. So the least of the larger of
 * the two is found by nested searches.
 */
#ifndef vtkMTNormalSampling_h
#define vtkMTNormalSampling_h

#include "vtkMTJointSampling.h"

struct vtkMTMeasure;

class VTKMTVERIFICATION_EXPORT vtkMTNormalSampling : public vtkMTJointSampling
{
public:
  /// samples: points on each surface. The source must outlive this object.
  vtkMTNormalSampling(const vtkMTPatchSource& source, std::size_t samples, std::uint64_t seed);
  ~vtkMTNormalSampling() override;

  bool HasMeasure() const override { return this->Measure != nullptr; }

protected:
  void AddData(const vtkMTPatch& patch, std::size_t triangle, Side& side) override;
  bool Take(const Side& from, const Place& place, Wanted& wanted) const override;
  bool HasPoint(
    const Side& to, std::uint32_t triangle, const Wanted& wanted, std::uint32_t node, double reach) const override;
  std::string Describe(const Wanted& wanted, std::uint32_t node) const override;

private:
  static Corners GetNormals(const Side& side, std::uint32_t triangle);
  double GetAngle(std::uint32_t node) const;

  const vtkMTMeasure* Measure;
  Column Normals; // none: those of the triangles
};

#endif
