// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationReader and vtkMultiTriangulationWriter in a pipeline.
#include "MTFileSeal.h"
#include "MTIOTest.h"
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTFileSink.h"
#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTMemoryByteSource.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationReader.h"
#include "vtkMultiTriangulationWriter.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

using namespace MTIOTest;

namespace
{
// Keeps the errors of an algorithm off the terminal and in a string.
class Errors
{
public:
  explicit Errors(vtkAlgorithm* algorithm, unsigned long event = vtkCommand::ErrorEvent)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Errors*>(self)->Text += static_cast<const char*>(text); });
    algorithm->AddObserver(event, this->Command);
    algorithm->GetExecutive()->AddObserver(event, this->Command);
  }
  std::string Text;

private:
  vtkNew<vtkCallbackCommand> Command;
};

vtkSmartPointer<vtkMultiTriangulation> MakeData()
{
  auto data = vtkSmartPointer<vtkMultiTriangulation>::New();
  EXPECT_TRUE(data->SetSource(MTTestModel::MakeTube()));
  return data;
}
}

TEST(ReaderWriter, WhatIsWrittenIsRead)
{
  Folder folder;
  const auto data = MakeData();
  vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName((folder / "model.bmt").c_str());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(vtkMultiTriangulationReader::CanReadFile((folder / "model.bmt").c_str()), 1);

  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName((folder / "model.bmt").c_str());
  reader->Update();
  ASSERT_NE(reader->GetOutput(), nullptr);
  ASSERT_NE(reader->GetOutput()->GetSource(), nullptr);
  ExpectStored(*data->GetSource(), *reader->GetOutput()->GetSource());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), data->GetNumberOfPolys());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPatches(), data->GetNumberOfPatches());
  EXPECT_EQ(reader->GetOutput()->GetPointData()->GetNumberOfArrays(), data->GetPointData()->GetNumberOfArrays());
}

TEST(ReaderWriter, FileMayBeReplacedByWhatWasReadFromIt)
{
  Folder folder;
  vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputData(MakeData());
  writer->SetFileName((folder / "model.bmt").c_str());
  ASSERT_EQ(writer->Write(), 1);
  const Bytes before = ReadFile(folder / "model.bmt");
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName((folder / "model.bmt").c_str());
  vtkNew<vtkMultiTriangulationWriter> again;
  again->SetInputConnection(reader->GetOutputPort());
  again->SetFileName((folder / "model.bmt").c_str());
  ASSERT_EQ(again->Write(), 1);
  vtkMTFileSource sources[2];
  std::string error;
  ASSERT_TRUE(sources[0].Open(std::make_shared<vtkMTMemoryByteSource>(Bytes(before)), error)) << error;
  ASSERT_TRUE(sources[1].Open(folder / "model.bmt", error)) << error;
  ExpectStored(sources[0], sources[1]);
}

TEST(ReaderWriter, PlainPolyDataIsRefusedByTheWriter)
{
  Folder folder;
  vtkNew<vtkMultiTriangulationWriter> writer;
  Errors errors(writer);
  writer->SetInputData(MTTestMeshes::Icosphere(1));
  writer->SetFileName((folder / "model.bmt").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(errors.Text.find("vtkMultiTriangulationBuilder"), std::string::npos) << errors.Text;
  EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  vtkNew<vtkMultiTriangulation> empty;
  writer->SetInputData(empty);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_TRUE(folder.List().empty());
}

TEST(ReaderWriter, WriterSaysWhatIsWrong)
{
  Folder folder;
  vtkNew<vtkMultiTriangulationWriter> writer;
  Errors errors(writer);
  writer->SetInputData(MakeData());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoFileNameError));
  writer->SetFileName((folder / "missing/model.bmt").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::CannotOpenFileError));
  EXPECT_NE(errors.Text.find("missing/model.bmt"), std::string::npos);
}

