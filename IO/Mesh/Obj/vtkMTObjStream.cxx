// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTObjStream.h"

#include "vtkMTChunkStream.h"
#include "vtkMTFieldNames.h"
#include "vtkMTGzipByteSource.h"
#include "vtkMTIdNames.h"
#include "vtkMTObjMaterials.h"
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
  std::int32_t Object;
  std::int32_t Padding;
};

// A point as the lines "v" give it.
struct PointRecord
{
  double Place[3];
  vtkMTObjParser::Color Color;
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
    , OtherSpool(store)
  {
  }

  bool Read(std::string& error)
  {
    return this->Parse(error) && this->PointSpool.Seal(error) && this->TextureSpool.Seal(error) &&
      this->NormalSpool.Seal(error) && this->FaceSpool.Seal(error) && this->OtherSpool.Seal(error) &&
      this->Wedges.Finish(this->Points, { this->Textures, this->Normals }, this->Missing, error) &&
      this->FindOthers(error);
  }

  // When it is known which faces are bad.
  const vtkMTInputReport& Finish(std::uint64_t badFaces)
  {
    const std::uint64_t good = this->GoodOthers[0] + this->GoodOthers[1];
    this->CountAll(this->Missing, badFaces + this->Others - good);
    vtkMTInputReports::Add("vertices", this->GoodOthers[Vertices], this->Report);
    vtkMTInputReports::Add("lines", this->GoodOthers[Line], this->Report);
    return this->Report;
  }
  std::uint64_t GetNumberOfGoodOthers() const { return this->GoodOthers[Vertices] + this->GoodOthers[Line]; }

  using vtkMTObjParser::Faces;
  using vtkMTObjParser::FinishColor;
  using vtkMTObjParser::Groups;
  using vtkMTObjParser::HasAlpha;
  using vtkMTObjParser::HasColors;
  using vtkMTObjParser::HasGroups;
  using vtkMTObjParser::HasObjects;
  using vtkMTObjParser::IsDouble;
  using vtkMTObjParser::Libraries;
  using vtkMTObjParser::Materials;
  using vtkMTObjParser::Normals;
  using vtkMTObjParser::Objects;
  using vtkMTObjParser::Points;
  using vtkMTObjParser::Textures;

  vtkMTSpoolQueue PointSpool;
  vtkMTSpoolQueue TextureSpool;
  vtkMTSpoolQueue NormalSpool;
  vtkMTSpoolQueue FaceSpool;
  vtkMTSpoolWedges Wedges;

private:
  bool AddVertex(const double* place, const vtkMTObjParser::Color& color) override
  {
    PointRecord record{};
    std::copy_n(place, 3, record.Place);
    record.Color = color;
    return this->PointSpool.Put(&record, sizeof(record), this->Error);
  }
  bool AddTexture(const float* coordinates) override
  {
    return this->TextureSpool.Put(coordinates, 2 * sizeof(float), this->Error);
  }
  bool AddNormal(const float* normal) override { return this->NormalSpool.Put(normal, 3 * sizeof(float), this->Error); }
  bool AddCell(const Cell& cell) override
  {
    if (cell.Kind != Face)
    {
      // They are only counted, when it is known whether their points exist.
      std::uint64_t record[2] = { static_cast<std::uint64_t>(cell.Kind), 0 };
      for (const Corner& corner : cell.Corners)
      {
        record[1] = std::max(record[1], corner.Point);
      }
      ++this->Others;
      return this->OtherSpool.Put(record, sizeof(record), this->Error);
    }
    const FaceRecord record{ cell.Corners.size(), cell.Material, cell.Group, cell.Object, 0 };
    return this->FaceSpool.Put(&record, sizeof(record), this->Error) &&
      std::all_of(cell.Corners.begin(), cell.Corners.end(),
        [this](const Corner& corner) {
          return this->Wedges.AddCorner(corner.Point, { corner.Texture, corner.Normal }, this->Error);
        });
  }

  bool FindOthers(std::string& error)
  {
    for (std::uint64_t i = 0; i < this->Others; ++i)
    {
      std::uint64_t record[2];
      const unsigned char* bytes = this->OtherSpool.Take(sizeof(record), error);
      if (!bytes)
      {
        return false;
      }
      std::memcpy(record, bytes, sizeof(record));
      this->GoodOthers[record[0]] += this->HasCorner(record[1]) ? 1 : 0;
    }
    return true;
  }

  vtkMTSpoolQueue OtherSpool; // of vertices and lines: the kind, and the largest point
  std::uint64_t Others = 0;
  std::uint64_t GoodOthers[2] = { 0, 0 }; // by kind
  Key Missing = { 0, 0 };
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
  Stream(std::unique_ptr<vtkMTByteSource> bytes, vtkMTSpoolStore* store, std::size_t memory)
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
    if (!this->File.Read(this->Error) || !this->FindValues() || !this->FindCells() ||
      this->GetNumberOfCells() == this->FirstCell)
    {
      return false;
    }
    this->NameIds();
    this->Bytes.reset();
    vtkNew<vtkPolyData> points;
    vtkNew<vtkPolyData> cells;
    vtkMTCellCorners corners;
    const bool isRead =
      this->RewindFile() && this->ReadPoints(1, points) && this->ReadCells(1, cells, corners) && this->Rewind();
    this->Arrays = GetArraysOf(points, cells);
    return isRead;
  }

  bool HasNames() const { return !this->File.Libraries.empty() || !this->File.Materials.Names.empty(); }
  void GetNames(vtkPolyData* mesh) const
  {
    vtkMTFieldNames::Add(mesh, "MaterialLibraries", this->File.Libraries);
    vtkMTFieldNames::Add(mesh, "MaterialNames", this->File.Materials.Names);
  }

