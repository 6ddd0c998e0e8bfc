// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVolumeImage.h"

#include "vtkMTErrorCollector.h"
#include "vtkMTVolumeFormat.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

vtkMTVolumeImage::vtkMTVolumeImage() = default;
vtkMTVolumeImage::~vtkMTVolumeImage() = default;

bool vtkMTVolumeImage::Open(const std::string& path, double bytes, std::string& error)
{
  vtkMTErrorCollector errors;
  errors.ObserveOutputWindow(true); // these readers only warn of some files that are truncated
  const vtkSmartPointer<vtkAlgorithm> reader = vtkMTVolumeFormat::MakeReader(path, errors);
  errors.Observe(reader.Get());
  reader->UpdateInformation();
  if (errors.HasErrors())
  {
    error = errors.GetMessage();
    return false;
  }
  if (!vtkMTVolumeFormat::CheckExtent(reader, bytes, error))
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
  this->Image->ShallowCopy(volume);
  return vtkMTVolumeFormat::UseScalars(this->Image, error) && this->FindPlace(error);
}

bool vtkMTVolumeImage::FindPlace(std::string& error)
{
  this->Image->GetExtent(this->Extent.data());
  const vtkMatrix4x4* matrix = this->Image->GetIndexToPhysicalMatrix();
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Place.Axes[axis][i] = matrix->GetElement(static_cast<int>(i), static_cast<int>(axis));
    }
    this->Place.Origin[i] = matrix->GetElement(static_cast<int>(i), 3);
  }
  vtkPointData* arrays = this->Image->GetPointData();
  vtkDataArray* scalars = arrays->GetScalars();
  if (scalars->GetNumberOfComponents() > 1)
  {
    this->Report["volume_ignored_components"] = scalars->GetNumberOfComponents() - 1;
  }
  if (scalars->GetDataType() == VTK_BIT) // slabs are parts of this memory
  {
    vtkNew<vtkUnsignedCharArray> octets;
    octets->DeepCopy(scalars);
    arrays->SetScalars(octets);
  }
  error = "its spacing or its direction spans no space: an axis is 0, not finite, or in a plane with the others";
  return this->Place.IsSound();
}

bool vtkMTVolumeImage::Read(int first, int last, vtkImageData* slab, std::string&)
{
  vtkDataArray* scalars = this->Image->GetPointData()->GetScalars();
  const vtkIdType slice = vtkIdType(this->Extent[1] - this->Extent[0] + 1) * (this->Extent[3] - this->Extent[2] + 1) *
    scalars->GetNumberOfComponents();
  const auto part = vtkSmartPointer<vtkDataArray>::Take(scalars->NewInstance());
  part->SetNumberOfComponents(scalars->GetNumberOfComponents());
  part->SetVoidArray(
    scalars->GetVoidPointer((first - this->Extent[4]) * slice), vtkIdType(last - first + 1) * slice, 1);
  slab->Initialize();
  slab->SetExtent(this->Extent[0], this->Extent[1], this->Extent[2], this->Extent[3], first, last);
  slab->GetPointData()->SetScalars(part);
  return true;
}
