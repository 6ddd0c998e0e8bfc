// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVolumeReader.h"

#include "vtkMTFileByteSource.h"
#include "vtkMTIsosurfaceStream.h"
#include "vtkMTVolumeFormat.h"
#include "vtkMTVolumeHeader.h"
#include "vtkMTVolumeImage.h"
#include "vtkMTVolumeSamples.h"

#include "vtkPolyData.h"

#include <cmath>
#include <exception>

namespace
{
std::unique_ptr<vtkMTVolumeSlabs> OpenVolume(const std::string& path, double bytes, std::string& error)
{
  const std::string ending = vtkMTVolumeFormat::GetEnding(path);
  if (ending == "vti" || ending == "vtk")
  {
    auto image = std::make_unique<vtkMTVolumeImage>();
    return image->Open(path, bytes, error) ? std::move(image) : nullptr;
  }
  vtkMTVolumeHeader header;
  auto samples = std::make_unique<vtkMTVolumeSamples>();
  return header.Read(path, error) && samples->Open(header, error) ? std::move(samples) : nullptr;
}

// On failure error names the file; nothing is thrown.
template <typename Body>
bool Guard(const std::string& path, double value, std::string& error, Body&& body)
{
  const auto bytes = vtkMTFileByteSource::Open(path, error);
  if (!bytes)
  {
    return false;
  }
  std::string reason;
  try
  {
    if (!vtkMTVolumeReader::CanRead(path))
    {
      reason = "is no volume; .vti, .mhd, .mha, .nrrd, .nhdr, .nii, .nii.gz, .hdr with .img, and .vtk with structured "
               "points are read";
    }
    else if (!std::isfinite(value))
    {
      reason = "the isovalue is no finite number";
    }
    else
    {
      std::unique_ptr<vtkMTVolumeSlabs> volume = OpenVolume(path, static_cast<double>(bytes->GetSize()), reason);
      if (volume && body(std::move(volume), reason))
      {
        return true;
      }
    }
  }
  catch (const std::exception& exception) // no memory
  {
    reason = exception.what();
  }
  error = path + ": " + reason;
  return false;
}
}

bool vtkMTVolumeReader::CanRead(const std::string& path)
{
  const std::string ending = vtkMTVolumeFormat::GetEnding(path);
  return ending == "vti" || vtkMTVolumeHeader::CanRead(path) ||
    (ending == "vtk" && vtkMTVolumeFormat::IsStructuredPoints(path));
}

std::vector<std::string> vtkMTVolumeReader::FindOtherFiles(const std::string& path)
{
  std::vector<std::string> others;
  vtkMTVolumeHeader header;
  std::string error;
  if (!vtkMTVolumeHeader::CanRead(path) || !header.Read(path, error))
  {
    return others;
  }
  header.Files.insert(header.Files.begin(), { header.Path });
  for (const vtkMTVolumeHeader::File& file : header.Files)
  {
    if (file.Path != path)
    {
      others.push_back(file.Path);
    }
  }
  return others;
}

bool vtkMTVolumeReader::ReadIsosurface(
  const std::string& path, double value, bool gradientNormals, vtkPolyData* output, std::string& error, Facts* facts)
{
  output->Initialize();
  const bool good = Guard(path, value, error,
    [&](std::unique_ptr<vtkMTVolumeSlabs> volume, std::string& reason)
    {
      Facts found{ volume->GetPlace().World, volume->GetReport() };
      if (!vtkMTIsosurfaceStream::Make(*volume, value, gradientNormals, output, reason))
      {
        return false;
      }
      if (volume->GetPlace().IsLeftHanded())
      {
        found.Report["turned_triangles"] = output->GetNumberOfPolys();
      }
      if (facts)
      {
        *facts = found;
      }
      return true;
    });
  if (!good)
  {
    output->Initialize();
  }
  return good;
}

std::unique_ptr<vtkMTTriangleStream> vtkMTVolumeReader::StreamIsosurface(
  const std::string& path, double value, std::string& error, std::uint64_t samplesPerSlab, vtkMTWorldFrame* frame)
{
  std::unique_ptr<vtkMTTriangleStream> stream;
  Guard(path, value, error,
    [&](std::unique_ptr<vtkMTVolumeSlabs> volume, std::string& reason)
    {
      if (frame)
      {
        *frame = volume->GetPlace().World;
      }
      stream = vtkMTIsosurfaceStream::Open(
        std::move(volume), value, reason, samplesPerSlab > 0 ? samplesPerSlab : vtkMTIsosurfaceStream::SamplesPerSlab);
      return stream != nullptr;
    });
  return stream;
}
