// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVolumeFormat.h"

#include "vtkMTErrorCollector.h"
#include "vtkMTTextFormat.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
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
  return named(vtkSmartPointer<vtkStructuredPointsReader>::New());
}

namespace
{
// No compression that the format knows makes a sample smaller than this: LZMA, which .vti may have, packs 273 bytes
// into less than half a bit.
constexpr double MostSamplesPerByte = 8192.0;
}

// What the header says, before memory is asked for.
bool vtkMTVolumeFormat::CheckExtent(vtkAlgorithm* reader, double bytes, std::string& error)
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
  if (samples > MostSamplesPerByte * bytes)
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
