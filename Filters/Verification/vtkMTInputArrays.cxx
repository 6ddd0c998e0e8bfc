// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTInputArrays.h"

#include "vtkMTGraph.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace
{
enum class Kind
{
  Plain,
  Colors,
  Directions,
  Coordinates,
  Names
};

// More different values than this are no labels.
constexpr std::size_t LabelsLimit = 4096;
// Values that went through single precision, and colours that went through a byte.
constexpr double SingleRounding = 1e-6;
constexpr double ByteRounding = 0.6 / 255.0;
constexpr double DirectionRounding = 2e-3;

using Values = std::vector<double>;

std::string Write(const Values& values)
{
  std::ostringstream text;
  text.precision(9);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    text << (i > 0 ? " " : "") << values[i];
  }
  return text.str();
}

bool IsWhole(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

bool HasNames(vtkDataArray* array)
{
  return array->GetLookupTable() && array->GetLookupTable()->GetNumberOfAnnotatedValues() > 0;
}

std::string GetName(vtkDataArray* array, double value)
{
  vtkScalarsToColors* table = array->GetLookupTable();
  const vtkIdType index = table ? table->GetAnnotatedValueIndex(vtkVariant(value)) : -1;
  return index < 0 ? std::string() : std::string(table->GetAnnotation(index));
}

double EncodeSrgb(double x)
{
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
}
}

// One array of one side.
struct vtkMTInputArrays::Column
{
  vtkDataArray* Array = nullptr;
  bool IsOfCells = false;
  Kind What = Kind::Plain;
  double Unit = 1.0;      // what values are divided by
  bool IsSrgb = false;    // to be encoded, to compare
  bool IsIndexed = false; // the colours of the annotations

  std::string GetTitle() const
  {
    return std::string(this->What == Kind::Colors ? "colours '" : (this->What == Kind::Names ? "names '" : "array '")) +
      (this->Array->GetName() ? this->Array->GetName() : "") + "' of its " + (this->IsOfCells ? "cells" : "points");
  }

  // With three components where the other side has three.
  void Get(vtkIdType tuple, int components, Values& values) const
  {
    values.resize(components);
    if (this->IsIndexed)
    {
      auto* table = vtkLookupTable::SafeDownCast(this->Array->GetLookupTable());
      const vtkIdType index = table->GetAnnotatedValueIndex(vtkVariant(this->Array->GetComponent(tuple, 0)));
      double color[4] = { -1.0, -1.0, -1.0, -1.0 };
      if (index >= 0)
      {
        table->GetTableValue(index % std::max<vtkIdType>(table->GetNumberOfTableValues(), 1), color);
      }
      std::copy_n(color, components, values.begin());
      return;
    }
    for (int c = 0; c < components; ++c)
    {
      const bool isThere = c < this->Array->GetNumberOfComponents();
      const double value = isThere ? this->Array->GetComponent(tuple, c) / this->Unit : 1.0;
      values[c] = this->IsSrgb && c < 3 ? EncodeSrgb(value) : value;
    }
    if (this->What == Kind::Directions)
    {
      const double length = std::hypot(values[0], values[1], values[2]);
      std::for_each(values.begin(), values.end(), [length](double& x) { x = length > 0.0 ? x / length : x; });
    }
  }
};

vtkMTInputArrays::vtkMTInputArrays(vtkPolyData* inputMesh, const vtkMTSampledSurface& input, vtkPolyData* modelMesh,
  const vtkMTSampledSurface& model, const std::vector<vtkMTInputComparison::Pair>& pairs)
  : InputMesh(inputMesh)
  , Input(input)
  , ModelMesh(modelMesh)
  , Model(model)
  , Pairs(pairs)
{
}

bool vtkMTInputArrays::IsSameAtPairs(
  const Column& input, const Column& model, const Describer& describe, std::string& difference) const
{
  const int components =
    model.IsIndexed ? 3 : std::max(input.Array->GetNumberOfComponents(), model.Array->GetNumberOfComponents());
  const double exact = IsWhole(input.Array) && IsWhole(model.Array) ? 0.0 : SingleRounding;
  const double allowed = input.What == Kind::Colors && input.Unit != model.Unit ? ByteRounding
    : input.What == Kind::Colors && (model.IsIndexed || input.IsSrgb)           ? ByteRounding
    : input.What == Kind::Directions                                            ? DirectionRounding
                                                                                : 0.0;
  Values a, b;
  const auto isSame = [&](const vtkMTInputComparison::Pair& pair, const vtkMTCounterparts::Counterpart& counterpart)
  {
    for (int corner = 0; corner < (input.IsOfCells ? 1 : 3); ++corner)
    {
      const std::uint32_t p = this->Input.Triangles[pair.Input][corner];
      const std::uint32_t q = this->Model.Triangles[counterpart.Triangle][counterpart.Corners[corner]];
      input.Get(input.IsOfCells ? this->Input.Cells[pair.Input] : p, components, a);
      model.Get(input.IsOfCells ? this->Model.Cells[counterpart.Triangle] : q, components, b);
      for (int c = 0; c < components; ++c)
      {
        const double rounding = std::max(allowed, exact * std::max(std::abs(a[c]), std::abs(b[c])));
        if (!std::isnan(a[c]) && a[c] != b[c] && !(std::abs(a[c] - b[c]) <= rounding))
        {
          difference =
            "at " + describe(this->Input.Points[p]) + " the input has " + Write(a) + ", the model " + Write(b);
          return false;
        }
      }
    }
    return true;
  };
  const auto isSameOnce = [&](const vtkMTInputComparison::Pair& pair)
  {
    return std::any_of(pair.Models.begin(), pair.Models.end(),
      [&](const vtkMTCounterparts::Counterpart& counterpart) { return isSame(pair, counterpart); });
  };
  if (!std::all_of(this->Pairs.begin(), this->Pairs.end(), isSameOnce))
  {
    return false;
  }
  difference.clear(); // of copies that are other ones
  return true;
}

