// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFinishStep.h"

#include "vtkMTFinishGraph.h"
#include "vtkMTPartitionStrategy.h"
#include "vtkMTSimplifier.h"

#include <cmath>
#include <locale>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{
std::string ToText(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

// What the user chose that arrays are taken for; "a,b".
void PutNames(const std::vector<std::string>& names, std::map<std::string, std::string>& settings, const char* key)
{
  for (const std::string& name : names)
  {
    std::string& list = settings[key];
    list += (list.empty() ? "" : ",") + name;
  }
}
}

bool vtkMTFinishStep::Run()
{
  const vtkMTStageTimes::Scope write(this->Options.Times, vtkMTStageTimes::Write);
  return this->WriteRoots() && this->FinishGraph();
}

bool vtkMTFinishStep::WriteRoots()
{
  for (std::size_t f = 0; f < this->State.NodeOfFragment.size(); ++f)
  {
    vtkMTCertifiedMesh mesh;
    PatchToWrite patch;
    bool isEmpty = false;
    if (!this->TakeFragment(f, mesh, isEmpty, this->Error))
    {
      return false;
    }
    if (!isEmpty &&
      (!this->PreparePatch(std::move(mesh), patch, this->Error) ||
        !this->WritePatch(std::move(patch), vtkMTSequenceState::None, this->State.NodeOfFragment[f], this->Error)))
    {
      return false;
    }
  }
  return true;
}

bool vtkMTFinishStep::FinishGraph()
{
  std::map<std::string, std::string>& settings = this->State.Graph.Settings;
  settings["partition"] = this->Options.Partition->GetSettings();
  settings["simplifier"] = this->Options.Simplifier->GetSettings();
  settings["patch_triangles"] = std::to_string(this->Options.PatchTriangles);
  if (this->Options.KeepFarOutliers)
  {
    settings["far_outliers"] = "kept";
  }
  PutNames(this->Options.LabelArrays, settings, "labels");
  PutNames(this->Options.ValueArrays, settings, "values");
  if (this->State.FeatureAngle >= 0.0)
  {
    // What the mesh would choose is there whoever chose, so that the same normals give the same file.
    settings["feature_angle"] = ToText(this->State.FeatureAngle);
    settings["feature_angle_auto"] = ToText(this->State.AutomaticFeatureAngle);
    settings["dihedral_angles"] = this->State.DihedralAngles;
  }
  settings["reduction"] = ToText(this->Options.Reduction); // of a level: a floor's triangles over its fragment's
  settings["floor_triangles"] = std::to_string(std::llround(this->Options.GetFloorTarget()));
  return vtkMTFinishGraph::Run(this->State, this->Sink, this->Error);
}
