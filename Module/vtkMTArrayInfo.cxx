// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTArrayInfo.h"

#include "vtkType.h"

//------------------------------------------------------------------------------
static std::size_t GetTypeSize(int type)
{
  switch (type)
  {
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
    case VTK_UNSIGNED_CHAR:
      return 1;
    case VTK_SHORT:
    case VTK_UNSIGNED_SHORT:
      return 2;
    case VTK_INT:
    case VTK_UNSIGNED_INT:
    case VTK_FLOAT:
      return 4;
    case VTK_LONG:
    case VTK_UNSIGNED_LONG:
      return sizeof(long);
    case VTK_ID_TYPE:
      return sizeof(vtkIdType);
    case VTK_LONG_LONG:
    case VTK_UNSIGNED_LONG_LONG:
    case VTK_DOUBLE:
      return 8;
    default:
      return 0;
  }
}

//------------------------------------------------------------------------------
std::size_t vtkMTArrayInfo::GetTupleSize() const
{
  return this->Components > 0 ? GetTypeSize(this->Type) * static_cast<std::size_t>(this->Components) : 0;
}

//------------------------------------------------------------------------------
bool vtkMTArrayInfo::operator==(const vtkMTArrayInfo& other) const
{
  return this->Name == other.Name && this->Type == other.Type && this->Components == other.Components &&
    this->Association == other.Association && this->Resampling == other.Resampling && this->Role == other.Role &&
    this->Attribute == other.Attribute && this->ComponentNames == other.ComponentNames &&
    this->Properties == other.Properties;
}
