// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfMeshopt.h"

#ifdef MT_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

using namespace vtkMTGltfJson;

namespace
{
#ifdef MT_HAS_MESHOPTIMIZER
// A byte stands for at most so many: two bits for 16 zero bytes.
constexpr std::uint64_t LargestRatio = 64;

struct Layout
{
  std::string Mode;
  std::string Filter;
  std::size_t Count;
  std::size_t Stride;
};

void Check(const Layout& layout, std::uint64_t compressed, std::uint64_t length, const std::string& where)
{
  const bool isVertices = layout.Mode == "ATTRIBUTES";
  const bool isIndices = layout.Mode == "TRIANGLES" || layout.Mode == "INDICES";
  if (!isVertices && !isIndices)
  {
    Fail(where, "mode \"" + layout.Mode + "\" is not known");
  }
  const std::uint64_t stride = layout.Stride;
  if (isVertices ? stride == 0 || stride > 256 || stride % 4 != 0 : stride != 2 && stride != 4)
  {
    Fail(where, "byteStride " + std::to_string(stride) + " is impossible");
  }
  if (layout.Count > length / stride || (layout.Mode == "TRIANGLES" && layout.Count % 3 != 0))
  {
    Fail(where, "count " + std::to_string(layout.Count) + " is impossible");
  }
  if (layout.Count * stride / LargestRatio > compressed)
  {
    Fail(where, "has fewer bytes than " + std::to_string(layout.Count) + " elements need");
  }
  const bool isRight = layout.Filter == "NONE" ||
    (isVertices &&
      ((layout.Filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) ||
        (layout.Filter == "QUATERNION" && stride == 8) || layout.Filter == "EXPONENTIAL"));
  if (!isRight)
  {
    Fail(where, "filter \"" + layout.Filter + "\" is not known, or not possible with these elements");
  }
}

bool DecodeMode(const Layout& layout, const std::vector<unsigned char>& from, unsigned char* to)
{
  if (layout.Mode == "ATTRIBUTES")
  {
    return meshopt_decodeVertexBuffer(to, layout.Count, layout.Stride, from.data(), from.size()) == 0;
  }
  if (layout.Mode == "TRIANGLES")
  {
    return meshopt_decodeIndexBuffer(to, layout.Count, layout.Stride, from.data(), from.size()) == 0;
  }
  return meshopt_decodeIndexSequence(to, layout.Count, layout.Stride, from.data(), from.size()) == 0;
}

void ApplyFilter(const Layout& layout, unsigned char* elements)
{
  if (layout.Filter == "OCTAHEDRAL")
  {
    meshopt_decodeFilterOct(elements, layout.Count, layout.Stride);
  }
  else if (layout.Filter == "QUATERNION")
  {
    meshopt_decodeFilterQuat(elements, layout.Count, layout.Stride);
  }
  else if (layout.Filter == "EXPONENTIAL")
  {
    meshopt_decodeFilterExp(elements, layout.Count, layout.Stride);
  }
}
#endif
}

namespace vtkMTGltfMeshopt
{
const Json* FindExtension(const Json& object)
{
  return vtkMTGltfJson::FindExtension(object, "EXT_meshopt_compression");
}

#ifdef MT_HAS_MESHOPTIMIZER
bool IsAvailable()
{
  return true;
}

std::vector<unsigned char> Decode(
  const Json& extension, const std::vector<unsigned char>& compressed, std::uint64_t length, const std::string& where)
{
  const Layout layout{ GetText(extension, "mode"), GetText(extension, "filter", "NONE"),
    static_cast<std::size_t>(GetCount(extension, "count", where)),
    static_cast<std::size_t>(GetCount(extension, "byteStride", where)) };
  Check(layout, compressed.size(), length, where);
  std::vector<unsigned char> bytes(layout.Count * layout.Stride);
  if (!DecodeMode(layout, compressed, bytes.data()))
  {
    Fail(where, "is damaged, or of a newer version of the codec");
  }
  ApplyFilter(layout, bytes.data());
  return bytes;
}
#else
bool IsAvailable()
{
  return false;
}

std::vector<unsigned char> Decode(
  const Json&, const std::vector<unsigned char>&, std::uint64_t, const std::string& where)
{
  Fail(where, "cannot be decoded: this program was built without meshoptimizer");
}
#endif
}
