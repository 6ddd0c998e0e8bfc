// SPDX-License-Identifier: BSD-3-Clause
// The parts of the section on stiff and extreme cases.
#ifndef MTReportStiff_h
#define MTReportStiff_h

class MTReportContext;
class MTReportSection;

/// Build time against size, and curves where quality degrades.
void MTReportStiffCurves(MTReportContext& context, MTReportSection& section);

/// Certified errors and the search for the worst place beside CGAL's bounded-error Hausdorff distance.
void MTReportStiffOracle(MTReportContext& context, MTReportSection& section);

#endif
