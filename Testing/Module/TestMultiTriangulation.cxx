// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestMeshes.h"
#include "MTTestModel.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObjectTypes.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMTCut.h"
#include "vtkMTMeshToPolyData.h"
#include "vtkMTPolyDataStream.h"
#include "vtkMultiTriangulation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkTrivialProducer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

namespace
{
struct ErrorCounter
{
  vtkNew<vtkCallbackCommand> Command;
  int Count = 0;
  std::string Text;
  ErrorCounter()
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void* text)
      {
        ++static_cast<ErrorCounter*>(self)->Count;
        static_cast<ErrorCounter*>(self)->Text = static_cast<const char*>(text);
      });
  }
};

vtkSmartPointer<vtkMultiTriangulation> MakeTube()
{
  vtkSmartPointer<vtkMultiTriangulation> mt = vtkSmartPointer<vtkMultiTriangulation>::New();
  EXPECT_TRUE(mt->SetSource(MTTestModel::MakeTube()));
  return mt;
}
}

TEST(MultiTriangulation, IsThePolyDataOfItsCoarsestCut)
{
  const auto mt = MakeTube();
  const vtkMTGraph& graph = mt->GetSource()->GetGraph();
  EXPECT_EQ(mt->GetDataObjectType(), VTK_POLY_DATA);
  EXPECT_STREQ(mt->GetClassName(), "vtkMultiTriangulation");
  EXPECT_TRUE(mt->IsA("vtkPolyData"));
  EXPECT_EQ(mt->GetNumberOfPolys(), static_cast<vtkIdType>(graph.GetNumberOfRootTriangles()));
  EXPECT_EQ(mt->GetNumberOfLevels(), 6);
  EXPECT_EQ(mt->GetNumberOfFinestTriangles(), 256 * 16);
  EXPECT_EQ(mt->GetNumberOfPatches(), static_cast<vtkIdType>(graph.Arcs.size()));
  EXPECT_EQ(mt->GetNumberOfNodes(), static_cast<vtkIdType>(graph.Nodes.size()));
  EXPECT_STREQ(mt->GetPointData()->GetScalars()->GetName(), "height");
  EXPECT_STREQ(mt->GetPointData()->GetTCoords()->GetName(), "uv");
  EXPECT_EQ(mt->GetCellData()->GetArray("vtkMTInputCellIds")->GetDataType(), VTK_ID_TYPE);
  EXPECT_EQ(MTTestMeshes::CountEdges(mt, true).Open, 0);
  std::ostringstream text;
  mt->PrintSelf(text, vtkIndent());
  EXPECT_NE(text.str().find("NumberOfLevels: 6"), std::string::npos);
}

TEST(MultiTriangulation, CopiesShareTheHandle)
{
  const auto mt = MakeTube();
  vtkNew<vtkMultiTriangulation> shallow;
  shallow->ShallowCopy(mt);
  EXPECT_EQ(shallow->GetSource(), mt->GetSource());
  EXPECT_EQ(shallow->GetNumberOfPolys(), mt->GetNumberOfPolys());
  vtkNew<vtkMultiTriangulation> deep;
  deep->DeepCopy(mt);
  EXPECT_EQ(deep->GetSource(), mt->GetSource());
  EXPECT_NE(deep->GetPoints(), mt->GetPoints());
  vtkNew<vtkMultiTriangulation> structure;
  structure->CopyStructure(mt);
  EXPECT_EQ(structure->GetSource(), mt->GetSource());
  shallow->ShallowCopy(shallow);
  EXPECT_EQ(shallow->GetSource(), mt->GetSource());
  vtkSmartPointer<vtkDataObject> sibling;
  sibling.TakeReference(mt->NewInstance());
  EXPECT_TRUE(vtkMultiTriangulation::SafeDownCast(sibling));

  vtkNew<vtkPolyData> plain;
  plain->ShallowCopy(mt);
  EXPECT_EQ(plain->GetNumberOfPolys(), mt->GetNumberOfPolys());
  shallow->ShallowCopy(plain);
  EXPECT_EQ(shallow->GetSource(), nullptr) << "plain polydata has no patches";
  deep->Initialize();
  EXPECT_EQ(deep->GetSource(), nullptr);
  EXPECT_EQ(deep->GetNumberOfPatches(), 0);
  EXPECT_EQ(deep->GetNumberOfPoints(), 0);
}

