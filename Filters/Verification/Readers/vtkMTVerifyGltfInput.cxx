// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyGltfInput.h"

#include "vtkMTVerifyGltfFile.h"
#include "vtkMTVerifyMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

using Json = vtkMTVerifyJson;
using Accessor = vtkMTVerifyGltfFile::Accessor;
using Vector = std::array<double, 3>;

// Three columns and a translation.
struct Affine
{
  Vector Columns[4] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 0, 0 } };

  Vector Turn(const Vector& x) const
  {
    Vector y;
    for (int r = 0; r < 3; ++r)
    {
      y[r] = this->Columns[0][r] * x[0] + this->Columns[1][r] * x[1] + this->Columns[2][r] * x[2];
    }
    return y;
  }
  Vector Apply(const Vector& x) const
  {
    const Vector y = this->Turn(x);
    return { y[0] + this->Columns[3][0], y[1] + this->Columns[3][1], y[2] + this->Columns[3][2] };
  }
  Affine operator*(const Affine& other) const
  {
    Affine product;
    for (int c = 0; c < 3; ++c)
    {
      product.Columns[c] = this->Turn(other.Columns[c]);
    }
    product.Columns[3] = this->Apply(other.Columns[3]);
    return product;
  }
  // The columns of the inverse transpose times the determinant, and the determinant.
  double GetCofactors(Vector cofactors[3]) const
  {
    for (int c = 0; c < 3; ++c)
    {
      const Vector& a = this->Columns[(c + 1) % 3];
      const Vector& b = this->Columns[(c + 2) % 3];
      cofactors[c] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
    }
    const Vector& x = this->Columns[0];
    return x[0] * cofactors[0][0] + x[1] * cofactors[0][1] + x[2] * cofactors[0][2];
  }
};

Affine FromParts(const std::vector<double>& t, const std::vector<double>& q, const std::vector<double>& s)
{
  const double x = q[0], y = q[1], z = q[2], w = q[3];
  Affine m;
  m.Columns[0] = { s[0] * (1 - 2 * (y * y + z * z)), s[0] * 2 * (x * y + z * w), s[0] * 2 * (x * z - y * w) };
  m.Columns[1] = { s[1] * 2 * (x * y - z * w), s[1] * (1 - 2 * (x * x + z * z)), s[1] * 2 * (y * z + x * w) };
  m.Columns[2] = { s[2] * 2 * (x * z + y * w), s[2] * 2 * (y * z - x * w), s[2] * (1 - 2 * (x * x + y * y)) };
  m.Columns[3] = { t[0], t[1], t[2] };
  return m;
}

Affine GetMatrix(const Json& node)
{
  const std::vector<double> m = node.GetNumbers("matrix", {});
  if (m.size() != 16)
  {
    return FromParts(node.GetNumbers("translation", { 0, 0, 0 }), node.GetNumbers("rotation", { 0, 0, 0, 1 }),
      node.GetNumbers("scale", { 1, 1, 1 }));
  }
  Affine affine;
  for (int c = 0; c < 4; ++c)
  {
    affine.Columns[c] = { m[4 * c], m[4 * c + 1], m[4 * c + 2] };
  }
  return affine;
}

class Scene
{
public:
  Scene(vtkMTVerifyGltfFile& file, std::string& error)
    : File(file)
    , Root(file.GetRoot())
    , Error(error)
  {
    const std::vector<Json>& materials = this->Root.Get("materials").Items;
    this->HasBaseColors = !materials.empty();
    for (const Json& material : materials)
    {
      const Json& surface = material.Get("pbrMetallicRoughness");
      this->HasBaseColors = this->HasBaseColors && !surface.Has("baseColorTexture") &&
        !material.Get("extensions").Has("KHR_materials_pbrSpecularGlossiness");
    }
  }

  bool Read()
  {
    const Json& scene = this->Root.Get("scenes").At(this->Root.GetNumber("scene", 0.0));
    std::vector<double> roots = scene.GetNumbers("nodes", {});
    if (this->Root.Get("scenes").Items.empty()) // then every node without a parent
    {
      std::vector<double> children;
      for (const Json& node : this->Root.Get("nodes").Items)
      {
        const std::vector<double> own = node.GetNumbers("children", {});
        children.insert(children.end(), own.begin(), own.end());
      }
      for (std::size_t i = 0; i < this->Root.Get("nodes").Items.size(); ++i)
      {
        const auto index = static_cast<double>(i);
        if (std::find(children.begin(), children.end(), index) == children.end())
        {
          roots.push_back(index);
        }
      }
    }
    const bool isRead =
      std::all_of(roots.begin(), roots.end(), [this](double root) { return this->AddNode(root, Affine(), 0); });
    this->Mesh.Fill();
    this->DropUniform("MaterialIds");
    this->DropUniform("BaseColors");
    return isRead;
  }

