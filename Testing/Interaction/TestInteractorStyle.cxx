// SPDX-License-Identifier: BSD-3-Clause
// Keys as a window gets them, and what they do to camera, colours, files and camera paths.
#include "MTIOTest.h"
#include "MTTestModel.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkMTCameraPath.h"
#include "vtkMTInteractorStyle.h"
#include "vtkMath.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>
#include <thread>

namespace
{
struct Tube
{
  explicit Tube(double x = 0.0)
  {
    MTTestModel::TubeOptions options;
    options.Offset = { x, 0.0, 0.0 };
    this->Model->SetSource(MTTestModel::MakeTube(options));
    this->Mapper->SetInputDataObject(this->Model);
    this->Mapper->ScalarVisibilityOff();
    this->Actor->SetMapper(this->Mapper);
  }

  vtkNew<vtkMultiTriangulation> Model;
  vtkNew<vtkMultiTriangulationMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

std::string ReadText(const std::string& path)
{
  const MTIOTest::Bytes bytes = MTIOTest::ReadFile(path);
  return { bytes.begin(), bytes.end() };
}

class InteractorStyle : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Renderer->AddActor(this->First.Actor);
    this->Window->AddRenderer(this->Renderer);
    this->Window->SetSize(400, 300);
    this->Interactor->SetRenderWindow(this->Window);
    this->Style->SetRenderer(this->Renderer);
    this->Style->SetScreenshotPrefix((this->Folder / "shot").c_str());
    this->Style->SetPathPrefix((this->Folder / "path").c_str());
    this->Interactor->SetInteractorStyle(this->Style);
    this->Interactor->Initialize();
    this->Renderer->ResetCamera();
    this->Window->Render();
  }

  // As the window system reports a key.
  void Press(const std::string& name, char code = 0, bool shift = false, bool control = false)
  {
    this->Interactor->SetKeyEventInformation(control, shift, code, 0, name.c_str());
    this->Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    this->Interactor->InvokeEvent(vtkCommand::CharEvent);
    this->Interactor->InvokeEvent(vtkCommand::KeyReleaseEvent);
  }
  void Type(char code) { this->Press(std::string(1, code), code); }

  vtkCamera* Camera() { return this->Renderer->GetActiveCamera(); }
  std::array<double, 3> Position()
  {
    return { this->Camera()->GetPosition()[0], this->Camera()->GetPosition()[1], this->Camera()->GetPosition()[2] };
  }
  std::array<double, 3> FocalPoint()
  {
    return { this->Camera()->GetFocalPoint()[0], this->Camera()->GetFocalPoint()[1],
      this->Camera()->GetFocalPoint()[2] };
  }

  MTIOTest::Folder Folder;
  Tube First;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkMTInteractorStyle> Style;
};
}

TEST_F(InteractorStyle, KeysMoveTheCameraAsAMouseDoes)
{
  const double distance = this->Camera()->GetDistance();
  const std::array<double, 3> start = this->Position();
  const std::array<double, 3> center = this->FocalPoint();
  for (const char* key : { "Left", "Up", "Right", "Down" })
  {
    const std::array<double, 3> before = this->Position();
    this->Press(key);
    EXPECT_NE(this->Position(), before) << key;
    EXPECT_NEAR(this->Camera()->GetDistance(), distance, 1e-9 * distance) << key;
    EXPECT_EQ(this->FocalPoint(), center) << key << " turns about the focal point";
  }
  const double turned = std::sqrt(vtkMath::Distance2BetweenPoints(start.data(), this->Position().data()));
  EXPECT_LT(turned, 0.02 * distance) << "there and back";
  for (const char* key : { "Left", "Up", "Right", "Down" })
  {
    const std::array<double, 3> before = this->FocalPoint();
    this->Press(key, 0, true);
    EXPECT_NE(this->FocalPoint(), before) << "Shift " << key;
  }
  EXPECT_NEAR(
    std::sqrt(vtkMath::Distance2BetweenPoints(center.data(), this->FocalPoint().data())), 0.0, 1e-9 * distance);
  for (const auto& [closer, farther] : { std::array<const char*, 2>{ "Prior", "Next" }, { "KP_Prior", "KP_Next" } })
  {
    this->Press(closer);
    EXPECT_NEAR(this->Camera()->GetDistance(), distance / 1.15, 1e-9 * distance) << closer;
    this->Press(farther);
    EXPECT_NEAR(this->Camera()->GetDistance(), distance, 1e-9 * distance) << farther;
  }
  this->Press("Up", 0, false, true);
  this->Type('i');
  EXPECT_NEAR(this->Camera()->GetDistance(), distance / 1.15 / 1.15, 1e-9 * distance);
  this->Camera()->ParallelProjectionOn();
  const double scale = this->Camera()->GetParallelScale();
  this->Type('o');
  EXPECT_NEAR(this->Camera()->GetParallelScale(), 1.15 * scale, 1e-9 * scale);
  this->Type('Z');
  EXPECT_LT(this->Camera()->GetDirectionOfProjection()[2] - 1.0, 1e-9);
  EXPECT_GT(this->Camera()->GetDirectionOfProjection()[2], 1.0 - 1e-9) << "from the axis's other end";
  this->Type(',');
  EXPECT_GT(std::abs(this->Camera()->GetViewUp()[0]), 0.05) << "rolled";
}

