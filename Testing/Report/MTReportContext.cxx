// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportContext.h"

#include "MTReportMeshes.h"
#include "bmtCommon.h"

#include <cstdio>

MTReportContext::MTReportContext(std::string folder, bool isQuick, std::vector<std::string> meshFiles)
  : Folder(std::move(folder))
  , Quick(isQuick)
  , MeshFiles(std::move(meshFiles))
  , Begin(bmtWallSeconds())
{
}

const std::vector<MTReportMesh>& MTReportContext::GetMeshes()
{
  if (this->Meshes.empty())
  {
    const int triangles = this->Quick ? 20480 : 81920;
    this->Meshes.push_back({ "fractal sphere", MTReportMeshes::MakeFractalSphere(triangles) });
    this->Meshes.push_back({ "torus", MTReportMeshes::MakeTorus(this->Quick ? 14400 : 25600) });
    if (!this->Quick)
    {
      this->Meshes.push_back({ "terrain", MTReportMeshes::MakeTerrain(40000) });
    }
    for (const std::string& file : this->MeshFiles)
    {
      this->Meshes.push_back({ MTReportMeshes::GetShortName(file), MTReportMeshes::Read(file) });
    }
  }
  return this->Meshes;
}

void MTReportContext::Say(const std::string& what) const
{
  std::fprintf(stderr, "%6.1f s  %s\n", bmtWallSeconds() - this->Begin, what.c_str());
}
