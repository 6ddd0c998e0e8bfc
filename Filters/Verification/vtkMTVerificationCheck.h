// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTVerificationCheck
 * @brief one check of the verification and what came of it
 */
#ifndef vtkMTVerificationCheck_h
#define vtkMTVerificationCheck_h

#include <cstdint>
#include <functional>
#include <string>

/// Is told what is being done and the share of it that is done, from the calling thread; returns false to stop.
using vtkMTVerificationProgress = std::function<bool(const std::string& step, double share)>;

struct vtkMTVerificationCheck
{
  std::string Name;
  std::uint64_t Tested = 0;
  std::uint64_t Violations = 0;
  /// The largest of what was measured over what is allowed: at most 1 when all is well; 0 where nothing is measured.
  double Worst = 0.0;
  std::string Message; ///< the first violation, for a person

  explicit vtkMTVerificationCheck(const std::string& name)
    : Name(name)
  {
  }

  bool IsOk() const { return this->Violations == 0; }

  void Fail(const std::string& message)
  {
    ++this->Violations;
    if (this->Message.empty())
    {
      this->Message = message;
    }
  }
};

#endif
