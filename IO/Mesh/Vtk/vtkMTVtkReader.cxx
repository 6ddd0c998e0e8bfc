// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTVtkReader.h"

#include "vtkMTByteSource.h"
#include "vtkMTErrorCollector.h"
#include "vtkMTGridSurface.h"
#include "vtkMTIdNames.h"
#include "vtkMTLegacyCheck.h"
#include "vtkMTMeshMerge.h"
#include "vtkMTXmlCheck.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDataSet.h"
#include "vtkDataSetReader.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"
#include "vtkSmartPointer.h"
#include "vtkXMLMultiBlockDataReader.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLRectilinearGridReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <limits>
#include <vector>

namespace
{
template <typename Reader>
bool Update(Reader* reader, vtkMTErrorCollector& errors, std::string& error)
{
  errors.Observe(static_cast<vtkAlgorithm*>(reader));
  reader->Update();
  if (errors.HasErrors() || reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    error = errors.HasErrors() ? errors.GetMessage() : vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode());
    return false;
  }
  return true;
}

// False when VTK's readers cannot take so many from memory.
bool ReadAll(const vtkMTByteSource& bytes, std::string& text, std::string& error)
{
  if (bytes.GetSize() > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
  {
    error = "holds more than 2 GiB; decompress it first";
    return false;
  }
  text.resize(static_cast<std::size_t>(bytes.GetSize()));
  return bytes.Read(0, text.size(), text.data(), error);
}

//------------------------------------------------------------------------------
// The blocks that have surfaces, as parts of one mesh.
class Blocks
{
public:
  bool Add(vtkDataSet* block, const char* name, vtkMTInputReport& report, std::string& error)
  {
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    if (!block || !vtkMTGridSurface::CanTake(block) || block->GetNumberOfCells() == 0)
    {
      vtkMTInputReports::Add("skipped_blocks", 1, report);
      return true;
    }
    if (!vtkMTGridSurface::Take(block, surface, report, error))
    {
      return false;
    }
    this->Names.emplace_back(name ? name : "block " + std::to_string(this->Names.size()));
    this->Meshes.push_back(surface);
    return true;
  }

  bool Merge(vtkPolyData* output, vtkMTInputReport& report, std::string& error)
  {
    if (this->Meshes.empty())
    {
      error = "has no block with a surface";
      return false;
    }
    if (this->Meshes.size() == 1)
    {
      output->ShallowCopy(this->Meshes.front());
      return true;
    }
    if (!vtkMTMeshMerge::Merge(this->Meshes, output, report, error))
    {
      return false;
    }
    vtkMTIdNames::Set(output->GetCellData()->GetArray(vtkMTMeshMerge::GetPartIdName()), this->Names);
    return true;
  }

private:
  std::vector<vtkSmartPointer<vtkPolyData>> Meshes;
  std::vector<std::string> Names;
};

bool TakeBlocks(vtkMultiBlockDataSet* dataset, vtkPolyData* output, vtkMTInputReport& report, std::string& error)
{
  Blocks blocks;
  vtkNew<vtkDataObjectTreeIterator> iterator;
  iterator->SetDataSet(dataset);
  iterator->SkipEmptyNodesOff();
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    const bool hasName =
      iterator->HasCurrentMetaData() != 0 && iterator->GetCurrentMetaData()->Has(vtkCompositeDataSet::NAME()) != 0;
    const char* name = hasName ? iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : nullptr;
    if (!blocks.Add(vtkDataSet::SafeDownCast(iterator->GetCurrentDataObject()), name, report, error))
    {
      return false;
    }
  }
  return blocks.Merge(output, report, error);
}

vtkSmartPointer<vtkXMLReader> MakeXmlReader(const std::string& type)
{
  if (type == "PolyData")
  {
    return vtkSmartPointer<vtkXMLPolyDataReader>::New();
  }
  if (type == "UnstructuredGrid")
  {
    return vtkSmartPointer<vtkXMLUnstructuredGridReader>::New();
  }
  if (type == "StructuredGrid")
  {
    return vtkSmartPointer<vtkXMLStructuredGridReader>::New();
  }
  if (type == "RectilinearGrid")
  {
    return vtkSmartPointer<vtkXMLRectilinearGridReader>::New();
  }
  return type == "vtkMultiBlockDataSet" ? vtkSmartPointer<vtkXMLMultiBlockDataReader>::New() : nullptr;
}
}

bool vtkMTVtkReader::ReadXml(
  const vtkMTByteSource& bytes, bool isCompressed, vtkPolyData* output, std::string& error, vtkMTInputReport& report)
{
  vtkMTXmlCheck check(bytes);
  const vtkSmartPointer<vtkXMLReader> reader = MakeXmlReader(check.GetType());
  const bool isComposite = check.GetType() == "vtkMultiBlockDataSet";
  if (!reader || (isComposite && isCompressed))
  {
    error = reader ? "is compressed, and refers to other files; decompress it"
                   : "holds no polydata, and no grid or blocks that have a surface";
    return false;
  }
  if (!check.CheckCounts(error))
  {
    return false;
  }
  vtkMTErrorCollector errors;
  errors.ObserveOutputWindow(false); // the readers of blocks cannot be observed
  vtkMTErrorCollector::IgnoreUnknownKeys(reader);
  reader->SetReaderErrorObserver(errors.GetCommand());
  reader->SetParserErrorObserver(errors.GetCommand());
  std::string text;
  if (isCompressed && !ReadAll(bytes, text, error))
  {
    return false;
  }
  reader->SetFileName(bytes.GetName().c_str());
  reader->SetReadFromInputString(isCompressed);
  reader->SetInputString(text);
  if (!Update(reader.Get(), errors, error))
  {
    return false;
  }
  vtkDataObject* data = reader->GetOutputDataObject(0);
  if (isComposite)
  {
    return TakeBlocks(vtkMultiBlockDataSet::SafeDownCast(data), output, report, error);
  }
  return vtkMTGridSurface::Take(vtkDataSet::SafeDownCast(data), output, report, error);
}

bool vtkMTVtkReader::ReadLegacy(
  const vtkMTByteSource& bytes, bool isCompressed, vtkPolyData* output, std::string& error, vtkMTInputReport& report)
{
  std::string text;
  if (!vtkMTLegacyCheck::Check(bytes, error) || (isCompressed && !ReadAll(bytes, text, error)))
  {
    return false;
  }
  vtkMTErrorCollector errors;
  errors.ObserveOutputWindow(true); // a file that ends in its arrays is only warned of
  const vtkNew<vtkDataSetReader> reader;
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  reader->SetFileName(bytes.GetName().c_str());
  reader->SetReadFromInputString(isCompressed);
  reader->SetInputString(text);
  return Update(reader.Get(), errors, error) && vtkMTGridSurface::Take(reader->GetOutput(), output, report, error);
}
