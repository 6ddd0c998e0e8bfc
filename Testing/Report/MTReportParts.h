// SPDX-License-Identifier: BSD-3-Clause
// The parts of the report. To add one: write its function in a file of its own, declare it here, and add a line to the
// table in MTReportParts.cxx.
#ifndef MTReportParts_h
#define MTReportParts_h

#include <vector>

class MTReportContext;
class MTReportSection;

struct MTReportPart
{
  const char* Name;  ///< as --part takes it
  const char* Title; ///< of its section
  void (*Run)(MTReportContext& context, MTReportSection& section);
};

/// All of them, in the order of the page.
const std::vector<MTReportPart>& MTReportGetParts();

///@{
void MTReportBuilding(MTReportContext& context, MTReportSection& section);
void MTReportConditioning(MTReportContext& context, MTReportSection& section);
void MTReportDrawing(MTReportContext& context, MTReportSection& section);
void MTReportScaling(MTReportContext& context, MTReportSection& section);
void MTReportSettings(MTReportContext& context, MTReportSection& section);
void MTReportStiff(MTReportContext& context, MTReportSection& section);
void MTReportTightness(MTReportContext& context, MTReportSection& section);
///@}

#endif
