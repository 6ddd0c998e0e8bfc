// SPDX-License-Identifier: BSD-3-Clause
// Colours of the data of any type, ids with names and colours, and elevations: as vtkPolyDataMapper draws them.
#include "MTGridModel.h"
#include "MTPicture.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkElevationFilter.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkMTPatchStore.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationBuilder.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace
{
vtkSmartPointer<vtkPolyData> MakeSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(60);
  source->SetPhiResolution(40);
  source->Update();
  vtkSmartPointer<vtkPolyData> mesh = source->GetOutput();
  mesh->GetPointData()->Initialize();
  return mesh;
}

vtkSmartPointer<vtkMultiTriangulation> Build(vtkPolyData* mesh)
{
  vtkNew<vtkMultiTriangulationBuilder> builder;
  builder->SetInputData(mesh);
  builder->SetPatchTriangles(200);
  builder->Update();
  return vtkMultiTriangulation::SafeDownCast(builder->GetOutputDataObject(0));
}

// Bytes that differ from tuple to tuple, times a factor.
vtkSmartPointer<vtkDataArray> MakeColors(int type, int components, double factor, vtkIdType tuples)
{
  auto colors = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  colors->SetNumberOfComponents(components);
  colors->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    const std::array<double, 4> bytes{ 255.0 * ((i * 7) % 52) / 51.0, 5.0 * ((i * 13) % 52), i % 2 ? 200.0 : 30.0,
      i % 3 ? 255.0 : 60.0 };
    for (int c = 0; c < components; ++c)
    {
      colors->SetComponent(i, c, factor * std::floor(bytes[static_cast<std::size_t>(c)]));
    }
  }
  return colors;
}

