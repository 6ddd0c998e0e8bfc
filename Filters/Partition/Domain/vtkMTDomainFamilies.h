// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTDomainFamilies
 * @brief families of cells that divide a domain, and cubes where that is not enough
 *
 * A family is numbered by how often the domain has been divided; 0 is the whole domain or the faces of a base mesh, and
 * a sphere has coarser ones. Each has as many cells as the next coarser one times the reduction. Cells that hold too
 * much are replaced by those of as fine a family as they need if they are evenly filled, up to MostReplaced finer; what
 * is still too much lies at nearly one place of the domain, above one another for instance, and is divided in space, by
 * the faces or the edges of a regular partition: by faces on odd levels and by edges on even ones, which have no border
 * in common.
 */
#ifndef vtkMTDomainFamilies_h
#define vtkMTDomainFamilies_h

#include "vtkMTCellFamilies.h"
#include "vtkMTDomain.h"

class vtkMTDomainFamilies : public vtkMTCellFamilies
{
public:
  /// largest: absolute value of a coordinate.
  vtkMTDomainFamilies(const vtkMTDomain& domain, double largest, bool isOddLevel);
  ~vtkMTDomainFamilies() override;

  /// From here on cells are replaced by families of this domain, and not much finer ones.
  void SetFirst(int family) { this->First = family; }

  /// The numbers of vtkMTCellFamilies begin elsewhere than a domain's: this is what they add.
  static constexpr int Offset = 1 << 16;

  ///@{
  /// Of the domain's families: the coarsest, the finest, and how many cells one has where the mesh covers the domain.
  virtual int GetCoarsest() const = 0;
  virtual int GetFinest() const = 0;
  virtual double GetNumberOfCells(int family) const = 0;
  ///@}

  bool Locate(int family, const Point& x, Cell& cell) const override;
  int GetReplacement(const Cell& cell, const Point& lo, const Point& hi, double excess) const override;
  Point GetSeed(const Cell& cell, const Point& lo, const Point& hi) const override;

protected:
  /// The cell of the domain's family; sets everything but its Family.
  virtual void LocateInDomain(int family, const Point& x, Cell& cell) const = 0;
  const vtkMTDomain& GetDomain() const { return this->Domain; }

private:
  static constexpr int MostReplaced = 8;

  const vtkMTDomain Domain;
  const vtkMTRegularFamilies Space;
  const vtkMTRegularFamily::SeedType SpaceType;
  int First = 0;
};

#endif
