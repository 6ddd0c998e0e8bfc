// SPDX-License-Identifier: BSD-3-Clause
// Meshes that are written and read again.
#include "MTIOTest.h"
#include "MTTestMeshes.h"

#include "vtkMTMeshReader.h"
#include "vtkMTMeshWriter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <csignal>
#include <limits>

#include <sys/resource.h>

using namespace MTIOTest;

namespace
{
template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, int components, vtkIdType tuples, double step)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      array->SetComponent(i, c, step * static_cast<double>(i) + c);
    }
  }
  return array;
}

// Double positions that single precision cannot hold, and all kinds of arrays.
MTTestMeshes::Mesh MakeRichMesh()
{
  const MTTestMeshes::Mesh sphere = MTTestMeshes::Icosphere(2);
  const vtkIdType points = sphere->GetNumberOfPoints();
  const vtkIdType cells = sphere->GetNumberOfPolys();
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < points; ++i)
  {
    const double* p = sphere->GetPoint(i);
    places->InsertNextPoint(4.5e5 + p[0], 4.2e6 + p[1], p[2]);
  }
  sphere->SetPoints(places);
  vtkPointData* point = sphere->GetPointData();
  point->SetNormals(MakeArray<vtkFloatArray>("Normals", 3, points, 0.25));
  point->SetScalars(MakeArray<vtkUnsignedCharArray>("Color", 4, points, 1));
  point->SetTCoords(MakeArray<vtkFloatArray>("TCoords", 2, points, 0.1));
  point->AddArray(MakeArray<vtkDoubleArray>("temperature field", 1, points, 0.1));
  point->AddArray(MakeArray<vtkDoubleArray>("V", 3, points, 0.01));
  point->AddArray(MakeArray<vtkTypeInt64Array>("large", 1, points, 1e10));
  vtkCellData* cell = sphere->GetCellData();
  cell->AddArray(MakeArray<vtkIdTypeArray>("id", 1, cells, 3));
  cell->AddArray(MakeArray<vtkIntArray>("part", 1, cells, -1));
  return sphere;
}

void ExpectSamePlaces(vtkPolyData* a, vtkPolyData* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    ASSERT_TRUE(std::equal(p, p + 3, q)) << i;
  }
}

void ExpectSameValues(vtkDataArray* a, vtkDataArray* b)
{
  ASSERT_NE(a, nullptr);
  ASSERT_NE(b, nullptr);
  ASSERT_EQ(a->GetNumberOfTuples(), b->GetNumberOfTuples());
  ASSERT_EQ(a->GetNumberOfComponents(), b->GetNumberOfComponents());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      ASSERT_EQ(a->GetComponent(i, c), b->GetComponent(i, c)) << i;
    }
  }
}

MTTestMeshes::Mesh WriteAndRead(vtkPolyData* mesh, const std::string& path)
{
  std::string error;
  EXPECT_TRUE(vtkMTMeshWriter::Write(path, mesh, error)) << error;
  auto read = MTTestMeshes::Mesh::New();
  EXPECT_TRUE(vtkMTMeshReader::Read(path, read, error)) << error;
  return read;
}
}

//------------------------------------------------------------------------------
TEST(MeshWriter, PlyKeepsPlacesAndArrays)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MakeRichMesh();
  const MTTestMeshes::Mesh read = WriteAndRead(mesh, folder / "mesh.PLY");
  EXPECT_EQ(read->GetPoints()->GetDataType(), VTK_DOUBLE);
  ExpectSamePlaces(mesh, read);
  vtkPointData* from = mesh->GetPointData();
  vtkPointData* to = read->GetPointData();
  ExpectSameValues(from->GetNormals(), to->GetNormals());
  ExpectSameValues(from->GetScalars(), to->GetScalars());
  ExpectSameValues(from->GetTCoords(), to->GetTCoords());
  ExpectSameValues(from->GetArray("temperature field"), to->GetArray("temperature_field"));
  ExpectSameValues(from->GetArray("large"), to->GetArray("large"));
  for (int c = 0; c < 3; ++c)
  {
    vtkDataArray* component = to->GetArray(("V_" + std::to_string(c)).c_str());
    ASSERT_NE(component, nullptr);
    EXPECT_EQ(component->GetTuple1(7), from->GetArray("V")->GetComponent(7, c));
  }
  ExpectSameValues(mesh->GetCellData()->GetArray("id"), read->GetCellData()->GetArray("id"));
  EXPECT_EQ(read->GetCellData()->GetArray("id")->GetDataType(), VTK_INT);
  ExpectSameValues(mesh->GetCellData()->GetArray("part"), read->GetCellData()->GetArray("part"));
}