MTDifference CompareWithCut(
  MTScene& scene, vtkMultiTriangulationMapper* mapper, vtkPolyDataMapper* reference, const std::string& name)
{
  MTScene plain(reference);
  for (MTScene* each : { &scene, &plain })
  {
    // The builder makes normals, which the mesh of the reference has not.
    each->Actor->GetProperty()->LightingOff();
    each->Renderer->ResetCamera();
    each->Renderer->GetActiveCamera()->Elevation(-40.0);
    each->Renderer->ResetCameraClippingRange();
  }
  plain.Renderer->GetActiveCamera()->DeepCopy(scene.Renderer->GetActiveCamera());
  const auto picture = scene.Render();
  const auto expected = plain.Render();
  MTWritePicture(picture, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Colors" + name + ".png");
  MTWritePicture(expected, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/Colors" + name + "Expected.png");
  const MTDifference difference = MTDifference::Compare(picture, expected);
  std::cout << name << ": " << mapper->GetNumberOfTriangles() << " triangles, " << difference << "\n";
  return difference;
}

struct Kind
{
  std::string Name;
  int Type;
  int Components;
  double Factor; // times a byte
  bool OfCells;
  bool Active; // scalars
};

void PrintTo(const Kind& kind, std::ostream* os)
{
  *os << kind.Name;
}

class ColorsOfTheData : public ::testing::TestWithParam<Kind>
{
};

TEST_P(ColorsOfTheData, AreDrawnAsVtkDrawsTheirBytes)
{
  const Kind& kind = GetParam();
  const auto mesh = MakeSphere();
  vtkDataSetAttributes* data = mesh->GetAttributes(kind.OfCells ? vtkDataObject::CELL : vtkDataObject::POINT);
  const vtkIdType tuples = kind.OfCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  const auto colors = MakeColors(kind.Type, kind.Components, kind.Factor, tuples);
  colors->SetName("COLOR_0");
  data->AddArray(colors);
  if (kind.Active)
  {
    data->SetScalars(colors);
  }
  const auto model = Build(mesh);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(model);
  mapper->SetPixelError(0.0);
  MTScene scene(mapper);

  // The same mesh with bytes, drawn by VTK.
  const auto bytes = MakeColors(VTK_UNSIGNED_CHAR, kind.Components, 1.0, tuples);
  data->Initialize();
  data->SetScalars(bytes);
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  for (const bool chosen : { false, true })
  {
    if (chosen)
    {
      mapper->ScalarVisibilityOff();
      EXPECT_TRUE(mapper->SelectColors());
      EXPECT_STREQ(mapper->GetArrayName(), "COLOR_0");
      EXPECT_TRUE(mapper->GetScalarVisibility());
    }
    EXPECT_EQ(mapper->HasTranslucentPolygonalGeometry(), reference->HasTranslucentPolygonalGeometry());
    const MTDifference difference = CompareWithCut(scene, mapper, reference, kind.Name);
    EXPECT_GT(difference.Drawn, 10000u);
    // Without blending in order, what is translucent depends on the order of the triangles.
    EXPECT_LE(difference.ClearlyOff, kind.Components == 4 ? difference.Drawn / 20 : difference.Drawn / 500);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, ColorsOfTheData,
  ::testing::Values(Kind{ "Bytes", VTK_UNSIGNED_CHAR, 3, 1.0, false, true },
    Kind{ "BytesNotActive", VTK_UNSIGNED_CHAR, 3, 1.0, false, false },
    Kind{ "Bytes4", VTK_UNSIGNED_CHAR, 4, 1.0, false, true },
    Kind{ "Words", VTK_UNSIGNED_SHORT, 3, 257.0, false, true },
    Kind{ "Words4", VTK_UNSIGNED_SHORT, 4, 257.0, false, false },
    Kind{ "SmallWords", VTK_UNSIGNED_SHORT, 3, 1.0, false, true }, Kind{ "Ints", VTK_INT, 3, 1.0, false, true },
    Kind{ "Floats", VTK_FLOAT, 3, 1.0 / 255.0, false, true }, Kind{ "Floats4", VTK_FLOAT, 4, 1.0 / 255.0, false, true },
    Kind{ "FloatsTo255", VTK_FLOAT, 3, 1.0, false, false }, Kind{ "Doubles", VTK_DOUBLE, 3, 1.0 / 255.0, false, false },
    Kind{ "CellBytes", VTK_UNSIGNED_CHAR, 3, 1.0, true, true },
    Kind{ "CellWords", VTK_UNSIGNED_SHORT, 3, 257.0, true, false },
    Kind{ "CellFloats4", VTK_FLOAT, 4, 1.0 / 255.0, true, true }),
  [](const ::testing::TestParamInfo<Kind>& info) { return info.param.Name; });

TEST(Colors, ValuesThatAreNoColoursAreMappedAndAskingForColoursSaysThereAreNone)
{
  const auto mesh = MakeSphere();
  const auto velocity = MakeColors(VTK_FLOAT, 3, 1.0 / 255.0, mesh->GetNumberOfPoints());
  velocity->SetName("Velocity");
  mesh->GetPointData()->SetScalars(velocity);
  const auto model = Build(mesh);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  EXPECT_FALSE(mapper->SelectColors());
  mapper->SetInputData(model);
  mapper->SetPixelError(0.0);
  EXPECT_FALSE(mapper->SelectColors());
  EXPECT_EQ(mapper->GetScalarMode(), VTK_SCALAR_MODE_DEFAULT);
  MTScene scene(mapper);
  vtkNew<vtkPolyDataMapper> reference;
  reference->SetInputData(mesh);
  EXPECT_LE(CompareWithCut(scene, mapper, reference, "Velocity").ClearlyOff, 20u);
}

// Four groups of cells, in sectors.
void AddGroups(vtkPolyData* mesh, int type)
{
  vtkNew<vtkLookupTable> table;
  table->IndexedLookupOn();
  table->SetNumberOfTableValues(4);
  const std::array<std::array<double, 3>, 4> colors{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 },
    { 1.0, 1.0, 0.0 } } };
  for (int i = 0; i < 4; ++i)
  {
    const auto& color = colors[static_cast<std::size_t>(i)];
    table->SetTableValue(i, color[0], color[1], color[2]);
    table->SetAnnotation(vtkVariant(10 * i + 3), "group " + std::to_string(i));
  }
  auto ids = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  ids->SetName("MaterialIds");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    mesh->GetCellBounds(cell, bounds);
    ids->InsertNextTuple1(10.0 * ((bounds[0] + bounds[1] > 0.0 ? 1 : 0) + (bounds[2] + bounds[3] > 0.0 ? 2 : 0)) + 3.0);
  }
  ids->SetLookupTable(table);
  mesh->GetCellData()->AddArray(ids);
}