// The same cells have the same name, whatever its value is.
bool vtkMTInputArrays::HasSameNames(const Column& input, const Column& model, std::string& difference) const
{
  std::map<double, double> valueOf, nameOf;
  for (const vtkMTInputComparison::Pair& pair : this->Pairs)
  {
    if (pair.Models.size() > 1) // which of them it is, only names could say
    {
      continue;
    }
    const double a = input.Array->GetComponent(this->Input.Cells[pair.Input], 0);
    const double b = model.Array->GetComponent(this->Model.Cells[pair.Models[0].Triangle], 0);
    if (!std::isnan(a) && (valueOf.emplace(a, b).first->second != b || nameOf.emplace(b, a).first->second != a))
    {
      difference = "cells of '" + GetName(input.Array, a) + "' are mixed with others";
      return false;
    }
  }
  for (const auto& [name, value] : valueOf)
  {
    const std::string mine = GetName(input.Array, name);
    const std::string found = GetName(model.Array, value);
    if (!mine.empty() && found != mine && (" " + mine + " ").find(" " + found + " ") == std::string::npos)
    {
      difference = "the name '" + mine + "' is lost" + (found.empty() ? "" : "; the model has '" + found + "'");
      return false;
    }
  }
  return true;
}

// The values of one component on the triangles of one side.
struct vtkMTInputArrays::Spread
{
  double Least = std::numeric_limits<double>::infinity();
  double Largest = -std::numeric_limits<double>::infinity();
  bool HasHoles = false; // NaN
  std::set<double> Values;

  Spread(const Column& column, int component, const vtkMTSampledSurface& surface)
  {
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      for (int corner = 0; corner < (column.IsOfCells ? 1 : 3); ++corner)
      {
        const vtkIdType tuple =
          column.IsOfCells ? surface.Cells[t] : static_cast<vtkIdType>(surface.Triangles[t][corner]);
        const double x = column.Array->GetComponent(tuple, component) / column.Unit;
        this->HasHoles = this->HasHoles || std::isnan(x);
        this->Least = x < this->Least ? x : this->Least;
        this->Largest = x > this->Largest ? x : this->Largest;
        if (!std::isnan(x) && this->Values.size() <= LabelsLimit)
        {
          this->Values.insert(x);
        }
      }
    }
  }
};

bool vtkMTInputArrays::IsSameInRange(const Column& input, const Column& model, std::string& difference) const
{
  const int components = std::min(input.Array->GetNumberOfComponents(), model.Array->GetNumberOfComponents());
  for (int c = 0; c < components; ++c)
  {
    const Spread a(input, c, this->Input);
    const Spread b(model, c, this->Model);
    if (a.Values.empty())
    {
      continue;
    }
    const double rounding = input.Unit != model.Unit
      ? ByteRounding
      : SingleRounding * std::max({ std::abs(a.Least), std::abs(a.Largest), 1e-300 });
    const bool isHeld = b.Least <= a.Least + rounding && b.Largest >= a.Largest - rounding;
    const bool isEqual = isHeld && b.Least >= a.Least - rounding && b.Largest <= a.Largest + rounding;
    if (a.HasHoles ? !isHeld : !isEqual)
    {
      difference = "the input's values (component " + std::to_string(c) + ") are from " +
        Write({ a.Least, a.Largest }) + ", the model's from " + Write({ b.Least, b.Largest });
      return false;
    }
    const bool areLabels = components == 1 && IsWhole(model.Array) && a.Values.size() <= LabelsLimit;
    if (areLabels && input.Unit == model.Unit && !a.HasHoles && a.Values != b.Values)
    {
      difference = "the input has " + std::to_string(a.Values.size()) + " different values, the model " +
        std::to_string(b.Values.size());
      return false;
    }
  }
  return true;
}