TEST(MeshWriter, PlyIsSingleWhereThatLosesNothing)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::Icosphere(2); // of floats
  const MTTestMeshes::Mesh read = WriteAndRead(mesh, folder / "mesh.ply");
  EXPECT_EQ(read->GetPoints()->GetDataType(), VTK_FLOAT);
  ExpectSamePlaces(mesh, read);
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName((folder / "mesh.ply").c_str());
  reader->Update();
  ExpectSamePlaces(mesh, reader->GetOutput());
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), mesh->GetNumberOfPolys());
}

TEST(MeshWriter, PlyRefusesIntegersThatItCannotHold)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::Icosphere(0);
  auto array = MakeArray<vtkTypeInt64Array>("huge", 1, mesh->GetNumberOfPoints(), 1);
  array->SetValue(3, std::numeric_limits<std::int64_t>::max() - 1);
  mesh->GetPointData()->AddArray(array);
  std::string error;
  EXPECT_FALSE(vtkMTMeshWriter::Write(folder / "mesh.ply", mesh, error));
  EXPECT_NE(error.find("huge"), std::string::npos) << error;
  EXPECT_TRUE(folder.List().empty());
}

TEST(MeshWriter, StlKeepsSinglePlacesAndOrientation)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::Icosphere(2);
  const MTTestMeshes::Mesh read = WriteAndRead(mesh, folder / "mesh.stl");
  ASSERT_EQ(read->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  EXPECT_EQ(read->GetNumberOfPoints(), 3 * mesh->GetNumberOfPolys());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    mesh->GetPolys()->GetCellAtId(i, count, corners);
    for (int c = 0; c < 3; ++c)
    {
      double p[3];
      double q[3];
      mesh->GetPoint(corners[c], p);
      read->GetPoint(3 * i + c, q);
      ASSERT_TRUE(std::equal(p, p + 3, q)) << i;
    }
  }
  EXPECT_EQ(
    std::filesystem::file_size(folder / "mesh.stl"), 84u + 50u * static_cast<std::uintmax_t>(mesh->GetNumberOfPolys()));
}

TEST(MeshWriter, ObjKeepsDoublePlacesNormalsAndTextureCoordinates)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MakeRichMesh();
  const MTTestMeshes::Mesh read = WriteAndRead(mesh, folder / "mesh.Obj");
  EXPECT_EQ(read->GetPoints()->GetDataType(), VTK_DOUBLE);
  ExpectSamePlaces(mesh, read);
  ExpectSameValues(mesh->GetPointData()->GetNormals(), read->GetPointData()->GetNormals());
  ExpectSameValues(mesh->GetPointData()->GetTCoords(), read->GetPointData()->GetTCoords());
  const MTTestMeshes::Mesh single = MTTestMeshes::FractalSphere(3);
  const MTTestMeshes::Mesh singleRead = WriteAndRead(single, folder / "single.obj");
  EXPECT_EQ(singleRead->GetPoints()->GetDataType(), VTK_FLOAT);
  ExpectSamePlaces(single, singleRead);
}

