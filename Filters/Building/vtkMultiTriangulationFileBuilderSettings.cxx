// SPDX-License-Identifier: BSD-3-Clause
// The settings of vtkMultiTriangulationFileBuilder, and what can be asked after a build.
#include "vtkMultiTriangulationFileBuilder.h"
#include "vtkMultiTriangulationFileBuilderInternals.h"

#include "vtkMTBuildWorkspace.h"
#include "vtkMTFileBuildReport.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTSimplifier.h"

#include <algorithm>
#include <cmath>

namespace
{
// Whether that is a change.
template <class Value>
bool Change(Value& setting, const Value& value)
{
  const bool isOther = !(setting == value);
  setting = value;
  return isOther;
}
}

//------------------------------------------------------------------------------
// The input
void vtkMultiTriangulationFileBuilder::AddFileName(const char* name)
{
  if (name && *name)
  {
    this->Implementation->Input.Paths.emplace_back(name);
    this->Modified();
  }
}

void vtkMultiTriangulationFileBuilder::SetFileName(const char* name)
{
  this->RemoveAllFileNames();
  this->AddFileName(name);
}

void vtkMultiTriangulationFileBuilder::RemoveAllFileNames()
{
  if (!this->Implementation->Input.Paths.empty())
  {
    this->Implementation->Input.Paths.clear();
    this->Modified();
  }
}

int vtkMultiTriangulationFileBuilder::GetNumberOfFileNames() const
{
  return static_cast<int>(this->Implementation->Input.Paths.size());
}

const char* vtkMultiTriangulationFileBuilder::GetFileName(int index) const
{
  return index >= 0 && index < this->GetNumberOfFileNames()
    ? this->Implementation->Input.Paths[static_cast<std::size_t>(index)].c_str()
    : nullptr;
}

void vtkMultiTriangulationFileBuilder::SetIsoValue(double value)
{
  if (!std::isfinite(value))
  {
    vtkErrorMacro("The iso value must be a finite number, not " << value << ".");
    return;
  }
  if (Change(this->Implementation->Input.IsoValue, std::optional<double>(value)))
  {
    this->Modified();
  }
}

void vtkMultiTriangulationFileBuilder::ClearIsoValue()
{
  if (Change(this->Implementation->Input.IsoValue, std::optional<double>()))
  {
    this->Modified();
  }
}

bool vtkMultiTriangulationFileBuilder::HasIsoValue() const
{
  return this->Implementation->Input.IsoValue.has_value();
}

double vtkMultiTriangulationFileBuilder::GetIsoValue() const
{
  return this->Implementation->Input.IsoValue.value_or(0.0);
}

void vtkMultiTriangulationFileBuilder::SetGradientNormals(bool on)
{
  if (Change(this->Implementation->Input.GradientNormals, on))
  {
    this->Modified();
  }
}

bool vtkMultiTriangulationFileBuilder::GetGradientNormals() const
{
  return this->Implementation->Input.GradientNormals;
}

void vtkMultiTriangulationFileBuilder::SetVerticalScale(double scale)
{
  if (!std::isfinite(scale) || scale == 0.0)
  {
    vtkErrorMacro("The vertical scale must be a finite number other than 0, not " << scale << ".");
    return;
  }
  if (Change(this->Implementation->Input.VerticalScale, scale))
  {
    this->Modified();
  }
}

double vtkMultiTriangulationFileBuilder::GetVerticalScale() const
{
  return this->Implementation->Input.VerticalScale;
}

void vtkMultiTriangulationFileBuilder::SetDegrees(bool on)
{
  if (Change(this->Implementation->Input.Degrees, on))
  {
    this->Modified();
  }
}

bool vtkMultiTriangulationFileBuilder::GetDegrees() const
{
  return this->Implementation->Input.Degrees;
}

void vtkMultiTriangulationFileBuilder::AddArrayName(const char* name)
{
  if (name)
  {
    this->Implementation->Arrays.emplace_back(name);
    this->KeepAllArrays = false;
    this->Modified();
  }
}

