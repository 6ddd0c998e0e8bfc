// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVersion.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMTVersion);

vtkMTVersion::vtkMTVersion() = default;

vtkMTVersion::~vtkMTVersion() = default;

const char* vtkMTVersion::GetVersion()
{
  return MT_VERSION;
}

int vtkMTVersion::GetMajorVersion()
{
  return MT_VERSION_MAJOR;
}

int vtkMTVersion::GetMinorVersion()
{
  return MT_VERSION_MINOR;
}

int vtkMTVersion::GetPatchVersion()
{
  return MT_VERSION_PATCH;
}

void vtkMTVersion::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Version: " << vtkMTVersion::GetVersion() << "\n";
}
