// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStreamShuffle.h"

#include "vtkMTBarycentreSample.h"

#include <algorithm>

//------------------------------------------------------------------------------
int vtkMTStreamShuffle::GetStream(std::uint64_t number)
{
  const std::uint64_t hash = vtkMTBarycentreSample::Hash(number);
  int stream = 0;
  while (stream < MaximumStream && (hash >> stream & 1u) == 0)
  {
    ++stream;
  }
  return stream;
}

//------------------------------------------------------------------------------
bool vtkMTStreamShuffle::Take(vtkMTBarycentreScan& scan, int firstStream)
{
  firstStream = std::clamp(firstStream, 0, MaximumStream);
  std::vector<std::vector<Point>> streams(static_cast<std::size_t>(MaximumStream - firstStream) + 1);
  Point first{};
  this->Count = 0;
  const bool done = scan.Scan(
    [&](const Point* points, std::size_t count)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        if (!vtkMTBarycentreSample::IsFinite(points[i]))
        {
          continue;
        }
        first = this->Count == 0 ? points[i] : first;
        // Counted without those that are no numbers, so that they have no influence.
        const int stream = vtkMTStreamShuffle::GetStream(this->Count++);
        if (stream >= firstStream)
        {
          streams[static_cast<std::size_t>(stream - firstStream)].push_back(points[i]);
        }
      }
    });
  this->Points.clear();
  for (auto stream = streams.rbegin(); stream != streams.rend(); ++stream)
  {
    this->Points.insert(this->Points.end(), stream->begin(), stream->end());
    std::vector<Point>().swap(*stream);
  }
  if (this->Points.empty() && this->Count > 0)
  {
    this->Points.push_back(first);
  }
  return done;
}
