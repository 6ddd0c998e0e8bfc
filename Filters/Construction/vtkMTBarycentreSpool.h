// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTBarycentreSpool
 * @brief the barycentres of the input, in a spool, for the sequential scans that place seeds (BMT 4.2.2)
 *
 * 24 bytes per triangle, written and read in blocks of 8192; nothing but one block is in memory, and one that lies in
 * memory already is read there. Those of other levels are made anew for every scan (vtkMTSplitStep).
 */
#ifndef vtkMTBarycentreSpool_h
#define vtkMTBarycentreSpool_h

#include "vtkMTConstructionModule.h" // For export macro
#include "vtkMTPartition.h"
#include "vtkMTPatchRecord.h"
#include "vtkMTSpoolStore.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct vtkMTPatch;

class VTKMTCONSTRUCTION_EXPORT vtkMTBarycentreSpool : public vtkMTBarycentreScan
{
public:
  using Barycentre = std::array<double, 3>;

  /// Of all triangles of the mesh, in their order, in steps of the lattice.
  static std::vector<Barycentre> GetBarycentres(const vtkMTPatch& mesh);
  /// And of a record's, one for each triangle.
  static void PutBarycentres(const vtkMTPatchRecord::Shape& mesh, Barycentre* to);

  vtkMTBarycentreSpool();
  ~vtkMTBarycentreSpool() override;

  ///@{
  /// False with a message in error. Put comes after Begin, Seal after the last Put.
  bool Begin(vtkMTSpoolStore& store, const std::string& name, std::string& error);
  bool Put(const std::vector<Barycentre>& barycentres, std::string& error);
  bool Seal(std::string& error);
  void Remove();
  ///@}

  /// Asked before every few blocks; false ends the scan as a failure. Empty: always goes on.
  void SetContinue(std::function<bool()> function) { this->Continue = std::move(function); }

  std::size_t GetNumberOfTriangles() const override;
  bool Scan(const Block& block) override;
  /// Why the last scan failed.
  const std::string& GetError() const { return this->Error; }

private:
  vtkMTSpoolStore* Store = nullptr;
  std::string Name;
  std::unique_ptr<vtkMTSpool> Spool;
  std::vector<Barycentre> Buffer;
  std::function<bool()> Continue;
  std::string Error;
};

#endif
