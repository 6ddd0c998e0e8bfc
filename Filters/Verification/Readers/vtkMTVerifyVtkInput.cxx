// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVerifyVtkInput.h"

#include "vtkMTVerifyMesh.h"
#include "vtkMTVerifyText.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDataSetReader.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkExecutive.h"
#include "vtkIdList.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <limits>

namespace
{
// What a reader says becomes the error, instead of a message on the screen.
void KeepMessage(vtkObject*, unsigned long, void* client, void* text)
{
  auto* error = static_cast<std::string*>(client);
  *error = error->empty() && text ? static_cast<const char*>(text) : *error;
}

// That VTK lacks the module which defines a key of an array's information changes nothing that is checked.
void PassWarning(vtkObject*, unsigned long, void*, void* text)
{
  const std::string message = text ? static_cast<const char*>(text) : "";
  if (message.find("Could not locate key ") == std::string::npos)
  {
    vtkOutputWindowDisplayWarningText(message.c_str());
  }
}

template <class Reader>
vtkSmartPointer<vtkDataObject> ReadBy(const std::string& path, std::string& error)
{
  vtkNew<Reader> reader;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(KeepMessage);
  keep->SetClientData(&error);
  reader->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
  vtkNew<vtkCallbackCommand> pass;
  pass->SetCallback(PassWarning);
  reader->AddObserver(vtkCommand::WarningEvent, pass);
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutputDataObject(0);
}

// Legacy files: all arrays of a kind, where the reader would take the first one only.
template <>
vtkSmartPointer<vtkDataObject> ReadBy<vtkDataSetReader>(const std::string& path, std::string& error)
{
  vtkNew<vtkDataSetReader> reader;
  vtkNew<vtkCallbackCommand> keep;
  keep->SetCallback(KeepMessage);
  keep->SetClientData(&error);
  reader->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, keep);
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  return reader->GetOutputDataObject(0);
}

vtkSmartPointer<vtkPolyData> GetSurface(vtkDataObject* data)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh;
  }
  if (!vtkDataSet::SafeDownCast(data))
  {
    return nullptr;
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(data);
  surface->Update();
  return surface->GetOutput();
}

vtkSmartPointer<vtkPolyData> GetSurfaceOfBlocks(vtkCompositeDataSet* blocks)
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  std::vector<vtkPolyData*> parts;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkSmartPointer<vtkPolyData> surface = GetSurface(iterator->GetCurrentDataObject());
    if (surface)
    {
      surfaces.push_back(surface);
      parts.push_back(surface);
    }
  }
  auto all = vtkSmartPointer<vtkPolyData>::New();
  if (parts.size() == 1)
  {
    all->ShallowCopy(parts[0]);
    return all;
  }
  vtkMTVerifyVtkInput::Append(parts, false, all);
  return all;
}

// Polygons, then strips as triangles, and which cell each of them is of.
void CollectPolygons(vtkPolyData* part, std::vector<std::vector<vtkIdType>>& polygons, std::vector<vtkIdType>& cells)
{
  vtkIdType cell = part->GetNumberOfVerts() + part->GetNumberOfLines();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < part->GetPolys()->GetNumberOfCells(); ++i, ++cell)
  {
    part->GetPolys()->GetCellAtId(i, ids);
    polygons.emplace_back(ids->begin(), ids->end());
    cells.push_back(cell);
  }
  for (vtkIdType i = 0; i < part->GetStrips()->GetNumberOfCells(); ++i, ++cell)
  {
    part->GetStrips()->GetCellAtId(i, ids);
    for (vtkIdType j = 2; j < ids->GetNumberOfIds(); ++j)
    {
      const vtkIdType odd = j % 2;
      polygons.push_back({ ids->GetId(j - 2), ids->GetId(j - 1 + odd), ids->GetId(j - odd) });
      cells.push_back(cell);
    }
  }
}

vtkMTVerifyMesh::KindType GetKind(vtkDataSetAttributes* attributes, vtkDataArray* array)
{
  auto* table = array->GetLookupTable();
  const bool isColor = attributes->GetScalars() == array && array->GetNumberOfComponents() >= 3;
  return attributes->GetNormals() == array             ? vtkMTVerifyMesh::Normals
    : attributes->GetTCoords() == array                ? vtkMTVerifyMesh::Coordinates
    : isColor                                          ? vtkMTVerifyMesh::Colors
    : table && table->GetNumberOfAnnotatedValues() > 0 ? vtkMTVerifyMesh::Names
                                                       : vtkMTVerifyMesh::Plain;
}

