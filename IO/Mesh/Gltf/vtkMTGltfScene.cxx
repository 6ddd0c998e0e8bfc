// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfScene.h"

#include "vtkMTGltfAccessor.h"

#include <algorithm>

using namespace vtkMTGltfJson;

namespace
{
std::string NameNode(std::size_t node)
{
  return "node " + std::to_string(node);
}

// Column by column, or translation, rotation and scale.
vtkMTGltfMatrix ReadMatrix(const Json& node, const std::string& where)
{
  if (Find(node, "matrix"))
  {
    const std::vector<double> columns = GetNumbers(node, "matrix", 16, where, {});
    vtkMTGltfMatrix matrix;
    for (std::size_t i = 0; i < 12; ++i)
    {
      matrix.Rows[i / 4][i % 4] = columns[i % 4 * 4 + i / 4];
    }
    return matrix;
  }
  const std::vector<double> translation = GetNumbers(node, "translation", 3, where, { 0.0, 0.0, 0.0 });
  const std::vector<double> rotation = GetNumbers(node, "rotation", 4, where, { 0.0, 0.0, 0.0, 1.0 });
  const std::vector<double> scale = GetNumbers(node, "scale", 3, where, { 1.0, 1.0, 1.0 });
  return vtkMTGltfMatrix::FromParts(translation.data(), rotation.data(), scale.data());
}
}

vtkMTGltfScene::vtkMTGltfScene(vtkMTGltfFile& file, Counts& counts)
  : File(file)
{
  this->FindParents();
  const std::size_t nodes = this->Parents.size();
  for (std::size_t mesh = 0; nodes == 0 && mesh < file.GetSize("meshes"); ++mesh)
  {
    this->Placements.push_back({ mesh, -1, {} });
  }
  // A stack of its own: nodes may be nested as deeply as the file likes.
  std::vector<std::pair<std::size_t, vtkMTGltfMatrix>> waiting;
  const std::vector<std::size_t> roots = this->FindRoots(counts);
  for (auto root = roots.rbegin(); root != roots.rend(); ++root)
  {
    waiting.emplace_back(*root, vtkMTGltfMatrix());
  }
  while (!waiting.empty())
  {
    const auto [node, above] = waiting.back();
    waiting.pop_back();
    const Json& object = file.GetItem("nodes", node);
    const vtkMTGltfMatrix matrix = above * ReadMatrix(object, NameNode(node));
    this->AddNode(node, matrix, counts);
    const std::vector<std::size_t> children = this->GetIndices(object, "children", NameNode(node));
    for (auto child = children.rbegin(); child != children.rend(); ++child)
    {
      waiting.emplace_back(*child, matrix);
    }
  }
}

std::vector<std::size_t> vtkMTGltfScene::GetIndices(const Json& object, const char* key, const std::string& where) const
{
  std::vector<std::size_t> indices;
  for (const Json& index : GetList(object, key, where))
  {
    indices.push_back(GetIndex(Json{ { key, index } }, key, this->File.GetSize("nodes"), where));
  }
  return indices;
}

// With at most one parent each, nodes are trees unless some are their own ancestors.
void vtkMTGltfScene::FindParents()
{
  const std::size_t nodes = this->File.GetSize("nodes");
  this->Parents.assign(nodes, nodes);
  for (std::size_t node = 0; node < nodes; ++node)
  {
    for (const std::size_t child : this->GetIndices(this->File.GetItem("nodes", node), "children", NameNode(node)))
    {
      if (this->Parents[child] != nodes)
      {
        Fail(NameNode(child),
          "is a child of two nodes, " + std::to_string(this->Parents[child]) + " and " + std::to_string(node));
      }
      this->Parents[child] = node;
    }
  }
  // The walk upwards in which a node was met first.
  std::vector<std::size_t> walks(nodes, nodes);
  for (std::size_t start = 0; start < nodes; ++start)
  {
    std::size_t node = start;
    for (; node != nodes && walks[node] == nodes; node = this->Parents[node])
    {
      walks[node] = start;
    }
    if (node != nodes && walks[node] == start)
    {
      Fail(NameNode(node), "is its own ancestor: the nodes have a cycle");
    }
  }
}

