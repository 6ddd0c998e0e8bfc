// SPDX-License-Identifier: BSD-3-Clause
// Filters that know polydata alone get the coarsest cut, and a warning says so once.
#include "MTIOTest.h"
#include "MTTestModel.h"

#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationReader.h"
#include "vtkMultiTriangulationWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"

#include <string>

using namespace MTIOTest;

namespace
{
class Unaware : public vtkPolyDataAlgorithm
{
public:
  static Unaware* New();
  vtkTypeMacro(Unaware, vtkPolyDataAlgorithm);

protected:
  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    vtkPolyData::GetData(outputs)->vtkPolyData::ShallowCopy(vtkPolyData::GetData(inputs[0]));
    return 1;
  }
};
vtkStandardNewMacro(Unaware);

class Aware : public Unaware
{
public:
  static Aware* New();
  vtkTypeMacro(Aware, Unaware);
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs,
    int port, vtkMTimeType* time) override
  {
    vtkMultiTriangulation::AnnounceUse(inputs);
    return this->Superclass::ComputePipelineMTime(request, inputs, outputs, port, time);
  }
};
vtkStandardNewMacro(Aware);

// A reader of a model of several levels, and what it warns of.
class PatchUse : public testing::Test
{
protected:
  PatchUse()
  {
    WriteFile(this->Place / "model.bmt", StoreModel(*MTTestModel::MakeTube()));
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        ++static_cast<PatchUse*>(self)->Warnings;
        static_cast<PatchUse*>(self)->Text = static_cast<const char*>(text);
      });
    this->Reader->AddObserver(vtkCommand::WarningEvent, this->Command);
    this->Reader->SetFileName((this->Place / "model.bmt").c_str());
  }

  template <typename Filter>
  void Run()
  {
    vtkNew<Filter> filter;
    filter->SetInputConnection(this->Reader->GetOutputPort());
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), this->Reader->GetOutput()->GetNumberOfCells());
  }

  const Folder Place;
  vtkNew<vtkMultiTriangulationReader> Reader;
  vtkNew<vtkCallbackCommand> Command;
  int Warnings = 0;
  std::string Text;
};
}

TEST_F(PatchUse, FilterThatKnowsPolyDataAloneIsWarnedOfOnce)
{
  this->Run<Unaware>();
  EXPECT_EQ(this->Warnings, 1);
  std::cout << this->Text;
  const std::string cells = std::to_string(this->Reader->GetOutput()->GetNumberOfCells());
  EXPECT_NE(this->Text.find("coarsest cut, of " + cells + " triangles"), std::string::npos) << this->Text;
  EXPECT_NE(this->Text.find("vtkMultiTriangulationCutFilter"), std::string::npos);
  EXPECT_NE(this->Text.find("SetOutputError"), std::string::npos);
  this->Run<Unaware>(); // the first one is no more
  this->Reader->Modified();
  this->Run<Unaware>();
  EXPECT_EQ(this->Warnings, 1);
}

TEST_F(PatchUse, FilterThatComesAfterTheReaderHasRunIsFoundToo)
{
  this->Reader->Update();
  this->Run<Aware>();
  EXPECT_EQ(this->Warnings, 0);
  this->Run<Unaware>();
  EXPECT_EQ(this->Warnings, 1);
}

TEST_F(PatchUse, WhoUsesThePatchesIsNotWarnedOf)
{
  vtkNew<Aware> aware;
  aware->SetInputConnection(this->Reader->GetOutputPort());
  this->Reader->Update(); // connected, but it is not the filter that asks
  aware->Update();
  aware->Modified();
  aware->Update();
  vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputConnection(this->Reader->GetOutputPort());
  writer->SetFileName((this->Place / "copy.bmt").c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(this->Warnings, 0) << this->Text;
}

TEST_F(PatchUse, WhereTheCutWasChosenThereIsNoWarning)
{
  this->Reader->SetOutputError(0.0);
  this->Run<Unaware>();
  EXPECT_EQ(this->Warnings, 0) << this->Text;
}
