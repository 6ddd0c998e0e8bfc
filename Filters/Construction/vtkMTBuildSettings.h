// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBuildSettings
 * @brief what the parts of the construction are told: what to make, and (vtkMTWorkSettings) with what
 *
 * vtkMultiTriangulationBuilder documents the settings that users have; this is how they are handed down.
 */
#ifndef vtkMTBuildSettings_h
#define vtkMTBuildSettings_h

#include "vtkMTArrayInfo.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTWorkSettings.h"

#include "vtkType.h"

#include <algorithm>
#include <string>
#include <vector>

class vtkMTPartitionStrategy;
class vtkMTSimplifier;

struct VTKMTCONSTRUCTION_EXPORT vtkMTBuildSettings : vtkMTWorkSettings
{
  ///@{
  /// These have an influence on the result.
  std::size_t PatchTriangles = 1000;
  int LatticeBits = 24;
  bool MakeNormals = true;
  double FeatureAngle = -1.0; ///< of made normals, degrees; below 0: chosen by the mesh
  int NormalBits = 12;        ///< of each coordinate of made normals (vtkMTMadeNormals)
  bool KeepFarOutliers = false;
  bool ExactPoints = false;
  /// Which patches have the input's cell ids.
  enum class Ids
  {
    None,
    Finest,
    All
  };
  Ids InputIds = Ids::Finest;
  bool InputPointIds = false; ///< whether those of level 0 have the input's point ids
  bool CertifyNormals = false;
  int DirectLevels = 5; ///< how far below a fragment the mesh is that its errors are held against; below 2: none
  std::vector<std::string> LabelArrays;     ///< names of arrays that are labels, whatever their type
  std::vector<std::string> ValueArrays;     ///< and of those that are values
  std::vector<std::string> CertifiedArrays; ///< names of arrays whose values are certified
  double Reduction = 2.0; ///< of a level: the strategy's (vtkMTPartitionStrategy::GetReduction), above 1
  const vtkMTPartitionStrategy* Partition = nullptr;
  const vtkMTSimplifier* Simplifier = nullptr;
  ///@}

  ///@{
  /// Bytes that splitting a fragment, or simplifying a region, takes per byte of its records.
  double MemoryPerByteSplit = 0.0;
  double MemoryPerByteSimplified = 0.0;
  ///@}

  /// Triangles of a region of Psi_i on M_i over those of a patch: the strategy's
  /// (vtkMTPartitionStrategy::GetPatchesPerRegion).
  double PatchesPerRegion = 2.9;

  /// The wanted mean number of triangles in a region of Psi_i on M_i.
  double GetRegionTarget() const { return this->PatchesPerRegion * static_cast<double>(this->PatchTriangles); }
  /// Whether meshes below are held against. Angles and values are certified together with the distances that the steps
  /// add up to.
  bool KeepsFinerLevels() const
  {
    return this->DirectLevels > 1 && !this->CertifyNormals && this->CertifiedArrays.empty();
  }
  /// Where the certified ones are among the arrays; their number for one that is not there.
  std::vector<std::size_t> FindCertifiedArrays(const std::vector<vtkMTArrayInfo>& arrays) const
  {
    std::vector<std::size_t> found;
    for (const std::string& name : this->CertifiedArrays)
    {
      const auto array =
        std::find_if(arrays.begin(), arrays.end(), [&name](const vtkMTArrayInfo& info) { return info.Name == name; });
      found.push_back(static_cast<std::size_t>(array - arrays.begin()));
    }
    return found;
  }
  /// Appends what is kept of the input's ids: those of cells, then those of points.
  void AddIdArrays(std::vector<vtkMTArrayInfo>& arrays) const
  {
    vtkMTArrayInfo info;
    info.Type = VTK_ID_TYPE;
    info.Resampling = vtkMTArrayInfo::Nearest;
    for (const vtkMTArrayInfo::RoleType role : { vtkMTArrayInfo::InputCellIds, vtkMTArrayInfo::InputPointIds })
    {
      const bool ofCells = role == vtkMTArrayInfo::InputCellIds;
      info.Name = ofCells ? "vtkMTInputCellIds" : "vtkMTInputPointIds";
      info.Association = ofCells ? vtkMTArrayInfo::Cell : vtkMTArrayInfo::Point;
      info.Role = role;
      if (!ofCells || this->InputIds == Ids::Finest)
      {
        info.SetFinestOnly();
      }
      if (ofCells ? this->InputIds != Ids::None : this->InputPointIds)
      {
        arrays.push_back(info);
      }
    }
  }
  /// And of Psi_(i+1) on M_i: of a floor.
  double GetFloorTarget() const { return this->Reduction * this->GetRegionTarget(); }
};

#endif
