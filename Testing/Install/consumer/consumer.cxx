// SPDX-License-Identifier: BSD-3-Clause
// consumer FILE: builds a small Multi-Triangulation with the installed headers and libraries, writes it and checks what
// is in the file.
#include <vtkMTValidate.h>
#include <vtkMTVersion.h>
#include <vtkMultiTriangulation.h>
#include <vtkMultiTriangulationBuilder.h>
#include <vtkMultiTriangulationReader.h>
#include <vtkMultiTriangulationWriter.h>

#include <vtkNew.h>
#include <vtkSphereSource.h>

#include <iostream>
#include <string>

#if MT_VERSION_NUMBER < MT_VERSION_CHECK(0, 1, 0)
#error "vtkMTVersion.h gives no version"
#endif

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: consumer FILE\n";
    return 2;
  }
  if (std::string(vtkMTVersion::GetVersion()) != MT_VERSION)
  {
    std::cerr << "compiled against " << MT_VERSION << ", runs with " << vtkMTVersion::GetVersion() << "\n";
    return 1;
  }
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputConnection(sphere->GetOutputPort());
  builder->SetPatchTriangles(100);
  vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputConnection(builder->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();

  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  vtkMultiTriangulation* model = reader->GetOutput();
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
