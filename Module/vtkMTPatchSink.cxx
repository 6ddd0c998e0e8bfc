// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTPatchSink.h"

#include <utility>

namespace
{
struct WholePatch : public vtkMTPatchSink::PreparedPatch
{
  vtkMTPatch Patch;
};
}

vtkMTPatchSink::~vtkMTPatchSink() = default;

vtkMTPatchSink::PreparedPatch::~PreparedPatch() = default;

std::unique_ptr<vtkMTPatchSink::PreparedPatch> vtkMTPatchSink::Prepare(vtkMTPatch&& patch, std::string&) const
{
  auto prepared = std::make_unique<WholePatch>();
  prepared->Patch = std::move(patch);
  return prepared;
}

bool vtkMTPatchSink::WritePrepared(std::unique_ptr<PreparedPatch> patch)
{
  return this->WritePatch(std::move(static_cast<WholePatch&>(*patch).Patch));
}

bool vtkMTPatchSink::Save(std::vector<unsigned char>&)
{
  return false;
}

bool vtkMTPatchSink::Restore(const std::vector<vtkMTArrayInfo>&, const std::vector<unsigned char>&)
{
  this->Error = "this sink cannot go on with the patches of another process";
  return false;
}
