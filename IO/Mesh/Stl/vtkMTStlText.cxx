// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlText.h"

#include <limits>

vtkMTStlText::vtkMTStlText(vtkMTTextFormat::Stream& stream)
  : Stream(stream)
{
  stream.SkipByteOrderMark();
}

bool vtkMTStlText::IsText(std::string_view begin)
{
  // Binary files whose header says "solid" have zero bytes behind it.
  const bool hasZero = begin.find('\0') != std::string_view::npos;
  begin.remove_prefix(vtkMTTextFormat::GetByteOrderMarkSize(begin));
  return !hasZero && vtkMTTextFormat::ToLower(vtkMTTextFormat::NextToken(begin).substr(0, 5)) == "solid";
}

bool vtkMTStlText::Read(std::size_t vertices, std::vector<float>& coordinates)
{
  const std::size_t before = coordinates.size();
  std::string_view line;
  while ((coordinates.size() - before) / 3 < vertices)
  {
    if (this->NextPending < this->Pending.size())
    {
      this->TakeTriangle(coordinates);
      continue;
    }
    if (!this->Stream.TakeLine(line))
    {
      return (this->Stream.GetError().empty() || this->Fail(this->Stream.GetError())) &&
        (!this->IsInSolid || this->Fail("ends before \"endsolid\": it is truncated"));
    }
    ++this->LineNumber;
    if (!this->ReadLine(line))
    {
      return this->Fail("line " + std::to_string(this->LineNumber) + ": " + this->Error);
    }
  }
  return true;
}

// The first vertex, and two more.
void vtkMTStlText::TakeTriangle(std::vector<float>& coordinates)
{
  const float* const first = this->Pending.data();
  const float* const next = first + this->NextPending;
  coordinates.insert(coordinates.end(), first, first + 3);
  coordinates.insert(coordinates.end(), next - 3, next + 3);
  this->NextPending += 3;
}

bool vtkMTStlText::CountBad(const char* reason, const std::string& what)
{
  constexpr std::uint64_t few = 10;
  ++this->Report[reason];
  return ++this->BadLines <= few + this->LineNumber / few || this->Fail(what);
}

bool vtkMTStlText::ReadLine(std::string_view line)
{
  const std::string_view token = vtkMTTextFormat::NextToken(line);
  const std::string keyword = vtkMTTextFormat::ToLower(token.substr(0, 20));
  if (keyword == "vertex")
  {
    return this->ReadVertex(line);
  }
  if (keyword == "facet")
  {
    const bool good = this->FinishFacet();
    this->IsInFacet = true;
    return good;
  }
  if (keyword == "solid")
  {
    const bool good = this->FinishFacet();
    this->IsInSolid = true;
    this->Solids.Add(this->Triangles, line);
    return good;
  }
  if (keyword.substr(0, 3) == "end")
  {
    const bool isSplit = keyword == "end";
    const std::string_view rest = isSplit ? vtkMTTextFormat::NextToken(line) : token.substr(3);
    vtkMTInputReports::Add("split_keywords", isSplit ? 1 : 0, this->Report);
    return this->ReadEnd(vtkMTTextFormat::ToLower(rest.substr(0, 20)));
  }
  const bool isLoop = keyword == "outer" || keyword == "outerloop" || keyword == "loop";
  return keyword.empty() || isLoop || this->CountBad("ignored_lines", "\"" + keyword + "\" is no keyword of STL");
}

bool vtkMTStlText::ReadEnd(const std::string& keyword)
{
  if (keyword == "facet")
  {
    return this->FinishFacet();
  }
  if (keyword == "solid")
  {
    this->IsInSolid = false;
    return this->FinishFacet();
  }
  return keyword == "loop" || this->CountBad("ignored_lines", "\"end" + keyword + "\" is no keyword of STL");
}

bool vtkMTStlText::ReadVertex(std::string_view line)
{
  float place[3] = { 0.0f, 0.0f, 0.0f };
  bool good = true;
  for (float& x : place)
  {
    if (!vtkMTTextFormat::ToNumber(vtkMTTextFormat::NextToken(line), x))
    {
      x = std::numeric_limits<float>::quiet_NaN(); // the triangle will be dropped, and counted
      good = false;
    }
  }
  if (!this->IsInFacet)
  {
    return this->CountBad("bad_records", "a vertex is out of place");
  }
  this->Facet.insert(this->Facet.end(), place, place + 3);
  return good || this->CountBad("bad_records", "a vertex does not have three coordinates");
}

bool vtkMTStlText::FinishFacet()
{
  const std::size_t corners = this->Facet.size() / 3;
  const bool wasInFacet = this->IsInFacet;
  this->IsInFacet = false;
  this->Pending.swap(this->Facet);
  this->Facet.clear();
  this->NextPending = 6;
  if (corners < 3)
  {
    this->Pending.clear();
    return !wasInFacet || this->CountBad("bad_records", "a facet ends with " + std::to_string(corners) + " vertices");
  }
  this->Triangles += corners - 2;
  vtkMTInputReports::Add("facets_of_more_corners", corners > 3 ? 1 : 0, this->Report);
  return true;
}