TEST(ReaderWriter, ReaderSaysWhatIsWrong)
{
  Folder folder;
  WriteFile(folder / "garbage.bmt", std::string(1000, 'x'));
  vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputData(MakeData());
  writer->SetFileName((folder / "model.bmt").c_str());
  ASSERT_EQ(writer->Write(), 1);
  Bytes bytes = ReadFile(folder / "model.bmt");
  bytes.resize(bytes.size() - 1);
  WriteFile(folder / "short.bmt", bytes);
  bytes = ReadFile(folder / "model.bmt");
  bytes[MTFileSeal::GetSectionOffset(bytes.data()) + 50] ^= 1;
  WriteFile(folder / "damaged.bmt", bytes);

  const std::vector<std::pair<std::string, unsigned long>> cases = { { "", vtkErrorCode::NoFileNameError },
    { folder / "missing.bmt", vtkErrorCode::FileNotFoundError }, { folder / "", vtkErrorCode::CannotOpenFileError },
    { folder / "garbage.bmt", vtkErrorCode::UnrecognizedFileTypeError },
    { folder / "short.bmt", vtkErrorCode::FileFormatError },
    { folder / "damaged.bmt", vtkErrorCode::FileFormatError } };
  for (const auto& test : cases)
  {
    vtkNew<vtkMultiTriangulationReader> reader;
    Errors errors(reader);
    reader->SetFileName(test.first.c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), test.second) << test.first;
    EXPECT_FALSE(errors.Text.empty());
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(reader->GetOutput()->GetSource(), nullptr);
  }
  EXPECT_EQ(vtkMultiTriangulationReader::CanReadFile((folder / "garbage.bmt").c_str()), 0);
  EXPECT_EQ(vtkMultiTriangulationReader::CanReadFile((folder / "missing.bmt").c_str()), 0);
  EXPECT_EQ(vtkMultiTriangulationReader::CanReadFile(nullptr), 0);
}

TEST(ReaderWriter, OutputErrorChoosesWhatUnawareFiltersGet)
{
  Folder folder;
  vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputData(MakeData());
  writer->SetFileName((folder / "model.bmt").c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkMultiTriangulationReader> reader;
  Errors warnings(reader, vtkCommand::WarningEvent);
  reader->SetFileName((folder / "model.bmt").c_str());
  reader->Update();
  const vtkIdType coarsest = reader->GetOutput()->GetNumberOfPolys();
  reader->SetOutputError(0.0);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), reader->GetOutput()->GetNumberOfFinestTriangles());
  reader->SetOutputError(0.01);
  reader->Update();
  EXPECT_GT(reader->GetOutput()->GetNumberOfPolys(), coarsest);
  reader->SetOutputError(std::nan(""));
  EXPECT_EQ(reader->GetOutputError(), 0.01);
  EXPECT_NE(warnings.Text.find("NaN"), std::string::npos);
}

TEST(ReaderWriter, FrameGoesIntoTheFileAndComesBack)
{
  Folder folder;
  const auto data = MakeData();
  const double matrix[16] = { 0, -2, 0, 5, 2, 0, 0, 6, 0, 0, 3, 7, 0, 0, 0, 1 };
  ASSERT_TRUE(data->ApplyTransform(matrix));
  vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName((folder / "model.bmt").c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName((folder / "model.bmt").c_str());
  reader->Update();
  double frame[16];
  reader->GetOutput()->GetFrame(frame);
  EXPECT_TRUE(std::equal(frame, frame + 16, matrix));
  ASSERT_EQ(reader->GetOutput()->GetNumberOfPoints(), data->GetNumberOfPoints());
  // The file keeps the points of a patch in an order of its own.
  std::multiset<std::array<double, 3>> places[2];
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> place;
    data->GetPoint(p, place.data());
    places[0].insert(place);
    reader->GetOutput()->GetPoint(p, place.data());
    places[1].insert(place);
  }
  EXPECT_EQ(places[0], places[1]);
  double bounds[2][6];
  data->GetModelBounds(bounds[0]);
  reader->GetOutput()->GetModelBounds(bounds[1]);
  EXPECT_TRUE(std::equal(bounds[0], bounds[0] + 6, bounds[1]));
}

