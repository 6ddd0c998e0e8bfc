// SPDX-License-Identifier: BSD-3-Clause
// The formats of volumes that VTK's readers read, and what is checked before these are believed. Not installed.
#ifndef vtkMTVolumeFormat_h
#define vtkMTVolumeFormat_h

#include "vtkSmartPointer.h"

#include <string>

class vtkAlgorithm;
class vtkImageData;
class vtkMTErrorCollector;

namespace vtkMTVolumeFormat
{
/// In lower case, without the first dot; .nii.gz ends in two parts.
std::string GetEnding(const std::string& path);
/// Whether the legacy file has structured points in it.
bool IsStructuredPoints(const std::string& path);

/// The reader for the ending; errors collects what its parts report.
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path, vtkMTErrorCollector& errors);

///@{
/// False with the reason in error: an extent that is no volume, or that the file's bytes cannot hold, before memory is
/// asked for; a volume without scalars at its points, which are made the active ones otherwise.
bool CheckExtent(vtkAlgorithm* reader, double bytes, std::string& error);
bool UseScalars(vtkImageData* volume, std::string& error);
///@}
}

#endif