private:
  // Of every point and copy, texture coordinates and normals by the keys; of copies, their originals.
  bool FindValues()
  {
    vtkMTSpoolWedges& wedges = this->File.Wedges;
    this->Points = this->File.Points + wedges.GetNumberOfCopies();
    this->FirstCell = this->File.GetNumberOfGoodOthers();
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
    std::uint64_t bad = 0;
    for (std::uint64_t i = 0; i < this->File.Faces; ++i)
    {
      FaceRecord face;
      corners.clear();
      if (!this->TakeFace(face, corners))
      {
        return false;
      }
      const bool isBad = std::find(corners.begin(), corners.end(), None) != corners.end();
      bad += isBad ? 1 : 0;
      if (!isBad && !this->AddCell(corners.data(), corners.size()))
      {
        return false;
      }
    }
    vtkMTInputReports::Add(this->File.Finish(bad), this->Report);
    return this->FinishCells();
  }

  // The tables of the ids' names, which every chunk has.
  void NameIds()
  {
    if (!this->File.Materials.Names.empty())
    {
      std::vector<std::string> ignored; // vtkMTTextureCollector meets them again
      vtkMTObjMaterials::SetTable(this->Materials, this->File.Materials.Names,
        vtkMTObjMaterials::Read(this->Name, this->File.Libraries, ignored));
    }
    if (this->File.HasGroups())
    {
      vtkMTIdNames::Set(this->Groups, this->File.Groups.Names);
    }
    if (this->File.HasObjects())
    {
      vtkMTIdNames::Set(this->Objects, this->File.Objects.Names);
    }
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
    const int channels = this->File.HasAlpha() ? 4 : 3;
    const auto colors = MakeArray(channels == 4 ? "RGBA" : "RGB", channels, count);
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
      colors->SetTypedTuple(i, this->File.FinishColor(record.Color).data());
    }
    chunk->SetPoints(points);
    if (this->File.HasColors())
    {
      chunk->GetPointData()->SetScalars(colors);
    }
    chunk->GetPointData()->SetTCoords(this->Textures.GetNumberOfRequests() > 0 ? coordinates : nullptr);
    chunk->GetPointData()->SetNormals(this->Normals.GetNumberOfRequests() > 0 ? normals : nullptr);
    return true;
  }

  bool ReadCells(std::uint64_t count, vtkPolyData* chunk, vtkMTCellCorners& corners) override
  {
    std::vector<std::uint64_t> ofFace;
    const vtkNew<vtkIntArray> materials;
    const vtkNew<vtkIntArray> groups;
    const vtkNew<vtkIntArray> objects;
    while (corners.Ends.size() < count)
    {
      FaceRecord face;
      ofFace.clear();
      if (!this->TakeFace(face, ofFace))
      {
        return this->Fail(this->Name + ": " + this->Error);
      }
      if (std::find(ofFace.begin(), ofFace.end(), None) != ofFace.end())
      {
        continue;
      }
      corners.Points.insert(corners.Points.end(), ofFace.begin(), ofFace.end());
      corners.Ends.push_back(corners.Points.size());
      materials->InsertNextValue(face.Material);
      groups->InsertNextValue(face.Group);
      objects->InsertNextValue(face.Object);
    }
    AddIds(chunk, "MaterialIds", materials, this->Materials);
    AddIds(chunk, "GroupIds", groups, this->Groups);
    AddIds(chunk, "ObjectIds", objects, this->Objects);
    return true;
  }

  // Those that have names.
  static void AddIds(vtkPolyData* chunk, const char* name, vtkIntArray* ids, vtkIntArray* named)
  {
    if (named->GetLookupTable())
    {
      ids->SetName(name);
      ids->SetLookupTable(named->GetLookupTable());
      chunk->GetCellData()->AddArray(ids);
    }
  }

  const std::string Name;
  Content File;
  vtkMTSpoolLookup Copies;
  vtkMTSpoolLookup Textures;
  vtkMTSpoolLookup Normals;
  std::unique_ptr<vtkMTByteSource> Bytes; // while the file is read
  std::uint64_t NextPoint = 0;
  vtkNew<vtkIntArray> Materials; // without values, with the names of all ids
  vtkNew<vtkIntArray> Groups;
  vtkNew<vtkIntArray> Objects;
};
}

std::unique_ptr<vtkMTTriangleStream> vtkMTObjStream::Open(
  const std::string& path, const vtkMTMeshStream::Settings& settings, vtkPolyData* names)
{
  std::string error;
  std::unique_ptr<vtkMTByteSource> bytes = vtkMTGzipByteSource::OpenFile(path, error);
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