TEST_F(InteractorStyle, EveryKeyOfTheListIsAKeyAndNoOtherIs)
{
  std::istringstream list(vtkMTInteractorStyle::GetKeys());
  std::string line;
  int keys = 0;
  while (std::getline(list, line))
  {
    std::istringstream names(line.substr(0, 12));
    for (std::string name; names >> name;)
    {
      if (name.size() == 1 && name != "q")
      {
        EXPECT_TRUE(this->Style->PressKey(name.c_str())) << line;
        ++keys;
      }
    }
  }
  std::cout << keys << " keys\n";
  EXPECT_GT(keys, 25);
  for (const char* name : { "", "Q", "~", "Control+Left", "space bar" })
  {
    EXPECT_FALSE(this->Style->PressKey(name)) << name;
  }
  EXPECT_FALSE(this->Style->PressKey(nullptr));
  this->Style->SetRenderer(nullptr);
  EXPECT_FALSE(this->Style->PressKey("r")) << "there is nothing to act on";
}

TEST_F(InteractorStyle, FiguresAreThoseOfTheFrameAndSummedOverModels)
{
  const auto has = [this](const std::string& text)
  { return this->Style->GetOverlayText().find(text) != std::string::npos; };
  EXPECT_TRUE(has("1 model ")) << this->Style->GetOverlayText();
  Tube second(5.0);
  this->Renderer->AddActor(second.Actor);
  this->Type('r');
  const vtkIdType both = this->First.Mapper->GetNumberOfTriangles() + second.Mapper->GetNumberOfTriangles();
  std::string digits = std::to_string(both);
  digits.insert(digits.size() - 3, " ");
  std::cout << this->Style->GetOverlayText() << "\n";
  EXPECT_GT(both, this->First.Mapper->GetNumberOfTriangles());
  EXPECT_TRUE(has("2 models  " + digits + " triangles")) << digits;
  for (const char* word : { "frame ", "cut ", "memory ", "GPU ", " MiB", "pixels", "h: keys" })
  {
    EXPECT_TRUE(has(word)) << word;
  }
  EXPECT_FALSE(has("FROZEN"));
  this->Type('f');
  EXPECT_TRUE(has("FROZEN"));
  EXPECT_TRUE(second.Mapper->GetFreezeCut());
  this->Type('f');
  EXPECT_FALSE(has("FROZEN"));
  this->Type('+');
  EXPECT_EQ(this->First.Mapper->GetPixelError(), 0.5);
  EXPECT_EQ(second.Mapper->GetPixelError(), 0.5);
  this->Style->SetStatus("building");
  this->Style->SetMessage("hello");
  this->Type('h');
  EXPECT_TRUE(has(vtkMTInteractorStyle::GetKeys()));
  EXPECT_TRUE(has("hello"));
  this->Press("F1");
  this->Type('v');
  EXPECT_EQ(this->Style->GetOverlayText(), "building\nhello") << "no figures, no keys, but what the program has to say";
}

