// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportChart.h"

#include "MTReportImage.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextScene.h"
#include "vtkContextView.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotPoints.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
constexpr int Width = 640;
constexpr int Height = 420;

// Of lines, in turn; told apart on white by eyes of every kind (Okabe and Ito), then again with other markers.
constexpr unsigned char Colors[][3] = { { 0, 114, 178 }, { 213, 94, 0 }, { 0, 158, 115 }, { 204, 121, 167 },
  { 86, 180, 233 }, { 230, 159, 0 }, { 0, 0, 0 }, { 120, 120, 120 } };
constexpr int Markers[] = { vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE, vtkPlotPoints::DIAMOND, vtkPlotPoints::PLUS,
  vtkPlotPoints::CROSS };

// Tick labels of powers are short.
void Configure(vtkAxis* axis, const std::string& title, bool isLogarithmic)
{
  axis->SetTitle(title);
  axis->SetLogScale(isLogarithmic);
  axis->SetBehavior(vtkAxis::FIXED); // or its range would end at the outermost points, and split their markers
  axis->SetNotation(vtkAxis::PRINTF_NOTATION);
  axis->SetLabelFormat("%g");
  axis->GetTitleProperties()->SetBold(0);
  axis->GetTitleProperties()->SetFontSize(13);
  axis->GetLabelProperties()->SetFontSize(12);
  axis->GetGridPen()->SetColor(225, 225, 225);
}

// Some room at both ends.
void SetRange(vtkAxis* axis, double low, double high, bool isLogarithmic)
{
  if (isLogarithmic)
  {
    low = std::log10(low) - 0.08;
    high = std::log10(high) + 0.08;
    axis->SetUnscaledRange(std::pow(10.0, low), std::pow(10.0, high));
    return;
  }
  const double room = high > low ? 0.05 * (high - low) : 0.5 * std::abs(high) + 1e-12;
  axis->SetRange(low - room, high + room);
}

void WritePicture(vtkRenderWindow* window, const std::string& path)
{
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->Update();
  MTReportImage::Write(picture->GetOutput(), 8, path);
}
}

MTReportChart::MTReportChart(std::string name, std::string title, Axis x, Axis y)
  : Name(std::move(name))
  , Title(std::move(title))
  , X(std::move(x))
  , Y(std::move(y))
{
}

bool MTReportChart::CanShow(const std::pair<double, double>& point) const
{
  const auto canShow = [](double value, const Axis& axis)
  { return std::isfinite(value) && (!axis.IsLogarithmic || value > 0.0); };
  return canShow(point.first, this->X) && canShow(point.second, this->Y);
}

void MTReportChart::AddPoint(const std::string& label, double x, double y)
{
  if (!this->CanShow({ x, y }))
  {
    return;
  }
  const auto isOfLabel = [&label](const Line& line) { return line.Label == label; };
  auto line = std::find_if(this->Lines.begin(), this->Lines.end(), isOfLabel);
  if (line == this->Lines.end())
  {
    line = this->Lines.insert(line, { label, {} });
  }
  line->Points.emplace_back(x, y);
}

void MTReportChart::Write(const std::string& folder) const
{
  if (this->IsEmpty())
  {
    throw std::runtime_error("the chart " + this->Name + " has no points");
  }
  vtkNew<vtkContextView> view;
  view->GetRenderWindow()->SetOffScreenRendering(1);
  view->GetRenderWindow()->SetMultiSamples(0);
  view->GetRenderWindow()->SetSize(Width, Height);
  view->GetRenderer()->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkChartXY> chart;
  view->GetScene()->AddItem(chart);
  chart->SetTitle(this->Title);
  chart->GetTitleProperties()->SetFontSize(14);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetInline(false);
  chart->GetLegend()->SetLabelSize(12);
  Configure(chart->GetAxis(vtkAxis::BOTTOM), this->X.Title, this->X.IsLogarithmic);
  Configure(chart->GetAxis(vtkAxis::LEFT), this->Y.Title, this->Y.IsLogarithmic);
  std::pair<double, double> low = this->Lines.front().Points.front();
  std::pair<double, double> high = low;
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    vtkNew<vtkDoubleArray> xs;
    vtkNew<vtkDoubleArray> ys;
    xs->SetName("x");
    ys->SetName(this->Lines[i].Label.c_str());
    for (const auto& [x, y] : this->Lines[i].Points)
    {
      xs->InsertNextValue(x);
      ys->InsertNextValue(y);
      low = { std::min(low.first, x), std::min(low.second, y) };
      high = { std::max(high.first, x), std::max(high.second, y) };
    }
    vtkNew<vtkTable> table;
    table->AddColumn(xs);
    table->AddColumn(ys);
    const unsigned char* color = Colors[i % std::size(Colors)];
    auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(vtkChart::LINE));
    plot->SetInputData(table, 0, 1);
    plot->SetColor(color[0], color[1], color[2], 255);
    plot->SetWidth(1.5f);
    plot->SetMarkerStyle(Markers[i % std::size(Markers)]);
    plot->SetMarkerSize(7.0f);
  }
  SetRange(chart->GetAxis(vtkAxis::BOTTOM), low.first, high.first, this->X.IsLogarithmic);
  SetRange(chart->GetAxis(vtkAxis::LEFT), low.second, high.second, this->Y.IsLogarithmic);
  view->GetRenderWindow()->Render();
  WritePicture(view->GetRenderWindow(), folder + "/" + this->Name + ".png");
}
