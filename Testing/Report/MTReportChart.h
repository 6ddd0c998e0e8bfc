// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportChart
 * @brief lines with markers over two axes, drawn by vtkChartXY into a PNG
 *
 * Points with a coordinate that is not finite, or not positive on a logarithmic axis, are left out. Needs a display
 * (CMake/with-display).
 */
#ifndef MTReportChart_h
#define MTReportChart_h

#include <string>
#include <utility>
#include <vector>

class MTReportChart
{
public:
  struct Axis
  {
    std::string Title; ///< with its unit
    bool IsLogarithmic = false;
  };

  /// name: of the file, without ending.
  MTReportChart(std::string name, std::string title, Axis x, Axis y);

  /// Adds a point to the line of that label, which is made where there is none; labels are in the order of their first
  /// points.
  void AddPoint(const std::string& label, double x, double y);

  bool IsEmpty() const { return this->Lines.empty(); }
  const std::string& GetName() const { return this->Name; }
  const std::string& GetTitle() const { return this->Title; }

  /// Into the folder, as Name.png; throws std::runtime_error where that fails or the chart is empty.
  void Write(const std::string& folder) const;

private:
  struct Line
  {
    std::string Label;
    std::vector<std::pair<double, double>> Points;
  };
  bool CanShow(const std::pair<double, double>& point) const;

  std::string Name;
  std::string Title;
  Axis X;
  Axis Y;
  std::vector<Line> Lines;
};

#endif
