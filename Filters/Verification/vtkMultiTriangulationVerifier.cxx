// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationVerifier.h"

#include "Interpreter/vtkMTLongWork.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTCompatibility.h"
#include "vtkMTPatchSource.h"
#include "vtkMTTriangleStream.h"
#include "vtkMTVerification.h"
#include "vtkMultiTriangulation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <exception>

vtkStandardNewMacro(vtkMultiTriangulationVerifier);

namespace
{
template <class Array>
Array* AddColumn(vtkTable* table, const char* name)
{
  vtkNew<Array> column;
  column->SetName(name);
  table->AddColumn(column);
  return column;
}

void FillChecks(const std::vector<vtkMTVerificationCheck>& checks, vtkTable* table)
{
  auto* name = AddColumn<vtkStringArray>(table, "name");
  auto* tested = AddColumn<vtkIdTypeArray>(table, "tested");
  auto* violations = AddColumn<vtkIdTypeArray>(table, "violations");
  auto* worst = AddColumn<vtkDoubleArray>(table, "worst");
  auto* message = AddColumn<vtkStringArray>(table, "message");
  for (const vtkMTVerificationCheck& check : checks)
  {
    name->InsertNextValue(check.Name);
    tested->InsertNextValue(static_cast<vtkIdType>(check.Tested));
    violations->InsertNextValue(static_cast<vtkIdType>(check.Violations));
    worst->InsertNextValue(check.Worst);
    message->InsertNextValue(check.Message);
  }
}

void FillSpans(const std::map<std::uint32_t, std::size_t>& spans, vtkTable* table)
{
  auto* levels = AddColumn<vtkIdTypeArray>(table, "levels");
  auto* cuts = AddColumn<vtkIdTypeArray>(table, "cuts");
  for (const auto& [span, count] : spans)
  {
    levels->InsertNextValue(span);
    cuts->InsertNextValue(static_cast<vtkIdType>(count));
  }
}

void FillTightness(const std::map<std::uint32_t, vtkMTErrorSampling::Tightness>& levels, vtkTable* table)
{
  auto* level = AddColumn<vtkIdTypeArray>(table, "level");
  auto* median = AddColumn<vtkDoubleArray>(table, "median");
  auto* worst = AddColumn<vtkDoubleArray>(table, "worst");
  auto* nodes = AddColumn<vtkIdTypeArray>(table, "nodes");
  for (const auto& [index, tightness] : levels)
  {
    level->InsertNextValue(index);
    median->InsertNextValue(tightness.Median);
    worst->InsertNextValue(tightness.Worst);
    nodes->InsertNextValue(static_cast<vtkIdType>(tightness.Nodes));
  }
}
}

vtkMultiTriangulationVerifier::vtkMultiTriangulationVerifier()
{
  this->SetNumberOfInputPorts(2);
  this->Clear();
}

vtkMultiTriangulationVerifier::~vtkMultiTriangulationVerifier() = default;

void vtkMultiTriangulationVerifier::Clear()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->ErrorMessage.clear();
  this->Aborted = false;
  // New tables, since the last ones may have been handed out.
  this->Checks = vtkSmartPointer<vtkTable>::New();
  this->Spans = vtkSmartPointer<vtkTable>::New();
  this->Tightness = vtkSmartPointer<vtkTable>::New();
  this->InputChecked = false;
  this->InputReading.clear();
  this->CoordinateAllowance = 0.0;
  this->AreaAllowance = 0.0;
  this->VolumeAllowance = 0.0;
  this->Certified = false;
  this->NumberOfMeasuredCuts = 0;
  this->NumberOfSkippedValues = 0;
  this->Tolerance = 0.0;
  this->NumberOfNonFiniteTriangles = 0;
  this->NumberOfOutOfRangeTriangles = 0;
  this->NumberOfDegenerateTriangles = 0;
  this->NumberOfFarOutliers = 0;
}

void vtkMultiTriangulationVerifier::AddInputFileName(const char* name)
{
  if (name && *name)
  {
    this->InputFileNames.emplace_back(name);
    this->Modified();
  }
}

void vtkMultiTriangulationVerifier::RemoveAllInputFileNames()
{
  if (!this->InputFileNames.empty())
  {
    this->InputFileNames.clear();
    this->Modified();
  }
}