TEST_F(InteractorStyle, ColoursGoThroughAllArraysAndBackToTheData)
{
  std::set<std::string> pictures;
  const auto look = [&]
  {
    const std::string path = this->Style->TakeScreenshot();
    pictures.insert(ReadText(path));
  };
  this->Type('v'); // times would differ anyway
  this->Style->SetMessage("");
  this->Window->Render();
  look();
  ASSERT_EQ(this->Style->GetNumberOfColorArrays(), 2);
  EXPECT_EQ(this->Style->GetColorArrayName(0), "height");
  EXPECT_EQ(this->Style->GetColorArrayName(1), "uv");
  EXPECT_EQ(this->Style->GetColorArrayName(2), "");
  for (const std::string name : { "height", "uv", "" })
  {
    this->Type('c');
    EXPECT_EQ(this->Style->GetColorBy(), name);
    EXPECT_EQ(this->First.Mapper->GetScalarVisibility(), !name.empty());
  }
  this->Type('C');
  EXPECT_STREQ(this->Style->GetColorBy(), "uv");
  this->Type('j');
  EXPECT_EQ(this->First.Mapper->GetLookupTable()->GetVectorComponent(), 0);
  this->Type('j');
  EXPECT_EQ(this->First.Mapper->GetLookupTable()->GetVectorComponent(), 1);
  this->Type('C');
  double range[2];
  ASSERT_TRUE(this->First.Model->GetArrayRange("height", vtkDataObject::POINT, 0, range));
  EXPECT_EQ(this->First.Mapper->GetScalarRange()[0], range[0]);
  EXPECT_EQ(this->First.Mapper->GetScalarRange()[1], range[1]) << "the range of the finest level";
  this->Style->SetMessage("");
  this->Window->Render();
  look();
  this->Type('b');
  this->Style->SetMessage("");
  this->Window->Render();
  look();
  EXPECT_EQ(pictures.size(), 3u) << "plain, an array with its scalar bar, and without";
  EXPECT_FALSE(this->Style->SetColorBy("nothing"));
  EXPECT_STREQ(this->Style->GetColorBy(), "height") << "nothing has changed";
  for (const char key : { 'l', 'p', 'd', 'n' })
  {
    this->Type(key);
  }
  EXPECT_STREQ(this->Style->GetColorBy(), "");
  EXPECT_EQ(this->First.Mapper->GetColorBy(), vtkMultiTriangulationMapper::NONE);
}

TEST_F(InteractorStyle, OneScaleIsForAllModelsThatHaveTheArray)
{
  Tube second(5.0);
  second.Actor->SetScale(2.0);
  this->Renderer->AddActor(second.Actor);
  ASSERT_TRUE(this->Style->SetColorBy("height"));
  EXPECT_EQ(this->First.Mapper->GetLookupTable(), second.Mapper->GetLookupTable());
  Tube third(-5.0);
  this->Renderer->AddActor(third.Actor);
  EXPECT_FALSE(third.Mapper->GetScalarVisibility());
  this->Style->ColorsChanged();
  EXPECT_TRUE(third.Mapper->GetScalarVisibility()) << "what came later is coloured as the others";
}

TEST_F(InteractorStyle, TexturesComeAndGoWithAKeyAndWithColours)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  vtkProperty* property = this->First.Actor->GetProperty();
  property->SetTexture("leaf", texture);
  this->Style->ColorsChanged();
  EXPECT_EQ(property->GetTexture("leaf"), texture.Get());
  this->Type('t');
  EXPECT_EQ(property->GetNumberOfTextures(), 0);
  this->Type('t');
  EXPECT_EQ(property->GetTexture("leaf"), texture.Get());
  this->Type('l');
  EXPECT_EQ(property->GetNumberOfTextures(), 0) << "levels are seen without the texture";
  this->Type('n');
  EXPECT_EQ(property->GetTexture("leaf"), texture.Get());
}

