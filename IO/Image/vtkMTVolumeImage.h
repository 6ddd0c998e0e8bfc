// SPDX-License-Identifier: BSD-3-Clause
// Slabs of a volume that one of VTK's readers read whole: .vti, and .vtk with structured points. Not installed.
#ifndef vtkMTVolumeImage_h
#define vtkMTVolumeImage_h

#include "vtkMTVolumeSlabs.h"

#include "vtkNew.h"

class vtkMTVolumeImage : public vtkMTVolumeSlabs
{
public:
  vtkMTVolumeImage();
  ~vtkMTVolumeImage() override;

  /// bytes: the size of the file. False with a reason that does not name the file.
  bool Open(const std::string& path, double bytes, std::string& error);

  bool Read(int first, int last, vtkImageData* slab, std::string& error) override;

private:
  bool FindPlace(std::string& error);

  vtkNew<vtkImageData> Image;
};

#endif
