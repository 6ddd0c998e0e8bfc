// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFinestPatches.h"

#include "vtkMTFinestNear.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchLoader.h"
#include "vtkMTPatchSource.h"
#include "vtkMTVector.h"

#include <algorithm>
#include <cstring>

using namespace vtkMTVector;

namespace
{
// Of distances that were computed by different ways.
constexpr double Rounding = 1e-9;

// From the origin to a triangle. Ericson, "Real-Time Collision Detection" (2005), section 5.1.5: the regions of the
// corners, of the edges, of the inside.
double GetDistance2(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector ab = Subtract(b, a);
  const Vector ac = Subtract(c, a);
  const double d1 = -Dot(ab, a);
  const double d2 = -Dot(ac, a);
  const double d3 = -Dot(ab, b);
  const double d4 = -Dot(ac, b);
  const double d5 = -Dot(ab, c);
  const double d6 = -Dot(ac, c);
  const auto square = [](const Vector& x) { return Dot(x, x); };
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return square(a);
  }
  if (d3 >= 0.0 && d4 <= d3)
  {
    return square(b);
  }
  if (d6 >= 0.0 && d5 <= d6)
  {
    return square(c);
  }
  if (d1 * d4 - d3 * d2 <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    return square(Lerp(a, b, d1 / (d1 - d3)));
  }
  if (d5 * d2 - d1 * d6 <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    return square(Lerp(a, c, d2 / (d2 - d6)));
  }
  if (d3 * d6 - d5 * d4 <= 0.0 && d4 >= d3 && d5 >= d6)
  {
    return square(Lerp(b, c, (d4 - d3) / ((d4 - d3) + (d5 - d6))));
  }
  const Vector n = Cross(ab, ac);
  const double height = Dot(a, n);
  return height * height / Dot(n, n);
}

Vector ToVector(const vtkMTPoint& point, const Vector& x)
{
  return { point[0] - x[0], point[1] - x[1], point[2] - x[2] };
}
}

//------------------------------------------------------------------------------
vtkMTFinestPatches::Patch::Patch(std::shared_ptr<const vtkMTPatch> mesh, bool ofPoints, std::size_t column)
  : Mesh(std::move(mesh))
  , Ids(ofPoints ? this->Mesh->PointColumns[column] : this->Mesh->CellColumns[column])
  , OfPoints(ofPoints)
{
  const std::size_t triangles = ofPoints ? 0 : this->Mesh->Triangles.size();
  for (std::size_t begin = 0; begin < triangles; begin += BlockSize)
  {
    vtkMTBox box{ VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MIN };
    for (std::size_t t = begin; t < std::min(begin + BlockSize, triangles); ++t)
    {
      for (const std::uint32_t p : this->Mesh->GetPointsOfTriangle(t))
      {
        for (std::size_t i = 0; i < 3; ++i)
        {
          box[2 * i] = std::min(box[2 * i], this->Mesh->Points[p][i]);
          box[2 * i + 1] = std::max(box[2 * i + 1], this->Mesh->Points[p][i]);
        }
      }
    }
    this->Boxes.push_back(box);
  }
  this->Bytes = this->Mesh->GetMemorySize() + this->Boxes.size() * sizeof(vtkMTBox);
}

vtkIdType vtkMTFinestPatches::Patch::GetId(std::size_t i) const
{
  vtkIdType id;
  std::memcpy(&id, this->Ids.data() + i * sizeof(id), sizeof(id));
  return id;
}

void vtkMTFinestPatches::Patch::FindTriangle(std::size_t triangle, Search& search) const
{
  const vtkMTTriangle points = this->Mesh->GetPointsOfTriangle(triangle);
  const Vector a = ToVector(this->Mesh->Points[points[0]], search.X);
  const Vector b = ToVector(this->Mesh->Points[points[1]], search.X);
  const Vector c = ToVector(this->Mesh->Points[points[2]], search.X);
  const double distance2 = GetDistance2(a, b, c);
  if (!(distance2 <= search.GetFarthest2()))
  {
    return;
  }
  const vtkIdType id = this->GetId(triangle);
  search.Any.Offer(distance2, id);
  if (search.HasDirection && distance2 <= search.Reach2 &&
    Dot(Cross(Subtract(b, a), Subtract(c, a)), search.Direction) > 0.0)
  {
    search.Facing.Offer(distance2, id);
  }
}

void vtkMTFinestPatches::Patch::FindPoints(Search& search) const
{
  for (std::uint32_t w = 0; w < this->Mesh->GetNumberOfWedges(); ++w)
  {
    const Vector way = ToVector(this->Mesh->Points[this->Mesh->GetPointOfWedge(w)], search.X);
    const double distance2 = Dot(way, way);
    if (distance2 <= search.Any.Distance2)
    {
      search.Any.Offer(distance2, this->GetId(w));
    }
  }
}

void vtkMTFinestPatches::Patch::Find(Search& search) const
{
  if (this->OfPoints)
  {
    this->FindPoints(search);
    return;
  }
  for (std::size_t block = 0; block < this->Boxes.size(); ++block)
  {
    const double bound = vtkMTFinestNear::GetDistance2(this->Boxes[block], search.X) * (1.0 - Rounding);
    const std::size_t end = std::min((block + 1) * BlockSize, this->Mesh->Triangles.size());
    for (std::size_t t = block * BlockSize; t < end && bound <= search.GetFarthest2(); ++t)
    {
      this->FindTriangle(t, search);
    }
  }
}

