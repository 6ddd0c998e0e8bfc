// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtCheck.h
 * @brief one check of `bmt verify` and what came of it
 */
#ifndef bmtCheck_h
#define bmtCheck_h

#include "bmtCommon.h"

#include <cstdint>
#include <string>

struct bmtCheck
{
  std::string Name;
  std::uint64_t Tested = 0;
  std::uint64_t Violations = 0;
  double Worst =
    0.0; ///< what is measured over what is allowed, largest: at most 1 when all is well; 0 where nothing is measured
  std::string Message; ///< the first violation, for a person

  explicit bmtCheck(const std::string& name)
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

  bmtJson ToJson() const
  {
    bmtJson json;
    json["name"] = this->Name;
    json["ok"] = this->IsOk();
    json["tested"] = this->Tested;
    json["violations"] = this->Violations;
    json["worst"] = this->Worst;
    if (!this->Message.empty())
    {
      json["message"] = this->Message;
    }
    return json;
  }
};

#endif