void vtkMultiTriangulationFileBuilder::RemoveAllArrayNames()
{
  if (!this->Implementation->Arrays.empty())
  {
    this->Implementation->Arrays.clear();
    this->Modified();
  }
}

void vtkMultiTriangulationFileBuilder::AddCertifiedArrayName(const char* name)
{
  this->Implementation->Builder->AddCertifiedArrayName(name);
}

void vtkMultiTriangulationFileBuilder::RemoveAllCertifiedArrayNames()
{
  this->Implementation->Builder->RemoveAllCertifiedArrayNames();
}

void vtkMultiTriangulationFileBuilder::AddLabelArrayName(const char* name)
{
  this->Implementation->Builder->AddLabelArrayName(name);
}

void vtkMultiTriangulationFileBuilder::AddValueArrayName(const char* name)
{
  this->Implementation->Builder->AddValueArrayName(name);
}

void vtkMultiTriangulationFileBuilder::RemoveAllLabelArrayNames()
{
  this->Implementation->Builder->RemoveAllLabelArrayNames();
}

void vtkMultiTriangulationFileBuilder::RemoveAllValueArrayNames()
{
  this->Implementation->Builder->RemoveAllValueArrayNames();
}

//------------------------------------------------------------------------------
// What the builder does with it
void vtkMultiTriangulationFileBuilder::SetMakeNormals(bool on)
{
  this->Implementation->Builder->SetMakeNormals(on);
}

bool vtkMultiTriangulationFileBuilder::GetMakeNormals() const
{
  return this->Implementation->Builder->GetMakeNormals();
}

void vtkMultiTriangulationFileBuilder::SetNormalBits(int bits)
{
  this->Implementation->Builder->SetNormalBits(bits);
}

int vtkMultiTriangulationFileBuilder::GetNormalBits() const
{
  return this->Implementation->Builder->GetNormalBits();
}

void vtkMultiTriangulationFileBuilder::SetFeatureAngle(double degrees)
{
  this->Implementation->Builder->SetFeatureAngle(degrees);
}

double vtkMultiTriangulationFileBuilder::GetFeatureAngle() const
{
  return this->Implementation->Builder->GetFeatureAngle();
}

void vtkMultiTriangulationFileBuilder::SetKeepFarOutliers(bool on)
{
  this->Implementation->Builder->SetKeepFarOutliers(on);
}

bool vtkMultiTriangulationFileBuilder::GetKeepFarOutliers() const
{
  return this->Implementation->Builder->GetKeepFarOutliers();
}

void vtkMultiTriangulationFileBuilder::SetInputIds(int ids)
{
  this->Implementation->Builder->SetInputIds(ids);
}

int vtkMultiTriangulationFileBuilder::GetInputIds() const
{
  return this->Implementation->Builder->GetInputIds();
}

void vtkMultiTriangulationFileBuilder::SetInputPointIds(bool on)
{
  this->Implementation->Builder->SetInputPointIds(on);
}

bool vtkMultiTriangulationFileBuilder::GetInputPointIds() const
{
  return this->Implementation->Builder->GetInputPointIds();
}

void vtkMultiTriangulationFileBuilder::SetExactPoints(bool on)
{
  this->Implementation->Builder->SetExactPoints(on);
}

bool vtkMultiTriangulationFileBuilder::GetExactPoints() const
{
  return this->Implementation->Builder->GetExactPoints();
}

void vtkMultiTriangulationFileBuilder::SetDirectLevels(int levels)
{
  this->Implementation->Builder->SetDirectLevels(levels);
}

int vtkMultiTriangulationFileBuilder::GetDirectLevels() const
{
  return this->Implementation->Builder->GetDirectLevels();
}

void vtkMultiTriangulationFileBuilder::SetCertifyNormals(bool on)
{
  this->Implementation->Builder->SetCertifyNormals(on);
}

bool vtkMultiTriangulationFileBuilder::GetCertifyNormals() const
{
  return this->Implementation->Builder->GetCertifyNormals();
}