std::set<std::tuple<int, int, int>> GetColors(vtkImageData* picture)
{
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  std::set<std::tuple<int, int, int>> colors;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    colors.emplace(pixels->GetTypedComponent(i, 0), pixels->GetTypedComponent(i, 1), pixels->GetTypedComponent(i, 2));
  }
  return colors;
}

TEST(Colors, IdsHaveTheColoursOfTheTableThatTheyCarryOnEveryLevel)
{
  for (const int type : { VTK_INT, VTK_UNSIGNED_CHAR, VTK_ID_TYPE })
  {
    const auto mesh = MakeSphere();
    AddGroups(mesh, type);
    const auto model = Build(mesh);
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputData(model);
    EXPECT_TRUE(mapper->SelectColors()); // the materials' colours
    EXPECT_STREQ(mapper->GetArrayName(), "MaterialIds");
    MTScene scene(mapper);
    scene.Actor->GetProperty()->LightingOff();
    scene.Renderer->ResetCamera();
    for (const double pixelError : { 0.0, 4.0, 100.0 })
    {
      mapper->SetPixelError(pixelError);
      const auto picture = scene.Render();
      MTWritePicture(picture, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/ColorsOfGroups.png");
      const auto colors = GetColors(picture);
      EXPECT_EQ(colors.size(), 5u) << "the background and four groups at " << pixelError;
      EXPECT_EQ(colors.count({ 255, 0, 0 }) + colors.count({ 0, 255, 0 }) + colors.count({ 0, 0, 255 }) +
          colors.count({ 255, 255, 0 }),
        4u);
    }
  }
}

vtkSmartPointer<vtkTexture> MakeTexture(unsigned char red, unsigned char green, unsigned char blue)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 4; ++i)
  {
    auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(i % 2, i / 2, 0));
    pixel[0] = red;
    pixel[1] = green;
    pixel[2] = blue;
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetBlendingMode(vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE);
  return texture;
}

