// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCameraPathFile.h"

#include "vtkCamera.h"
#include "vtkMTOutputFile.h"
#include "vtkMath.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

namespace
{
constexpr std::array<const char*, 12> Columns{ "time", "px", "py", "pz", "fx", "fy", "fz", "ux", "uy", "uz",
  "view_angle", "parallel_scale" };
using Row = std::array<double, Columns.size()>;

std::string MakeHeader()
{
  std::string header;
  for (const char* name : Columns)
  {
    header += (header.empty() ? "" : ",") + std::string(name);
  }
  return header;
}

Row ToRow(const vtkMTCameraView& view)
{
  Row row{ view.Time };
  std::copy(view.Position.begin(), view.Position.end(), row.begin() + 1);
  std::copy(view.FocalPoint.begin(), view.FocalPoint.end(), row.begin() + 4);
  std::copy(view.ViewUp.begin(), view.ViewUp.end(), row.begin() + 7);
  row[10] = view.ViewAngle;
  row[11] = view.ParallelScale;
  return row;
}

vtkMTCameraView ToView(const Row& row)
{
  vtkMTCameraView view;
  view.Time = row[0];
  std::copy_n(row.begin() + 1, 3, view.Position.begin());
  std::copy_n(row.begin() + 4, 3, view.FocalPoint.begin());
  std::copy_n(row.begin() + 7, 3, view.ViewUp.begin());
  view.ViewAngle = row[10];
  view.ParallelScale = row[11];
  return view;
}

std::string Trim(const std::string& text)
{
  const std::size_t first = text.find_first_not_of(" \t\r");
  const std::size_t last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> Split(const std::string& line)
{
  std::vector<std::string> cells(1);
  for (const char c : line)
  {
    if (c == ',')
    {
      cells.emplace_back();
    }
    else
    {
      cells.back() += c;
    }
  }
  std::transform(cells.begin(), cells.end(), cells.begin(), Trim);
  return cells;
}

// Gives what is wrong with the line, or nothing.
std::string ParseRow(const std::string& line, Row& row)
{
  const std::vector<std::string> cells = Split(line);
  if (cells.size() != row.size())
  {
    return std::to_string(cells.size()) + " values instead of " + std::to_string(row.size()) + " (" + MakeHeader() +
      ")";
  }
  for (std::size_t i = 0; i < row.size(); ++i)
  {
    const char* const begin = cells[i].data();
    const char* const end = begin + cells[i].size();
    const auto [stop, code] = std::from_chars(begin, end, row[i]);
    if (code != std::errc() || stop != end || !std::isfinite(row[i]))
    {
      return std::string("column ") + Columns[i] + ": '" + cells[i].substr(0, 40) + "' is no finite number";
    }
  }
  return "";
}

std::string CheckView(const vtkMTCameraView& view, const std::vector<vtkMTCameraView>& before)
{
  if (!before.empty() && !(view.Time > before.back().Time))
  {
    return "column time: times must increase from line to line";
  }
  return view.FindProblem();
}
}

//------------------------------------------------------------------------------
vtkMTCameraView vtkMTCameraView::Get(double time, vtkCamera* camera)
{
  vtkMTCameraView view;
  view.Time = time;
  camera->GetPosition(view.Position.data());
  camera->GetFocalPoint(view.FocalPoint.data());
  camera->GetViewUp(view.ViewUp.data());
  view.ViewAngle = camera->GetViewAngle();
  view.ParallelScale = camera->GetParallelProjection() ? camera->GetParallelScale() : 0.0;
  return view;
}

//------------------------------------------------------------------------------
void vtkMTCameraView::Set(vtkCamera* camera) const
{
  camera->SetPosition(this->Position.data());
  camera->SetFocalPoint(this->FocalPoint.data());
  camera->SetViewUp(this->ViewUp.data());
  camera->SetViewAngle(this->ViewAngle);
  camera->SetParallelProjection(this->ParallelScale > 0.0);
  if (this->ParallelScale > 0.0)
  {
    camera->SetParallelScale(this->ParallelScale);
  }
}

//------------------------------------------------------------------------------
std::string vtkMTCameraView::FindProblem() const
{
  double direction[3];
  double side[3];
  vtkMath::Subtract(this->FocalPoint.data(), this->Position.data(), direction);
  vtkMath::Cross(direction, this->ViewUp.data(), side);
  const Row row = ToRow(*this);
  const bool isFinite = std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); });
  if (!isFinite || !(vtkMath::Norm(side) > 1e-9 * vtkMath::Norm(direction) * vtkMath::Norm(this->ViewUp.data())))
  {
    return "the camera's position, focal point and view up do not make a view; position and focal point must differ, "
           "and view up must not point along the view";
  }
  if (!(this->ViewAngle > 0.0 && this->ViewAngle < 180.0))
  {
    return "the view angle must be between 0 and 180 degrees";
  }
  return this->ParallelScale < 0.0 ? "the parallel scale must not be negative" : "";
}

//------------------------------------------------------------------------------
bool vtkMTCameraPathFile::Write(const std::string& path, const std::vector<vtkMTCameraView>& views, std::string& error)
{
  std::string text = MakeHeader();
  for (const vtkMTCameraView& view : views)
  {
    char separator = '\n';
    for (const double value : ToRow(view))
    {
      char digits[32]; // the shortest text that is read back as the same number has 24 characters at most
      const char* const end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
      text += separator + std::string(digits, static_cast<std::size_t>(end - digits));
      separator = ',';
    }
  }
  text += '\n';
  vtkMTOutputFile file;
  const bool isWritten = file.Open(path) && file.Write(text.data(), text.size()) && file.Commit();
  error = isWritten ? "" : file.GetError();
  return isWritten;
}

//------------------------------------------------------------------------------
bool vtkMTCameraPathFile::Read(const std::string& path, std::vector<vtkMTCameraView>& views, std::string& error)
{
  std::ifstream file(path);
  if (!file)
  {
    error = path + ": cannot be opened: " + std::strerror(errno);
    return false;
  }
  views.clear();
  std::string line;
  std::string problem;
  bool hasHeader = false;
  std::size_t number = 0;
  for (; problem.empty() && std::getline(file, line); ++number)
  {
    line = Trim(line);
    if (line.empty() || line[0] == '#')
    {
      continue;
    }
    if (!hasHeader)
    {
      hasHeader = line == MakeHeader();
      problem = hasHeader ? "" : "is no camera path, which begins with " + MakeHeader();
      continue;
    }
    Row row{};
    problem = ParseRow(line, row);
    const vtkMTCameraView view = ToView(row);
    problem = problem.empty() ? CheckView(view, views) : problem;
    views.push_back(view);
  }
  if (problem.empty() && (file.bad() || views.empty()))
  {
    error = path + (file.bad() ? ": cannot be read" : ": has no views");
    return false;
  }
  error = problem.empty() ? "" : path + ":" + std::to_string(number) + ": " + problem;
  return problem.empty();
}
