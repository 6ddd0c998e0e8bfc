// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTObjStream.h"

#include "vtkMTChunkStream.h"
#include "vtkMTFieldNames.h"
#include "vtkMTFileByteSource.h"
#include "vtkMTObjParser.h"
#include "vtkMTSpoolWedges.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstring>

namespace
{
using Key = vtkMTSpoolWedges::Key;
constexpr std::uint64_t None = vtkMTObjParser::None;

struct FaceRecord
{
  std::uint64_t Corners;
  std::int32_t Material;
  std::int32_t Group;
};

// A point as the lines "v" give it.
struct PointRecord
{
  double Place[3];
  float Color[3];
  float Padding;
};

//------------------------------------------------------------------------------
// Everything that the file says, in spools, and corners on their way to their wedges.
class Content : public vtkMTObjParser
{
public:
  Content(const vtkMTByteSource& bytes, vtkMTSpoolStore& store, std::size_t memory)
    : vtkMTObjParser(bytes)
    , PointSpool(store)
    , TextureSpool(store)
    , NormalSpool(store)
    , FaceSpool(store)
    , Wedges(store, memory)
  {
  }

  bool Read(std::string& error)
  {
    return this->Parse(error) && this->PointSpool.Seal(error) && this->TextureSpool.Seal(error) &&
      this->NormalSpool.Seal(error) && this->FaceSpool.Seal(error) &&
      this->Wedges.Finish(this->Points, { None, None }, error);
  }

  using vtkMTObjParser::Faces;
  using vtkMTObjParser::Group;
  using vtkMTObjParser::HasColors;
  using vtkMTObjParser::IsDouble;
  using vtkMTObjParser::Libraries;
  using vtkMTObjParser::Lines;
  using vtkMTObjParser::MaterialNames;
  using vtkMTObjParser::Normals;
  using vtkMTObjParser::Points;
  using vtkMTObjParser::Textures;

  vtkMTSpoolQueue PointSpool;
  vtkMTSpoolQueue TextureSpool;
  vtkMTSpoolQueue NormalSpool;
  vtkMTSpoolQueue FaceSpool;
  vtkMTSpoolWedges Wedges;

private:
  bool AddVertex(const double* place, const float* colors) override
  {
    PointRecord record{};
    std::copy_n(place, 3, record.Place);
    std::copy_n(colors, colors ? 3 : 0, record.Color);
    return this->PointSpool.Put(&record, sizeof(record), this->Error);
  }
  bool AddTexture(const float* coordinates) override
  {
    return this->TextureSpool.Put(coordinates, 2 * sizeof(float), this->Error);
  }
  bool AddNormal(const float* normal) override { return this->NormalSpool.Put(normal, 3 * sizeof(float), this->Error); }
  bool AddCell(const Cell& cell) override
  {
    if (!cell.IsFace)
    {
      return true; // lines are only counted
    }
    const FaceRecord record{ cell.Corners.size(), cell.Material, cell.Group };
    return this->FaceSpool.Put(&record, sizeof(record), this->Error) &&
      std::all_of(cell.Corners.begin(), cell.Corners.end(),
        [this](const Corner& corner) {
          return this->Wedges.AddCorner(corner.Point, { corner.Texture, corner.Normal }, this->Error);
        });
  }
};

// Passes all items of a spool by the lookup.
bool PassAll(
  vtkMTSpoolQueue& items, std::uint64_t count, std::size_t size, vtkMTSpoolLookup& lookup, std::string& error)
{
  items.Rewind();
  for (std::uint64_t i = 0; i < count; ++i)
  {
    const unsigned char* item = items.Take(size, error);
    if (!item || !lookup.PassBy(item, error))
    {
      return false;
    }
  }
  return lookup.Finish(error);
}

//------------------------------------------------------------------------------
class Stream : public vtkMTChunkStream
{
public:
  Stream(std::unique_ptr<vtkMTFileByteSource> bytes, vtkMTSpoolStore* store, std::size_t memory)
    : vtkMTChunkStream(store, memory / 4)
    , Name(bytes->GetName())
    , File(*bytes, *store, memory)
    , Copies(*store, sizeof(PointRecord), memory / 4)
    , Textures(*store, 2 * sizeof(float), memory / 4)
    , Normals(*store, 3 * sizeof(float), memory / 4)
    , Bytes(std::move(bytes))
  {
  }

