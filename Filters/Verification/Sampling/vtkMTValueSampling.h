// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTValueSampling
 * @brief tests a model's certified deviations of scalar arrays by sampling
 *
 * The data of a place (vtkMTJointSampling) are the values of those arrays of one component that the model has the
 * measures vtkMTMeasure::GetValueDeviationName of: linear over a triangle for arrays of points, constant for those of
 * cells. A node says by how much the value may differ. The part of a triangle where the value is within that of the
 * wanted one is a convex polygon, the triangle cut by two parallel lines, so whether its closest point is within the
 * distance decides exactly. A node that certifies nothing, its measure being the largest number there is, is held to
 * the distance alone.
 *
 * Places whose value is not finite are left out and counted. 1e-12 of the array's largest value is allowed for
 * rounding.
 */
#ifndef vtkMTValueSampling_h
#define vtkMTValueSampling_h

#include "vtkMTJointSampling.h"

#include <string>
#include <vector>

struct vtkMTMeasure;

class VTKMTVERIFICATION_EXPORT vtkMTValueSampling : public vtkMTJointSampling
{
public:
  /// samples: points on each surface. The source must outlive this object.
  vtkMTValueSampling(const vtkMTPatchSource& source, std::size_t samples, std::uint64_t seed);
  ~vtkMTValueSampling() override;

  bool HasMeasure() const override { return !this->Parts.empty(); }

protected:
  void AddData(const vtkMTPatch& patch, std::size_t triangle, Side& side) override;
  std::size_t GetNumberOfParts() const override { return this->Parts.size(); }
  bool Take(const Side& from, const Place& place, Wanted& wanted) const override;
  bool HasPoint(
    const Side& to, std::uint32_t triangle, const Wanted& wanted, std::uint32_t node, double reach) const override;
  std::string Describe(const Wanted& wanted, std::uint32_t node) const override;

private:
  struct Part
  {
    const vtkMTMeasure* Measure;
    Column Values;
    std::string Name;
    double Largest; // of the values that were read, without their signs
  };

  std::vector<Part> Parts; // an array each
};

#endif