bool vtkMTInputArrays::IsSame(
  const Column& input, const Column& model, const Describer& describe, std::string& difference) const
{
  if (input.What == Kind::Names)
  {
    return this->HasSameNames(input, model, difference);
  }
  const int a = input.Array->GetNumberOfComponents();
  const int b = model.Array->GetNumberOfComponents();
  if (!model.IsIndexed && a != b && (input.What != Kind::Colors || std::min(a, b) < 3 || std::max(a, b) > 4))
  {
    difference = "it has " + std::to_string(a) + " components, the model's " + std::to_string(b);
    return false;
  }
  const bool isRanged = input.What == Kind::Plain || input.What == Kind::Coordinates ||
    (input.What == Kind::Colors && !model.IsIndexed && !input.IsSrgb);
  return this->IsSameAtPairs(input, model, describe, difference) &&
    (!isRanged || this->IsSameInRange(input, model, difference));
}

namespace
{
vtkDataSetAttributes* GetAttributes(vtkPolyData* mesh, bool isOfCells)
{
  return isOfCells ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) : mesh->GetPointData();
}

Kind GetKind(vtkDataSetAttributes* attributes, vtkDataArray* array, bool isOfCells)
{
  const int components = array->GetNumberOfComponents();
  const bool isReal = !IsWhole(array);
  return HasNames(array) && components == 1 && isOfCells && isReal            ? Kind::Names
    : array == attributes->GetScalars() && components >= 3 && components <= 4 ? Kind::Colors
    : array == attributes->GetNormals() && components == 3 && isReal          ? Kind::Directions
    : array == attributes->GetTCoords() && isReal                             ? Kind::Coordinates
                                                                              : Kind::Plain;
}

double GetColorUnit(vtkDataArray* array)
{
  switch (array->GetDataType())
  {
    case VTK_FLOAT:
    case VTK_DOUBLE:
      return array->GetRange(0)[1] > 1.0 || array->GetRange(1)[1] > 1.0 || array->GetRange(2)[1] > 1.0 ? 255.0 : 1.0;
    case VTK_UNSIGNED_SHORT:
      return 65535.0;
    default:
      return 255.0;
  }
}
}

bool vtkMTInputArrays::Matches(
  const Column& input, vtkDataArray* model, const Describer& describe, std::string& difference) const
{
  Column mine = input;
  Column other = input;
  other.Array = model;
  const int components = model->GetNumberOfComponents();
  const bool isOfSameType = model->GetDataType() == input.Array->GetDataType();
  if (input.What != Kind::Colors || (isOfSameType && components == input.Array->GetNumberOfComponents()))
  {
    return this->IsSame(mine, other, describe, difference);
  }
  auto* table = vtkLookupTable::SafeDownCast(model->GetLookupTable());
  other.IsIndexed = components == 1 && table && HasNames(model) && table->GetNumberOfTableValues() > 0;
  if (components < 3 && !other.IsIndexed)
  {
    difference = "it is no colour in the model";
    return false;
  }
  mine.Unit = GetColorUnit(input.Array);
  other.Unit = other.IsIndexed ? 1.0 : GetColorUnit(model);
  Column encoded = mine;
  encoded.IsSrgb = true;
  std::string again;
  return this->IsSame(mine, other, describe, difference) || this->IsSame(encoded, other, describe, again);
}

bool vtkMTInputArrays::IsThere(const Column& input, const Describer& describe, std::string& difference) const
{
  vtkDataSetAttributes* attributes = GetAttributes(this->ModelMesh, input.IsOfCells);
  vtkDataArray* const named = attributes->GetArray(input.Array->GetName());
  if (named && this->Matches(input, named, describe, difference))
  {
    return true;
  }
  if (named && input.What == Kind::Plain)
  {
    return false;
  }
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = attributes->GetArray(i);
    std::string why;
    if (array && array != named && this->Matches(input, array, describe, why))
    {
      return true;
    }
    if (difference.empty() && why.find("is lost") != std::string::npos) // the same cells, without names
    {
      difference = why;
    }
  }
  return false;
}

vtkMTVerificationCheck vtkMTInputArrays::Test(const vtkMTGraph& graph, const Describer& describe) const
{
  vtkMTVerificationCheck check("input_arrays");
  const auto left = graph.InputReport.find("arrays_left_out");
  std::int64_t mayLack = left == graph.InputReport.end() ? 0 : left->second;
  for (const bool isOfCells : { false, true })
  {
    vtkDataSetAttributes* attributes = GetAttributes(this->InputMesh, isOfCells);
    const vtkIdType tuples = isOfCells ? this->InputMesh->GetNumberOfCells() : this->InputMesh->GetNumberOfPoints();
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      Column column;
      column.Array = attributes->GetArray(i);
      column.IsOfCells = isOfCells;
      if (!column.Array || !column.Array->GetName() || column.Array->GetDataType() == VTK_BIT ||
        column.Array->GetNumberOfTuples() != tuples)
      {
        continue;
      }
      column.What = GetKind(attributes, column.Array, isOfCells);
      check.Tested += this->Pairs.size();
      std::string difference;
      if (!this->IsThere(column, describe, difference) && (!difference.empty() || mayLack-- <= 0))
      {
        check.Fail("the input's " + column.GetTitle() +
          (difference.empty() ? " are in none of the model's arrays" : " differ: " + difference));
      }
    }
  }
  return check;
}
