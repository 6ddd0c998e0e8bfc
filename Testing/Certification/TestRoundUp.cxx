// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTRoundUp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>

TEST(RoundUp, GivesTheLeastFloatThatIsNoSmaller)
{
  constexpr float Infinity = std::numeric_limits<float>::infinity();
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-160.0, 120.0); // denormals of single precision too
  int raised = 0;
  for (int i = 0; i < 200000; ++i)
  {
    const double value = i == 0 ? 0.0 : std::exp2(exponent(random)) * (i % 3 == 0 ? 1.0 : 1.37);
    const float rounded = vtkMTRoundUp::ToFloat(value);
    ASSERT_GE(static_cast<double>(rounded), value);
    ASSERT_TRUE(rounded == 0.0f || static_cast<double>(std::nextafter(rounded, 0.0f)) < value) << value;
    ASSERT_EQ(vtkMTRoundUp::GetNext(rounded), std::nextafter(rounded, Infinity));
    raised += static_cast<double>(rounded) > value ? 1 : 0;
  }
  std::cout << raised << " of 200000 are not floats\n";
  EXPECT_GT(raised, 100000);
}
