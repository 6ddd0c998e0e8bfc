// SPDX-License-Identifier: BSD-3-Clause
// The geometry section of a patch that is not compressed. Not installed.
#ifndef vtkMTRawGeometry_h
#define vtkMTRawGeometry_h

#include "vtkMTPatch.h"

#include <string>
#include <vector>

struct vtkMTArc;

namespace vtkMTRawGeometry
{
/// Appends a consistent patch's geometry.
void Encode(const vtkMTPatch& patch, std::vector<unsigned char>& bytes);

bool Decode(const unsigned char* data, std::uint64_t size, const vtkMTArc& arc, vtkMTPatch& patch, std::string& error);
}

#endif