int vtkMultiTriangulationVerifier::GetNumberOfInputFileNames() const
{
  return static_cast<int>(this->InputFileNames.size());
}

const char* vtkMultiTriangulationVerifier::GetInputFileName(int index) const
{
  return index >= 0 && index < this->GetNumberOfInputFileNames() ? this->InputFileNames[index].c_str() : nullptr;
}

void vtkMultiTriangulationVerifier::SetInputIsoValue(double value)
{
  if (!std::isfinite(value))
  {
    vtkErrorMacro("The iso value must be a finite number, not " << value << ".");
    return;
  }
  if (!this->HasInputIsoValue || this->InputIsoValue != value)
  {
    this->HasInputIsoValue = true;
    this->InputIsoValue = value;
    this->Modified();
  }
}

void vtkMultiTriangulationVerifier::ClearInputIsoValue()
{
  if (this->HasInputIsoValue)
  {
    this->HasInputIsoValue = false;
    this->Modified();
  }
}

void vtkMultiTriangulationVerifier::SetInputVerticalScale(double scale)
{
  if (!std::isfinite(scale))
  {
    vtkErrorMacro("The vertical scale must be a finite number, not " << scale << ".");
    return;
  }
  if (this->InputVerticalScale != scale)
  {
    this->InputVerticalScale = scale;
    this->Modified();
  }
}

bool vtkMultiTriangulationVerifier::Run(const vtkMTPatchSource& source, vtkPolyData* mesh, const InputOpener& openInput)
{
  vtkMTVerification::Settings settings;
  settings.Cuts = static_cast<std::size_t>(this->NumberOfCuts);
  settings.Samples = static_cast<std::size_t>(this->NumberOfSamples);
  settings.Seed = this->Seed;
  settings.InputName = this->InputFileNames.empty() ? this->InputName : this->InputFileNames.front();
  vtkMTVerification verification(source, settings,
    [this](const std::string& step, double share)
    {
      this->SetProgressText(step.c_str());
      this->UpdateProgress(share);
      this->Aborted = vtkMTIsAborted(this);
      return !this->Aborted;
    });
  vtkMTVerification::Input input;
  input.Mesh = mesh;
  input.Files.Paths = this->InputFileNames;
  input.Files.IsoValue = this->HasInputIsoValue ? std::optional<double>(this->InputIsoValue) : std::nullopt;
  input.Files.VerticalScale = this->InputVerticalScale;
  input.Files.Degrees = this->InputDegrees;
  input.Open = openInput;
  if (!verification.Run(input, this->ErrorMessage))
  {
    return false;
  }
  const vtkMTVerification::Result& result = verification.GetResult();
  FillChecks(result.Checks, this->Checks);
  FillSpans(result.Spans, this->Spans);
  FillTightness(result.Tightness, this->Tightness);
  for (const vtkMTVerificationCheck& check : result.Checks)
  {
    this->InputReading = check.Name == "input_reading" ? check.Message : this->InputReading;
    this->InputChecked = this->InputChecked || check.Name == "input_arrays"; // the last of those
  }
  this->CoordinateAllowance = result.CoordinateAllowance;
  this->AreaAllowance = result.AreaAllowance;
  this->VolumeAllowance = result.VolumeAllowance;
  this->Certified = result.IsCertified;
  this->NumberOfMeasuredCuts = static_cast<vtkIdType>(result.MeasuredCuts);
  this->NumberOfSkippedValues = static_cast<vtkIdType>(result.SkippedValues);
  this->Tolerance = result.Tolerance;
  this->NumberOfNonFiniteTriangles = result.NonFinite;
  this->NumberOfOutOfRangeTriangles = result.OutOfRange;
  this->NumberOfDegenerateTriangles = result.Degenerate;
  this->NumberOfFarOutliers = result.FarOutliers;
  return true;
}

bool vtkMultiTriangulationVerifier::Verify(const vtkMTPatchSource& source, const InputOpener& openInput)
{
  return this->VerifyInput(source, nullptr, openInput);
}

bool vtkMultiTriangulationVerifier::VerifyInput(
  const vtkMTPatchSource& source, vtkPolyData* mesh, const InputOpener& openInput)
{
  const vtkMTLongWork work;
  this->Clear();
  this->UpdateProgress(0.0);
  bool verified = false;
  try
  {
    verified = this->Run(source, mesh, openInput);
  }
  catch (const std::exception& e)
  {
    this->ErrorMessage = std::string("out of memory or an internal fault: ") + e.what();
  }
  if (!verified)
  {
    this->SetErrorCode(this->Aborted ? vtkErrorCode::UserError : vtkErrorCode::UnknownError);
    return false;
  }
  this->UpdateProgress(1.0);
  return true;
}

