// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPartitionStrategy.h"

#include "vtkMTHexagonPartition.h"
#include "vtkMTKdPartition.h"
#include "vtkMTQuadPartition.h"
#include "vtkMTRegularPartition.h"
#include "vtkMTVoronoiPartition.h"

namespace
{
// With the domain that a name ends with.
vtkSmartPointer<vtkMTPartitionStrategy> MakeOfDomain(const std::string& name, const std::string& stem)
{
  const std::string domain = name.substr(stem.size());
  vtkSmartPointer<vtkMTDomainPartition> strategy;
  if (stem == "quad")
  {
    strategy = vtkSmartPointer<vtkMTQuadPartition>::New();
  }
  else
  {
    strategy = vtkSmartPointer<vtkMTHexagonPartition>::New();
  }
  if (!domain.empty())
  {
    strategy->SetDomain(domain == "-plane" ? vtkMTDomainPartition::PLANE : vtkMTDomainPartition::SPHERE);
  }
  return domain.empty() || domain == "-plane" || domain == "-sphere" ? strategy : nullptr;
}
}

vtkMTPartitionStrategy::vtkMTPartitionStrategy() = default;

vtkMTPartitionStrategy::~vtkMTPartitionStrategy() = default;

vtkSmartPointer<vtkMTPartitionStrategy> vtkMTPartitionStrategy::MakeByName(const std::string& name)
{
  if (name == "v")
  {
    return vtkSmartPointer<vtkMTVoronoiPartition>::New();
  }
  if (name == "regular")
  {
    return vtkSmartPointer<vtkMTRegularPartition>::New();
  }
  if (name == "kd")
  {
    return vtkSmartPointer<vtkMTKdPartition>::New();
  }
  for (const std::string stem : { "quad", "hexagon" })
  {
    if (name.compare(0, stem.size(), stem) == 0)
    {
      return MakeOfDomain(name, stem);
    }
  }
  return nullptr;
}

std::vector<std::string> vtkMTPartitionStrategy::GetNames()
{
  return { "v", "regular", "kd", "quad", "quad-plane", "quad-sphere", "hexagon", "hexagon-plane", "hexagon-sphere" };
}

void vtkMTPartitionStrategy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "StrategyName: " << this->GetStrategyName() << "\n";
  os << indent << "Settings: " << this->GetSettings() << "\n";
}
