// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportImage.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <stdexcept>

void MTReportImage::Write(vtkImageData* image, int levels, const std::string& path)
{
  const double step = 255.0 / (levels - 1);
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
  {
    pixels->SetValue(i, static_cast<unsigned char>(std::lround(std::round(pixels->GetValue(i) / step) * step)));
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->SetCompressionLevel(9);
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw std::runtime_error(path + ": cannot be written");
  }
}
