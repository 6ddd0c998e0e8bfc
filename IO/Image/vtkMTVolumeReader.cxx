// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVolumeReader.h"

#include "vtkMTErrorCollector.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTIsosurfaceStream.h"
#include "vtkMTTextFormat.h"
#include "vtkMTVolumeFormat.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkExtractVOI.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkInformation.h"
#include "vtkMetaImageReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <filesystem>
#include <string_view>

namespace
{
using namespace vtkMTVolumeFormat;

bool ReadUnnamed(const std::string& path, double bytes, vtkImageData* output, std::string& error)
{
  vtkMTErrorCollector errors;
  errors.ObserveOutputWindow(true); // several of these readers only warn of files that are truncated
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

class HeldVolume : public vtkMTVolumeSlabs
{
public:
  vtkNew<vtkImageData> Image;

  std::array<int, 6> GetExtent() const override
  {
    std::array<int, 6> extent;
    this->Image->GetExtent(extent.data());
    return extent;
  }
  bool Read(int first, int last, vtkImageData* slab, std::string&) override
  {
    const std::array<int, 6> extent = this->GetExtent();
    vtkNew<vtkExtractVOI> extract;
    extract->SetInputData(this->Image);
    extract->SetVOI(extent[0], extent[1], extent[2], extent[3], first, last);
    extract->Update();
    slab->ShallowCopy(extract->GetOutput());
    return true;
  }
};

// Of formats whose readers read as much as they are asked for.
class VolumeFile : public vtkMTVolumeSlabs
{
public:
  bool Open(const vtkSmartPointer<vtkAlgorithm>& reader, const std::string& path, double bytes, std::string& error)
  {
    this->Reader = reader;
    this->Errors.Observe(this->Reader.Get());
    this->Reader->UpdateInformation();
    if (this->Errors.HasErrors())
    {
      error = this->Errors.GetMessage();
      return false;
    }
    return CheckExtent(this->Reader, path, bytes, error);
  }

  std::array<int, 6> GetExtent() const override
  {
    std::array<int, 6> extent;
    this->Reader->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data());
    return extent;
  }

  bool Read(int first, int last, vtkImageData* slab, std::string& error) override
  {
    std::array<int, 6> extent = this->GetExtent();
    extent[4] = first;
    extent[5] = last;
    vtkMTErrorCollector warnings;
    warnings.ObserveOutputWindow(true); // of a file that is truncated
    this->Reader->UpdateExtent(extent.data());
    vtkImageData* image = vtkImageData::SafeDownCast(this->Reader->GetOutputDataObject(0));
    const bool isBad = this->Errors.HasErrors() || warnings.HasErrors();
    if (isBad || !image || !std::equal(extent.begin(), extent.end(), image->GetExtent()))
    {
      error = this->Errors.HasErrors() ? this->Errors.GetMessage()
                                       : (isBad ? warnings.GetMessage() : "slices could not be read by themselves");
      return false;
    }
    slab->ShallowCopy(image);
    return UseScalars(slab, error);
  }

private:
  vtkMTErrorCollector Errors;
  vtkSmartPointer<vtkAlgorithm> Reader;
};

// The value of a MetaImage header's field, in its own case; empty where there is none.
std::string GetMetaField(const std::string& head, const std::string& name)
{
  for (std::size_t line = 0; line < head.size(); line = std::min(head.find('\n', line), head.size() - 1) + 1)
  {
    const std::string field = head.substr(line, std::min(head.find('\n', line), head.size()) - line);
    const std::size_t sign = field.find('=');
    std::string_view key = std::string_view(field).substr(0, sign);
    std::string_view value = std::string_view(field).substr(sign == std::string::npos ? field.size() : sign + 1);
    if (vtkMTTextFormat::NextToken(key) == name)
    {
      return std::string(vtkMTTextFormat::NextToken(value));
    }
  }
  return "";
}

// A reader of the samples alone: vtkMetaImageReader of VTK 9.1 gives other slices than it is asked for. Null where they
// are not simply one behind the other, or do not fill their file to its end.
vtkSmartPointer<vtkAlgorithm> MakeMetaReader(
  const std::string& path, const std::string& head, std::uint64_t fileSize, vtkMTErrorCollector& errors)
{
  const std::string data = GetMetaField(head, "ElementDataFile");
  const auto is = [&head](const char* name, const char* value)
  { return vtkMTTextFormat::ToLower(GetMetaField(head, name)) == value; };
  const bool isLocal = vtkMTTextFormat::ToLower(data) == "local";
  if (!is("BinaryData", "true") || is("CompressedData", "true") || data.empty() || data == "LIST" ||
    data.find('%') != std::string::npos || !GetMetaField(head, "HeaderSize").empty())
  {
    return nullptr;
  }
  const std::string name =
    isLocal ? path : (std::filesystem::path(path).parent_path() / std::filesystem::path(data)).string();
  std::error_code code;
  const std::uint64_t size = isLocal ? fileSize : std::filesystem::file_size(name, code);
  vtkNew<vtkMetaImageReader> meta;
  errors.Observe(static_cast<vtkAlgorithm*>(meta.Get()));
  meta->SetFileName(path.c_str());
  meta->UpdateInformation();
  const int* extent = meta->GetDataExtent();
  std::uint64_t bytes = static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(meta->GetDataScalarType()));
  for (int axis = 0; axis < 3; ++axis)
  {
    bytes *= static_cast<std::uint64_t>(std::max(extent[2 * axis + 1] - extent[2 * axis] + 1, 0));
  }
  if (code || errors.HasErrors() || meta->GetNumberOfScalarComponents() != 1 || bytes == 0 || size < bytes ||
    (!isLocal && size != bytes))
  {
    return nullptr;
  }
  auto reader = vtkSmartPointer<vtkImageReader2>::New();
  reader->SetFileName(name.c_str());
  reader->SetHeaderSize(size - bytes);
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(meta->GetDataExtent());
  reader->SetDataOrigin(meta->GetDataOrigin());
  reader->SetDataSpacing(meta->GetDataSpacing());
  reader->SetDataScalarType(meta->GetDataScalarType());
  reader->SetNumberOfScalarComponents(1);
  reader->FileLowerLeftOn();
  const bool isBig = is("BinaryDataByteOrderMSB", "true") || is("ElementByteOrderMSB", "true");
  isBig ? reader->SetDataByteOrderToBigEndian() : reader->SetDataByteOrderToLittleEndian();
  return reader;
}

