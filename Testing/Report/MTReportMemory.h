// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportMemory
 * @brief the most memory that the process holds while something is done, beyond what it held before
 *
 * As Linux counts it (VmHWM of /proc/self/status, which a write to clear_refs sets back); NaN elsewhere.
 */
#ifndef MTReportMemory_h
#define MTReportMemory_h

class MTReportMemory
{
public:
  /// Gives free memory back to the system, and begins to count.
  MTReportMemory();
  /// Bytes.
  double GetPeak() const;

private:
  double Before;
};

#endif