  vtkMTVerifyMesh Mesh;

private:
  // One material, or one colour, tells no cells apart.
  void DropUniform(const std::string& name)
  {
    const auto isUniform = [&](const vtkMTVerifyMesh::Array& array)
    {
      const std::vector<double>& v = array.Values;
      const bool isSame = v.empty() || std::equal(v.begin() + array.Components, v.end(), v.begin());
      return array.Name == name && array.IsOfCells && isSame;
    };
    std::vector<vtkMTVerifyMesh::Array>& arrays = this->Mesh.Arrays;
    arrays.erase(std::remove_if(arrays.begin(), arrays.end(), isUniform), arrays.end());
  }

  bool Fail(const std::string& message)
  {
    this->Error = message;
    return false;
  }

  bool AddNode(double index, const Affine& parent, std::size_t depth)
  {
    const std::vector<Json>& nodes = this->Root.Get("nodes").Items;
    const Json& node = this->Root.Get("nodes").At(index);
    if (node.Type != Json::Object || depth > nodes.size())
    {
      return this->Fail(depth > nodes.size() ? "its nodes form a cycle" : "names a node that is not there");
    }
    const Affine matrix = parent * GetMatrix(node);
    if (node.Has("mesh"))
    {
      if (node.Has("skin"))
      {
        return this->Fail("has a skin");
      }
      std::vector<Affine> instances;
      if (!this->GetInstances(node.Get("extensions").Get("EXT_mesh_gpu_instancing"), instances))
      {
        return false;
      }
      for (const Affine& instance : instances)
      {
        if (!this->AddMesh(this->Root.Get("meshes").At(node.GetNumber("mesh", -1.0)), node, matrix * instance))
        {
          return false;
        }
      }
    }
    const std::vector<double> children = node.GetNumbers("children", {});
    return std::all_of(
      children.begin(), children.end(), [&](double child) { return this->AddNode(child, matrix, depth + 1); });
  }

  bool GetInstances(const Json& extension, std::vector<Affine>& instances)
  {
    const Json& attributes = extension.Get("attributes");
    Accessor parts[3];
    const char* const names[3] = { "TRANSLATION", "ROTATION", "SCALE" };
    std::size_t count = 1;
    for (int i = 0; i < 3; ++i)
    {
      if (attributes.Has(names[i]))
      {
        if (!this->File.Read(attributes.GetNumber(names[i], -1.0), parts[i], this->Error))
        {
          return false;
        }
        count = parts[i].Count;
      }
    }
    const auto get = [&](int i, std::size_t n, const std::vector<double>& otherwise)
    {
      const std::vector<double>& all = parts[i].Values;
      const std::size_t size = otherwise.size();
      return all.size() < (n + 1) * size ? otherwise
                                         : std::vector<double>(all.begin() + n * size, all.begin() + (n + 1) * size);
    };
    for (std::size_t n = 0; n < count; ++n)
    {
      instances.push_back(FromParts(get(0, n, { 0, 0, 0 }), get(1, n, { 0, 0, 0, 1 }), get(2, n, { 1, 1, 1 })));
    }
    return true;
  }

  bool AddMesh(const Json& mesh, const Json& node, const Affine& matrix)
  {
    for (double weight : node.GetNumbers("weights", mesh.GetNumbers("weights", {})))
    {
      if (weight != 0.0)
      {
        return this->Fail("has morph targets with weights");
      }
    }
    const std::vector<Json>& primitives = mesh.Get("primitives").Items;
    return std::all_of(primitives.begin(), primitives.end(),
      [&](const Json& primitive) { return this->AddPrimitive(primitive, matrix); });
  }

