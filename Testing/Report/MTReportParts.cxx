// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportParts.h"

const std::vector<MTReportPart>& MTReportGetParts()
{
  static const std::vector<MTReportPart> parts{
    { "building", "Error against run time: building", MTReportBuilding },
    { "settings", "Error against run time: settings of a build", MTReportSettings },
    { "drawing", "Error against run time: drawing", MTReportDrawing },
    { "scaling", "Scaling", MTReportScaling },
    { "tightness", "Tightness of certified errors against build time", MTReportTightness },
    { "stiff", "Stiff and extreme cases", MTReportStiff },
    { "conditioning", "Conditioning of the DAG", MTReportConditioning },
  };
  return parts;
}
