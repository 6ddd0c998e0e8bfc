// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPlaneSource.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTPlane.h"
#include "vtkMTStreamOutput.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMTPlaneSource);

vtkMTPlaneSource::vtkMTPlaneSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkMTPlaneSource::~vtkMTPlaneSource() = default;

int vtkMTPlaneSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkMTPlane stream(static_cast<std::uint64_t>(this->NumberOfTriangles));
  std::string error;
  if (!vtkMTStreamOutput::Fill(stream, this, vtkPolyData::GetData(outputVector), error) && !error.empty())
  {
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro("No mesh was made: " << error << ".");
    return 0;
  }
  return 1; // an abort is no error
}

void vtkMTPlaneSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
}
