// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportTimes.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

double MTReportTimes::GetCpuSeconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double MTReportTimes::GetQuantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double rank = std::ceil(share * static_cast<double>(values.size())) - 1.0;
  const auto at = static_cast<std::ptrdiff_t>(std::clamp(rank, 0.0, static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[at];
}

void MTReportTimes::Measure(const std::function<void()>& work)
{
  const double begin = GetCpuSeconds();
  work();
  this->Add(GetCpuSeconds() - begin);
}

double MTReportTimes::GetMedian() const
{
  return GetQuantile(this->Seconds, 0.5);
}

double MTReportTimes::GetLeast() const
{
  return GetQuantile(this->Seconds, 0.0);
}

double MTReportTimes::GetLargest() const
{
  return GetQuantile(this->Seconds, 1.0);
}

double MTReportTimes::GetSpread() const
{
  return 100.0 * (this->GetLargest() - this->GetLeast()) / this->GetMedian();
}
