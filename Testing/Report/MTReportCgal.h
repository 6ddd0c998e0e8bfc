// SPDX-License-Identifier: BSD-3-Clause
/**
 * CGAL's bounded-error Hausdorff distance between two surfaces: a second oracle beside MTWorstPlace, for small cuts.
 *
 * CGAL is GPL. MTReportCgal.cxx is the only source outside Filters/Simplification that includes it, and what links it
 * is not installed; the layers' test holds it so.
 */
#ifndef MTReportCgal_h
#define MTReportCgal_h

#include "MTWorstPlace.h"

namespace MTReportCgal
{
struct Distance
{
  double Least = 0.0; ///< the true one is within [Least, Largest]
  double Largest = 0.0;
};

/**
 * The symmetric Hausdorff distance of two surfaces that are not empty, up to bound, above 0. Triangles that meet at an
 * edge or a corner in any way are allowed: they become a manifold by points that are there several times.
 */
Distance GetSymmetricDistance(const MTWorstPlace::Surface& a, const MTWorstPlace::Surface& b, double bound);
}

#endif
