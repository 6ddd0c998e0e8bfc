// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVolumeFormat.h"

#include "vtkMTByteSource.h"
#include "vtkMTErrorCollector.h"
#include "vtkMTTextFormat.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredPointsReader.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>

std::string vtkMTVolumeFormat::GetEnding(const std::string& path)
{
  const std::string ending = vtkMTTextFormat::GetLowerCaseEnding(path);
  return ending == "gz" ? vtkMTTextFormat::GetLowerCaseEnding(path.substr(0, path.size() - 3)) + ".gz" : ending;
}

bool vtkMTVolumeFormat::IsStructuredPoints(const std::string& path)
{
  vtkNew<vtkStructuredPointsReader> reader;
  vtkMTErrorCollector errors;
  errors.Observe(static_cast<vtkAlgorithm*>(reader.Get()));
  reader->SetFileName(path.c_str());
  return reader->IsFileStructuredPoints() != 0;
}

vtkSmartPointer<vtkAlgorithm> vtkMTVolumeFormat::MakeReader(const std::string& path, vtkMTErrorCollector& errors)
{
  const std::string ending = GetEnding(path);
  const auto named = [&path](auto reader) -> vtkSmartPointer<vtkAlgorithm>
  {
    reader->SetFileName(path.c_str());
    return reader;
  };
  if (ending == "vti")
  {
    auto reader = vtkSmartPointer<vtkXMLImageDataReader>::New();
    reader->SetReaderErrorObserver(errors.GetCommand());
    reader->SetParserErrorObserver(errors.GetCommand());
    return named(reader);
  }
  if (ending == "mhd" || ending == "mha")
  {
    return named(vtkSmartPointer<vtkMetaImageReader>::New());
  }
  if (ending == "nrrd" || ending == "nhdr")
  {
    return named(vtkSmartPointer<vtkNrrdReader>::New());
  }
  if (ending == "nii" || ending == "nii.gz")
  {
    return named(vtkSmartPointer<vtkNIFTIImageReader>::New());
  }
  return named(vtkSmartPointer<vtkStructuredPointsReader>::New());
}

bool vtkMTVolumeFormat::IsNrrd(const std::string& path)
{
  const std::string ending = GetEnding(path);
  return ending == "nrrd" || ending == "nhdr";
}

namespace
{
// The data of these lie in other files, whose sizes the header does not bound.
bool HasDetachedData(const std::string& path)
{
  const std::string ending = vtkMTVolumeFormat::GetEnding(path);
  return ending == "mhd" || ending == "nhdr";
}

// No compression that the format knows makes a sample smaller than this: deflate's best is 1032 to 1, that of LZMA,
// which .vti may have, 273 bytes in less than half a bit.
double GetMostSamplesPerByte(const std::string& path)
{
  return vtkMTVolumeFormat::GetEnding(path) == "vti" ? 8192.0 : 1100.0;
}
}

// What the header says, before memory is asked for.
bool vtkMTVolumeFormat::CheckExtent(vtkAlgorithm* reader, const std::string& path, double bytes, std::string& error)
{
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
  double samples = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = static_cast<double>(extent[2 * axis + 1]) - extent[2 * axis] + 1.0;
    if (size < 2.0)
    {
      error = "is no volume: it has " + std::to_string(static_cast<long long>(std::max(size, 0.0))) +
        " samples along axis " + std::to_string(axis) + "; two or more are needed";
      return false;
    }
    samples *= size;
  }
  if (!HasDetachedData(path) && samples > GetMostSamplesPerByte(path) * bytes)
  {
    error = "claims more samples than its bytes can hold: it is damaged";
    return false;
  }
  return true;
}

bool vtkMTVolumeFormat::UseScalars(vtkImageData* volume, std::string& error)
{
  vtkPointData* arrays = volume->GetPointData();
  for (int i = 0; !arrays->GetScalars() && i < arrays->GetNumberOfArrays(); ++i)
  {
    if (arrays->GetArray(i) && arrays->GetArray(i)->GetName())
    {
      arrays->SetActiveScalars(arrays->GetArray(i)->GetName());
    }
  }
  vtkDataArray* scalars = arrays->GetScalars();
  if (!scalars || scalars->GetNumberOfTuples() != volume->GetNumberOfPoints())
  {
    error = "has no scalars at its points; cell values must be made into point values first (vtkCellDataToPointData)";
    return false;
  }
  return true;
}

// vtkNrrdReader of VTK 9.1 never ends on a header that does not: "NRRD", lines with a colon or comments, a blank line.
bool vtkMTVolumeFormat::CheckNrrd(const vtkMTByteSource& source, std::string& error)
{
  const bool isDetached = vtkMTTextFormat::GetLowerCaseEnding(source.GetName()) == "nhdr";
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(source.GetSize(), 1 << 20)), ' ');
  if (!source.Read(0, text.size(), text.data(), error))
  {
    return false;
  }
  bool good = text.rfind("NRRD", 0) == 0;
  std::size_t line = text.find('\n');
  int number = 2;
  for (; good && line != std::string::npos; ++number)
  {
    const std::size_t end = text.find('\n', line + 1);
    const std::string field = text.substr(line + 1, (end == std::string::npos ? text.size() : end) - line - 1);
    const bool isLast = field.empty() || field == "\r";
    if (isLast && (end != std::string::npos || isDetached))
    {
      return true;
    }
    good = end != std::string::npos && (field[0] == '#' || field.find(':') != std::string::npos);
    line = end;
  }
  error = "line " + std::to_string(number - 1) + ": is no line of a NRRD header, or the header does not end";
  return false;
}
