// SPDX-License-Identifier: BSD-3-Clause
// Simplifications of a whole mesh in memory, to compare cuts with: the toolkit's own simplifiers without patches, VTK's
// filters, and meshoptimizer.
#ifndef MTReportYardsticks_h
#define MTReportYardsticks_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace MTReportYardsticks
{
using Mesh = vtkSmartPointer<vtkPolyData>;
/// Simplifies once; what it needs has been prepared.
using Work = std::function<Mesh()>;

struct Yardstick
{
  std::string Name;
  /// For about so many triangles. Preparing is not part of the time that is measured.
  std::function<Work(vtkPolyData* mesh, vtkIdType triangles)> Prepare;
};

/// One of the toolkit's simplifiers by its name, on the whole mesh: what it does when there are no patches.
Work PrepareOwn(const std::string& simplifier, vtkPolyData* mesh, vtkIdType triangles);

/// Those of others.
const std::vector<Yardstick>& GetOthers();
}

#endif