void vtkMultiTriangulationFileBuilder::SetPatchTriangles(int triangles)
{
  this->Implementation->Builder->SetPatchTriangles(triangles);
}

int vtkMultiTriangulationFileBuilder::GetPatchTriangles() const
{
  return this->Implementation->Builder->GetPatchTriangles();
}

void vtkMultiTriangulationFileBuilder::SetPrecision(double precision)
{
  if (!std::isfinite(precision) || precision < 0.0)
  {
    vtkErrorMacro("The precision must be a finite number from 0, not " << precision << ".");
    return;
  }
  if (Change(this->Precision, precision))
  {
    this->Modified();
  }
}

void vtkMultiTriangulationFileBuilder::SetPartitionStrategy(vtkMTPartitionStrategy* strategy)
{
  this->Implementation->Builder->SetPartitionStrategy(strategy);
}

vtkMTPartitionStrategy* vtkMultiTriangulationFileBuilder::GetPartitionStrategy()
{
  return this->Implementation->Builder->GetPartitionStrategy();
}

void vtkMultiTriangulationFileBuilder::SetSimplifier(vtkMTSimplifier* simplifier)
{
  this->Implementation->Builder->SetSimplifier(simplifier);
}

vtkMTSimplifier* vtkMultiTriangulationFileBuilder::GetSimplifier()
{
  return this->Implementation->Builder->GetSimplifier();
}

void vtkMultiTriangulationFileBuilder::SetNumberOfThreads(int threads)
{
  this->Implementation->Builder->SetNumberOfThreads(threads);
}

int vtkMultiTriangulationFileBuilder::GetNumberOfThreads() const
{
  return this->Implementation->Builder->GetNumberOfThreads();
}

vtkMTimeType vtkMultiTriangulationFileBuilder::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->Implementation->Builder->GetMTime());
}

//------------------------------------------------------------------------------
// Memory, and what came of it
vtkTypeInt64 vtkMultiTriangulationFileBuilder::GetDefaultMemoryLimit()
{
  return static_cast<vtkTypeInt64>(vtkMTBuildWorkspace::GetMachineMemory() / 4);
}

bool vtkMultiTriangulationFileBuilder::GetWasFinished() const
{
  return this->Report->WasFinished;
}

std::string vtkMultiTriangulationFileBuilder::GetWorkFolder() const
{
  return vtkMTBuildWorkspace::GetFolder(this->OutputFileName, this->TemporaryFolder);
}

const vtkMTStageTimes& vtkMultiTriangulationFileBuilder::GetStageTimes() const
{
  return this->Implementation->Builder->GetStageTimes();
}

void vtkMultiTriangulationFileBuilder::PrintSelf(ostream& os, vtkIndent indent)
{
  const auto print = [&](const char* name, const auto& value) { os << indent << name << ": " << value << "\n"; };
  this->Superclass::PrintSelf(os, indent);
  for (const std::string& path : this->Implementation->Input.Paths)
  {
    print("FileName", path);
  }
  print("OutputFileName", this->OutputFileName);
  print("IsoValue", this->HasIsoValue() ? std::to_string(this->GetIsoValue()) : "none");
  print("GradientNormals", this->GetGradientNormals() ? "on" : "off");
  print("VerticalScale", this->GetVerticalScale());
  print("Degrees", this->GetDegrees() ? "on" : "off");
  print("KeepAllArrays", this->KeepAllArrays ? "on" : "off");
  for (const std::string& name : this->Implementation->Arrays)
  {
    print("ArrayName", name);
  }
  print("LatticeBits", this->LatticeBits);
  print("Precision", this->Precision);
  print("Compression", this->Compression);
  print("MemoryLimit", this->MemoryLimit);
  print("TemporaryFolder", this->TemporaryFolder);
  print("Resume", this->Resume ? "on" : "off");
  print("ErrorMessage", this->ErrorMessage);
  print("HasCheckpoint", this->HasCheckpoint ? "yes" : "no");
  os << indent << "Builder:\n";
  this->Implementation->Builder->PrintSelf(os, indent.GetNextIndent());
}
