// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTInputFragmentStep
 * @brief the fragments of mesh M_0, made of the input's triangles and points by region
 *
 * Make assembles every region's records, in parallel: all but what depends on other fragments. Finish reverses
 * what has to be (vtkMTOrientation), chooses the feature angle (vtkMTDihedralAngles), gives shared points their normals
 * (vtkMTSharedNormals) and numbers (vtkMTSharedIds), and fills the state.
 */
#ifndef vtkMTInputFragmentStep_h
#define vtkMTInputFragmentStep_h

#include "vtkMTBuildSettings.h"
#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTInputFragment.h"
#include "vtkMTInputRegions.h"
#include "vtkMTOrderedWork.h"
#include "vtkMTOrientation.h"
#include "vtkMTSequenceState.h"
#include "vtkMTSharedIds.h"
#include "vtkMTSharedNormals.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkMTInputSpool;

class VTKMTCONSTRUCTION_EXPORT vtkMTInputFragmentStep
{
public:
  vtkMTInputFragmentStep(
    const vtkMTBuildSettings& settings, vtkMTSequenceState& state, std::uint32_t regions, bool makesNormals);
  ~vtkMTInputFragmentStep();

  ///@{
  /// One after the other; what Make was given is not needed any more then. False with a message in GetError.
  bool Make(vtkMTInputRegions& regions, const vtkMTInputSpool& input);
  bool Finish();
  ///@}
  const std::string& GetError() const { return this->Error; }
  bool WasAborted() const { return this->Aborted; }

private:
  using Bytes = std::vector<unsigned char>;
  struct Making
  {
    vtkMTInputRegions::Region Records;
    vtkMTInputFragment Fragment;
  };
  struct Finishing
  {
    vtkMTInputFragment Fragment;
    std::vector<vtkMTSharedNormals::Normal> SharedNormals;
    std::size_t Triangles = 0;
    Bytes Record;
  };

  bool Fail(const std::string& error);
  bool Continue(const char* step, std::uint64_t done);
  bool PutMade(std::size_t region, Making& making, std::string& error);
  bool Fetch(std::uint32_t region, Finishing& finishing, std::string& error);
  void FinishOne(Finishing& finishing) const;
  void AddNormals(Finishing& finishing) const;
  bool ForAllRegions(
    const vtkMTOrderedWork::Work& fetch, const vtkMTOrderedWork::Work& work, const vtkMTOrderedWork::Work& take);

  const vtkMTBuildSettings& Settings;
  vtkMTSequenceState& State;
  const std::uint32_t NumberOfRegions;
  const bool MakesNormals;
  std::string Error;
  bool Aborted = false;
  std::unique_ptr<vtkMTOrientation> Orientation;
  std::unique_ptr<vtkMTSharedNormals> Normals;
  vtkMTDihedralAngles Angles; // of all edges inside of fragments
  std::unique_ptr<vtkMTSharedIds> SharedIds;
  vtkMTRecordSpool Fragments; // by region, with their orientation
};

#endif
