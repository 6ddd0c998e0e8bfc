// SPDX-License-Identifier: BSD-3-Clause
// planted_fault overflow|leak|shift|race|none: does what its argument says.
#include <cstdio>
#include <string>
#include <vector>

namespace
{
int Overflow(int length)
{
  std::vector<int> values(static_cast<std::size_t>(length), 1);
  return values.data()[length];
}

int Leak(int length)
{
  int* volatile values = new int[static_cast<std::size_t>(length)]{};
  values = nullptr;
  return values == nullptr ? length : 0;
}

int Shift(int bits)
{
  return 1 << (30 + bits);
}

int Race(int count)
{
  int sum = 0;
#pragma omp parallel for num_threads(2)
  for (int i = 0; i < count; ++i)
  {
    sum = sum + i;
  }
  return sum;
}

int NoFault(int count)
{
  std::vector<int> values(static_cast<std::size_t>(count));
#pragma omp parallel for num_threads(2) schedule(dynamic)
  for (int i = 0; i < count; ++i)
  {
    values[static_cast<std::size_t>(i)] = i;
  }
  int sum = 0;
  for (const int value : values)
  {
    sum += value;
  }
  return sum;
}
}

int main(int argc, char* argv[])
{
  const std::string fault = argc > 1 ? argv[1] : "none";
  int result = 0;
  if (fault == "overflow")
  {
    result = Overflow(argc * 100);
  }
  else if (fault == "leak")
  {
    result = Leak(argc * 100);
  }
  else if (fault == "shift")
  {
    result = Shift(argc);
  }
  else if (fault == "race")
  {
    result = Race(argc * 10000);
  }
  else
  {
    result = NoFault(argc * 10000);
  }
  std::printf("%d\n", result);
  return 0;
}
