// SPDX-License-Identifier: BSD-3-Clause
// What the tests of IO share: a folder for each test, whole files as bytes, child processes, comparison of models.
#ifndef MTIOTest_h
#define MTIOTest_h

#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <unistd.h>

namespace MTIOTest
{
using Bytes = std::vector<unsigned char>;

//------------------------------------------------------------------------------
/// An empty folder of the running test's own, gone at the end.
class Folder
{
public:
  Folder();
  ~Folder();
  std::string operator/(const std::string& name) const { return (this->Path / name).string(); }
  std::vector<std::string> List() const;

private:
  std::filesystem::path Path;
};

//------------------------------------------------------------------------------
Bytes ReadFile(const std::string& path);

void WriteFile(const std::string& path, const Bytes& bytes);

void WriteFile(const std::string& path, const std::string& text);

//------------------------------------------------------------------------------
// Sanitizers keep memory that was freed, so what a process holds says nothing.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool IsSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool IsSanitized = true;
#else
constexpr bool IsSanitized = false;
#endif
#else
constexpr bool IsSanitized = false;
#endif

//------------------------------------------------------------------------------
struct ChildResult
{
  bool Crashed = false;
  int ExitCode = 0;
};

/// Runs body in a child process, whose exit code is what body gives.
ChildResult RunInChild(const std::function<int()>& body);

//------------------------------------------------------------------------------
/// The folder of real meshes, or empty when it is not there.
std::string GetDataFolder();

//------------------------------------------------------------------------------
bool AreEqual(const vtkMTPatch& a, const vtkMTPatch& b);

bool AreEqual(const vtkMTNode& a, const vtkMTNode& b);

bool AreEqual(const vtkMTArc& a, const vtkMTArc& b);

template <typename Item>
bool AreAllEqual(const std::vector<Item>& a, const std::vector<Item>& b)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(), [](const Item& x, const Item& y) { return AreEqual(x, y); });
}

void ExpectEqual(const vtkMTGraph& a, const vtkMTGraph& b);

/// A file of all patches of a model, in the order of the arcs.
Bytes StoreModel(const vtkMTPatchSource& model);

/// Graph and all patches, byte for byte, where b was made of a by storing it.
void ExpectStored(const vtkMTPatchSource& a, const vtkMTPatchSource& b);
}

#endif