void CollectArrays(
  vtkDataSetAttributes* attributes, bool isOfCells, const std::vector<vtkIdType>* cells, vtkMTVerifyMesh& mesh)
{
  for (int a = 0; a < attributes->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* from = attributes->GetArray(a);
    if (!from || !from->GetName())
    {
      continue;
    }
    const int components = from->GetNumberOfComponents();
    vtkMTVerifyMesh::Array& to = mesh.GetArray(from->GetName(), GetKind(attributes, from), isOfCells, components);
    if (to.Components != components)
    {
      continue;
    }
    const double unit =
      to.Kind == vtkMTVerifyMesh::Colors && from->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
    const vtkIdType tuples = cells ? static_cast<vtkIdType>(cells->size()) : from->GetNumberOfTuples();
    for (vtkIdType t = 0; t < tuples; ++t)
    {
      for (int c = 0; c < components; ++c)
      {
        double value = from->GetComponent(cells ? (*cells)[t] : t, c);
        if (to.Kind == vtkMTVerifyMesh::Names)
        {
          auto* table = from->GetLookupTable();
          const vtkIdType index = table ? table->GetAnnotatedValueIndex(vtkVariant(value)) : -1;
          value = vtkMTVerifyMesh::GetIndexOfName(
            to, index < 0 ? std::to_string(value) : std::string(table->GetAnnotation(index)));
        }
        to.Values.push_back(value * unit);
      }
    }
  }
}
}

void vtkMTVerifyVtkInput::Append(const std::vector<vtkPolyData*>& parts, bool addPart, vtkPolyData* out)
{
  vtkMTVerifyMesh mesh;
  std::vector<double> partOfCell;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    vtkPolyData* part = parts[p];
    const auto first = static_cast<vtkIdType>(mesh.Points.size());
    std::vector<vtkIdType> cells;
    std::vector<std::vector<vtkIdType>> polygons;
    CollectPolygons(part, polygons, cells);
    mesh.Fill();
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      mesh.Points.emplace_back();
      part->GetPoint(i, mesh.Points.back().data());
    }
    for (std::vector<vtkIdType>& polygon : polygons)
    {
      for (vtkIdType& id : polygon)
      {
        id = id < 0 || id >= part->GetNumberOfPoints() ? -1 : id + first;
      }
    }
    const std::size_t before = mesh.Polygons.size();
    const std::size_t arrays = mesh.Arrays.size();
    CollectArrays(part->GetPointData(), false, nullptr, mesh);
    CollectArrays(part->GetCellData(), true, &cells, mesh);
    for (std::size_t a = arrays; a < mesh.Arrays.size(); ++a) // what the parts before lack
    {
      vtkMTVerifyMesh::Array& array = mesh.Arrays[a];
      const std::size_t lacking = array.IsOfCells ? before : static_cast<std::size_t>(first);
      array.Values.insert(array.Values.begin(), lacking * array.Components, std::numeric_limits<double>::quiet_NaN());
    }
    mesh.Polygons.insert(mesh.Polygons.end(), polygons.begin(), polygons.end());
    partOfCell.resize(mesh.Polygons.size(), static_cast<double>(p));
  }
  if (addPart)
  {
    for (vtkMTVerifyMesh::Array& array : mesh.Arrays)
    {
      array.Name = array.IsOfCells && array.Name == "PartId" ? "InputPartId" : array.Name;
    }
    mesh.GetArray("PartId", vtkMTVerifyMesh::Plain, true, 1).Values = partOfCell;
  }
  mesh.Give(out);
}

const char* vtkMTVerifyVtkInput::GetReader(const std::string& ending)
{
  return ending == "vtp" ? "vtkXMLPolyDataReader"
    : ending == "vtu"    ? "vtkXMLUnstructuredGridReader"
    : ending == "vtm"    ? "vtkXMLMultiBlockDataReader"
    : ending == "vtk"    ? "vtkDataSetReader"
                         : nullptr;
}

bool vtkMTVerifyVtkInput::Read(const std::string& path, vtkPolyData* out, std::string& error)
{
  const std::string ending = vtkMTVerifyText::GetEnding(path);
  std::string message;
  vtkSmartPointer<vtkDataObject> data;
  if (ending == "vtp")
  {
    data = ReadBy<vtkXMLPolyDataReader>(path, message);
  }
  else if (ending == "vtu")
  {
    data = ReadBy<vtkXMLUnstructuredGridReader>(path, message);
  }
  else if (ending == "vtm")
  {
    data = ReadBy<vtkXMLMultiBlockDataReader>(path, message);
  }
  else if (ending == "vtk")
  {
    data = ReadBy<vtkDataSetReader>(path, message);
  }
  auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
  const vtkSmartPointer<vtkPolyData> mesh = blocks ? GetSurfaceOfBlocks(blocks) : GetSurface(data);
  if (!message.empty() || !mesh)
  {
    error = message.empty() ? "holds no surface" : "VTK's reader says: " + message.substr(message.find("): ") + 1);
    return false;
  }
  out->ShallowCopy(mesh);
  return true;
}