TEST(MultiTriangulation, HandleEndsWithItsPoints)
{
  const auto mt = MakeTube();
  vtkNew<vtkMultiTriangulation> moved;
  moved->CopyStructure(mt);
  vtkNew<vtkPoints> points;
  points->DeepCopy(mt->GetPoints());
  moved->SetPoints(points);
  EXPECT_EQ(moved->GetSource(), nullptr);
  EXPECT_EQ(moved->GetNumberOfLevels(), 0);
  vtkNew<vtkMultiTriangulation> copy;
  copy->ShallowCopy(moved);
  EXPECT_EQ(copy->GetSource(), nullptr);
  EXPECT_NE(mt->GetSource(), nullptr);
}

TEST(MultiTriangulation, RemovingTheMeshLeavesThePatches)
{
  const auto mt = MakeTube();
  double before[6];
  mt->GetModelBounds(before);
  vtkNew<vtkMultiTriangulation> bare;
  bare->ShallowCopy(mt);
  bare->RemoveMesh();
  EXPECT_EQ(bare->GetNumberOfPoints(), 0);
  EXPECT_EQ(bare->GetNumberOfCells(), 0);
  EXPECT_EQ(bare->GetPointData()->GetNumberOfArrays(), mt->GetPointData()->GetNumberOfArrays());
  EXPECT_EQ(bare->GetPointData()->GetArray("height")->GetNumberOfTuples(), 0);
  EXPECT_EQ(bare->GetSource(), mt->GetSource());
  double after[6];
  bare->GetModelBounds(after);
  EXPECT_TRUE(std::equal(before, before + 6, after));
  EXPECT_GT(mt->GetNumberOfPoints(), 0) << "copies of it keep theirs";
  vtkNew<vtkMultiTriangulation> copy;
  copy->ShallowCopy(bare);
  EXPECT_EQ(copy->GetSource(), mt->GetSource());
}

TEST(MultiTriangulation, TravelsThroughAPipeline)
{
  const auto mt = MakeTube();
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(mt);
  producer->Update();
  vtkInformation* info = producer->GetOutputInformation(0);
  EXPECT_EQ(vtkMultiTriangulation::GetData(info), mt);
  EXPECT_EQ(vtkMultiTriangulation::GetData(static_cast<vtkInformation*>(nullptr)), nullptr);
}

TEST(MultiTriangulation, UnreadablePatchesGiveAnErrorEventAndAnEmptyObject)
{
  const auto tube = MTTestModel::MakeTube();
  tube->GetMutablePatches().clear();
  vtkNew<vtkMultiTriangulation> mt;
  ErrorCounter errors;
  mt->AddObserver(vtkCommand::ErrorEvent, errors.Command);
  EXPECT_FALSE(mt->SetSource(tube));
  EXPECT_EQ(errors.Count, 1);
  EXPECT_EQ(mt->GetSource(), nullptr);
  EXPECT_EQ(mt->GetNumberOfPoints(), 0);
}

TEST(MultiTriangulation, FinestCutAsPolyDataHasEveryRing)
{
  const auto tube = MTTestModel::MakeTube();
  vtkMTCut cut(tube->GetGraph());
  for (std::uint32_t node = 0; node < tube->GetGraph().Nodes.size(); ++node)
  {
    cut.RefineWithDependencies(node);
  }
  vtkNew<vtkPolyData> mesh;
  std::string error;
  ASSERT_TRUE(vtkMultiTriangulation::CutToPolyData(*tube, cut, mesh, error)) << error;
  EXPECT_EQ(mesh->GetNumberOfPolys(), 256 * 16);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 256 * 9) << "eight points and a seam wedge per ring";
  const MTTestMeshes::EdgeFigures edges = MTTestMeshes::CountEdges(mesh, true);
  EXPECT_EQ(edges.Open + edges.Crowded, 0);
}

