// SPDX-License-Identifier: BSD-3-Clause
// fuzz_seeds NAME FOLDER: small good inputs for the fuzzer of that name.
#include "MTTestMeshes.h"
#include "MTTestModel.h"

#include "vtkMTFileSink.h"
#include "vtkMTMeshWriter.h"
#include "vtkMTPatchCodec.h"

#include "vtkPolyData.h"

#include <cstdio>
#include <fstream>
#include <string>

namespace
{
bool WriteModels(const std::string& folder)
{
  const vtkMTFileSink::CompressionType types[] = { vtkMTFileSink::None, vtkMTFileSink::Fast, vtkMTFileSink::Small };
  for (int i = 0; i < 3; ++i)
  {
    MTTestModel::TubeOptions options;
    options.Rings = 8;
    options.Across = 3 + i;
    options.Regions = 2;
    const auto model = MTTestModel::MakeTube(options);
    vtkMTFileSink sink(folder + "/tube" + std::to_string(i) + ".bmt", types[i]);
    vtkMTGraph graph = model->GetGraph();
    graph.Blobs.push_back({ "picture", "image/png", {} });
    bool done = sink.Begin(graph.Arrays) && sink.WriteBlob(std::vector<unsigned char>(10, 1));
    std::vector<std::uint32_t> order;
    for (std::uint32_t arc = 0; done && arc < graph.Arcs.size(); ++arc)
    {
      vtkMTPatch patch;
      std::string error;
      done = model->ReadPatch(arc, nullptr, patch, error) && sink.WritePatch(std::move(patch));
      order.push_back(arc);
    }
    if (!done || !sink.Finish(graph, order))
    {
      return false;
    }
  }
  return true;
}

// A sheet of 64 points with normals.
vtkMTPatch MakeSheet()
{
  vtkMTPatch patch;
  for (std::uint32_t i = 0; i < 64; ++i)
  {
    const std::uint32_t x = i % 8;
    const std::uint32_t y = i / 8;
    patch.Points.push_back({ static_cast<std::int32_t>(10 * x), static_cast<std::int32_t>(10 * y), 0 });
    if (x < 7 && y < 7)
    {
      patch.Triangles.push_back({ i, i + 1, i + 9 });
      patch.Triangles.push_back({ i, i + 9, i + 8 });
    }
  }
  patch.Ids = { 1, 2, 3, 4 };
  patch.PointColumns.emplace_back(64 * 3 * sizeof(float), static_cast<unsigned char>(0));
  return patch;
}

// Codec, counts, array type and size of the geometry as fuzz_patch reads them, then the geometry and the normals.
bool WritePatches(const std::string& folder)
{
  vtkMTArrayInfo normals;
  normals.Type = 10;
  normals.Components = 3;
  normals.Association = vtkMTArrayInfo::Point;
  normals.Role = vtkMTArrayInfo::MadeNormals;
  bool done = true;
  for (const auto codec : { vtkMTFileFormat::Raw, vtkMTFileFormat::Lz4, vtkMTFileFormat::Zstd })
  {
    std::vector<unsigned char> bytes;
    std::vector<vtkMTFileSection> sections;
    std::string error;
    done = vtkMTPatchCodec::Encode(MakeSheet(), { normals }, codec, bytes, sections, error) && done;
    const std::uint32_t size = done ? sections[0].StoredSize : 0;
    const bool isExpected = done && sections[1].Codec == vtkMTFileFormat::Expected;
    const unsigned char head[16] = { static_cast<unsigned char>(codec + (isExpected ? 12 : 0)), 64, 0, 64, 0, 98, 0, 4,
      0, 10, 2, 0, 1, static_cast<unsigned char>(size), static_cast<unsigned char>(size >> 8), 0 };
    std::ofstream file(folder + "/patch" + std::to_string(int(codec)), std::ios::binary);
    file.write(reinterpret_cast<const char*>(head), sizeof(head));
    for (const auto& section : sections)
    {
      file.write(reinterpret_cast<const char*>(bytes.data() + section.Offset), section.StoredSize);
    }
  }
  return done;
}
}

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::fprintf(stderr, "usage: fuzz_seeds NAME FOLDER\n");
    return 2;
  }
  const std::string name = argv[1];
  const std::string folder = argv[2];
  if (name == "model")
  {
    return WriteModels(folder) ? 0 : 1;
  }
  if (name == "patch")
  {
    return WritePatches(folder) ? 0 : 1;
  }
  std::string error;
  const bool done = vtkMTMeshWriter::Write(folder + "/mesh." + name, MTTestMeshes::Icosphere(1), error);
  if (name == "ply")
  {
    std::ofstream(folder + "/text.ply")
      << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nproperty uchar red\nelement face 1\n"
         "property list uchar int vertex_indices\nend_header\n"
         "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n4 0 1 2 3\n";
  }
  if (name == "stl")
  {
    std::ofstream(folder + "/text.stl") << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                                           "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
  }
  if (name == "obj")
  {
    std::ofstream(folder + "/text.obj") << "mtllib a.mtl\nv 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\ng one\n"
                                           "usemtl red\nf 1/1/1 2/1/1 3/1/1\nf -3//-1 -2//-1 -1//-1\n";
  }
  if (name == "glb")
  {
    std::ofstream(folder + "/text.gltf")
      << R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[-1,1,1],)"
         R"("extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}}}],"meshes":[{"primitives":)"
         R"([{"attributes":{"POSITION":0,"_ID":1,"COLOR_0":0},"mode":5,"material":0}]}],"materials":[{"name":"a",)"
         R"("pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}],"accessors":[{"bufferView":0,"componentType":5126,)"
         R"("count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"componentType":5123},"values":)"
         R"({"bufferView":0,"byteOffset":12}}},{"bufferView":0,"componentType":5121,"normalized":true,"count":3,)"
         R"("type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":38,"byteLength":2}],)"
         R"("buffers":[{"byteLength":42,"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}]})";
  }
  return done ? 0 : 1;
}
