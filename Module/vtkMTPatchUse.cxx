// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchUse.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"

namespace
{
enum StateType
{
  Unused = 1, // by some consumer
  Warned = 2
};

vtkInformationIntegerKey* GetUses()
{
  static vtkInformationIntegerKey* const key = vtkInformationIntegerKey::MakeKey("USES_PATCHES", "vtkMTPatchUse");
  return key;
}

vtkInformationIntegerKey* GetState()
{
  static vtkInformationIntegerKey* const key = vtkInformationIntegerKey::MakeKey("STATE", "vtkMTPatchUse");
  return key;
}

bool HoldsCoarsest(vtkMultiTriangulation* model)
{
  const std::shared_ptr<const vtkMTPatchSource> source = model ? model->GetSource() : nullptr;
  return source && model->GetNumberOfLevels() > 1 &&
    static_cast<std::uint64_t>(model->GetNumberOfCells()) == source->GetKnownGraph().GetNumberOfRootTriangles();
}
}

//------------------------------------------------------------------------------
void vtkMTPatchUse::Announce(vtkInformationVector** inputs)
{
  if (vtkInformation* info = inputs[0]->GetInformationObject(0))
  {
    info->Set(GetUses(), 1);
  }
}

//------------------------------------------------------------------------------
void vtkMTPatchUse::Check(vtkAlgorithm* producer, vtkInformationVector* outputs, int port)
{
  vtkInformation* info = port >= 0 ? outputs->GetInformationObject(port) : nullptr;
  if (!info)
  {
    return;
  }
  if (info->Has(GetUses()))
  {
    info->Remove(GetUses());
    return;
  }
  if (!info->Has(GetState()))
  {
    info->Set(GetState(), Unused);
  }
  vtkMTPatchUse::Warn(producer, outputs);
}

//------------------------------------------------------------------------------
void vtkMTPatchUse::Warn(vtkAlgorithm* producer, vtkInformationVector* outputs)
{
  vtkInformation* info = outputs->GetInformationObject(0);
  vtkMultiTriangulation* model = vtkMultiTriangulation::GetData(outputs);
  if (!info->Has(GetState()) || info->Get(GetState()) == Warned || !HoldsCoarsest(model))
  {
    return;
  }
  info->Set(GetState(), Warned);
  vtkWarningWithObjectMacro(producer,
    "A filter that knows polydata alone works on the coarsest cut, of "
      << model->GetNumberOfCells() << " triangles, where the finest level has " << model->GetNumberOfFinestTriangles()
      << ". A vtkMultiTriangulationCutFilter before it gives it a finer one; so does "
         "vtkMultiTriangulationReader::SetOutputError.");
}