TEST_F(InteractorStyle, ScreenshotsAreNewFilesOfWhatIsSeen)
{
  const std::string mine = this->Folder / "shot-0007.png";
  MTIOTest::WriteFile(mine, "mine");
  this->Type('g');
  this->Press("F12");
  EXPECT_EQ(ReadText(mine), "mine");
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName((this->Folder / "shot-0009.png").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[0], 400);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[1], 300);
  std::set<double> reds;
  for (vtkIdType i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i)
  {
    reds.insert(reader->GetOutput()->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  std::cout << reds.size() << " different values\n";
  EXPECT_GT(reds.size(), 20u) << "a shaded tube, and text";
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "shot-0008.png"));
  EXPECT_EQ(std::string(this->Style->GetMessage()), "picture in " + std::string(this->Folder / "shot-0009.png"));
  this->Style->SetScreenshotPrefix((this->Folder / "nowhere/shot").c_str());
  EXPECT_EQ(this->Style->TakeScreenshot(), "");
  EXPECT_NE(std::string(this->Style->GetMessage()).find("No such file"), std::string::npos)
    << this->Style->GetMessage();
}

TEST_F(InteractorStyle, ARecordedPathIsWrittenAndPlayedFromItsFirstViewToItsLast)
{
  const std::array<double, 3> start = this->Position();
  this->Type('m');
  EXPECT_TRUE(this->Style->GetRecording());
  for (int i = 0; i < 4; ++i)
  {
    this->Press("Left");
    std::this_thread::sleep_for(std::chrono::milliseconds(i == 1 ? 200 : 25)); // with a pause
  }
  this->Type('m');
  EXPECT_FALSE(this->Style->GetRecording());
  const std::array<double, 3> end = this->Position();
  vtkNew<vtkMTCameraPath> path;
  ASSERT_TRUE(path->Read((this->Folder / "path-0001.csv").c_str())) << path->GetErrorMessage();
  std::cout << path->GetNumberOfViews() << " views in " << path->GetLastTime() << " s\n";
  EXPECT_GE(path->GetNumberOfViews(), 3);
  vtkNew<vtkCamera> camera;
  ASSERT_TRUE(path->GetView(0.0, camera));
  EXPECT_EQ(camera->GetPosition()[0], start[0]);
  ASSERT_TRUE(path->GetView(path->GetLastTime(), camera));
  EXPECT_EQ(camera->GetPosition()[0], end[0]);

  this->Type('r');
  this->Style->SetCameraPath(path);
  this->Press("space", ' ');
  EXPECT_TRUE(this->Style->GetPlaying());
  int frames = 0;
  for (; this->Style->GetPlaying() && frames < 1000000; ++frames)
  {
    this->Interactor->InvokeEvent(vtkCommand::TimerEvent);
  }
  std::cout << frames << " frames\n";
  EXPECT_FALSE(this->Style->GetPlaying());
  EXPECT_EQ(this->Position(), end);
}

TEST_F(InteractorStyle, NothingIsRecordedOfACameraThatStands)
{
  this->Style->StartRecording();
  this->Window->Render();
  EXPECT_EQ(this->Style->StopRecording(), "");
  EXPECT_NE(std::string(this->Style->GetMessage()).find("has not moved"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "path-0001.csv"));
  this->Type('u');
  this->Type('k');
  EXPECT_NE(std::string(this->Style->GetMessage()).find("is empty"), std::string::npos);
  this->Style->StartPlaying();
  EXPECT_FALSE(this->Style->GetPlaying());
}

TEST_F(InteractorStyle, ViewsMakeAPathAndEveryFrameOfItAPicture)
{
  this->Type('a');
  this->Type('x');
  this->Type('a');
  this->Type('k');
  vtkNew<vtkMTCameraPath> path;
  ASSERT_TRUE(path->Read((this->Folder / "path-0001.csv").c_str())) << path->GetErrorMessage();
  EXPECT_EQ(path->GetNumberOfViews(), 2);
  EXPECT_EQ(path->GetLastTime(), 2.0);
  this->Style->SetFrameRate(2.0);
  EXPECT_EQ(this->Style->RenderPath((this->Folder / "film").c_str()), 5);
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "film-0005.png"));
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "film-0006.png"));
  EXPECT_NEAR(this->Camera()->GetDirectionOfProjection()[0], -1.0, 1e-9);
  EXPECT_EQ(this->Style->RenderPath((this->Folder / "nowhere/film").c_str()), -1);
  this->Style->SetFrameRate(0.0);
  EXPECT_EQ(this->Style->GetFrameRate(), 1.0);
}