  bool Open()
  {
    if (!this->File.Read(this->Error) || this->File.Faces == 0 || !this->FindValues() || !this->FindCells())
    {
      return false;
    }
    this->Bytes.reset();
    vtkNew<vtkPolyData> points;
    vtkNew<vtkPolyData> cells;
    vtkMTCellCorners corners;
    const bool isRead =
      this->RewindFile() && this->ReadPoints(1, points) && this->ReadCells(1, cells, corners) && this->Rewind();
    this->Arrays = GetArraysOf(points, cells);
    if (this->File.Lines > 0)
    {
      this->Report["lines"] = static_cast<std::int64_t>(this->File.Lines);
    }
    return isRead;
  }

  bool HasNames() const { return !this->File.Libraries.empty() || !this->File.MaterialNames.empty(); }
  void GetNames(vtkPolyData* mesh) const
  {
    vtkMTFieldNames::Add(mesh, "MaterialLibraries", this->File.Libraries);
    vtkMTFieldNames::Add(mesh, "MaterialNames", this->File.MaterialNames);
  }

private:
  // Of every point and copy, texture coordinates and normals by the keys; of copies, their originals.
  bool FindValues()
  {
    vtkMTSpoolWedges& wedges = this->File.Wedges;
    this->Points = this->File.Points + wedges.GetNumberOfCopies();
    this->FirstCell = this->File.Lines;
    for (std::uint64_t i = 0; i < wedges.GetNumberOfCopies(); ++i)
    {
      std::uint64_t original = 0;
      if (!this->Take(wedges.Originals, original) || !this->Copies.Request(original, this->Error))
      {
        return false;
      }
    }
    for (std::uint64_t i = 0; i < this->Points; ++i)
    {
      Key key;
      if (!this->Take(wedges.Keys, key) || (key[0] != None && !this->Textures.Request(key[0], this->Error)) ||
        (key[1] != None && !this->Normals.Request(key[1], this->Error)))
      {
        return false;
      }
    }
    return PassAll(this->File.PointSpool, this->File.Points, sizeof(PointRecord), this->Copies, this->Error) &&
      PassAll(this->File.TextureSpool, this->File.Textures, 2 * sizeof(float), this->Textures, this->Error) &&
      PassAll(this->File.NormalSpool, this->File.Normals, 3 * sizeof(float), this->Normals, this->Error);
  }

  bool FindCells()
  {
    std::vector<std::uint64_t> corners;
    for (std::uint64_t i = 0; i < this->File.Faces; ++i)
    {
      FaceRecord face;
      corners.clear();
      if (!this->TakeFace(face, corners) || !this->AddCell(corners.data(), corners.size()))
      {
        return false;
      }
    }
    return this->FinishCells();
  }

  template <typename Record>
  bool Take(vtkMTSpoolQueue& from, Record& record)
  {
    const unsigned char* bytes = from.Take(sizeof(Record), this->Error);
    if (bytes)
    {
      std::memcpy(&record, bytes, sizeof(Record));
    }
    return bytes != nullptr;
  }

  bool TakeFace(FaceRecord& face, std::vector<std::uint64_t>& corners)
  {
    bool good = this->Take(this->File.FaceSpool, face);
    for (std::uint64_t c = 0; good && c < face.Corners; ++c)
    {
      std::uint64_t corner = 0;
      good = this->Take(this->File.Wedges.Corners, corner);
      corners.push_back(corner);
    }
    return good;
  }

  bool RewindFile() override
  {
    for (vtkMTSpoolQueue* queue :
      { &this->File.PointSpool, &this->File.FaceSpool, &this->File.Wedges.Keys, &this->File.Wedges.Corners })
    {
      queue->Rewind();
    }
    this->Copies.Rewind();
    this->Textures.Rewind();
    this->Normals.Rewind();
    this->NextPoint = 0;
    return true;
  }

