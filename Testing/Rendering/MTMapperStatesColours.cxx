// SPDX-License-Identifier: BSD-3-Clause
// Colours from arrays, tables and textures.
#include "MTMapperStates.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"
#include "vtkVariant.h"

void MTMapperStates::MakeTexture(vtkTexture* texture)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < 16; ++j)
  {
    for (int i = 0; i < 16; ++i)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
      pixel[0] = static_cast<unsigned char>(16 * i);
      pixel[1] = static_cast<unsigned char>(16 * j);
      pixel[2] = (i + j) % 2 ? 200 : 40;
    }
  }
  texture->SetInputData(image);
  texture->InterpolateOn();
}

void MTMapperStates::AddColours()
{
  this->Add("ActiveScalars", [](MTScene& scene) { scene.Mapper->SetScalarRange(-0.15, 0.15); });
  this->Add("PointArrayByName",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray("TCoords");
      scene.Mapper->SetScalarRange(0.0, 1.0);
    });
  this->Add("CellArrayByName",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
      scene.Mapper->SetScalarRange(0.0, 63.0);
    });
  this->Add("DirectColors",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray("Color");
      scene.Mapper->SetColorModeToDirectScalars();
      scene.Actor->ForceOpaqueOn();
    });
  this->Add("DirectColorsTranslucent",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray("Color");
      scene.Mapper->SetColorModeToDirectScalars();
      scene.Renderer->UseDepthPeelingOn();
      scene.Renderer->SetMaximumNumberOfPeels(20);
      scene.Window->SetAlphaBitPlanes(1);
    });
  this->Add("ScalarsThroughTexture",
    [](MTScene& scene)
    {
      scene.Mapper->InterpolateScalarsBeforeMappingOn();
      scene.Mapper->SetScalarRange(-0.1, 0.1);
    });
  this->Add("OwnLookupTable",
    [](MTScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->SetNumberOfTableValues(7);
      table->SetHueRange(0.6, 0.0);
      table->SetRange(-0.1, 0.12);
      table->Build();
      scene.Mapper->SetLookupTable(table);
      scene.Mapper->UseLookupTableScalarRangeOn();
    });
  this->Add("Textured",
    [](MTScene& scene)
    {
      Plain(scene);
      vtkNew<vtkTexture> texture;
      MakeTexture(texture);
      scene.Actor->SetTexture(texture);
    });
  this->Add("FlatPointScalars",
    [](MTScene& scene)
    {
      scene.Actor->GetProperty()->SetInterpolationToFlat();
      scene.Mapper->SetScalarRange(-0.15, 0.15);
    });
  this->Add("OpacityOfCells",
    [](MTScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->SetAlphaRange(0.1, 0.9);
      table->SetRange(0.0, 63.0);
      table->Build();
      scene.Mapper->SetLookupTable(table);
      scene.Mapper->UseLookupTableScalarRangeOn();
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
      scene.Renderer->UseDepthPeelingOn();
      scene.Renderer->SetMaximumNumberOfPeels(20);
      scene.Window->SetAlphaBitPlanes(1);
    });
  this->Add("OneComponent",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->ColorByArrayComponent("TCoords", 1);
      scene.Mapper->GetLookupTable()->SetVectorModeToComponent();
      scene.Mapper->GetLookupTable()->SetVectorComponent(1);
      scene.Mapper->SetScalarRange(0.0, 1.0);
    });
  this->Add("Magnitude",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray("TCoords");
      scene.Mapper->GetLookupTable()->SetVectorModeToMagnitude();
      scene.Mapper->SetScalarRange(0.0, 1.5);
    });
  this->Add("ArrayByNumber",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectColorArray(0);
      scene.Mapper->SetScalarRange(-0.15, 0.15);
    });
  this->Add("FieldDataTuple",
    [](MTScene& scene)
    {
      vtkNew<vtkFloatArray> kinds;
      kinds->SetName("Kind");
      for (const float kind : { 0.0f, 1.0f, 2.0f, 3.0f })
      {
        kinds->InsertNextValue(kind);
      }
      scene.Mapper->GetInputAsDataSet()->GetFieldData()->AddArray(kinds);
      scene.Mapper->SetScalarModeToUseFieldData();
      scene.Mapper->SelectColorArray("Kind");
      scene.Mapper->SetFieldDataTupleId(1);
      scene.Mapper->SetScalarRange(0.0, 3.0);
    });
  this->Add("Logarithmic",
    [](MTScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->SetScaleToLog10();
      table->SetRange(1.0, 63.0);
      table->Build();
      scene.Mapper->SetLookupTable(table);
      scene.Mapper->UseLookupTableScalarRangeOn();
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
    });
  this->Add("Categories",
    [](MTScene& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->IndexedLookupOn();
      table->SetNumberOfTableValues(5);
      for (int i = 0; i < 5; ++i)
      {
        table->SetTableValue(i, 0.2 * i, 1.0 - 0.2 * i, i % 2);
        table->SetAnnotation(vtkVariant(i * 9), "block");
      }
      table->SetNanColor(0.3, 0.3, 0.3, 1.0);
      scene.Mapper->SetLookupTable(table);
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
    });
  this->Add("TexturedWithScalars",
    [](MTScene& scene)
    {
      scene.Mapper->SetScalarRange(-0.15, 0.15);
      vtkNew<vtkTexture> texture;
      MakeTexture(texture);
      scene.Actor->SetTexture(texture);
    });
}
