// SPDX-License-Identifier: BSD-3-Clause
#include "MTTestModel.h"
#include "vtkMTRandomCut.h"
#include "vtkMTValidate.h"

#include <gtest/gtest.h>

#include <iostream>

TEST(Validate, SoundModelHasNoFindings)
{
  const auto tube = MTTestModel::MakeTube();
  ASSERT_TRUE(tube);
  const vtkMTValidate::Result result = vtkMTValidate::All(*tube, 200, 1);
  std::cout << result.Tested << " tests\n";
  for (const auto& finding : result.Findings)
  {
    ADD_FAILURE() << finding.Check << ": " << finding.What;
  }
  EXPECT_EQ(result.Violations, 0u);
}
