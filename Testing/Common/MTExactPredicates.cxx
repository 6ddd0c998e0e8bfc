// SPDX-License-Identifier: BSD-3-Clause
#include "MTExactPredicates.h"

namespace MTExactPredicates
{
namespace
{
__extension__ using Integer = __int128;
using Normal = std::array<Integer, 3>;

int GetSign(Integer x)
{
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

Normal GetNormal(const Triangle& t)
{
  Integer u[3], v[3];
  for (int i = 0; i < 3; ++i)
  {
    u[i] = t[1][i] - t[0][i];
    v[i] = t[2][i] - t[0][i];
  }
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}

// Of a sum of products of numbers of at most 68 bits, which may have 138: by halves of 34.
int GetDotSign(const Normal& a, const Normal& b)
{
  constexpr int Half = 34;
  constexpr Integer Base = Integer(1) << Half;
  Integer high = 0, middle = 0, low = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Integer a1 = a[i] >> Half, b1 = b[i] >> Half;
    const Integer a0 = a[i] - a1 * Base, b0 = b[i] - b1 * Base; // not negative
    high += a1 * b1;
    middle += a1 * b0 + a0 * b1;
    low += a0 * b0;
  }
  middle += low >> Half;
  low -= (low >> Half) * Base;
  high += middle >> Half;
  middle -= (middle >> Half) * Base;
  return high != 0 ? GetSign(high) : middle != 0 ? 1 : low != 0 ? 1 : 0;
}

// In the plane of two axes.
int GetPlaneOrientation(const Point& a, const Point& b, const Point& c, int u, int v)
{
  return GetSign(Integer(b[u] - a[u]) * (c[v] - a[v]) - Integer(b[v] - a[v]) * (c[u] - a[u]));
}

bool IsBetween(std::int64_t a, std::int64_t b, std::int64_t x)
{
  return a <= b ? a <= x && x <= b : b <= x && x <= a;
}

bool SegmentsMeetInPlane(const Point& p, const Point& q, const Point& a, const Point& b, int u, int v)
{
  const int sides[4] = { GetPlaneOrientation(p, q, a, u, v), GetPlaneOrientation(p, q, b, u, v),
    GetPlaneOrientation(a, b, p, u, v), GetPlaneOrientation(a, b, q, u, v) };
  if (sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0)
  {
    return true;
  }
  const auto isOn = [u, v](int side, const Point& s, const Point& t, const Point& x)
  { return side == 0 && IsBetween(s[u], t[u], x[u]) && IsBetween(s[v], t[v], x[v]); };
  return isOn(sides[0], p, q, a) || isOn(sides[1], p, q, b) || isOn(sides[2], a, b, p) || isOn(sides[3], a, b, q);
}

// A segment that lies in the triangle's plane: projected along an axis along which the triangle does not vanish.
bool SegmentMeetsTriangleInPlane(const Point& p, const Point& q, const Triangle& t)
{
  const Normal normal = GetNormal(t);
  const int axis = normal[2] != 0 ? 2 : normal[1] != 0 ? 1 : 0;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  const int sides[3] = { GetPlaneOrientation(t[0], t[1], p, u, v), GetPlaneOrientation(t[1], t[2], p, u, v),
    GetPlaneOrientation(t[2], t[0], p, u, v) };
  if ((sides[0] >= 0 && sides[1] >= 0 && sides[2] >= 0) || (sides[0] <= 0 && sides[1] <= 0 && sides[2] <= 0))
  {
    return true;
  }
  return SegmentsMeetInPlane(p, q, t[0], t[1], u, v) || SegmentsMeetInPlane(p, q, t[1], t[2], u, v) ||
    SegmentsMeetInPlane(p, q, t[2], t[0], u, v);
}
}

int GetOrientation(const Point& a, const Point& b, const Point& c, const Point& d)
{
  const Normal normal = GetNormal({ a, b, c });
  return GetSign(normal[0] * (d[0] - a[0]) + normal[1] * (d[1] - a[1]) + normal[2] * (d[2] - a[2]));
}

bool IsDegenerate(const Triangle& t)
{
  const Normal normal = GetNormal(t);
  return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
}

int GetNormalProductSign(const Triangle& s, const Triangle& t)
{
  return GetDotSign(GetNormal(s), GetNormal(t));
}

bool SegmentMeetsTriangle(const Point& p, const Point& q, const Triangle& t)
{
  const int sideP = GetOrientation(t[0], t[1], t[2], p);
  const int sideQ = GetOrientation(t[0], t[1], t[2], q);
  if (sideP * sideQ > 0)
  {
    return false;
  }
  if (sideP == 0 && sideQ == 0)
  {
    return SegmentMeetsTriangleInPlane(p, q, t);
  }
  const int a = GetOrientation(p, q, t[0], t[1]);
  const int b = GetOrientation(p, q, t[1], t[2]);
  const int c = GetOrientation(p, q, t[2], t[0]);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool TrianglesMeet(const Triangle& s, const Triangle& t)
{
  int sides[3];
  for (int c = 0; c < 3; ++c)
  {
    sides[c] = GetOrientation(t[0], t[1], t[2], s[c]);
  }
  if (sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2])
  {
    return false;
  }
  for (int c = 0; c < 3; ++c)
  {
    if (SegmentMeetsTriangle(s[c], s[(c + 1) % 3], t) || SegmentMeetsTriangle(t[c], t[(c + 1) % 3], s))
    {
      return true;
    }
  }
  return false;
}

bool TrianglesMeetBeyondCorner(const Triangle& s, const Triangle& t)
{
  // What they have in common but the corner is a segment from it, or more, and ends at the opposite edge of one.
  return SegmentMeetsTriangle(s[1], s[2], t) || SegmentMeetsTriangle(t[1], t[2], s);
}

bool TrianglesFold(const Triangle& s, const Triangle& t)
{
  return GetOrientation(s[0], s[1], s[2], t[2]) == 0 && GetNormalProductSign(s, { s[0], s[1], t[2] }) > 0;
}
}