  bool AddPrimitive(const Json& primitive, const Affine& matrix)
  {
    const double mode = primitive.GetNumber("mode", 4.0);
    const Json& attributes = primitive.Get("attributes");
    if (mode < 4.0 || !attributes.Has("POSITION")) // points and lines
    {
      return true;
    }
    if (primitive.Get("extensions").Has("KHR_draco_mesh_compression"))
    {
      return this->Fail("is compressed by KHR_draco_mesh_compression");
    }
    Accessor positions;
    if (!this->File.Read(attributes.GetNumber("POSITION", -1.0), positions, this->Error))
    {
      return false;
    }
    if (positions.Components != 3)
    {
      return this->Fail("has positions of other than three coordinates");
    }
    const std::size_t first = this->Mesh.Points.size();
    this->Mesh.Fill(); // what the primitives before do not have
    for (std::size_t i = 0; i < positions.Count; ++i)
    {
      const double* x = positions.Values.data() + 3 * i;
      this->Mesh.Points.push_back(matrix.Apply({ x[0], x[1], x[2] }));
    }
    for (const auto& [name, index] : attributes.Members)
    {
      if (!this->AddAttribute(name, index.Value, primitive, matrix, first, positions.Count))
      {
        return false;
      }
    }
    return this->AddTriangles(primitive, mode, matrix, first, positions.Count);
  }

  bool AddAttribute(const std::string& name, double index, const Json& primitive, const Affine& matrix,
    std::size_t first, std::size_t count)
  {
    const auto starts = [&](const char* prefix) { return name.rfind(prefix, 0) == 0; };
    if (name == "POSITION" || name == "TANGENT" || starts("JOINTS_") || starts("WEIGHTS_"))
    {
      return true;
    }
    Accessor values;
    if (!this->File.Read(index, values, this->Error))
    {
      return false;
    }
    const vtkMTVerifyMesh::KindType kind = name == "NORMAL" ? vtkMTVerifyMesh::Normals
      : starts("COLOR_")                                    ? vtkMTVerifyMesh::Colors
      : starts("TEXCOORD_")                                 ? vtkMTVerifyMesh::Coordinates
                                                            : vtkMTVerifyMesh::Plain;
    const int components = kind == vtkMTVerifyMesh::Colors ? 4 : values.Components;
    vtkMTVerifyMesh::Array& array = this->Mesh.GetArray(name, kind, false, components);
    if (values.Count != count || array.Components != components)
    {
      return this->Fail("has attributes " + name + " of different lengths or types");
    }
    array.Values.resize(first * components, NaN);
    for (std::size_t i = 0; i < count; ++i)
    {
      std::vector<double> tuple(
        values.Values.begin() + i * values.Components, values.Values.begin() + (i + 1) * values.Components);
      tuple.resize(components, 1.0); // alpha
      this->Turn(name, kind, primitive, matrix, tuple);
      array.Values.insert(array.Values.end(), tuple.begin(), tuple.end());
    }
    return true;
  }

  // Normals by the inverse transpose; texture coordinates by their transform and from the bottom.
  void Turn(const std::string& name, vtkMTVerifyMesh::KindType kind, const Json& primitive, const Affine& matrix,
    std::vector<double>& tuple) const
  {
    if (kind == vtkMTVerifyMesh::Normals)
    {
      Affine inverse;
      const double sign = matrix.GetCofactors(inverse.Columns) < 0.0 ? -1.0 : 1.0;
      const Vector n = inverse.Turn({ tuple[0], tuple[1], tuple[2] });
      const double length = sign * std::hypot(n[0], n[1], n[2]);
      tuple = { n[0] / length, n[1] / length, n[2] / length };
    }
    else if (kind == vtkMTVerifyMesh::Coordinates)
    {
      const Json& material = this->Root.Get("materials").At(primitive.GetNumber("material", -1.0));
      const Json& texture = material.Get("pbrMetallicRoughness").Get("baseColorTexture");
      const Json& transform = texture.Get("extensions").Get("KHR_texture_transform");
      const double set = transform.GetNumber("texCoord", texture.GetNumber("texCoord", 0.0));
      if (transform.Type == Json::Object && name == "TEXCOORD_" + std::to_string(static_cast<int>(set)))
      {
        const std::vector<double> offset = transform.GetNumbers("offset", { 0, 0 });
        const std::vector<double> scale = transform.GetNumbers("scale", { 1, 1 });
        const bool isTurned = transform.GetNumber("rotation", 0.0) != 0.0;
        tuple[0] = isTurned ? NaN : offset[0] + scale[0] * tuple[0];
        tuple[1] = isTurned ? NaN : offset[1] + scale[1] * tuple[1];
      }
      tuple[1] = 1.0 - tuple[1];
    }
  }

