// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"

#include "vtkMTFileAccess.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>

#include <unistd.h>

//------------------------------------------------------------------------------
// Interruption

namespace
{
volatile std::sig_atomic_t Interrupted = 0;

extern "C" void HandleInterrupt(int signal)
{
  if (Interrupted)
  {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  Interrupted = 1;
}
}

void bmtCatchInterrupts()
{
  struct sigaction action;
  std::memset(&action, 0, sizeof(action));
  action.sa_handler = HandleInterrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool bmtIsInterrupted()
{
  return Interrupted != 0;
}

void bmtThrowIfInterrupted()
{
  if (bmtIsInterrupted())
  {
    throw bmtInterrupt();
  }
}

bmtInterruptWatch::bmtInterruptWatch(double patience, std::function<std::string()> leave)
  : Thread([this, patience, leave = std::move(leave)] { this->Watch(patience, leave); })
{
}

bmtInterruptWatch::~bmtInterruptWatch()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->HasEnded = true;
  }
  this->Ended.notify_one();
  this->Thread.join();
}

void bmtInterruptWatch::Watch(double patience, const std::function<std::string()>& leave)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  const auto endsWithin = [&](double seconds)
  { return this->Ended.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return this->HasEnded; }); };
  while (!bmtIsInterrupted())
  {
    if (endsWithin(0.05))
    {
      return;
    }
  }
  if (!endsWithin(patience))
  {
    bmtWarn(leave());
    _exit(bmtExit::Interrupted);
  }
}

//------------------------------------------------------------------------------
// Messages

// VTK says "ERROR: In file.cxx, line 1\nvtkClass (0x...): what\n\n": what it says in the end is enough for a person.
std::string bmtGetEssence(const std::string& text)
{
  const std::size_t object = text.find("): ");
  std::string essence = object == std::string::npos ? text : text.substr(object + 3);
  std::replace(essence.begin(), essence.end(), '\n', ' ');
  const std::size_t last = essence.find_last_not_of(' ');
  return essence.substr(0, last == std::string::npos ? 0 : last + 1);
}

namespace
{
class OutputWindow : public vtkOutputWindow
{
public:
  static OutputWindow* New();
  vtkTypeMacro(OutputWindow, vtkOutputWindow);
  void DisplayText(const char* text) override { bmtWarn(bmtGetEssence(text)); }

protected:
  OutputWindow() { this->SetDisplayModeToNever(); }
};
vtkStandardNewMacro(OutputWindow);
}

void bmtInstallOutputWindow()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // or else it would say everything a second time
  vtkNew<OutputWindow> window;
  vtkOutputWindow::SetInstance(window);
}

void bmtWarn(const std::string& text)
{
  if (!text.empty())
  {
    std::cerr << "bmt: " << text << std::endl;
  }
}

//------------------------------------------------------------------------------
// Time and progress

double bmtWallSeconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bmtProgress::bmtProgress(const char* what)
  : What(isatty(STDERR_FILENO) ? what : "")
{
}

bmtProgress::~bmtProgress()
{
  if (this->LastTime >= 0.0)
  {
    std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
  }
}

// From the rate since the fraction began to grow.
std::string bmtProgress::GetTimeLeft(double fraction, double now)
{
  if (this->FirstTime < 0.0 || fraction < this->FirstFraction)
  {
    this->FirstTime = fraction > 0.0 ? now : -1.0;
    this->FirstFraction = fraction;
  }
  if (now - this->FirstTime < 2.0 || this->FirstTime < 0.0 || fraction <= this->FirstFraction)
  {
    return "";
  }
  const double left = (1.0 - fraction) * (now - this->FirstTime) / (fraction - this->FirstFraction);
  const long seconds = std::lround(left);
  char text[64];
  std::snprintf(text, sizeof(text), ", %ld:%02ld:%02ld left", seconds / 3600, seconds / 60 % 60, seconds % 60);
  return text;
}

void bmtProgress::Update(double fraction, const std::string& step)
{
  const double now = bmtWallSeconds();
  if (this->What.empty() || now - this->LastTime < 0.1)
  {
    return;
  }
  this->LastTime = now;
  const std::string left = this->GetTimeLeft(fraction, now);
  std::fprintf(stderr, "\r\033[K%s %3.0f %%%s%s%s", this->What.c_str(), 100.0 * std::clamp(fraction, 0.0, 1.0),
    step.empty() ? "" : ", ", step.c_str(), left.c_str());
  std::fflush(stderr);
}

void bmtFollow(vtkAlgorithm* algorithm, bmtProgress& progress)
{
  const vtkNew<vtkCallbackCommand> follow;
  follow->SetClientData(&progress);
  follow->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* fraction)
    {
      auto* source = static_cast<vtkAlgorithm*>(caller);
      const char* step = source->GetProgressText();
      static_cast<bmtProgress*>(client)->Update(*static_cast<double*>(fraction), step ? step : "");
      if (bmtIsInterrupted())
      {
        source->AbortExecuteOn();
      }
    });
  algorithm->AddObserver(vtkCommand::ProgressEvent, follow);
}

//------------------------------------------------------------------------------
// Options and results

void bmtAddCommonOptions(CLI::App& command, bmtContext& context)
{
  command.add_flag("--json", context.Json, "Print the result as one JSON object, alone on standard output");
}

namespace
{
std::string ToText(const bmtJson& value)
{
  return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, bmtJson::error_handler_t::replace);
}

// The entries of a list, one line each.
void PrintList(std::ostream& out, const bmtJson& list, const std::string& indent)
{
  for (const bmtJson& item : list)
  {
    const char* separator = "- ";
    out << indent;
    for (const auto& [name, entry] : item.items())
    {
      out << separator << name << ": " << ToText(entry);
      separator = ", ";
    }
    out << "\n";
  }
}

void PrintLines(std::ostream& out, const bmtJson& value, const std::string& indent)
{
  for (const auto& [name, entry] : value.items())
  {
    const bool isList = entry.is_array() && !entry.empty() && entry.front().is_object();
    const bool isObject = entry.is_object() && !entry.empty();
    out << indent << name << ":" << (isList || isObject ? "" : " " + ToText(entry)) << "\n";
    if (isList)
    {
      PrintList(out, entry, indent + "  ");
    }
    else if (isObject)
    {
      PrintLines(out, entry, indent + "  ");
    }
  }
}
}

void bmtPrint(const bmtContext& context, const bmtJson& result)
{
  if (context.Json)
  {
    // Names in files may hold any bytes; what is no UTF-8 is replaced rather than thrown at.
    std::cout << result.dump(2, ' ', false, bmtJson::error_handler_t::replace) << "\n";
  }
  else
  {
    PrintLines(std::cout, result, "");
  }
  bmtFinishOutput();
}

void bmtFinishOutput()
{
  std::cout.flush();
  if (!std::cout)
  {
    throw bmtError("the result cannot be written to standard output; is the disk full or the pipe closed?");
  }
}

//------------------------------------------------------------------------------
// Files

void bmtRequireWritable(const std::string& path)
{
  std::string error;
  if (!vtkMTFileAccess::CanWrite(path, error))
  {
    throw bmtError(error);
  }
}

std::string bmtGetEnding(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}