// What the scene names beside an ancestor comes with that one.
std::vector<std::size_t> vtkMTGltfScene::FindRoots(Counts& counts) const
{
  const std::size_t nodes = this->Parents.size();
  const std::size_t scenes = this->File.GetSize("scenes");
  std::vector<std::size_t> named;
  if (scenes > 0)
  {
    const Json& document = this->File.GetDocument();
    const std::size_t scene = Find(document, "scene") ? GetIndex(document, "scene", scenes, "the JSON") : 0;
    named = this->GetIndices(this->File.GetItem("scenes", scene), "nodes", "scene " + std::to_string(scene));
    counts["scenes_left_out"] += static_cast<std::int64_t>(scenes) - 1;
  }
  for (std::size_t node = 0; scenes == 0 && node < nodes; ++node)
  {
    if (this->Parents[node] == nodes)
    {
      named.push_back(node);
    }
  }
  std::vector<bool> isNamed(nodes, false);
  std::vector<bool> isBelow(nodes, false); // a named one
  for (const std::size_t node : named)
  {
    isNamed[node] = true;
  }
  std::vector<std::size_t> waiting = named;
  while (!waiting.empty())
  {
    const std::size_t node = waiting.back();
    waiting.pop_back();
    for (const std::size_t child : this->GetIndices(this->File.GetItem("nodes", node), "children", NameNode(node)))
    {
      if (!isBelow[child])
      {
        isBelow[child] = true;
        waiting.push_back(child);
      }
    }
  }
  std::vector<std::size_t> roots;
  for (const std::size_t node : named)
  {
    if (isNamed[node] && !isBelow[node])
    {
      roots.push_back(node);
      isNamed[node] = false; // once
    }
  }
  return roots;
}

void vtkMTGltfScene::AddNode(std::size_t node, const vtkMTGltfMatrix& matrix, Counts& counts)
{
  const Json& object = this->File.GetItem("nodes", node);
  if (!Find(object, "mesh"))
  {
    return;
  }
  counts["skins_ignored"] += Find(object, "skin") ? 1 : 0;
  const std::size_t mesh = GetIndex(object, "mesh", this->File.GetSize("meshes"), NameNode(node));
  const Json* instancing = FindExtension(object, "EXT_mesh_gpu_instancing");
  if (!instancing)
  {
    this->Placements.push_back({ mesh, static_cast<int>(node), matrix });
    return;
  }
  for (const vtkMTGltfMatrix& instance : this->ReadInstances(node, *instancing, counts))
  {
    this->Placements.push_back({ mesh, static_cast<int>(node), matrix * instance });
  }
}

std::vector<vtkMTGltfMatrix> vtkMTGltfScene::ReadInstances(std::size_t node, const Json& extension, Counts& counts)
{
  const std::string where = NameNode(node) + ", EXT_mesh_gpu_instancing";
  const Json& attributes = vtkMTGltfJson::GetObject(extension, "attributes", where);
  std::uint64_t count = 0;
  const auto read = [&](const char* name, std::size_t components, std::vector<double>& values)
  {
    if (!Find(attributes, name))
    {
      return;
    }
    const vtkMTGltfAccessor accessor(this->File, GetIndex(attributes, name, this->File.GetSize("accessors"), where));
    if (accessor.GetComponents() != components || (count > 0 && accessor.GetCount() != count))
    {
      Fail(where, std::string(name) + " has not the type or the number of values that it should have");
    }
    count = accessor.GetCount();
    accessor.Read(this->File,
      [&](std::uint64_t, std::size_t size, const double* block)
      { values.insert(values.end(), block, block + size * components); });
  };
  std::vector<double> translations;
  std::vector<double> rotations;
  std::vector<double> scales;
  read("TRANSLATION", 3, translations);
  read("ROTATION", 4, rotations);
  read("SCALE", 3, scales);
  const double none[4] = { 0.0, 0.0, 0.0, 1.0 };
  const double one[3] = { 1.0, 1.0, 1.0 };
  std::vector<vtkMTGltfMatrix> instances;
  for (std::size_t i = 0; i < count; ++i)
  {
    instances.push_back(vtkMTGltfMatrix::FromParts(translations.empty() ? none : translations.data() + 3 * i,
      rotations.empty() ? none : rotations.data() + 4 * i, scales.empty() ? one : scales.data() + 3 * i));
  }
  for (const auto& [name, index] : attributes.items())
  {
    counts["instance_attributes_ignored"] += !name.empty() && name[0] == '_' ? 1 : 0;
  }
  if (count == 0)
  {
    Fail(where, "has neither TRANSLATION nor ROTATION nor SCALE");
  }
  return instances;
}