  bool AddTriangles(const Json& primitive, double mode, const Affine& matrix, std::size_t first, std::size_t count)
  {
    Accessor indices;
    if (primitive.Has("indices"))
    {
      if (!this->File.Read(primitive.GetNumber("indices", -1.0), indices, this->Error))
      {
        return false;
      }
    }
    else
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        indices.Values.push_back(static_cast<double>(i));
      }
    }
    Vector cofactors[3];
    const bool isMirrored = matrix.GetCofactors(cofactors) < 0.0;
    const std::size_t before = this->Mesh.Polygons.size();
    const std::vector<double>& v = indices.Values;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c)
    {
      std::vector<vtkIdType> triangle;
      for (std::size_t i : { a, isMirrored ? c : b, isMirrored ? b : c })
      {
        const bool isThere = v[i] < static_cast<double>(count);
        triangle.push_back(isThere ? static_cast<vtkIdType>(first) + static_cast<vtkIdType>(v[i]) : -1);
      }
      this->Mesh.Polygons.push_back(triangle);
    };
    for (std::size_t i = 0; i + 2 < v.size(); i += mode == 4.0 ? 3 : 1)
    {
      const bool isOdd = mode == 5.0 && i % 2 == 1;
      mode == 6.0 ? add(i + 1, i + 2, 0) : add(i, i + (isOdd ? 2 : 1), i + (isOdd ? 1 : 2));
    }
    this->AddMaterial(primitive.GetNumber("material", -1.0), before);
    return true;
  }

  void AddMaterial(double index, std::size_t before)
  {
    const std::vector<Json>& materials = this->Root.Get("materials").Items;
    if (materials.size() < 2 && !this->HasBaseColors)
    {
      return;
    }
    const Json& material = this->Root.Get("materials").At(index);
    const std::size_t count = this->Mesh.Polygons.size() - before;
    if (materials.size() > 1)
    {
      vtkMTVerifyMesh::Array& ids = this->Mesh.GetArray("MaterialIds", vtkMTVerifyMesh::Names, true, 1);
      ids.Values.resize(before, NaN);
      ids.Values.resize(before + count, static_cast<double>(index));
      ids.Names.resize(std::max<std::size_t>(ids.Names.size(), static_cast<std::size_t>(index + 1.0)));
      if (index >= 0.0)
      {
        ids.Names[static_cast<std::size_t>(index)] = material.Get("name").String; // none is demanded where it has none
      }
    }
    if (this->HasBaseColors)
    {
      vtkMTVerifyMesh::Array& colors = this->Mesh.GetArray("BaseColors", vtkMTVerifyMesh::Colors, true, 4);
      colors.Values.resize(4 * before, NaN);
      const std::vector<double> color =
        material.Get("pbrMetallicRoughness").GetNumbers("baseColorFactor", { 1, 1, 1, 1 });
      for (std::size_t i = 0; i < count; ++i)
      {
        colors.Values.insert(colors.Values.end(), color.begin(), color.end());
      }
    }
  }

  vtkMTVerifyGltfFile& File;
  const Json& Root;
  std::string& Error;
  bool HasBaseColors = false;
};

// What changes no triangle, or is read here.
bool IsKnown(const std::string& extension)
{
  const char* const prefixes[] = { "KHR_materials_", "KHR_texture_", "KHR_lights_", "EXT_texture_", "KHR_xmp",
    "KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "EXT_mesh_features", "EXT_structural_metadata", "MSFT_texture",
    "KHR_animation_pointer", "KHR_node_visibility" };
  return std::any_of(
    std::begin(prefixes), std::end(prefixes), [&](const char* prefix) { return extension.rfind(prefix, 0) == 0; });
}
}

bool vtkMTVerifyGltfInput::Read(const std::string& path, vtkPolyData* out, std::string& error)
{
  vtkMTVerifyGltfFile file;
  if (!file.Open(path, error))
  {
    return false;
  }
  for (const Json& extension : file.GetRoot().Get("extensionsRequired").Items)
  {
    const bool isCompression = extension.String.find("compression") != std::string::npos;
    if (!IsKnown(extension.String) || isCompression)
    {
      error = "requires " + extension.String;
      return false;
    }
  }
  Scene scene(file, error);
  if (!scene.Read())
  {
    return false;
  }
  scene.Mesh.Give(out);
  return true;
}
