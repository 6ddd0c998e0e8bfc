// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTStlText.h"

bool vtkMTStlText::IsText(std::string_view begin)
{
  return vtkMTTextFormat::ToLower(vtkMTTextFormat::NextToken(begin).substr(0, 6)) == "solid";
}

bool vtkMTStlText::Read(std::size_t vertices, std::vector<float>& coordinates)
{
  const std::size_t before = coordinates.size();
  std::string_view line;
  while ((coordinates.size() - before) / 3 < vertices)
  {
    if (!this->Stream.TakeLine(line))
    {
      return (this->Stream.GetError().empty() || this->Fail(this->Stream.GetError())) &&
        (!this->IsInSolid || this->Fail("ends before \"endsolid\": it is truncated"));
    }
    ++this->LineNumber;
    if (!this->ReadLine(line, coordinates))
    {
      return this->Fail("line " + std::to_string(this->LineNumber) + ": " + this->Error);
    }
  }
  return true;
}

bool vtkMTStlText::ReadLine(std::string_view line, std::vector<float>& coordinates)
{
  const std::string_view token = vtkMTTextFormat::NextToken(line);
  const std::string keyword = vtkMTTextFormat::ToLower(token.substr(0, 20));
  if (keyword == "vertex")
  {
    return this->ReadVertex(line, coordinates);
  }
  if (keyword == "facet" || keyword == "endfacet")
  {
    const bool opens = keyword == "facet";
    const bool isInOrder = this->IsInSolid && this->IsInFacet != opens && (opens || this->Corners == 3);
    this->IsInFacet = opens;
    const int corners = this->Corners;
    this->Corners = 0;
    return isInOrder ||
      this->Fail(opens ? "a facet begins within another or outside a solid"
                       : "a facet ends with " + std::to_string(corners) + " vertices");
  }
  if (keyword == "solid" || keyword == "endsolid")
  {
    const bool opens = keyword == "solid";
    const bool isInOrder = this->IsInSolid != opens && !this->IsInFacet;
    this->IsInSolid = opens;
    return isInOrder || this->Fail("\"" + keyword + "\" is out of place");
  }
  return keyword.empty() || keyword == "outer" || keyword == "endloop" ||
    this->Fail("\"" + keyword + "\" is no keyword of STL");
}

bool vtkMTStlText::ReadVertex(std::string_view line, std::vector<float>& coordinates)
{
  float place[3] = { 0.0f, 0.0f, 0.0f };
  for (float& x : place)
  {
    if (!vtkMTTextFormat::ToNumber(vtkMTTextFormat::NextToken(line), x))
    {
      return this->Fail("a vertex does not have three coordinates");
    }
  }
  if (!this->IsInFacet || ++this->Corners > 3 || !vtkMTTextFormat::NextToken(line).empty())
  {
    return this->Fail("a vertex is out of place");
  }
  coordinates.insert(coordinates.end(), place, place + 3);
  return true;
}
