// SPDX-License-Identifier: BSD-3-Clause
// What filters do on a rank that has only the handle of a model whose mesh another rank has.
#ifndef vtkMTReplica_h
#define vtkMTReplica_h

class vtkDataObject;
class vtkInformationVector;

namespace vtkMTReplica
{
/// Whether the object has patches and no mesh (vtkMultiTriangulation::RemoveMesh).
bool Is(vtkDataObject* object);

/// Where the first input is one: makes the output an empty mesh with the same arrays, and gives true.
bool MakeEmpty(vtkInformationVector** inputs, vtkInformationVector* outputs);
}

#endif
