// SPDX-License-Identifier: BSD-3-Clause
// A section of a patch: the decoders alone, behind all checks of file and directory.
#include "vtkMTDecodeScratch.h"
#include "vtkMTPatchCodec.h"

#include <algorithm>
#include <cstring>

namespace
{
constexpr std::size_t HeadSize = 16;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < HeadSize)
  {
    return 0;
  }
  std::uint16_t counts[4];
  std::memcpy(counts, data + 1, sizeof(counts));
  vtkMTArc arc;
  arc.Points = counts[0];
  arc.Wedges = counts[1];
  arc.Triangles = counts[2];
  arc.SharedPoints = std::min(counts[3], counts[0]);
  vtkMTArrayInfo array;
  array.Type = data[9] % 18;
  array.Components = 1 + data[10] % 9;
  array.Association = data[11] % 2 ? vtkMTArrayInfo::Cell : vtkMTArrayInfo::Point;
  array.Role = data[12] % 2 ? vtkMTArrayInfo::MadeNormals : vtkMTArrayInfo::Plain;
  vtkMTFileFormat::SectionRecord section{};
  section.Codec = data[0] % 3;
  // The geometry, then the array, both copied so that reads past what may be read are seen.
  std::uint16_t geometrySize = 0;
  std::memcpy(&geometrySize, data + 13, sizeof(geometrySize));
  const unsigned char* const end = data + size;
  const unsigned char* const middle = data + HeadSize + std::min<std::size_t>(geometrySize, size - HeadSize);
  std::vector<unsigned char> geometry(data + HeadSize, middle);
  section.StoredSize = static_cast<std::uint32_t>(geometry.size());
  geometry.resize(geometry.size() + vtkMTPatchCodec::Slack, 0xff);
  std::vector<unsigned char> values(middle, end);
  const auto valuesSize = static_cast<std::uint32_t>(values.size());
  values.resize(values.size() + vtkMTPatchCodec::Slack, 0xff);
  std::string error;
  vtkMTPatch patch;
  vtkMTDecodeScratch traversal;
  if (!vtkMTPatchCodec::DecodeGeometry(section, geometry.data(), arc, traversal, patch, error))
  {
    patch = vtkMTPatch();
  }
  vtkMTColumn column;
  if (array.GetTupleSize() > 0)
  {
    section.StoredSize = valuesSize;
    section.Codec = data[0] / 4 % 4 == 3 ? static_cast<std::uint8_t>(vtkMTFileFormat::Expected) : section.Codec;
    vtkMTPatchCodec::DecodeColumn(section, values.data(), arc, array, patch, traversal, column, error);
  }
  return 0;
}