TEST(Textures, CellsHaveThatOfTheirMaterialAndPart)
{
  const auto mesh = MakeSphere();
  AddGroups(mesh, VTK_INT);
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  places->SetNumberOfTuples(mesh->GetNumberOfPoints());
  places->Fill(0.5);
  mesh->GetPointData()->SetTCoords(places);
  vtkNew<vtkIntArray> parts;
  parts->SetName("PartId");
  parts->SetNumberOfValues(mesh->GetNumberOfCells());
  parts->Fill(5);
  mesh->GetCellData()->AddArray(parts);
  const auto model = Build(mesh);
  for (const int representation : { VTK_SURFACE, VTK_WIREFRAME })
  {
    vtkNew<vtkMultiTriangulationMapper> mapper;
    mapper->SetInputData(model);
    mapper->SetPixelError(0.5);
    MTScene scene(mapper);
    scene.Actor->GetProperty()->LightingOff();
    scene.Actor->GetProperty()->SetRepresentation(representation);
    scene.Renderer->ResetCamera();
    EXPECT_TRUE(mapper->SelectColors());
    const auto expected = scene.Render();

    mapper->ScalarVisibilityOff();
    const char* const names[4] = { "first", "second", "third", "fourth" };
    const std::array<std::array<unsigned char, 3>, 4> colors{ { { 255, 0, 0 }, { 0, 255, 0 }, { 0, 0, 255 },
      { 255, 255, 0 } } };
    for (std::size_t i = 0; i < 4; ++i)
    {
      scene.Actor->GetProperty()->SetTexture(names[i], MakeTexture(colors[i][0], colors[i][1], colors[i][2]));
      mapper->MapTextureToMaterial(names[i], static_cast<int>(10 * i + 3), i == 1 ? 5 : -1);
    }
    const auto picture = scene.Render();
    MTWritePicture(picture, std::string(MT_TEST_OUTPUT_DIRECTORY) + "/TexturesOfMaterials.png");
    const MTDifference difference = MTDifference::Compare(picture, expected);
    std::cout << difference << "\n";
    EXPECT_GT(difference.Drawn, 3000u);
    EXPECT_EQ(difference.ClearlyOff, 0u);
    // Of another part; and without mappings all are on all cells: red times green is black.
    mapper->MapTextureToMaterial("second", 13, 6);
    const auto other = GetColors(scene.Render());
    EXPECT_EQ(other.count({ 255, 255, 255 }), 1u);
    EXPECT_EQ(other.count({ 0, 255, 0 }), 0u);
    mapper->RemoveTextureMappings();
    const auto all = GetColors(scene.Render());
    EXPECT_EQ(all.count({ 0, 0, 0 }), 1u);
    EXPECT_EQ(all.size(), 2u);
  }
}

// Bytes with names beside colours: the ids' table does not get in the way of the colours.
TEST(Colors, ColoursComeBeforeMaterials)
{
  const auto mesh = MakeSphere();
  AddGroups(mesh, VTK_INT);
  const auto colors = MakeColors(VTK_UNSIGNED_CHAR, 3, 1.0, mesh->GetNumberOfPoints());
  colors->SetName("RGB");
  mesh->GetPointData()->AddArray(colors);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  mapper->SetInputData(Build(mesh));
  EXPECT_TRUE(mapper->SelectColors());
  EXPECT_STREQ(mapper->GetArrayName(), "RGB");
}

vtkSmartPointer<vtkMultiTriangulation> MakeGrid(bool moved)
{
  auto model = vtkSmartPointer<vtkMultiTriangulation>::New();
  EXPECT_TRUE(model->SetSource(MTGridModel().Make()));
  vtkNew<vtkTransform> transform;
  if (moved)
  {
    transform->Translate(2.0, 1.0, -3.0);
    transform->RotateX(30.0);
    transform->Scale(2.0, 1.0, 3.0);
  }
  EXPECT_TRUE(model->ApplyTransform(transform->GetMatrix()->GetData()));
  return model;
}

TEST(Elevation, IsWhatTheElevationFilterGivesOnEveryPatch)
{
  for (const bool moved : { false, true })
  {
    for (const bool throughTexture : { false, true })
    {
      const auto model = MakeGrid(moved);
      double box[6];
      model->GetModelBounds(box);
      const double low[3] = { box[0], box[2], box[4] + 0.3 * (box[5] - box[4]) };
      const double high[3] = { box[1], box[2], box[4] + 0.7 * (box[5] - box[4]) };
      const double range[2] = { 100.0, 250.0 };
      vtkNew<vtkMultiTriangulationMapper> mapper;
      mapper->SetInputData(model);
      mapper->SetPixelError(0.7);
      mapper->ScalarVisibilityOff(); // has nothing to do with it, as with the other colours of ColorBy
      mapper->SetInterpolateScalarsBeforeMapping(throughTexture);
      mapper->SetColorByElevation(low, high, range);
      EXPECT_EQ(mapper->GetScalarRange()[0], 100.0);
      MTScene scene(mapper);
      scene.Render();
      mapper->FreezeCutOn();
      vtkNew<vtkPolyData> cut;
      ASSERT_TRUE(mapper->GetCut(cut));
      vtkNew<vtkElevationFilter> elevation;
      elevation->SetInputData(cut);
      elevation->SetLowPoint(low[0], low[1], low[2]);
      elevation->SetHighPoint(high[0], high[1], high[2]);
      elevation->SetScalarRange(range[0], range[1]);
      vtkNew<vtkPolyDataMapper> reference;
      reference->SetInputConnection(elevation->GetOutputPort());
      reference->SetScalarRange(range[0], range[1]);
      reference->SetInterpolateScalarsBeforeMapping(throughTexture);
      const MTDifference difference = CompareWithCut(scene, mapper, reference,
        std::string("Elevation") + (moved ? "Moved" : "") + (throughTexture ? "Texture" : ""));
      EXPECT_GT(difference.Drawn, 5000u);
      EXPECT_LE(difference.ClearlyOff, difference.Drawn / 200);
      // It is what the settings say, and where the model stands.
      const auto before = scene.Render();
      const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
      scene.Render();
      EXPECT_EQ(mapper->GetNumberOfUploadedBytes(), uploaded);
      mapper->SetColorByElevation(high, low, range);
      EXPECT_GT(MTDifference::Compare(scene.Render(), before).ClearlyOff, difference.Drawn / 2);
    }
  }
}

