// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFractalSphereSource.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTFractalSphere.h"
#include "vtkMTStreamOutput.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMTFractalSphereSource);

vtkMTFractalSphereSource::vtkMTFractalSphereSource()
{
  this->SetNumberOfInputPorts(0);
}

vtkMTFractalSphereSource::~vtkMTFractalSphereSource() = default;

int vtkMTFractalSphereSource::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkMTFractalSphere stream(
    static_cast<std::uint64_t>(this->NumberOfTriangles), static_cast<std::uint64_t>(this->Seed));
  std::string error;
  if (!vtkMTStreamOutput::Fill(stream, this, vtkPolyData::GetData(outputVector), error) && !error.empty())
  {
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro("No mesh was made: " << error << ".");
    return 0;
  }
  return 1; // an abort is no error
}

void vtkMTFractalSphereSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
}
