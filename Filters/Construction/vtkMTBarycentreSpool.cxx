// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTBarycentreSpool.h"

#include "vtkMTPatch.h"
#include "vtkMTRelease.h"

#include <algorithm>

namespace
{
constexpr std::size_t BlockSize = 8192;
constexpr std::size_t Many = 1024; // are not copied into the buffer
constexpr std::size_t BlocksPerQuestion = 8;

vtkMTBarycentreSpool::Barycentre GetBarycentre(const vtkMTPoint& a, const vtkMTPoint& b, const vtkMTPoint& c)
{
  // A sum of three integers is exact, so the barycentre does not depend on the order of the corners.
  const auto third = [&](int i) { return static_cast<double>(std::int64_t(a[i]) + b[i] + c[i]) / 3.0; };
  return { third(0), third(1), third(2) };
}
}

vtkMTBarycentreSpool::vtkMTBarycentreSpool() = default;

vtkMTBarycentreSpool::~vtkMTBarycentreSpool() = default;

std::vector<vtkMTBarycentreSpool::Barycentre> vtkMTBarycentreSpool::GetBarycentres(const vtkMTPatch& mesh)
{
  std::vector<Barycentre> result(mesh.Triangles.size());
  for (std::size_t t = 0; t < result.size(); ++t)
  {
    const vtkMTTriangle p = mesh.GetPointsOfTriangle(t);
    result[t] = GetBarycentre(mesh.Points[p[0]], mesh.Points[p[1]], mesh.Points[p[2]]);
  }
  return result;
}

void vtkMTBarycentreSpool::PutBarycentres(const vtkMTPatchRecord::Shape& mesh, Barycentre* to)
{
  const vtkMTPoint* points = mesh.Points.data();
  const vtkMTTriangle* triangles = mesh.Triangles.data();
  if (points && triangles && mesh.WedgePoints.empty()) // as most of them are
  {
    for (const vtkMTTriangle* t = triangles; t < triangles + mesh.Triangles.size(); ++t)
    {
      *to++ = GetBarycentre(points[(*t)[0]], points[(*t)[1]], points[(*t)[2]]);
    }
    return;
  }
  const auto getPoint = [&mesh](std::uint32_t wedge)
  { return mesh.Points[mesh.WedgePoints.empty() ? wedge : mesh.WedgePoints[wedge]]; };
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const vtkMTTriangle w = mesh.Triangles[t];
    *to++ = GetBarycentre(getPoint(w[0]), getPoint(w[1]), getPoint(w[2]));
  }
}

bool vtkMTBarycentreSpool::Begin(vtkMTSpoolStore& store, const std::string& name, std::string& error)
{
  this->Store = &store;
  this->Name = name;
  this->Buffer.clear();
  this->Spool = store.Create(name, error);
  return this->Spool != nullptr;
}

bool vtkMTBarycentreSpool::Put(const std::vector<Barycentre>& barycentres, std::string& error)
{
  const bool areMany = barycentres.size() >= Many;
  if (!areMany && this->Buffer.size() < BlockSize)
  {
    this->Buffer.insert(this->Buffer.end(), barycentres.begin(), barycentres.end());
    return true;
  }
  const bool flushed = this->Spool->Append(this->Buffer.data(), this->Buffer.size() * sizeof(Barycentre), error);
  this->Buffer.clear();
  if (areMany)
  {
    return flushed && this->Spool->Append(barycentres.data(), barycentres.size() * sizeof(Barycentre), error);
  }
  this->Buffer = barycentres;
  return flushed;
}

bool vtkMTBarycentreSpool::Seal(std::string& error)
{
  const bool done = this->Spool->Append(this->Buffer.data(), this->Buffer.size() * sizeof(Barycentre), error);
  vtkMTRelease(this->Buffer);
  return done;
}

void vtkMTBarycentreSpool::Remove()
{
  if (this->Spool)
  {
    this->Spool.reset();
    this->Store->Remove(this->Name);
  }
}

std::size_t vtkMTBarycentreSpool::GetNumberOfTriangles() const
{
  return static_cast<std::size_t>(this->Spool->GetSize() / sizeof(Barycentre));
}

bool vtkMTBarycentreSpool::Scan(const Block& block)
{
  this->Error.clear();
  const std::size_t count = this->GetNumberOfTriangles();
  std::vector<Barycentre> copies;
  for (std::size_t begin = 0; begin < count; begin += BlockSize)
  {
    const std::size_t size = std::min(BlockSize, count - begin);
    if (this->Continue && begin % (BlocksPerQuestion * BlockSize) == 0 && !this->Continue())
    {
      this->Error = "aborted";
      return false;
    }
    const std::uint64_t offset = begin * std::uint64_t(sizeof(Barycentre));
    if (const unsigned char* bytes = this->Spool->Find(offset, size * sizeof(Barycentre)))
    {
      block(reinterpret_cast<const Barycentre*>(bytes), size); // its bytes begin where any type may
      continue;
    }
    copies.resize(size);
    if (!this->Spool->Read(offset, size * sizeof(Barycentre), copies.data(), this->Error))
    {
      return false;
    }
    block(copies.data(), size);
  }
  return true;
}
