// SPDX-License-Identifier: BSD-3-Clause
// Builds a small Multi-Triangulation with installed headers and libraries, and checks what came out.
#include "vtkMTValidate.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"

#include <vtkNew.h>
#include <vtkSphereSource.h>

#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputConnection(sphere->GetOutputPort());
  builder->SetPatchTriangles(100);
  builder->Update();

  auto* model = vtkMultiTriangulation::SafeDownCast(builder->GetOutput());
  if (!model || !model->GetSource())
  {
    std::cerr << "no model\n";
    return 1;
  }
  const vtkMTValidate::Result result = vtkMTValidate::All(*model->GetSource(), 20, 1);
  for (const vtkMTValidate::Finding& finding : result.Findings)
  {
    std::cerr << finding.Check << ": " << finding.What << "\n";
  }
  std::cout << model->GetNumberOfFinestTriangles() << " triangles, " << model->GetNumberOfPatches() << " patches, "
            << model->GetNumberOfLevels() << " levels, " << result.Violations << " violations\n";
  return model->GetNumberOfLevels() > 2 && result.IsValid() ? 0 : 1;
}