bool vtkMultiTriangulationVerifier::IsValid() const
{
  auto* violations = vtkIdTypeArray::SafeDownCast(this->Checks->GetColumnByName("violations"));
  if (!violations || violations->GetNumberOfValues() == 0)
  {
    return false;
  }
  for (vtkIdType i = 0; i < violations->GetNumberOfValues(); ++i)
  {
    if (violations->GetValue(i) != 0)
    {
      return false;
    }
  }
  return true;
}

vtkTable* vtkMultiTriangulationVerifier::GetChecks()
{
  return this->Checks;
}

vtkTable* vtkMultiTriangulationVerifier::GetSpans()
{
  return this->Spans;
}

vtkTable* vtkMultiTriangulationVerifier::GetTightness()
{
  return this->Tightness;
}

//------------------------------------------------------------------------------
int vtkMultiTriangulationVerifier::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::AnnounceUse(inputVector);
  return this->Superclass::ComputePipelineMTime(request, inputVector, outputVector, port, time);
}

int vtkMultiTriangulationVerifier::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkMultiTriangulationVerifier::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* output = vtkTable::GetData(outputVector);
  output->Initialize();
  auto* model = vtkMultiTriangulation::GetData(inputVector[0]);
  const std::shared_ptr<const vtkMTPatchSource> source = model ? model->GetSource() : nullptr;
  if (!source)
  {
    this->Clear();
    this->SetErrorCode(vtkErrorCode::UserError);
    this->ErrorMessage = "the input on port 0 is no vtkMultiTriangulation that has its patches";
    vtkErrorMacro("Nothing was verified: " << this->ErrorMessage << ".");
    return 0;
  }
  if (!this->VerifyInput(*source, vtkPolyData::GetData(inputVector[1]), nullptr))
  {
    if (this->Aborted)
    {
      return 1; // what the user asked for is no error
    }
    vtkErrorMacro("Nothing was verified: " << this->ErrorMessage << ".");
    return 0;
  }
  output->ShallowCopy(this->Checks);
  return 1;
}

void vtkMultiTriangulationVerifier::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfCuts: " << this->NumberOfCuts << "\n";
  os << indent << "NumberOfSamples: " << this->NumberOfSamples << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "InputName: " << this->InputName << "\n";
  os << indent << "InputFileNames: " << this->InputFileNames.size() << "\n";
  os << indent << "InputIsoValue: " << (this->HasInputIsoValue ? std::to_string(this->InputIsoValue) : "(none)")
     << "\n";
  os << indent << "InputVerticalScale: " << this->InputVerticalScale << "\n";
  os << indent << "InputDegrees: " << (this->InputDegrees ? "on" : "off") << "\n";
  os << indent << "InputChecked: " << (this->InputChecked ? "yes" : "no") << "\n";
  os << indent << "InputReading: " << this->InputReading << "\n";
  os << indent << "CoordinateAllowance: " << this->CoordinateAllowance << "\n";
  os << indent << "AreaAllowance: " << this->AreaAllowance << "\n";
  os << indent << "VolumeAllowance: " << this->VolumeAllowance << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "Checks: " << this->Checks->GetNumberOfRows() << "\n";
  os << indent << "Valid: " << (this->IsValid() ? "yes" : "no") << "\n";
  os << indent << "Certified: " << (this->Certified ? "yes" : "no") << "\n";
  os << indent << "NumberOfMeasuredCuts: " << this->NumberOfMeasuredCuts << "\n";
  os << indent << "NumberOfSkippedValues: " << this->NumberOfSkippedValues << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "NumberOfNonFiniteTriangles: " << this->NumberOfNonFiniteTriangles << "\n";
  os << indent << "NumberOfOutOfRangeTriangles: " << this->NumberOfOutOfRangeTriangles << "\n";
  os << indent << "NumberOfDegenerateTriangles: " << this->NumberOfDegenerateTriangles << "\n";
  os << indent << "NumberOfFarOutliers: " << this->NumberOfFarOutliers << "\n";
}
