// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCutIds.h"

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMTPlacement.h"
#include "vtkMTVector.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <thread>

using namespace vtkMTVector;

namespace
{
constexpr unsigned int MostThreads = 4;

// The array of that role, where the mesh has it.
vtkIdTypeArray* FindArray(const vtkMTGraph& graph, vtkMTArrayInfo::RoleType role, vtkPolyData* mesh)
{
  for (const vtkMTArrayInfo& info : graph.Arrays)
  {
    if (info.Role == role && info.IsFinestOnly())
    {
      vtkDataSetAttributes* const attributes = info.Association == vtkMTArrayInfo::Cell
        ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData())
        : mesh->GetPointData();
      return vtkIdTypeArray::SafeDownCast(attributes->GetArray(info.Name.c_str()));
    }
  }
  return nullptr;
}

class Filling
{
public:
  Filling(const vtkMTPatchSource& source, const vtkMTPlacement* placement, vtkPolyData* mesh)
    : Source(source)
    , Mesh(mesh)
  {
    if (placement && !placement->IsIdentity())
    {
      this->IsPlaced = true;
      this->Sign = placement->IsMirrored() ? -1.0 : 1.0;
      this->ToModel = placement->GetInverse();
    }
  }

  bool Run(vtkMTArrayInfo::RoleType role, const std::vector<std::uint32_t>& arcs,
    const vtkMTInputIdFinder::Progress& progress, std::string& error)
  {
    vtkIdTypeArray* const array = FindArray(this->Source.GetKnownGraph(), role, this->Mesh);
    if (!array)
    {
      return true;
    }
    this->Queries.clear();
    this->Places.clear();
    role == vtkMTArrayInfo::InputCellIds ? this->AddCells(arcs, array) : this->AddPoints(array);
    vtkMTInputIdFinder::Settings settings;
    settings.Threads = static_cast<int>(std::min(std::max(std::thread::hardware_concurrency(), 1u), MostThreads));
    vtkMTInputIdFinder finder(this->Source, role, settings);
    std::vector<vtkIdType> ids;
    const bool found = finder.Find(this->Queries, ids, error, progress);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      array->SetValue(this->Places[i], ids[i]);
    }
    array->Modified();
    return found;
  }

private:
  Vector GetPlace(vtkIdType point) const
  {
    Vector x;
    this->Mesh->GetPoint(point, x.data());
    return this->IsPlaced ? this->ToModel.ToObject(x) : x;
  }

  // The triangles of the arcs lie one after the other.
  void AddCells(const std::vector<std::uint32_t>& arcs, vtkIdTypeArray* array)
  {
    vtkNew<vtkIdList> ids;
    vtkIdType cell = 0;
    for (const std::uint32_t arc : arcs)
    {
      const vtkIdType end = cell + this->Source.GetKnownGraph().Arcs[arc].Triangles;
      for (; cell < end; ++cell)
      {
        if (array->GetValue(cell) != vtkMTInputIdFinder::Unknown)
        {
          continue;
        }
        this->Mesh->GetCellPoints(cell, ids);
        const std::array<Vector, 3> corners{ this->GetPlace(ids->GetId(0)), this->GetPlace(ids->GetId(1)),
          this->GetPlace(ids->GetId(2)) };
        vtkMTInputIdFinder::Query query;
        query.Arc = arc;
        query.X = Scale(Add(Add(corners[0], corners[1]), corners[2]), 1.0 / 3.0);
        // A mirrored mesh has its triangles turned.
        query.Direction = Scale(Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0])), this->Sign);
        this->Queries.push_back(query);
        this->Places.push_back(cell);
      }
    }
  }

  void AddPoints(vtkIdTypeArray* array)
  {
    for (vtkIdType point = 0; point < array->GetNumberOfValues(); ++point)
    {
      if (array->GetValue(point) == vtkMTInputIdFinder::Unknown)
      {
        vtkMTInputIdFinder::Query query;
        query.X = this->GetPlace(point);
        this->Queries.push_back(query);
        this->Places.push_back(point);
      }
    }
  }

  const vtkMTPatchSource& Source;
  vtkPolyData* const Mesh;
  bool IsPlaced = false;
  double Sign = 1.0;
  vtkMTPlacement ToModel;
  std::vector<vtkMTInputIdFinder::Query> Queries;
  std::vector<vtkIdType> Places; // of the queries, in the array
};
}

bool vtkMTCutIds::Fill(const vtkMTPatchSource& source, const std::vector<std::uint32_t>& arcs,
  const vtkMTPlacement* placement, vtkPolyData* mesh, const vtkMTInputIdFinder::Progress& progress, std::string& error)
{
  Filling filling(source, placement, mesh);
  const auto half = [&progress](double from)
  {
    return !progress ? vtkMTInputIdFinder::Progress()
                     : [&progress, from](double fraction) { return progress(from + 0.5 * fraction); };
  };
  return filling.Run(vtkMTArrayInfo::InputCellIds, arcs, half(0.0), error) &&
    filling.Run(vtkMTArrayInfo::InputPointIds, arcs, half(0.5), error);
}
