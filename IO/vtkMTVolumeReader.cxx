// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVolumeReader.h"

#include "vtkMTErrorCollector.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTTextFormat.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredPointsReader.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cmath>
#include <exception>

namespace
{
// No compression that these formats know makes a sample smaller than this: deflate's best is 1032 to 1.
constexpr double MostSamplesPerByte = 1100.0;

// .nii.gz ends in two parts.
std::string GetEnding(const std::string& path)
{
  const std::string ending = vtkMTTextFormat::GetLowerCaseEnding(path);
  return ending == "gz" ? vtkMTTextFormat::GetLowerCaseEnding(path.substr(0, path.size() - 3)) + ".gz" : ending;
}

bool IsStructuredPoints(const std::string& path)
{
  vtkNew<vtkStructuredPointsReader> reader;
  vtkMTErrorCollector errors;
  errors.Observe(static_cast<vtkAlgorithm*>(reader.Get()));
  reader->SetFileName(path.c_str());
  return reader->IsFileStructuredPoints() != 0;
}

vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path, vtkMTErrorCollector& errors)
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

// The data of these lie in other files, whose sizes the header does not bound.
bool HasDetachedData(const std::string& path)
{
  const std::string ending = GetEnding(path);
  return ending == "mhd" || ending == "nhdr";
}

// What the header says, before memory is asked for.
bool CheckExtent(vtkAlgorithm* reader, const std::string& path, double bytes, std::string& error)
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
  if (!HasDetachedData(path) && samples > MostSamplesPerByte * bytes)
  {
    error = "claims more samples than its bytes can hold: it is damaged";
    return false;
  }
  return true;
}

bool UseScalars(vtkImageData* volume, std::string& error)
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
bool CheckNrrd(const vtkMTByteSource& source, std::string& error)
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

bool ReadUnnamed(const std::string& path, double bytes, vtkImageData* output, std::string& error)
{
  vtkMTErrorCollector errors;
  errors.ObserveOutputWindow(true); // several of these readers only warn of files that are cut off
  const vtkSmartPointer<vtkAlgorithm> reader = MakeReader(path, errors);
  errors.Observe(reader.Get());
  reader->UpdateInformation();
  if (errors.HasErrors())
  {
    error = errors.GetMessage();
    return false;
  }
  if (!CheckExtent(reader, path, bytes, error))
  {
    return false;
  }
  reader->Update();
  vtkImageData* volume = vtkImageData::SafeDownCast(reader->GetOutputDataObject(0));
  if (errors.HasErrors() || !volume || volume->GetNumberOfPoints() == 0)
  {
    error = errors.HasErrors() ? errors.GetMessage() : "no volume could be read";
    return false;
  }
  output->ShallowCopy(volume);
  return UseScalars(output, error);
}

bool Contour(vtkImageData* volume, double value, bool gradientNormals, vtkPolyData* output, std::string& error)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(volume);
  contour->SetValue(0, value);
  contour->SetComputeNormals(gradientNormals);
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  output->ShallowCopy(contour->GetOutput());
  if (output->GetNumberOfPolys() == 0)
  {
    double range[2];
    volume->GetPointData()->GetScalars()->GetRange(range, 0);
    error = "has no isosurface at " + std::to_string(value) + ": its values are between " + std::to_string(range[0]) +
      " and " + std::to_string(range[1]);
    return false;
  }
  return true;
}

// Whatever happens, output is empty on failure, error names the file, and nothing is thrown.
template <typename Output, typename Body>
bool Guard(const std::string& path, Output* output, std::string& error, Body&& body)
{
  output->Initialize();
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  if (!bytes)
  {
    return false;
  }
  std::string reason;
  try
  {
    if (body(*bytes, reason))
    {
      return true;
    }
  }
  catch (const std::exception& exception) // no memory
  {
    reason = exception.what();
  }
  output->Initialize();
  error = path + ": " + reason;
  return false;
}
}

bool vtkMTVolumeReader::CanRead(const std::string& path)
{
  static const char* const endings[] = { "vti", "mhd", "mha", "nrrd", "nhdr", "nii", "nii.gz" };
  const std::string ending = GetEnding(path);
  return std::find(std::begin(endings), std::end(endings), ending) != std::end(endings) ||
    (ending == "vtk" && IsStructuredPoints(path));
}

bool vtkMTVolumeReader::ReadVolume(const std::string& path, vtkImageData* output, std::string& error)
{
  return Guard(path, output, error,
    [&](const vtkMTByteSource& bytes, std::string& reason)
    {
      if (!CanRead(path))
      {
        reason = "is no volume; .vti, .mhd, .mha, .nrrd, .nhdr, .nii, .nii.gz and .vtk with structured points are read";
        return false;
      }
      const std::string ending = GetEnding(path);
      const bool isNrrd = ending == "nrrd" || ending == "nhdr";
      return (!isNrrd || CheckNrrd(bytes, reason)) &&
        ReadUnnamed(path, static_cast<double>(bytes.GetSize()), output, reason);
    });
}

bool vtkMTVolumeReader::ReadIsosurface(
  const std::string& path, double value, bool gradientNormals, vtkPolyData* output, std::string& error)
{
  output->Initialize();
  vtkNew<vtkImageData> volume;
  if (!ReadVolume(path, volume, error))
  {
    return false;
  }
  return Guard(path, output, error,
    [&](const vtkMTByteSource&, std::string& reason)
    {
      if (!std::isfinite(value))
      {
        reason = "the isovalue is no finite number";
        return false;
      }
      return Contour(volume, value, gradientNormals, output, reason);
    });
}