  static vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, int components, std::uint64_t count)
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(count));
    array->FillValue(0.0f);
    return array;
  }

  bool TakePoint(PointRecord& record)
  {
    if (this->NextPoint++ < this->File.Points)
    {
      return this->Take(this->File.PointSpool, record);
    }
    const unsigned char* bytes = this->Copies.Next(this->Error);
    if (bytes)
    {
      std::memcpy(&record, bytes, sizeof(record));
    }
    return bytes != nullptr;
  }

  // 0 where the corner had none.
  bool TakeValues(vtkMTSpoolLookup& values, std::uint64_t key, vtkFloatArray* array, vtkIdType point)
  {
    const unsigned char* bytes = key == None ? nullptr : values.Next(this->Error);
    if (bytes)
    {
      const std::size_t size = static_cast<std::size_t>(array->GetNumberOfComponents()) * sizeof(float);
      std::memcpy(array->GetPointer(point * array->GetNumberOfComponents()), bytes, size);
    }
    return bytes || key == None;
  }

  bool ReadPoints(std::uint64_t count, vtkPolyData* chunk) override
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(this->File.IsDouble ? VTK_DOUBLE : VTK_FLOAT);
    points->SetNumberOfPoints(static_cast<vtkIdType>(count));
    const auto colors = MakeArray("RGB", 3, count);
    const auto coordinates = MakeArray("TCoords", 2, count);
    const auto normals = MakeArray("Normals", 3, count);
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(count); ++i)
    {
      PointRecord record;
      Key key;
      if (!this->TakePoint(record) || !this->Take(this->File.Wedges.Keys, key) ||
        !this->TakeValues(this->Textures, key[0], coordinates, i) ||
        !this->TakeValues(this->Normals, key[1], normals, i))
      {
        return this->Fail(this->Name + ": " + this->Error);
      }
      points->SetPoint(i, record.Place);
      colors->SetTypedTuple(i, record.Color);
    }
    chunk->SetPoints(points);
    if (this->File.HasColors)
    {
      chunk->GetPointData()->AddArray(colors);
    }
    chunk->GetPointData()->SetTCoords(this->Textures.GetNumberOfRequests() > 0 ? coordinates : nullptr);
    chunk->GetPointData()->SetNormals(this->Normals.GetNumberOfRequests() > 0 ? normals : nullptr);
    return true;
  }

  bool ReadCells(std::uint64_t count, vtkPolyData* chunk, vtkMTCellCorners& corners) override
  {
    vtkNew<vtkIntArray> materials;
    vtkNew<vtkIntArray> groups;
    materials->SetName("MaterialIds");
    groups->SetName("GroupIds");
    for (std::uint64_t i = 0; i < count; ++i)
    {
      FaceRecord face;
      if (!this->TakeFace(face, corners.Points))
      {
        return this->Fail(this->Name + ": " + this->Error);
      }
      corners.Ends.push_back(corners.Points.size());
      materials->InsertNextValue(face.Material);
      groups->InsertNextValue(face.Group);
    }
    if (!this->File.MaterialNames.empty())
    {
      chunk->GetCellData()->AddArray(materials);
    }
    if (this->File.Group > 0)
    {
      chunk->GetCellData()->AddArray(groups);
    }
    return true;
  }

  const std::string Name;
  Content File;
  vtkMTSpoolLookup Copies;
  vtkMTSpoolLookup Textures;
  vtkMTSpoolLookup Normals;
  std::unique_ptr<vtkMTFileByteSource> Bytes; // while the file is read
  std::uint64_t NextPoint = 0;
};
}

std::unique_ptr<vtkMTTriangleStream> vtkMTObjStream::Open(
  const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData* names)
{
  std::string error;
  std::unique_ptr<vtkMTFileByteSource> bytes = vtkMTFileByteSource::Open(path, error);
  if (!bytes || !settings.Store || bytes->GetSize() < settings.LeastSize)
  {
    return nullptr;
  }
  auto stream = std::make_unique<Stream>(std::move(bytes), settings.Store, settings.Memory);
  if (!stream->Open() || (!names && stream->HasNames()))
  {
    return nullptr;
  }
  stream->GetNames(names);
  return stream;
}
