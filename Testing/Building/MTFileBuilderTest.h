// SPDX-License-Identifier: BSD-3-Clause
// What the tests of vtkMultiTriangulationFileBuilder share: a folder with a sphere in it, and what was observed.
#ifndef MTFileBuilderTest_h
#define MTFileBuilderTest_h

#include "MTIOTest.h"

#include "vtkMTFractalSphere.h"
#include "vtkMTMeshWriter.h"
#include "vtkMultiTriangulationFileBuilder.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

class MTFileBuilderTest : public testing::Test
{
protected:
  // What the builder tells its observers; nothing goes to the output window.
  struct Events
  {
    std::vector<double> Fractions;
    std::vector<std::string> Texts;
    std::vector<std::string> Errors;
    std::vector<std::string> Warnings;
    std::function<bool()> AbortWhen = [] { return false; };
  };

  static void Record(vtkObject* caller, unsigned long event, void* client, void* data)
  {
    Events& events = *static_cast<Events*>(client);
    if (event == vtkCommand::ProgressEvent)
    {
      vtkAlgorithm* algorithm = vtkAlgorithm::SafeDownCast(caller);
      const double fraction = *static_cast<double*>(data);
      if (fraction == 1.0 && algorithm->GetAbortExecute())
      {
        return; // newer pipelines report the end of what was aborted as well
      }
      events.Fractions.push_back(fraction);
      events.Texts.emplace_back(algorithm->GetProgressText() ? algorithm->GetProgressText() : "");
      if (events.AbortWhen())
      {
        algorithm->AbortExecuteOn();
      }
      return;
    }
    (event == vtkCommand::ErrorEvent ? events.Errors : events.Warnings).emplace_back(static_cast<const char*>(data));
  }

  static void Observe(vtkMultiTriangulationFileBuilder* builder, Events& events)
  {
    const vtkNew<vtkCallbackCommand> record;
    record->SetCallback(Record);
    record->SetClientData(&events);
    for (const auto event : { vtkCommand::ProgressEvent, vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
    {
      builder->AddObserver(event, record);
    }
    const vtkNew<vtkCallbackCommand> quiet; // the executive's error is about ours
    builder->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, quiet);
  }

  void MakeSphere(std::uint64_t triangles, const std::string& name = "sphere.ply") const
  {
    vtkMTFractalSphere sphere(triangles);
    std::string error;
    ASSERT_TRUE(vtkMTMeshWriter::WritePly(sphere, this->Folder / name, error)) << error;
  }

  // From sphere.ply to the output, with small patches.
  void Configure(vtkMultiTriangulationFileBuilder* builder, const std::string& output = "out.bmt") const
  {
    builder->AddFileName((this->Folder / "sphere.ply").c_str());
    builder->SetOutputFileName((this->Folder / output).c_str());
    builder->SetPatchTriangles(200);
  }

  MTIOTest::Folder Folder;
};

#endif
