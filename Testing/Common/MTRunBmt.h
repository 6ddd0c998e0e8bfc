// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MTRunBmt.h
 * @brief runs the built bmt as a child process, in a folder of the test's own
 */
#ifndef MTRunBmt_h
#define MTRunBmt_h

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

struct MTRun
{
  int Exit = -1; ///< exit code, or 1000 + the signal that ended it
  std::string Out;
  std::string Err;

  /// All of standard output as one JSON object; a test failure when it is anything else.
  nlohmann::json Json() const;
};

struct MTRunOptions
{
  std::vector<std::string> Environment; ///< NAME=VALUE, or NAME to take it away
  int InterruptAfterMilliseconds = -1;  ///< send SIGINT so long after the program is up
  std::function<bool()> InterruptWhen;  ///< send SIGINT as soon as this is true; asked every millisecond
  int Signal = SIGINT;                  ///< to send instead of SIGINT
  std::uint64_t LargestFile = 0;        ///< bytes that a file of the child's may have; 0: any number
};

/// A new, empty folder for each test; its files are removed when the test passed.
class MTBmtTest : public testing::Test
{
protected:
  void SetUp() override;
  void TearDown() override;

  MTRun Bmt(const std::vector<std::string>& arguments, const MTRunOptions& options = {}) const;
  /// The same with a failure unless the exit code is 0; gives the JSON. --json is added.
  nlohmann::json BmtJson(std::vector<std::string> arguments) const;

  std::string Path(const std::string& name) const { return (this->Folder / name).string(); }
  void WriteFile(const std::string& name, const std::string& bytes) const;
  std::string ReadFile(const std::string& name) const;
  /// The names in the folder, sorted.
  std::vector<std::string> List() const;

  /// A fractal sphere of that many triangles in sphere.ply, and its model with small patches in sphere.bmt.
  void MakeSphere(int triangles) const;
  void MakeModel(int triangles, int patchTriangles = 200, const std::vector<std::string>& options = {}) const;

  std::filesystem::path Folder;
};

#endif
