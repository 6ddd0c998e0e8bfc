// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationReader.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTFileSource.h"
#include "vtkMultiTriangulation.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Bytes of the graph that are read at once: a model of which that is all is either whole or refused.
constexpr std::uint64_t FirstBytes = std::uint64_t(1) << 20;

// Null, with the reason in error, where that fails. What is left of a larger graph is read on a thread of the source's.
std::shared_ptr<vtkMTFileSource> OpenLazily(const char* path, std::string& error)
{
  auto source = std::make_shared<vtkMTFileSource>();
  if (!source->OpenFirstPages(path, error) || !source->ReadOn(FirstBytes, error))
  {
    return nullptr;
  }
  source->StartReadingOn();
  return source;
}
}

vtkStandardNewMacro(vtkMultiTriangulationReader);

vtkMultiTriangulationReader::vtkMultiTriangulationReader()
  : OutputError(VTK_DOUBLE_MAX)
{
  this->SetNumberOfInputPorts(0);
}

vtkMultiTriangulationReader::~vtkMultiTriangulationReader()
{
  this->SetFileName(nullptr);
}

void vtkMultiTriangulationReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "OutputError: " << this->OutputError << "\n";
}

void vtkMultiTriangulationReader::SetOutputError(double error)
{
  if (std::isnan(error))
  {
    vtkWarningMacro("OutputError stays " << this->OutputError << ": NaN is no error.");
    return;
  }
  const double clamped = std::clamp(error, 0.0, VTK_DOUBLE_MAX);
  if (this->OutputError != clamped)
  {
    this->OutputError = clamped;
    this->Modified();
  }
}

int vtkMultiTriangulationReader::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::CheckUse(this, outputVector, port);
  return this->Superclass::ComputePipelineMTime(request, inputVector, outputVector, port, time);
}

int vtkMultiTriangulationReader::CanReadFile(const char* fileName)
{
  return fileName && vtkMTFileSource::CanRead(fileName) ? 1 : 0;
}

vtkMultiTriangulation* vtkMultiTriangulationReader::GetOutput()
{
  return vtkMultiTriangulation::SafeDownCast(this->GetOutputDataObject(0));
}

int vtkMultiTriangulationReader::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkMultiTriangulation");
  return 1;
}

vtkTypeBool vtkMultiTriangulationReader::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->RequestDataObject(request, inputVector, outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

int vtkMultiTriangulationReader::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  if (!vtkMultiTriangulation::SafeDownCast(info->Get(vtkDataObject::DATA_OBJECT())))
  {
    vtkNew<vtkMultiTriangulation> output;
    info->Set(vtkDataObject::DATA_OBJECT(), output);
  }
  return 1;
}

int vtkMultiTriangulationReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkMultiTriangulation* output = vtkMultiTriangulation::GetData(outputVector);
  output->Initialize();
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("no file name given");
    return 0;
  }
  std::string error;
  const std::shared_ptr<vtkMTFileSource> source = OpenLazily(this->FileName, error);
  if (!source)
  {
    const bool exists = vtksys::SystemTools::PathExists(this->FileName);
    const bool opens = vtkMTFileByteSource::Open(this->FileName, error) != nullptr;
    this->SetErrorCode(!exists                     ? vtkErrorCode::FileNotFoundError
        : !opens                                   ? vtkErrorCode::CannotOpenFileError
        : vtkMTFileSource::CanRead(this->FileName) ? vtkErrorCode::FileFormatError
                                                   : vtkErrorCode::UnrecognizedFileTypeError);
    vtkErrorMacro(<< error);
    return 0;
  }
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  if (!output->SetSource(source, this->OutputError < VTK_DOUBLE_MAX ? this->OutputError : unlimited))
  {
    output->Initialize();
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    vtkErrorMacro(<< this->FileName << ": the coarsest patches cannot be read");
    return 0;
  }
  vtkMultiTriangulation::WarnOfUse(this, outputVector);
  return 1;
}
