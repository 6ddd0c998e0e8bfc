// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyVolumeInput.h"

#include "vtkMTVerifyVolumeBytes.h"
#include "vtkMTVerifyVolumeMetaImage.h"
#include "vtkMTVerifyVolumeNifti.h"
#include "vtkMTVerifyVolumeNrrd.h"
#include "vtkMTVerifyVolumeSamples.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStructuredPoints.h"
#include "vtkStructuredPointsReader.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

using vtkMTVerifyVolumeBytes::EndsWith;

namespace
{
double GetDeterminant(const std::array<double, 16>& m)
{
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) + m[2] * (m[4] * m[9] - m[5] * m[8]);
}

/// Keeps the first message of a reader that would else go to VTK's window.
void KeepMessage(vtkObject*, unsigned long, void* clientData, void* callData)
{
  auto& message = *static_cast<std::string*>(clientData);
  if (message.empty() && callData)
  {
    message = static_cast<const char*>(callData);
  }
}

/// The map of VTK's image data for indices that count from 0, which its extent need not.
void SetPlace(vtkImageData* image, vtkMTVerifyVolumeHeader& header)
{
  const int* extent = image->GetExtent();
  const double* spacing = image->GetSpacing();
  double first[3];
  std::copy_n(image->GetOrigin(), 3, first);
  for (int axis = 0; axis < 3; ++axis)
  {
    double step[3];
    for (int row = 0; row < 3; ++row)
    {
      step[row] = image->GetDirectionMatrix()->GetElement(row, axis) * spacing[axis];
      first[row] += step[row] * extent[2 * axis];
    }
    header.SetAxis(axis, step[0], step[1], step[2]);
  }
  header.SetOrigin(first[0], first[1], first[2]);
}

void ObserveParser(vtkXMLImageDataReader* reader, vtkCommand* observer)
{
  reader->SetParserErrorObserver(observer);
}

void ObserveParser(vtkStructuredPointsReader*, vtkCommand*)
{
}

template <typename Reader>
vtkSmartPointer<vtkDataArray> ReadByVtk(
  Reader* reader, const std::string& path, vtkMTVerifyVolumeHeader& header, std::string& error)
{
  vtkNew<vtkCallbackCommand> observer;
  std::string message;
  observer->SetCallback(KeepMessage);
  observer->SetClientData(&message);
  header.Facts.Reader = reader->GetClassName();
  reader->SetFileName(path.c_str());
  reader->AddObserver(vtkCommand::ErrorEvent, observer);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  ObserveParser(reader, observer);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || !message.empty() || !image || image->GetNumberOfPoints() == 0)
  {
    // The message is behind the line that names VTK's source file.
    const std::size_t line = message.find('\n');
    error = message.empty() ? "VTK's reader cannot read it"
                            : vtkMTVerifyVolumeBytes::Trim(line == std::string::npos ? message : message.substr(line));
    return nullptr;
  }
  const int* sizes = image->GetDimensions();
  if (!header.SetSizes({ sizes[0], sizes[1], sizes[2] }, error))
  {
    return nullptr;
  }
  SetPlace(image, header);
  vtkPointData* data = image->GetPointData();
  vtkDataArray* scalars = data->GetScalars() ? data->GetScalars() : data->GetArray(0);
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    header.Refuse("A volume without one value for each point", error);
    return nullptr;
  }
  return scalars;
}

vtkSmartPointer<vtkDataArray> ReadSamples(const std::string& path, vtkMTVerifyVolumeHeader& header, std::string& error)
{
  if (EndsWith(path, ".vti"))
  {
    vtkNew<vtkXMLImageDataReader> reader;
    return ReadByVtk(reader.Get(), path, header, error);
  }
  if (EndsWith(path, ".vtk"))
  {
    vtkNew<vtkStructuredPointsReader> reader;
    return ReadByVtk(reader.Get(), path, header, error);
  }
  bool isParsed = false;
  if (EndsWith(path, ".mhd") || EndsWith(path, ".mha"))
  {
    isParsed = vtkMTVerifyVolumeMetaImage(path, header).Parse(error);
  }
  else if (EndsWith(path, ".nrrd") || EndsWith(path, ".nhdr"))
  {
    isParsed = vtkMTVerifyVolumeNrrd(path, header).Parse(error);
  }
  else if (vtkMTVerifyVolumeInput::CanRead(path))
  {
    isParsed = vtkMTVerifyVolumeNifti(path, header).Parse(error);
  }
  else
  {
    header.Refuse("This kind of file", error);
  }
  return isParsed ? vtkMTVerifyVolumeSamples(header).Read(error) : nullptr;
}