struct Events
{
  int Warnings = 0;
  int Errors = 0;
  std::string Last;
};

void Count(vtkObject* object, Events& events)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&events);
  command->SetCallback(
    [](vtkObject*, unsigned long event, void* client, void* text)
    {
      auto* counted = static_cast<Events*>(client);
      ++(event == vtkCommand::ErrorEvent ? counted->Errors : counted->Warnings);
      counted->Last = static_cast<const char*>(text);
    });
  object->AddObserver(vtkCommand::WarningEvent, command);
  object->AddObserver(vtkCommand::ErrorEvent, command);
}

TEST(Elevation, RefusesWhatIsNoElevation)
{
  vtkNew<vtkMultiTriangulationMapper> mapper;
  Events events;
  Count(mapper, events);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double low[3] = { 0.0, 0.0, 0.0 };
  const double high[3] = { 0.0, 0.0, 2.0 };
  const double wrong[3] = { 0.0, nan, 2.0 };
  const double range[2] = { 0.0, 2.0 };
  const double wrongRange[2] = { 0.0, std::numeric_limits<double>::infinity() };
  mapper->SetColorByElevation(low, low, range);
  mapper->SetColorByElevation(low, wrong, range);
  mapper->SetColorByElevation(low, high, wrongRange);
  EXPECT_EQ(events.Errors, 3);
  EXPECT_EQ(mapper->GetColorBy(), vtkMultiTriangulationMapper::NONE);
  EXPECT_EQ(mapper->GetElevationHighPoint()[2], 1.0);
  mapper->SetColorByElevation(low, high, range);
  EXPECT_EQ(events.Errors, 3);
  EXPECT_EQ(mapper->GetColorBy(), vtkMultiTriangulationMapper::ELEVATION);
  EXPECT_EQ(mapper->GetElevationHighPoint()[2], 2.0);
}

TEST(Colors, ArraysThatAFilterAddedAreWarnedOfOnce)
{
  const auto model = MakeGrid(false);
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputData(model);
  vtkNew<vtkMultiTriangulationMapper> mapper;
  Events events;
  Count(mapper, events);
  MTScene scene(mapper);
  mapper->SetInputData(model);
  scene.Render();
  EXPECT_EQ(events.Warnings, 0) << events.Last;
  elevation->Update();
  elevation->GetPolyDataOutput()->GetPointData()->GetScalars()->SetName("Height");
  mapper->SetInputData(elevation->GetPolyDataOutput());
  scene.Render();
  mapper->SetPixelError(3.0);
  scene.Render();
  EXPECT_EQ(events.Warnings, 1);
  EXPECT_NE(events.Last.find("Height"), std::string::npos) << events.Last;
}
}
