// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTGltfPrimitive.h"

#include <algorithm>

using namespace vtkMTGltfJson;

vtkMTGltfPrimitive::vtkMTGltfPrimitive(vtkMTGltfFile& file, std::size_t mesh, std::size_t index)
  : Where("primitive " + std::to_string(index) + " of mesh " + std::to_string(mesh))
{
  const Json& primitive = GetList(file.GetItem("meshes", mesh), "primitives", this->Where)[index];
  if (!primitive.is_object())
  {
    Fail(this->Where, "is no object");
  }
  this->Mode = GetCount(primitive, "mode", this->Where, TriangleCells);
  if (this->Mode > Fan)
  {
    Fail(this->Where, "mode " + std::to_string(this->Mode) + " is not known");
  }
  if (Find(primitive, "material"))
  {
    this->Material = static_cast<int>(GetIndex(primitive, "material", file.GetSize("materials"), this->Where));
  }
  this->MorphTargets = GetList(primitive, "targets", this->Where).size();
  this->FindDraco(file, primitive);
  this->FindAttributes(file, primitive);
  if (this->Points == 0)
  {
    return; // nothing to see
  }
  if (this->DracoView)
  {
    const std::string where = this->Where + ", KHR_draco_mesh_compression";
    this->Mode = TriangleCells;
    this->FindCells(3 * vtkMTGltfDraco::FindNumberOfTriangles(file.OpenView(*this->DracoView).ReadAll(where), where));
    return;
  }
  if (Find(primitive, "indices"))
  {
    this->Indices.emplace(file, GetIndex(primitive, "indices", file.GetSize("accessors"), this->Where));
    const int type = this->Indices->GetLayout().Type;
    const bool isUnsigned = type == vtkMTGltfAccessor::UnsignedByte || type == vtkMTGltfAccessor::UnsignedShort ||
      type == vtkMTGltfAccessor::UnsignedInt;
    if (this->Indices->GetComponents() != 1 || !isUnsigned || this->Indices->IsReal())
    {
      Fail(this->Where, "its indices (" + this->Indices->GetName() + ") are no unsigned whole numbers");
    }
  }
  this->FindCells(this->Indices ? this->Indices->GetCount() : this->Points);
}

// Where Draco is missing, values that stand beside may do instead.
void vtkMTGltfPrimitive::FindDraco(vtkMTGltfFile& file, const Json& primitive)
{
  const Json* draco = FindExtension(primitive, "KHR_draco_mesh_compression");
  const Json* indices = Find(primitive, "indices");
  const bool hasValues = indices &&
    Find(
      file.GetItem("accessors", GetIndex(primitive, "indices", file.GetSize("accessors"), this->Where)), "bufferView");
  if (!draco || (!vtkMTGltfDraco::IsAvailable() && hasValues))
  {
    return;
  }
  const std::string where = this->Where + ", KHR_draco_mesh_compression";
  this->DracoView = GetIndex(*draco, "bufferView", file.GetSize("bufferViews"), where);
  const Json& attributes = vtkMTGltfJson::GetObject(*draco, "attributes", where);
  for (const auto& [name, number] : attributes.items())
  {
    this->DracoNumbers[name] = GetCount(attributes, name.c_str(), where);
  }
}

void vtkMTGltfPrimitive::FindAttributes(vtkMTGltfFile& file, const Json& primitive)
{
  const Json& attributes = vtkMTGltfJson::GetObject(primitive, "attributes", this->Where);
  if (!Find(attributes, "POSITION"))
  {
    return;
  }
  for (const auto& [name, index] : attributes.items())
  {
    const std::size_t accessor = GetIndex(attributes, name.c_str(), file.GetSize("accessors"), this->Where);
    this->Attributes.emplace(name, vtkMTGltfAccessor(file, accessor));
  }
  const vtkMTGltfAccessor& positions = this->Attributes.at("POSITION");
  this->Points = positions.GetCount();
  for (const auto& [name, accessor] : this->Attributes)
  {
    const std::size_t components = accessor.GetComponents();
    const bool isRight = name == "POSITION" || name == "NORMAL" ? components == 3
      : name == "TANGENT"                                       ? components == 4
      : name.rfind("TEXCOORD_", 0) == 0                         ? components == 2
      : name.rfind("COLOR_", 0) == 0                            ? components == 3 || components == 4
                                                                : true;
    if (!isRight || accessor.GetCount() != this->Points)
    {
      Fail(this->Where,
        name + " (" + accessor.GetName() + ") has " + std::to_string(accessor.GetCount()) + " values of " +
          std::to_string(components) + " components; there are " + std::to_string(this->Points) + " points");
    }
  }
}

