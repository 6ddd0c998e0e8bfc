// SPDX-License-Identifier: BSD-3-Clause
// What the tests of Filters/General share: models, a source that counts, errors kept off the terminal.
#ifndef MTGeneralTest_h
#define MTGeneralTest_h

#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"

#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>

namespace MTGeneralTest
{
/// Hands everything on and counts what is read.
class CountingSource : public vtkMTPatchSource
{
public:
  explicit CountingSource(std::shared_ptr<const vtkMTPatchSource> source)
    : Source(std::move(source))
  {
  }
  const vtkMTGraph& GetGraph() const override { return this->Source->GetGraph(); }
  bool ReadPatch(
    std::uint32_t arc, const std::vector<unsigned char>* arrays, vtkMTPatch& patch, std::string& error) const override
  {
    ++this->Reads;
    if (this->IsBroken)
    {
      error = "broken on purpose";
      return false;
    }
    return this->Source->ReadPatch(arc, arrays, patch, error);
  }
  std::uint64_t GetPatchSize(std::uint32_t arc) const override { return this->Source->GetPatchSize(arc); }
  std::string GetName() const override { return "counting"; }

  mutable std::atomic<int> Reads{ 0 };
  bool IsBroken = false;

private:
  std::shared_ptr<const vtkMTPatchSource> Source;
};

/// Counts events of one kind, which then do not reach the terminal, and keeps their text.
class Events
{
public:
  explicit Events(vtkObject* object, unsigned long event = vtkCommand::ErrorEvent)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        auto* events = static_cast<Events*>(self);
        ++events->Count;
        events->Text += text ? static_cast<const char*>(text) : "";
      });
    object->AddObserver(event, this->Command);
    if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
    {
      algorithm->GetExecutive()->AddObserver(event, this->Command);
    }
  }
  int Count = 0;
  std::string Text;

private:
  vtkNew<vtkCallbackCommand> Command;
};

inline vtkSmartPointer<vtkMultiTriangulation> MakeModel(std::shared_ptr<const vtkMTPatchSource> source)
{
  auto model = vtkSmartPointer<vtkMultiTriangulation>::New();
  EXPECT_TRUE(model->SetSource(std::move(source)));
  return model;
}

/// 20,480 triangles of a bumpy sphere, built, without arrays but the cells' ids; the same object for all tests.
inline vtkMultiTriangulation* GetSphere()
{
  static const vtkSmartPointer<vtkMultiTriangulation> model = []
  {
    vtkNew<vtkMultiTriangulationBuilder> builder;
    builder->SetInputData(MTTestMeshes::FractalSphere(5));
    builder->SetPatchTriangles(100);
    builder->MakeNormalsOff();
    builder->Update();
    return vtkSmartPointer<vtkMultiTriangulation>(vtkMultiTriangulation::SafeDownCast(builder->GetOutputDataObject(0)));
  }();
  return model;
}

/// The enclosed volume times 6, by the triangles' orientation.
inline double GetVolume(vtkPolyData* mesh)
{
  double sum = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    double p[3][3];
    for (int i = 0; i < 3; ++i)
    {
      mesh->GetPoint(ids->GetId(i), p[i]);
    }
    sum += vtkMath::Determinant3x3(p[0], p[1], p[2]);
  }
  return sum;
}
}

#endif
