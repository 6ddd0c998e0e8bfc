// SPDX-License-Identifier: BSD-3-Clause
// Whether the cells of a legacy VTK file are sound. Not installed.
#ifndef vtkMTLegacyCheck_h
#define vtkMTLegacyCheck_h

#include <string>

class vtkMTByteSource;

namespace vtkMTLegacyCheck
{
/**
 * VTK 9.1's readers follow the counts and indices in the cells of polydata and grids without a look at them, and crash
 * where the file ends among them. So this goes through the file first, up to the end of its cells (arrays
 * come after them), in text or binary, in the formats before and after version 5.
 */
bool Check(const vtkMTByteSource& bytes, std::string& error);
}

#endif
