// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCrossing.h"

#include "Interpreter/vtkMTLongWork.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMTBarycentreSample.h"
#include "vtkMTCellBarycentres.h"
#include "vtkMTCompatibility.h"
#include "vtkMTSeedPartition.h"
#include "vtkMTSetMacros.h"
#include "vtkMTSliverMerge.h"
#include "vtkNew.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <vector>

vtkStandardNewMacro(vtkMTCrossing);
vtkMTCxxSetClampMacro(vtkMTCrossing, SliverShare, 0.0, 1.0);

namespace
{
using Points = std::vector<std::array<double, 3>>;
using Labels = std::vector<std::uint32_t>;

// The array's values as labels 0, 1, 2 ... in the order of the values. False when it is no array of region numbers.
bool ReadLabels(vtkCellData* data, const std::string& name, vtkIdType cells, Labels& labels)
{
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != cells ||
    array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
  {
    return false;
  }
  std::vector<double> values(static_cast<std::size_t>(cells));
  for (vtkIdType i = 0; i < cells; ++i)
  {
    values[static_cast<std::size_t>(i)] = array->GetComponent(i, 0);
  }
  std::vector<double> distinct = values;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  labels.resize(values.size());
  std::transform(values.begin(), values.end(), labels.begin(),
    [&distinct](double value) {
      return static_cast<std::uint32_t>(std::lower_bound(distinct.begin(), distinct.end(), value) - distinct.begin());
    });
  return true;
}

std::vector<std::size_t> GetOrder(const Labels& first, const Labels& second)
{
  std::vector<std::size_t> order(first.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t i, std::size_t j) { return first[i] != first[j] ? first[i] < first[j] : second[i] < second[j]; });
  return order;
}

// The element of each cell; returns the number of elements.
vtkIdType Number(const Labels& first, const Labels& second, vtkIdType* patches)
{
  vtkIdType last = -1;
  std::size_t previous = 0;
  for (const std::size_t i : GetOrder(first, second))
  {
    last += last < 0 || first[i] != first[previous] || second[i] != second[previous] ? 1 : 0;
    patches[i] = last;
    previous = i;
  }
  return last + 1;
}

// The mean barycentre of each label's cells, relative to the first of them for precision.
Points GetMeans(const Labels& labels, const Points& barycentres)
{
  const std::size_t count = labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + std::size_t(1);
  Points first(count, { 0.0, 0.0, 0.0 });
  Points sums(count, { 0.0, 0.0, 0.0 });
  std::vector<std::size_t> sizes(count, 0);
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (!vtkMTBarycentreSample::IsFinite(barycentres[i]))
    {
      continue;
    }
    const std::uint32_t label = labels[i];
    first[label] = sizes[label]++ == 0 ? barycentres[i] : first[label];
    for (int axis = 0; axis < 3; ++axis)
    {
      sums[label][axis] += barycentres[i][axis] - first[label][axis];
    }
  }
  for (std::size_t label = 0; label < count; ++label)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      first[label][axis] += sums[label][axis] / static_cast<double>(std::max<std::size_t>(1, sizes[label]));
    }
  }
  return first;
}

std::size_t MergeInAllRegions(const Labels& first, Labels& second, const Points& barycentres, std::size_t minimum)
{
  const vtkMTSeedPartition partition(GetMeans(second, barycentres));
  const std::vector<std::size_t> order = GetOrder(first, second);
  std::size_t merged = 0;
  for (auto begin = order.begin(); begin != order.end();)
  {
    const auto end = std::find_if(begin, order.end(), [&](std::size_t i) { return first[i] != first[*begin]; });
    Labels regions;
    Points places;
    for (auto i = begin; i != end; ++i)
    {
      regions.push_back(second[*i]);
      places.push_back(barycentres[*i]);
    }
    merged += vtkMTSliverMerge::MergeSlivers(partition, places, minimum, regions);
    for (auto i = begin; i != end; ++i)
    {
      second[*i] = regions[static_cast<std::size_t>(i - begin)];
    }
    begin = end;
  }
  return merged;
}
}

vtkMTCrossing::vtkMTCrossing() = default;

vtkMTCrossing::~vtkMTCrossing() = default;

int vtkMTCrossing::Cross(vtkPolyData* output)
{
  const vtkIdType cells = output->GetNumberOfCells();
  Labels first;
  Labels second;
  for (const bool isFirst : { true, false })
  {
    const std::string& name = isFirst ? this->FirstArrayName : this->SecondArrayName;
    if (!ReadLabels(output->GetCellData(), name, cells, isFirst ? first : second))
    {
      output->Initialize();
      this->SetErrorCode(vtkErrorCode::UserError);
      vtkErrorMacro("The input needs a cell array \"" << name << "\" of whole numbers, one component for each cell.");
      return 0;
    }
  }
  this->UpdateProgress(0.3);
  vtkNew<vtkIdTypeArray> patches;
  patches->SetName(this->PatchArrayName.c_str());
  patches->SetNumberOfTuples(cells);
  this->NumberOfPatches = Number(first, second, patches->GetPointer(0));
  this->UpdateProgress(0.6);
  if (this->MergeSlivers && this->NumberOfPatches > 0 && !vtkMTIsAborted(this))
  {
    const double mean = static_cast<double>(cells) / static_cast<double>(this->NumberOfPatches);
    const auto minimum = static_cast<std::size_t>(std::ceil(this->SliverShare * mean));
    this->NumberOfSlivers =
      static_cast<vtkIdType>(MergeInAllRegions(first, second, vtkMTCellBarycentres::Make(output), minimum));
    this->NumberOfPatches = Number(first, second, patches->GetPointer(0));
  }
  if (vtkMTIsAborted(this))
  {
    output->Initialize();
    return 1;
  }
  output->GetCellData()->SetScalars(patches);
  this->UpdateProgress(1.0);
  return 1;
}

int vtkMTCrossing::RequestData(vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkMTLongWork work;
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfPatches = 0;
  this->NumberOfSlivers = 0;
  this->SetErrorCode(vtkErrorCode::NoError);
  output->ShallowCopy(vtkPolyData::GetData(inputVector[0]));
  try
  {
    return this->Cross(output);
  }
  catch (const std::exception& error)
  {
    output->Initialize();
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro("The partitions cannot be crossed: " << error.what());
    return 0;
  }
}

void vtkMTCrossing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FirstArrayName: " << this->FirstArrayName << "\n";
  os << indent << "SecondArrayName: " << this->SecondArrayName << "\n";
  os << indent << "PatchArrayName: " << this->PatchArrayName << "\n";
  os << indent << "MergeSlivers: " << (this->MergeSlivers ? "on" : "off") << "\n";
  os << indent << "SliverShare: " << this->SliverShare << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "NumberOfSlivers: " << this->NumberOfSlivers << "\n";
}
