// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTErrorCollector.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkOutputWindow.h"

namespace
{
// "ERROR: In file.cxx, line 1\nvtkClass (0x123): what is wrong\n\n" -> "what is wrong"; generic warnings name no
// object.
std::string Trim(std::string text)
{
  const std::size_t line = text.find('\n');
  if ((text.compare(0, 6, "ERROR:") == 0 || text.compare(0, 8, "Generic ") == 0) && line != std::string::npos)
  {
    const std::size_t head = text.find("): ");
    text.erase(0, head != std::string::npos ? head + 3 : line + 1);
  }
  const std::size_t last = text.find_last_not_of(" \n\r\t");
  text.erase(last == std::string::npos ? 0 : last + 1);
  for (char& c : text)
  {
    c = c == '\n' || c == '\r' ? ' ' : c;
  }
  return text;
}
}

vtkMTErrorCollector::vtkMTErrorCollector()
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(&vtkMTErrorCollector::Collect);
}

vtkMTErrorCollector::~vtkMTErrorCollector()
{
  for (const auto& observed : this->Observed)
  {
    observed.first->RemoveObserver(observed.second);
  }
  if (this->Displaced)
  {
    vtkOutputWindow::SetInstance(this->Displaced);
  }
}

void vtkMTErrorCollector::Observe(vtkAlgorithm* algorithm)
{
  this->Observe(static_cast<vtkObject*>(algorithm));
  this->Observe(static_cast<vtkObject*>(algorithm->GetExecutive()));
}

void vtkMTErrorCollector::Observe(vtkObject* object)
{
  this->Observed.emplace_back(object, object->AddObserver(vtkCommand::ErrorEvent, this->Command));
}

void vtkMTErrorCollector::IgnoreUnknownKeys(vtkAlgorithm* reader)
{
  const vtkNew<vtkCallbackCommand> command;
  command->SetCallback(
    [](vtkObject*, unsigned long, void*, void* text)
    {
      const std::string message = text ? static_cast<const char*>(text) : "";
      if (message.find("Could not locate key ") == std::string::npos)
      {
        vtkOutputWindowDisplayWarningText(message.c_str());
      }
    });
  reader->AddObserver(vtkCommand::WarningEvent, command);
}

void vtkMTErrorCollector::ObserveOutputWindow(bool warningsToo)
{
  if (!this->Displaced)
  {
    this->Displaced = vtkOutputWindow::GetInstance();
    const vtkNew<vtkOutputWindow> quiet;
    quiet->SetDisplayModeToNever();
    vtkOutputWindow::SetInstance(quiet);
  }
  vtkOutputWindow* window = vtkOutputWindow::GetInstance();
  this->Observe(static_cast<vtkObject*>(window));
  if (warningsToo)
  {
    this->Observed.emplace_back(window, window->AddObserver(vtkCommand::WarningEvent, this->Command));
  }
}

vtkCommand* vtkMTErrorCollector::GetCommand()
{
  return this->Command;
}

void vtkMTErrorCollector::Collect(vtkObject*, unsigned long, void* self, void* text)
{
  std::vector<std::string>& messages = static_cast<vtkMTErrorCollector*>(self)->Messages;
  std::string message = Trim(text ? static_cast<const char*>(text) : "unknown error");
  // The executive only repeats that the algorithm has failed.
  const bool repeats = message.find("returned failure for request") != std::string::npos;
  constexpr std::size_t most = 4;
  if (messages.empty() || (!repeats && messages.size() < most && messages.back() != message))
  {
    messages.push_back(std::move(message));
  }
}

std::string vtkMTErrorCollector::GetMessage() const
{
  std::string all;
  for (const std::string& message : this->Messages)
  {
    all += (all.empty() ? "" : "; ") + message;
  }
  return all;
}
