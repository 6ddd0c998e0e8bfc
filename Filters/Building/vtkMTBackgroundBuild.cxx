// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBackgroundBuild.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkMTBuildError.h"
#include "vtkMTBuildInput.h"
#include "vtkMTBuildWorkspace.h"
#include "vtkMTFileSpoolStore.h"
#include "vtkMTOutputFile.h"
#include "vtkMTStreamPreview.h"
#include "vtkMTTriangleStream.h"
#include "vtkMultiTriangulationFileBuilder.h"
#include "vtkNew.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <unistd.h>

namespace
{
using Builder = vtkMultiTriangulationFileBuilder;
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds FirstPreview(1500); // what there is by then is shown; after twice that, and so on
constexpr std::chrono::milliseconds ProgressStep(250);
constexpr std::uint64_t SortingMemory = 64 << 20;
constexpr int Niceness = 10; // the window comes first

/// What the child does for one mesh.
class Worker
{
public:
  Worker(const vtkMTInputSettings& input, std::size_t index, std::string folder, std::string output,
    const vtkMTChildProcess::Report& report)
    : Input(input)
    , Index(index)
    , Folder(std::move(folder))
    , Output(std::move(output))
    , Report(report)
  {
  }

  // Without one the mesh is seen when it is built; what is wrong with it the builder says.
  void MakePreview()
  {
    vtkMTFileSpoolStore store;
    std::string problem;
    vtkMTBuildError error;
    if (vtkMTChildProcess::IsAskedToEnd() || !store.OpenFolder(this->Folder + "/spools", problem))
    {
      return;
    }
    this->Say(vtkMTBuildEvent::Progress, "reading");
    vtkMTBuildInput input(this->Input, [] { return !vtkMTChildProcess::IsAskedToEnd(); });
    const std::unique_ptr<vtkMTTriangleStream> stream = input.Open(store, SortingMemory, error);
    vtkMTStreamPreview preview;
    auto pause = FirstPreview;
    auto next = Clock::now() + pause;
    const auto goesOn = [&]
    {
      if (Clock::now() > next)
      {
        this->Show(preview);
        pause *= 2;
        next = Clock::now() + pause;
      }
      return !vtkMTChildProcess::IsAskedToEnd();
    };
    if (stream && preview.Read(*stream, goesOn, problem))
    {
      this->Show(preview);
    }
    store.Clear();
  }

  void Build()
  {
    if (vtkMTChildProcess::IsAskedToEnd())
    {
      return;
    }
    vtkNew<Builder> builder;
    this->Configure(builder);
    const vtkNew<vtkCallbackCommand> quiet; // the event says it
    builder->AddObserver(vtkCommand::ErrorEvent, quiet);
    builder->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet);
    vtkNew<vtkCallbackCommand> follow;
    follow->SetClientData(this);
    follow->SetCallback([](vtkObject* caller, unsigned long, void* self, void*)
      { static_cast<Worker*>(self)->Follow(static_cast<Builder*>(caller)); });
    builder->AddObserver(vtkCommand::ProgressEvent, follow);
    if (builder->Write())
    {
      this->Say(vtkMTBuildEvent::Model, this->Output);
    }
    else
    {
      this->Say(vtkMTBuildEvent::Failure, std::to_string(builder->GetErrorCode()) + " " + builder->GetErrorMessage());
    }
  }

private:
  void Say(char kind, const std::string& text) { this->Report(kind + std::to_string(this->Index) + " " + text); }

  void Configure(Builder* builder) const
  {
    for (const std::string& path : this->Input.Paths)
    {
      builder->AddFileName(path.c_str());
    }
    if (this->Input.IsoValue)
    {
      builder->SetIsoValue(*this->Input.IsoValue);
    }
    builder->SetGradientNormals(this->Input.GradientNormals);
    builder->SetVerticalScale(this->Input.VerticalScale);
    builder->SetDegrees(this->Input.Degrees);
    builder->SetOutputFileName(this->Output.c_str());
    builder->SetMemoryLimit(Builder::GetDefaultMemoryLimit());
    builder->ResumeOn();
  }

  void Show(const vtkMTStreamPreview& preview)
  {
    if (preview.GetNumberOfClusters() == 0)
    {
      return;
    }
    vtkNew<vtkPolyData> mesh;
    preview.Make(mesh);
    const std::string path =
      this->Folder + "/" + std::to_string(this->Index) + "-" + std::to_string(this->Previews++) + ".vtp";
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(path.c_str());
    writer->SetInputData(mesh);
    writer->SetCompressorTypeToNone();
    writer->EncodeAppendedDataOff();
    if (writer->Write())
    {
      this->Say(vtkMTBuildEvent::Preview, path);
    }
  }