// A reader that can be asked for some slices of samples that are stored as they are; null where there is none.
vtkSmartPointer<vtkAlgorithm> MakeSlabReader(
  const std::string& path, const vtkMTByteSource& bytes, vtkMTErrorCollector& errors)
{
  const std::string ending = GetEnding(path);
  const bool isMeta = ending == "mhd" || ending == "mha";
  std::string head(static_cast<std::size_t>(std::min<std::uint64_t>(bytes.GetSize(), 1 << 16)), ' ');
  std::string error;
  if ((!isMeta && !IsNrrd(path)) || !bytes.Read(0, head.size(), head.data(), error))
  {
    return nullptr;
  }
  if (isMeta)
  {
    return MakeMetaReader(path, head, bytes.GetSize(), errors);
  }
  const bool isRaw = vtkMTTextFormat::ToLower(head).find("\nencoding: raw") != std::string::npos;
  return isRaw && CheckNrrd(bytes, error) ? MakeReader(path, errors) : nullptr;
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
      return (!IsNrrd(path) || CheckNrrd(bytes, reason)) &&
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

std::unique_ptr<vtkMTTriangleStream> vtkMTVolumeReader::StreamIsosurface(
  const std::string& path, double value, std::string& error, std::uint64_t samplesPerSlab)
{
  std::unique_ptr<vtkMTTriangleStream> stream;
  auto held = std::make_unique<HeldVolume>();
  const auto open = [&](std::unique_ptr<vtkMTVolumeSlabs> slabs, std::string& reason)
  {
    if (!std::isfinite(value))
    {
      reason = "the isovalue is no finite number";
      return false;
    }
    stream = vtkMTIsosurfaceStream::Open(
      std::move(slabs), value, reason, samplesPerSlab > 0 ? samplesPerSlab : vtkMTIsosurfaceStream::SamplesPerSlab);
    return stream != nullptr;
  };
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  std::string reason;
  vtkMTErrorCollector errors;
  const vtkSmartPointer<vtkAlgorithm> reader = bytes ? MakeSlabReader(path, *bytes, errors) : nullptr;
  if (reader)
  {
    auto file = std::make_unique<VolumeFile>();
    if (!file->Open(reader, path, static_cast<double>(bytes->GetSize()), reason) || !open(std::move(file), reason))
    {
      error = path + ": " + reason;
    }
    return stream;
  }
  vtkImageData* image = held->Image;
  if (!ReadVolume(path, image, error))
  {
    return nullptr;
  }
  if (!open(std::move(held), reason))
  {
    error = path + ": " + reason;
  }
  return stream;
}