//------------------------------------------------------------------------------
vtkMTFinestPatches::vtkMTFinestPatches(const vtkMTPatchSource& source, std::size_t array, std::size_t limit)
  : Source(source)
  , Limit(limit)
  , Arrays(source.GetGraph().Arrays.size(), 0)
{
  const std::vector<vtkMTArrayInfo>& arrays = source.GetGraph().Arrays;
  this->Arrays[array] = 1;
  this->OfPoints = arrays[array].Association == vtkMTArrayInfo::Point;
  this->Column =
    static_cast<std::size_t>(std::count_if(arrays.begin(), arrays.begin() + static_cast<std::ptrdiff_t>(array),
      [&](const vtkMTArrayInfo& other) { return other.Association == arrays[array].Association; }));
}

std::size_t vtkMTFinestPatches::GetBytes(std::uint32_t arc) const
{
  return vtkMTPatchLoader::GetPatchBytes(this->Source.GetGraph(), arc, this->Arrays) * 11 / 10; // and the boxes
}

std::uint64_t vtkMTFinestPatches::GetNumberOfReads() const
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  return this->Reads;
}

bool vtkMTFinestPatches::Has(std::uint32_t arc) const
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  return this->Entries.count(arc) != 0;
}

// With the lock. False where it is there, or being read.
bool vtkMTFinestPatches::Claim(std::uint32_t arc)
{
  return this->Entries.emplace(arc, Entry()).second;
}

void vtkMTFinestPatches::Touch(std::uint32_t arc, Entry& entry)
{
  this->Order.erase(entry.Tick);
  entry.Tick = ++this->Tick;
  this->Order[entry.Tick] = arc;
}

void vtkMTFinestPatches::MakeRoom()
{
  while (this->Bytes > this->Limit && this->Order.size() > 1)
  {
    const auto oldest = this->Order.begin();
    const auto entry = this->Entries.find(oldest->second);
    this->Bytes -= entry->second.Known->GetBytes();
    this->Entries.erase(entry);
    this->Order.erase(oldest);
  }
}

void vtkMTFinestPatches::Put(std::uint32_t arc, PatchPointer patch, const std::string& error)
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  Entry& entry = this->Entries[arc];
  entry.IsBeingRead = false;
  entry.Known = std::move(patch);
  entry.Error = error;
  ++this->Reads;
  if (entry.Known)
  {
    this->Bytes += entry.Known->GetBytes();
    this->Touch(arc, entry);
    this->MakeRoom();
  }
  this->News.notify_all();
}

void vtkMTFinestPatches::Add(std::uint32_t arc, const std::shared_ptr<const vtkMTPatch>& mesh)
{
  const std::vector<vtkMTColumn>& columns = this->OfPoints ? mesh->PointColumns : mesh->CellColumns;
  const std::size_t tuples = this->OfPoints ? mesh->GetNumberOfWedges() : mesh->Triangles.size();
  if (this->Column >= columns.size() || columns[this->Column].size() != tuples * sizeof(vtkIdType))
  {
    return; // it was drawn without the ids
  }
  auto patch = std::make_shared<const Patch>(mesh, this->OfPoints, this->Column);
  const std::lock_guard<std::mutex> lock(this->Lock);
  if (this->Claim(arc))
  {
    Entry& entry = this->Entries[arc];
    entry.IsBeingRead = false;
    entry.Known = std::move(patch);
    this->Bytes += entry.Known->GetBytes();
    this->Touch(arc, entry);
    this->MakeRoom();
  }
}

void vtkMTFinestPatches::Read(const std::vector<std::uint32_t>& arcs)
{
  std::vector<std::uint32_t> missing;
  {
    const std::lock_guard<std::mutex> lock(this->Lock);
    std::copy_if(
      arcs.begin(), arcs.end(), std::back_inserter(missing), [this](std::uint32_t arc) { return this->Claim(arc); });
  }
  const auto take = [&](std::size_t index, bool read, vtkMTPatch& mesh, const std::string& error)
  {
    PatchPointer patch;
    if (read)
    {
      patch = std::make_shared<const Patch>(
        std::make_shared<const vtkMTPatch>(std::move(mesh)), this->OfPoints, this->Column);
    }
    this->Put(missing[index], std::move(patch), error);
  };
  if (!missing.empty())
  {
    this->Source.ReadPatches(missing, &this->Arrays, take);
  }
}

vtkMTFinestPatches::PatchPointer vtkMTFinestPatches::Get(std::uint32_t arc, std::string& error)
{
  std::unique_lock<std::mutex> lock(this->Lock);
  for (auto found = this->Entries.find(arc);; found = this->Entries.find(arc))
  {
    if (found == this->Entries.end())
    {
      lock.unlock();
      this->Read({ arc });
      lock.lock();
      continue; // another thread may have had it dropped since
    }
    if (!found->second.IsBeingRead)
    {
      break;
    }
    this->News.wait(lock);
  }
  Entry& entry = this->Entries[arc];
  if (entry.Known)
  {
    this->Touch(arc, entry);
  }
  error = entry.Known ? error : entry.Error;
  return entry.Known;
}