TEST(ReaderWriter, RangesOfTheWholeModelNeedNoPatch)
{
  Folder folder;
  vtkNew<vtkMultiTriangulationWriter> writer;
  writer->SetInputData(MakeData());
  writer->SetFileName((folder / "model.bmt").c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkMultiTriangulationReader> reader;
  reader->SetFileName((folder / "model.bmt").c_str());
  reader->SetOutputError(0.0); // the finest level, to compare with
  reader->Update();
  vtkMultiTriangulation* model = reader->GetOutput();
  double range[2] = { 7.0, 7.0 };
  double expected[2];
  ASSERT_TRUE(model->GetArrayRange("height", vtkDataObject::POINT, 0, range));
  model->GetPointData()->GetArray("height")->GetRange(expected, 0);
  EXPECT_EQ(range[0], expected[0]);
  EXPECT_EQ(range[1], expected[1]);
  ASSERT_TRUE(model->GetArrayRange("uv", vtkDataObject::POINT, 1, range));
  model->GetPointData()->GetArray("uv")->GetRange(expected, 1);
  EXPECT_EQ(range[1], expected[1]);
  ASSERT_TRUE(model->GetArrayRange("uv", vtkDataObject::POINT, -1, range));
  model->GetPointData()->GetArray("uv")->GetRange(expected, -1);
  EXPECT_LE(range[0], expected[0]);
  EXPECT_GE(range[1], expected[1]);
  ASSERT_TRUE(model->GetArrayRange("vtkMTInputCellIds", vtkDataObject::CELL, 0, range));
  EXPECT_FALSE(model->GetArrayRange("uv", vtkDataObject::POINT, 2, range));
  EXPECT_FALSE(model->GetArrayRange("uv", vtkDataObject::CELL, 0, range));
  EXPECT_FALSE(model->GetArrayRange("nothing", vtkDataObject::POINT, 0, range));
  EXPECT_FALSE(model->GetArrayRange(nullptr, vtkDataObject::POINT, 0, range));
}

// What a patch lacks is told from what a file has lost.
TEST(ReaderWriter, ArraysOfTheFinestLevelAreMissingElsewhereAndNowhereElse)
{
  Folder folder;
  const std::string path = folder / "model.bmt";
  const auto tube = MTTestModel::MakeTube();
  vtkMTGraph& graph = tube->GetMutableGraph();
  std::vector<vtkMTPatch>& patches = tube->GetMutablePatches();
  graph.Arrays[2].SetFinestOnly();
  std::uint32_t finest = 0;
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    finest = graph.IsFinest(arc) ? arc : finest;
    patches[arc].CellColumns[0].resize(graph.IsFinest(arc) ? patches[arc].CellColumns[0].size() : 0);
  }
  const auto write = [&]
  {
    vtkMTFileSink sink(path);
    std::vector<std::uint32_t> patchOfArc;
    bool good = sink.Begin(graph.Arrays);
    for (std::uint32_t arc = 0; good && arc < graph.Arcs.size(); ++arc)
    {
      patchOfArc.push_back(arc);
      good = sink.WritePatch(vtkMTPatch(patches[arc]));
    }
    return good && sink.Finish(graph, patchOfArc);
  };
  ASSERT_TRUE(write());
  vtkMTPatch patch;
  std::string error;
  {
    vtkMTFileSource source;
    ASSERT_TRUE(source.Open(path, error)) << error;
    EXPECT_TRUE(source.GetGraph().Arrays[2].IsFinestOnly());
    ExpectStored(*tube, source);
  }
  const std::string command = std::string("python3 ") + MT_SOURCE_DIRECTORY + "/Testing/IO/read_model.py " + path +
    " " + (folder / "dump") + " > " + (folder / "log") + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);

  patches[finest].CellColumns[0].clear();
  ASSERT_TRUE(write());
  vtkMTFileSource source;
  ASSERT_TRUE(source.Open(path, error)) << error;
  EXPECT_FALSE(source.ReadPatch(finest, nullptr, patch, error));
  EXPECT_NE(error.find("no section for the array"), std::string::npos) << error;
  EXPECT_NE(std::system(command.c_str()), 0);
  graph.Arrays[2].Properties.clear();
  EXPECT_FALSE(write()) << "an array of all levels is missing on some";
}
