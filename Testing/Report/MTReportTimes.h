// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportTimes
 * @brief CPU times of one thing that is done again and again: their median and their spread
 *
 * CPU time is that of all threads of the process, so it does not depend on what else the machine does, but for the
 * speed of its caches. What is to be compared is measured in turns, each thing once in every turn, so that a machine
 * that becomes slower does so for all.
 */
#ifndef MTReportTimes_h
#define MTReportTimes_h

#include <functional>
#include <vector>

class MTReportTimes
{
public:
  /// Does it once and keeps how long it took.
  void Measure(const std::function<void()>& work);
  void Add(double seconds) { this->Seconds.push_back(seconds); }

  ///@{
  /// Seconds; NaN while there are none.
  double GetMedian() const;
  double GetLeast() const;
  double GetLargest() const;
  ///@}
  /// (largest - least) / median, in per cent.
  double GetSpread() const;

  /// Of the process, since it began.
  static double GetCpuSeconds();
  /// The smallest value that is at least as large as this share of the values; NaN where there are none.
  static double GetQuantile(std::vector<double> values, double share);

private:
  std::vector<double> Seconds;
};

#endif
