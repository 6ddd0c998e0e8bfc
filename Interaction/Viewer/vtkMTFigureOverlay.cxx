// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFigureOverlay.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkMTColorSelector.h"
#include "vtkMTFrameFigures.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkScalarsToColors.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace
{
constexpr int OverlayLayer = 1;
constexpr double MiB = 1.0 / (1 << 20);

// Digits in groups of three.
std::string Group(long long number)
{
  std::string text = std::to_string(number);
  for (int place = static_cast<int>(text.size()) - 3; place > 0; place -= 3)
  {
    text.insert(static_cast<std::size_t>(place), " ");
  }
  return text;
}
}

//------------------------------------------------------------------------------
vtkMTFigureOverlay::vtkMTFigureOverlay(const vtkMTColorSelector& colors, std::function<std::string()> getText)
  : Colors(colors)
  , GetMore(std::move(getText))
{
  this->Layer->SetLayer(OverlayLayer);
  this->Layer->InteractiveOff();
  vtkTextProperty* font = this->Text->GetTextProperty();
  font->SetFontSize(15);
  font->SetFontFamilyToCourier();
  font->SetBackgroundColor(0.0, 0.0, 0.0);
  font->SetBackgroundOpacity(0.45);
  this->Text->SetPosition(10, 10);
  this->Layer->AddActor2D(this->Text);
  this->Bar->SetPosition(0.8, 0.2);
  this->Bar->SetWidth(0.19); // room for the title
  this->Bar->SetBarRatio(0.2);
  this->Bar->SetHeight(0.7);
  this->Bar->UnconstrainedFontSizeOn();
  this->Bar->GetTitleTextProperty()->SetFontSize(15);
  this->Bar->GetTitleTextProperty()->ItalicOff();
  this->Bar->GetLabelTextProperty()->SetFontSize(14);
  this->Bar->GetLabelTextProperty()->ItalicOff();
  this->Bar->SetVerticalTitleSeparation(8);
  this->Bar->SetLabelFormat("%.3g");
  this->Bar->VisibilityOff();
  this->Layer->AddActor2D(this->Bar);
  this->Command->SetClientData(this);
  this->Command->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<vtkMTFigureOverlay*>(self)->Update(); });
}

//------------------------------------------------------------------------------
vtkMTFigureOverlay::~vtkMTFigureOverlay()
{
  this->SetRenderer(nullptr);
}

//------------------------------------------------------------------------------
void vtkMTFigureOverlay::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->Command);
  }
  if (this->Window)
  {
    this->Window->RemoveRenderer(this->Layer);
  }
  this->Renderer = renderer;
  this->Window = renderer ? renderer->GetRenderWindow() : nullptr;
  if (this->Window)
  {
    this->Window->SetNumberOfLayers(std::max(this->Window->GetNumberOfLayers(), OverlayLayer + 1));
    this->Window->AddRenderer(this->Layer);
    this->Renderer->AddObserver(vtkCommand::EndEvent, this->Command);
  }
}

//------------------------------------------------------------------------------
std::string vtkMTFigureOverlay::GetText() const
{
  return this->Text->GetInput() ? this->Text->GetInput() : "";
}

//------------------------------------------------------------------------------
std::string vtkMTFigureOverlay::MakeFigures() const
{
  const vtkMTFrameFigures sums = vtkMTFrameFigures::Find(this->Renderer);
  if (sums.Models == 0)
  {
    return "no model yet";
  }
  const double frame = this->Renderer->GetLastRenderTimeInSeconds();
  char lines[400];
  std::snprintf(lines, sizeof(lines),
    "%zu model%s  %s triangles  %s patch%s (%s culled)  error %.2f of %.2f pixels\n"
    "frame %.1f ms (%.0f/s)  cut %.1f ms  memory %.1f MiB  GPU %.1f MiB%s%s",
    sums.Models, sums.Models == 1 ? "" : "s", Group(sums.Triangles).c_str(), Group(sums.Patches).c_str(),
    sums.Patches == 1 ? "" : "es", Group(sums.CulledPatches).c_str(), sums.PixelError, sums.WantedPixelError,
    1e3 * frame, frame > 0.0 ? 1.0 / frame : 0.0, 1e3 * sums.CutTime, MiB * sums.PatchMemory, MiB * sums.GraphicsMemory,
    sums.IsLoading ? "  loading" : "", sums.IsFrozen ? "  FROZEN" : "");
  return lines;
}

//------------------------------------------------------------------------------
void vtkMTFigureOverlay::Update()
{
  const std::string more = this->GetMore();
  std::string text = this->ShowFigures ? this->MakeFigures() : "";
  text += (text.empty() || more.empty() ? "" : "\n") + more;
  this->Text->SetInput(text.c_str());
  this->Text->SetVisibility(!text.empty());
  this->UpdateScalarBar();
}

//------------------------------------------------------------------------------
void vtkMTFigureOverlay::UpdateScalarBar()
{
  vtkScalarsToColors* table = this->Colors.GetTable();
  this->Bar->SetVisibility(this->ShowScalarBar && table);
  if (!table)
  {
    return;
  }
  const bool isNamed = table->GetIndexedLookup() && table->GetNumberOfAnnotatedValues() > 0;
  this->Bar->SetLookupTable(table);
  this->Bar->SetTitle(this->Colors.GetTitle().c_str());
  this->Bar->SetDrawAnnotations(isNamed);
  this->Bar->SetDrawTickLabels(!isNamed);
}