void vtkMTGltfPrimitive::FindCells(std::uint64_t corners)
{
  switch (this->Mode)
  {
    case PointCells:
      this->Vertices = corners;
      break;
    case LineCells:
      this->Lines = corners / 2;
      break;
    case LineLoop:
    case LineStrip:
      this->Lines = corners > 1 ? corners - (this->Mode == LineStrip ? 1 : 0) : 0;
      break;
    case TriangleCells:
      this->Triangles = corners / 3;
      this->LeftCorners = corners % 3;
      break;
    default:
      this->Triangles = corners > 2 ? corners - 2 : 0;
      this->LeftCorners = corners > 2 ? 0 : corners;
  }
}

//------------------------------------------------------------------------------
const vtkMTGltfDraco& vtkMTGltfPrimitive::Decode(vtkMTGltfFile& file)
{
  if (!this->Decoded)
  {
    const std::string where = this->Where + ", KHR_draco_mesh_compression";
    this->Decoded = std::make_shared<vtkMTGltfDraco>(file.OpenView(*this->DracoView).ReadAll(where), where);
    if (this->Decoded->GetNumberOfPoints() != this->Points || this->Decoded->GetNumberOfTriangles() != this->Triangles)
    {
      Fail(where,
        "holds " + std::to_string(this->Decoded->GetNumberOfPoints()) + " points and " +
          std::to_string(this->Decoded->GetNumberOfTriangles()) + " triangles, not " + std::to_string(this->Points) +
          " and " + std::to_string(this->Triangles));
    }
  }
  return *this->Decoded;
}

void vtkMTGltfPrimitive::ReadAttribute(
  vtkMTGltfFile& file, const std::string& name, const vtkMTGltfAccessor::Consumer& consumer)
{
  const vtkMTGltfAccessor& accessor = this->Attributes.at(name);
  const auto number = this->DracoNumbers.find(name);
  if (number != this->DracoNumbers.end())
  {
    this->Decode(file).ReadAttribute(number->second, accessor, consumer);
    return;
  }
  accessor.Read(file, consumer);
}

void vtkMTGltfPrimitive::ReadTriangles(vtkMTGltfFile& file, const TriangleConsumer& consumer)
{
  std::uint64_t kept[2] = { 0, 0 }; // of a triangle; the last two of a strip; the first and the last of a fan
  const auto add = [&](std::uint64_t position, std::uint64_t corner)
  {
    if (corner >= this->Points)
    {
      Fail(this->Where,
        "index " + std::to_string(corner) + " at place " + std::to_string(position) + ", of " +
          std::to_string(this->Points) + " points");
    }
    const std::uint64_t turn = this->Mode == TriangleCells ? position % 3 : std::min<std::uint64_t>(position, 2);
    if (turn < 2)
    {
      kept[turn] = corner;
      return;
    }
    // The second triangle of a strip, and every other one after it, is wound the other way round.
    const bool isOdd = this->Mode == Strip && position % 2 == 1;
    isOdd ? consumer(kept[0], corner, kept[1]) : consumer(kept[0], kept[1], corner);
    kept[0] = this->Mode == Strip ? kept[1] : kept[0];
    kept[1] = corner;
  };
  const auto addBlock = [&](std::uint64_t first, std::size_t count, const double* corners)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      add(first + i, static_cast<std::uint64_t>(corners[i]));
    }
  };
  if (this->DracoView)
  {
    this->Decode(file).ReadCorners(addBlock);
  }
  else if (this->Indices)
  {
    this->Indices->Read(file, addBlock);
  }
  for (std::uint64_t i = 0; !this->DracoView && !this->Indices && i < this->Points; ++i)
  {
    add(i, i);
  }
}