TEST(MeshWriter, VtpKeepsEverything)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MakeRichMesh();
  const MTTestMeshes::Mesh read = WriteAndRead(mesh, folder / "mesh.vtp");
  ExpectSamePlaces(mesh, read);
  for (vtkDataSetAttributes* attributes : { static_cast<vtkDataSetAttributes*>(mesh->GetPointData()),
         static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) })
  {
    vtkDataSetAttributes* others = attributes == mesh->GetPointData()
      ? static_cast<vtkDataSetAttributes*>(read->GetPointData())
      : static_cast<vtkDataSetAttributes*>(read->GetCellData());
    ASSERT_EQ(attributes->GetNumberOfArrays(), others->GetNumberOfArrays());
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      vtkDataArray* other = others->GetArray(array->GetName());
      ExpectSameValues(array, other);
      EXPECT_EQ(array->GetDataType(), other->GetDataType());
    }
  }
}

TEST(MeshWriter, PolygonsAndStripsBecomeTriangles)
{
  Folder folder;
  for (const char* name : { "mesh.ply", "mesh.stl", "mesh.obj" })
  {
    EXPECT_EQ(WriteAndRead(MTTestMeshes::Quads(4, 3), folder / name)->GetNumberOfPolys(), 12) << name;
    const MTTestMeshes::Mesh strips = MTTestMeshes::Strips(4, 3);
    EXPECT_EQ(WriteAndRead(strips, folder / name)->GetNumberOfPolys(), 12) << name;
  }
  EXPECT_EQ(WriteAndRead(MTTestMeshes::Quads(4, 3), folder / "mesh.vtp")->GetNumberOfPolys(), 6);
}

//------------------------------------------------------------------------------
TEST(MeshWriter, FailureLeavesTheEarlierFileAndNothingElse)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MakeRichMesh();
  for (const char* ending : { "ply", "stl", "obj", "vtp" })
  {
    const std::string name = std::string("mesh.") + ending;
    std::string error;
    ASSERT_TRUE(vtkMTMeshWriter::Write(folder / name, mesh, error)) << error;
    const std::uintmax_t size = std::filesystem::file_size(folder / name);
    WriteFile(folder / name, "earlier");
    for (const std::uintmax_t limit : { std::uintmax_t(0), size / 2, size - 1 })
    {
      const ChildResult result = RunInChild(
        [&]
        {
          std::signal(SIGXFSZ, SIG_IGN);
          const rlimit most = { limit, limit };
          ::setrlimit(RLIMIT_FSIZE, &most);
          std::string message;
          const bool written = vtkMTMeshWriter::Write(folder / name, mesh, message);
          return written ? 1 : message.find(name) == std::string::npos ? 2 : 0;
        });
      EXPECT_FALSE(result.Crashed) << name;
      EXPECT_EQ(result.ExitCode, 0) << name << " " << limit;
      EXPECT_EQ(ReadFile(folder / name).size(), 7u) << name;
      EXPECT_EQ(folder.List(), std::vector<std::string>{ name });
    }
    std::filesystem::remove(folder / name);
  }
}

TEST(MeshWriter, UnknownEndingsAndFoldersAreClearErrors)
{
  Folder folder;
  const MTTestMeshes::Mesh mesh = MTTestMeshes::Icosphere(0);
  std::string error;
  EXPECT_FALSE(vtkMTMeshWriter::Write(folder / "mesh.xyz", mesh, error));
  EXPECT_NE(error.find(".ply, .stl, .obj, .vtp, .gltf or .glb"), std::string::npos);
  EXPECT_FALSE(vtkMTMeshWriter::Write(folder / "mesh", mesh, error));
  EXPECT_FALSE(vtkMTMeshWriter::Write(folder / "missing/mesh.ply", mesh, error));
  EXPECT_NE(error.find("missing/mesh.ply"), std::string::npos);
  EXPECT_TRUE(vtkMTMeshWriter::CanWrite("a.b/C.VTP"));
  EXPECT_FALSE(vtkMTMeshWriter::CanWrite("a.ply/c"));
}
