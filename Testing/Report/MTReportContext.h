// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportContext
 * @brief what every part of the report is told: where output goes, how thorough to be, and which meshes
 */
#ifndef MTReportContext_h
#define MTReportContext_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

struct MTReportMesh
{
  std::string Name;                  ///< short, as tables and charts show it
  vtkSmartPointer<vtkPolyData> Data; ///< triangles and points, no arrays
};

class MTReportContext
{
public:
  MTReportContext(std::string folder, bool isQuick, std::vector<std::string> meshFiles);

  /// Exists.
  const std::string& GetFolder() const { return this->Folder; }
  /// Whether a few minutes must do: small meshes, few repeats.
  bool IsQuick() const { return this->Quick; }
  /// Of every time that is measured; an odd number.
  static constexpr int Repeats = 3;
  /// Of a build, where nothing else is measured: small meshes shall have levels, too.
  int GetPatchTriangles() const { return this->Quick ? 250 : 1000; }
  /// Of each surface, where distances are sampled.
  std::size_t GetSamples() const { return this->Quick ? 40000 : 150000; }

  /// Generated ones, then those of the command line; read when they are first needed. Throws bmtError.
  const std::vector<MTReportMesh>& GetMeshes();

  /// A line of progress on standard error, with the seconds since the program began.
  void Say(const std::string& what) const;

private:
  const std::string Folder;
  const bool Quick;
  const std::vector<std::string> MeshFiles;
  const double Begin;
  std::vector<MTReportMesh> Meshes;
};

#endif