  void Follow(Builder* builder)
  {
    if (vtkMTChildProcess::IsAskedToEnd())
    {
      builder->AbortExecuteOn();
    }
    if (Clock::now() > this->NextProgress)
    {
      this->NextProgress = Clock::now() + ProgressStep;
      const char* step = builder->GetProgressText();
      char text[200];
      std::snprintf(text, sizeof(text), "building, %.0f %%%s%s", 100.0 * builder->GetProgress(), step ? ", " : "",
        step ? step : "");
      this->Say(vtkMTBuildEvent::Progress, text);
    }
  }

  const vtkMTInputSettings& Input;
  const std::size_t Index;
  const std::string Folder;
  const std::string Output;
  const vtkMTChildProcess::Report& Report;
  int Previews = 0;
  Clock::time_point NextProgress;
};
}

vtkMTBackgroundBuild::vtkMTBackgroundBuild() = default;

//------------------------------------------------------------------------------
vtkMTBackgroundBuild::~vtkMTBackgroundBuild()
{
  const bool wasRunning = this->Child.IsRunning();
  this->Child.End();
  if (wasRunning && !this->Output.empty())
  {
    // Of a child that had to be killed.
    vtkMTOutputFile::RemoveStrays(this->Output);
    const std::string folder = vtkMTBuildWorkspace::GetFolder(this->Output, "");
    if (!vtkMTFileSpoolStore::HasState(folder))
    {
      vtkMTFileSpoolStore::RemoveFiles(folder);
    }
  }
  std::error_code ignored;
  if (!this->Folder.empty())
  {
    std::filesystem::remove_all(this->Folder, ignored);
  }
}

//------------------------------------------------------------------------------
bool vtkMTBackgroundBuild::Start(
  const std::vector<vtkMTInputSettings>& meshes, const std::string& output, std::string& error)
{
  error.clear();
  if (!this->IsDone.empty() || meshes.empty())
  {
    return this->IsDone.empty();
  }
  std::error_code code;
  this->Folder = (std::filesystem::temp_directory_path(code) / "bmt-build-XXXXXX").string();
  if (code || !mkdtemp(this->Folder.data()))
  {
    error = "no temporary folder can be made (TMPDIR says where): " + (code ? code.message() : std::strerror(errno));
    this->Folder.clear();
    return false;
  }
  this->Output = output;
  const auto work = [&](const vtkMTChildProcess::Report& report)
  {
    const int niceness = nice(Niceness);
    static_cast<void>(niceness);
    std::vector<Worker> workers;
    for (std::size_t i = 0; i < meshes.size(); ++i)
    {
      workers.emplace_back(
        meshes[i], i, this->Folder, output.empty() ? this->Folder + "/" + std::to_string(i) + ".bmt" : output, report);
    }
    std::for_each(workers.begin(), workers.end(), [](Worker& worker) { worker.MakePreview(); });
    std::for_each(workers.begin(), workers.end(), [](Worker& worker) { worker.Build(); });
    return 0;
  };
  if (!this->Child.Start(work, error))
  {
    return false;
  }
  this->IsDone.assign(meshes.size(), false);
  this->Unfinished = meshes.size();
  return true;
}

//------------------------------------------------------------------------------
vtkMTBuildEvent vtkMTBackgroundBuild::ToEvent(const std::string& line) const
{
  const std::size_t blank = line.find(' ');
  vtkMTBuildEvent event{ static_cast<vtkMTBuildEvent::KindType>(line[0]), std::stoul(line.substr(1, blank - 1)),
    line.substr(blank + 1), nullptr, 0 };
  if (event.Kind == vtkMTBuildEvent::Preview)
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(event.Text.c_str());
    reader->Update();
    event.Mesh = reader->GetOutput();
    std::remove(event.Text.c_str());
  }
  else if (event.Kind == vtkMTBuildEvent::Failure)
  {
    std::size_t digits = 0;
    event.Code = std::stoul(event.Text, &digits);
    event.Text.erase(0, digits + 1);
  }
  return event;
}

//------------------------------------------------------------------------------
std::vector<vtkMTBuildEvent> vtkMTBackgroundBuild::Poll()
{
  std::vector<vtkMTBuildEvent> events;
  for (const std::string& line : this->Child.TakeLines())
  {
    events.push_back(this->ToEvent(line));
    const vtkMTBuildEvent& event = events.back();
    if (event.Kind == vtkMTBuildEvent::Model || event.Kind == vtkMTBuildEvent::Failure)
    {
      this->IsDone[event.Index] = true;
      --this->Unfinished;
    }
  }
  for (std::size_t i = 0; i < this->IsDone.size() && !this->Child.IsRunning(); ++i)
  {
    if (!this->IsDone[i])
    {
      this->IsDone[i] = true;
      --this->Unfinished;
      events.push_back({ vtkMTBuildEvent::Failure, i,
        "the build ended with code " + std::to_string(this->Child.GetExitCode()) + "; was there too little memory?",
        nullptr, 0 });
    }
  }
  return events;
}
