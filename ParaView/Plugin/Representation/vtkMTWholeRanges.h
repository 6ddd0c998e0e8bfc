// SPDX-License-Identifier: BSD-3-Clause
// Has the arrays of a model's coarsest cut say the ranges of the whole model.
#ifndef vtkMTWholeRanges_h
#define vtkMTWholeRanges_h

class vtkMultiTriangulation;

namespace vtkMTWholeRanges
{
/// What vtkDataArray::GetRange and GetFiniteRange give, of components and magnitudes, until the array is modified.
void Announce(vtkMultiTriangulation& model);
}

#endif
