// SPDX-License-Identifier: BSD-3-Clause
// Pictures of the report as files.
#ifndef MTReportImage_h
#define MTReportImage_h

#include <string>

class vtkImageData;

namespace MTReportImage
{
/// Writes a picture of three components as a small PNG, with so many levels of each component: few of them are enough
/// for lines and letters, and halve the file. Changes the picture to what is written. Throws std::runtime_error where
/// that fails.
void Write(vtkImageData* image, int levels, const std::string& path);
}

#endif