TEST(MeshToPolyData, EveryTypeOfArraySurvivesARoundTrip)
{
  vtkSmartPointer<vtkPolyData> mesh = MTTestMeshes::Terrain(5, 4);
  for (int type :
    { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG,
      VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    for (vtkDataSetAttributes* attributes : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
           static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
    {
      const bool points = attributes == mesh->GetPointData();
      vtkSmartPointer<vtkDataArray> array;
      array.TakeReference(vtkDataArray::CreateDataArray(type));
      array->SetName(("type " + std::to_string(type)).c_str());
      array->SetNumberOfComponents(1 + type % 4);
      array->SetNumberOfTuples(points ? mesh->GetNumberOfPoints() : mesh->GetNumberOfCells());
      for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
      {
        array->SetComponent(i / array->GetNumberOfComponents(), static_cast<int>(i % array->GetNumberOfComponents()),
          static_cast<double>((i * 7 + type) % 100));
      }
      attributes->AddArray(array);
    }
  }
  vtkMTPolyDataStream stream(mesh);
  ASSERT_EQ(stream.GetArrays().size(), 28u);
  vtkMTTriangleStream::PointBlock points;
  vtkMTTriangleStream::TriangleBlock triangles;
  ASSERT_TRUE(stream.NextPoints(points));
  ASSERT_TRUE(stream.NextTriangles(triangles));
  const vtkMTLattice lattice = vtkMTLattice::FromBounds(mesh->GetBounds(), 31);
  vtkMTPatch patch;
  for (const std::array<double, 3>& p : points.Points)
  {
    patch.Points.push_back(lattice.Snap(p.data()));
  }
  for (const auto& t : triangles.Triangles)
  {
    patch.Triangles.push_back(
      { static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]), static_cast<std::uint32_t>(t[2]) });
  }
  patch.PointColumns = points.Columns;
  patch.CellColumns = triangles.Columns;
  vtkNew<vtkPolyData> result;
  vtkMTMeshToPolyData::Convert(patch, lattice, stream.GetArrays(), result);
  ASSERT_EQ(result->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  EXPECT_EQ(result->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const std::array<double, 3> exact = lattice.ToWorld(patch.Points[i]);
    double p[3];
    result->GetPoint(i, p);
    EXPECT_TRUE(std::equal(exact.begin(), exact.end(), p));
  }
  for (int i = 0; i < mesh->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* before = mesh->GetPointData()->GetArray(i);
    vtkDataArray* after = result->GetPointData()->GetArray(before->GetName());
    ASSERT_TRUE(after);
    EXPECT_EQ(after->GetDataType(), before->GetDataType());
    EXPECT_EQ(std::memcmp(before->GetVoidPointer(0), after->GetVoidPointer(0),
                before->GetNumberOfValues() * before->GetDataTypeSize()),
      0)
      << before->GetName();
    before = mesh->GetCellData()->GetArray(i);
    after = result->GetCellData()->GetArray(before->GetName());
    ASSERT_TRUE(after);
    EXPECT_EQ(std::memcmp(before->GetVoidPointer(0), after->GetVoidPointer(0),
                before->GetNumberOfValues() * before->GetDataTypeSize()),
      0)
      << before->GetName();
  }
}

TEST(MeshToPolyData, ActiveAttributesAndComponentNamesComeBack)
{
  vtkSmartPointer<vtkPolyData> mesh = MTTestMeshes::HardEdgeBox(3);
  MTTestMeshes::AddArrays(mesh);
  vtkMTPolyDataStream stream(mesh);
  vtkMTTriangleStream::PointBlock points;
  vtkMTTriangleStream::TriangleBlock triangles;
  ASSERT_TRUE(stream.NextPoints(points));
  ASSERT_TRUE(stream.NextTriangles(triangles));
  vtkMTPatch patch;
  patch.Points.resize(points.Points.size());
  patch.Triangles.resize(triangles.Triangles.size());
  patch.PointColumns = points.Columns;
  patch.CellColumns = triangles.Columns;
  vtkNew<vtkPolyData> result;
  vtkMTMeshToPolyData::Convert(patch, vtkMTLattice(), stream.GetArrays(), result);
  EXPECT_STREQ(result->GetPointData()->GetScalars()->GetName(), "elevation");
  EXPECT_STREQ(result->GetPointData()->GetNormals()->GetName(), "Normals");
  EXPECT_STREQ(result->GetPointData()->GetGlobalIds()->GetName(), "ids");
  EXPECT_STREQ(result->GetPointData()->GetArray("tensor")->GetComponentName(1), "xy");
  EXPECT_EQ(result->GetCellData()->GetScalars(), nullptr);
  EXPECT_EQ(result->GetCellData()->GetNumberOfArrays(), 3);
}

TEST(MultiTriangulation, ErrorChoosesTheCutThatItHolds)
{
  const auto source = MTTestModel::MakeTube();
  const double coarsest = vtkMTCut(source->GetGraph()).GetError();
  vtkNew<vtkMultiTriangulation> mt;
  vtkIdType before = 0;
  for (const double error : { std::numeric_limits<double>::infinity(), 0.3 * coarsest, 0.05 * coarsest, 0.0 })
  {
    ASSERT_TRUE(mt->SetSource(source, error));
    EXPECT_GT(mt->GetNumberOfPolys(), before);
    EXPECT_EQ(MTTestMeshes::CountEdges(mt, true).Open, 0);
    before = mt->GetNumberOfPolys();
  }
  EXPECT_EQ(before, mt->GetNumberOfFinestTriangles()) << "what cannot be reached gives the finest level";
  ASSERT_TRUE(mt->SetSource(source, std::nan("")));
  EXPECT_EQ(mt->GetNumberOfPolys(), static_cast<vtkIdType>(source->GetGraph().GetNumberOfRootTriangles()));
}

TEST(MultiTriangulation, TransformMovesMeshFrameAndBounds)
{
  const auto mt = MakeTube();
  const auto source = mt->GetSource();
  double before[6];
  mt->GetModelBounds(before);
  double graph[6];
  source->GetGraph().GetBounds(graph);
  EXPECT_TRUE(std::equal(before, before + 6, graph));
  EXPECT_EQ(mt->GetStretch(), 1.0);
  const double matrix[16] = { 0, -2, 0, 5, 2, 0, 0, 6, 0, 0, 3, 7, 0, 0, 0, 1 };
  double first[3];
  mt->GetPoint(0, first);
  ASSERT_TRUE(mt->ApplyTransform(matrix));
  EXPECT_EQ(mt->GetSource(), source);
  EXPECT_EQ(mt->GetPoint(0)[0], 5.0 - 2.0 * first[1]);
  EXPECT_NEAR(mt->GetStretch(), 3.0, 1e-9);
  double after[6];
  mt->GetModelBounds(after);
  EXPECT_EQ(after[0], 5.0 - 2.0 * before[3]);
  EXPECT_EQ(after[5], 7.0 + 3.0 * before[5]);
  double frame[16];
  mt->GetFrame(frame);
  EXPECT_TRUE(std::equal(frame, frame + 16, matrix));

  ErrorCounter errors;
  mt->AddObserver(vtkCommand::ErrorEvent, errors.Command);
  for (const double bad : { std::nan(""), std::numeric_limits<double>::infinity(), 0.0 })
  {
    double broken[16] = { 1, 0, 0, 0, 0, bad, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    EXPECT_FALSE(mt->ApplyTransform(broken));
  }
  EXPECT_EQ(errors.Count, 3);
  mt->GetFrame(frame);
  EXPECT_TRUE(std::equal(frame, frame + 16, matrix)) << "nothing has been done";
  mt->Initialize();
  mt->GetFrame(frame);
  EXPECT_EQ(frame[3], 0.0);
  mt->GetModelBounds(after);
  EXPECT_GT(after[0], after[1]);
}