void SetRange(vtkDataArray* samples, std::array<double, 2>& range)
{
  range = { std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() };
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
  {
    const double value = samples->GetComponent(i, 0);
    range[0] = std::min(range[0], std::isnan(value) ? range[0] : value);
    range[1] = std::max(range[1], std::isnan(value) ? range[1] : value);
  }
}

/**
 * Flying edges subtract samples in their own type, where a difference of unsigned int wraps around and one of int may
 * overflow (VTK 9.1): such samples become double.
 */
vtkSmartPointer<vtkDataArray> ToSafeType(vtkDataArray* samples)
{
  if (samples->GetDataTypeSize() < 4 || samples->GetDataType() == VTK_FLOAT || samples->GetDataType() == VTK_DOUBLE)
  {
    return samples;
  }
  vtkSmartPointer<vtkDoubleArray> safe = vtkSmartPointer<vtkDoubleArray>::New();
  safe->DeepCopy(samples);
  return safe;
}

/// The contour in index space: where samples lie at whole numbers.
void Contour(vtkDataArray* samples, const std::array<int, 3>& sizes, double isoValue, vtkPolyData* surface)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(sizes.data());
  image->GetPointData()->SetScalars(ToSafeType(samples));
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, isoValue);
  contour->ComputeNormalsOff();
  contour->ComputeGradientsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  surface->Initialize();
  surface->CopyStructure(contour->GetOutput());
}

void MapPoints(const std::array<double, 16>& map, vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3], y[3];
    surface->GetPoint(i, x);
    for (std::size_t row = 0; row < 3; ++row)
    {
      y[row] = map[4 * row] * x[0] + map[4 * row + 1] * x[1] + map[4 * row + 2] * x[2] + map[4 * row + 3];
    }
    points->SetPoint(i, y);
  }
  surface->SetPoints(points);
}

/// Flying edges' triangles are counterclockwise about normals to lower values; a left-handed map turns that.
void SetTriangles(bool isReversed, vtkPolyData* surface)
{
  vtkNew<vtkCellArray> triangles;
  vtkCellArray* contour = surface->GetPolys();
  triangles->AllocateExact(contour->GetNumberOfCells(), 3 * contour->GetNumberOfCells());
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < contour->GetNumberOfCells(); ++i)
  {
    contour->GetCellAtId(i, corners);
    vtkIdType ids[3] = { corners->GetId(0), corners->GetId(1), corners->GetId(2) };
    if (isReversed)
    {
      std::swap(ids[1], ids[2]);
    }
    triangles->InsertNextCell(3, ids);
  }
  surface->SetPolys(triangles);
}
}

bool vtkMTVerifyVolumeInput::CanRead(const std::string& path)
{
  const char* const endings[] = { ".vti", ".vtk", ".mhd", ".mha", ".nrrd", ".nhdr", ".nii", ".nii.gz", ".hdr",
    ".hdr.gz", ".img", ".img.gz" };
  return std::any_of(
    std::begin(endings), std::end(endings), [&](const char* ending) { return EndsWith(path, ending); });
}

bool vtkMTVerifyVolumeInput::Read(
  const std::string& path, const Options& options, vtkPolyData* surface, std::string& error)
{
  Facts facts;
  return Read(path, options, surface, facts, error);
}

bool vtkMTVerifyVolumeInput::Read(
  const std::string& path, const Options& options, vtkPolyData* surface, Facts& facts, std::string& error)
{
  vtkMTVerifyVolumeHeader header;
  vtkSmartPointer<vtkDataArray> samples;
  error.clear();
  try
  {
    samples = ReadSamples(path, header, error);
    facts = header.Facts;
    if (samples && std::isnan(options.IsoValue))
    {
      error = "the isosurface's value is NaN";
    }
    const double determinant = GetDeterminant(facts.IndexToWorld);
    if (samples && !(std::abs(determinant) > 0.0 && std::isfinite(determinant)))
    {
      error = "the map from indices to the world has no inverse";
    }
    if (samples && error.empty())
    {
      facts.IsLeftHanded = determinant < 0.0;
      SetRange(samples, facts.Range);
      Contour(samples, facts.Dimensions, options.IsoValue, surface);
      MapPoints(facts.IndexToWorld, surface);
      SetTriangles(facts.IsLeftHanded, surface);
      return true;
    }
  }
  catch (const std::exception& exception)
  {
    error = exception.what();
  }
  // The file's name once, also where the reason is about a file of samples beside it.
  error = error.find(path) == std::string::npos ? path + ": " + error : error;
  return false;
}
