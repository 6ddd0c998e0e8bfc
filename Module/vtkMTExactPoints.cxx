// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTExactPoints.h"

#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
constexpr std::size_t Axes = 3;

// The bits of numbers as integers that are ordered as the numbers are; -0 is the one before 0.
template <typename Real, typename Bits>
struct Ordered
{
  static constexpr Bits Sign = Bits(1) << (8 * sizeof(Bits) - 1);

  static Bits FromReal(Real x)
  {
    Bits bits;
    std::memcpy(&bits, &x, sizeof(bits));
    return (bits & Sign) != 0 ? ~bits : bits | Sign;
  }
  static Real ToReal(Bits order)
  {
    const Bits bits = (order & Sign) != 0 ? order ^ Sign : ~order;
    Real x;
    std::memcpy(&x, &bits, sizeof(x));
    return x;
  }
};

float RoundTo(double x, float)
{
  // Beyond the largest float a conversion is not defined; the lattice's place can be there.
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(x, -largest, largest));
}

double RoundTo(double x, double)
{
  return x;
}

template <typename Real, typename Bits>
void EncodeAs(const std::array<double, Axes>& lattice, const std::array<double, Axes>& exact, unsigned char* tuple)
{
  using Order = Ordered<Real, Bits>;
  for (std::size_t i = 0; i < Axes; ++i)
  {
    const Bits difference =
      static_cast<Bits>(Order::FromReal(static_cast<Real>(exact[i])) - Order::FromReal(RoundTo(lattice[i], Real())));
    std::memcpy(tuple + i * sizeof(difference), &difference, sizeof(difference));
  }
}

template <typename Real, typename Bits>
void DecodeAs(const std::array<double, Axes>& lattice, const unsigned char* tuple, std::array<double, Axes>& exact)
{
  using Order = Ordered<Real, Bits>;
  for (std::size_t i = 0; i < Axes; ++i)
  {
    Bits difference;
    std::memcpy(&difference, tuple + i * sizeof(difference), sizeof(difference));
    exact[i] =
      static_cast<double>(Order::ToReal(static_cast<Bits>(Order::FromReal(RoundTo(lattice[i], Real())) + difference)));
  }
}
}

vtkMTArrayInfo vtkMTExactPoints::MakeInfo(bool isSingle, const std::vector<vtkMTArrayInfo>& others)
{
  vtkMTArrayInfo info;
  info.Name = "vtkMTExactPoints";
  const auto isTaken = [&info](const vtkMTArrayInfo& other)
  { return other.Association == vtkMTArrayInfo::Point && other.Name == info.Name; };
  while (std::any_of(others.begin(), others.end(), isTaken))
  {
    info.Name += "_";
  }
  info.Type = isSingle ? VTK_INT : VTK_LONG_LONG;
  info.Components = static_cast<int>(Axes);
  info.Resampling = vtkMTArrayInfo::Nearest;
  info.Role = vtkMTArrayInfo::ExactPoints;
  return info;
}

bool vtkMTExactPoints::IsSound(const vtkMTArrayInfo& info)
{
  return info.Role == vtkMTArrayInfo::ExactPoints && info.Association == vtkMTArrayInfo::Point &&
    info.Components == static_cast<int>(Axes) && (info.Type == VTK_INT || info.Type == VTK_LONG_LONG);
}

bool vtkMTExactPoints::IsSingle(const vtkMTArrayInfo& info)
{
  return info.Type == VTK_INT;
}

bool vtkMTExactPoints::IsSingle(double x)
{
  return !std::isfinite(x) ||
    (std::abs(x) <= double(std::numeric_limits<float>::max()) && double(static_cast<float>(x)) == x);
}

void vtkMTExactPoints::Encode(const vtkMTArrayInfo& info, const vtkMTLattice& lattice, const vtkMTPoint& point,
  const Place& exact, unsigned char* tuple)
{
  return IsSingle(info) ? EncodeAs<float, std::uint32_t>(lattice.ToWorld(point), exact, tuple)
                        : EncodeAs<double, std::uint64_t>(lattice.ToWorld(point), exact, tuple);
}

bool vtkMTExactPoints::Decode(const vtkMTArrayInfo& info, const vtkMTLattice& lattice, const vtkMTPoint& point,
  const unsigned char* tuple, Place& exact)
{
  const Place place = lattice.ToWorld(point);
  if (IsSingle(info))
  {
    DecodeAs<float, std::uint32_t>(place, tuple, exact);
  }
  else
  {
    DecodeAs<double, std::uint64_t>(place, tuple, exact);
  }
  // Written so that what is no number is refused.
  return std::abs(exact[0] - place[0]) <= lattice.MaximumShift &&
    std::abs(exact[1] - place[1]) <= lattice.MaximumShift && std::abs(exact[2] - place[2]) <= lattice.MaximumShift;
}
