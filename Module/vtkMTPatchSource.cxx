// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchSource.h"

//------------------------------------------------------------------------------
vtkMTPatchSource::~vtkMTPatchSource() = default;

//------------------------------------------------------------------------------
bool vtkMTPatchSource::ReadBlob(std::uint32_t blob, std::vector<unsigned char>& bytes, std::string& error) const
{
  bytes.clear();
  error = this->GetName() + ": no blob " + std::to_string(blob);
  return false;
}
