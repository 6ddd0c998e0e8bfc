// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTTuples.h"

#include <cstring>

namespace
{
// Of a size that is known when it is compiled: a copy is one or two instructions then.
template <std::size_t Size>
void GatherSized(const unsigned char* from, const std::vector<std::uint32_t>& tuples, unsigned char* to)
{
  for (const std::uint32_t tuple : tuples)
  {
    std::memcpy(to, from + tuple * Size, Size);
    to += Size;
  }
}
}

vtkMTColumn vtkMTTuples::Gather(
  const vtkMTColumn& column, std::size_t tupleSize, const std::vector<std::uint32_t>& tuples)
{
  vtkMTColumn result(column.empty() ? 0 : tuples.size() * tupleSize);
  if (result.empty())
  {
    return result;
  }
  switch (tupleSize)
  {
    case 4:
      GatherSized<4>(column.data(), tuples, result.data());
      break;
    case 8:
      GatherSized<8>(column.data(), tuples, result.data());
      break;
    case 12:
      GatherSized<12>(column.data(), tuples, result.data());
      break;
    default:
      for (std::size_t i = 0; i < tuples.size(); ++i)
      {
        std::memcpy(result.data() + i * tupleSize, column.data() + tuples[i] * tupleSize, tupleSize);
      }
  }
  return result;
}
