// SPDX-License-Identifier: BSD-3-Clause
#include "MTRunBmt.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
std::string Slurp(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

// Waits until the child has a handler for SIGINT, however slowly the machine starts it, or 30 seconds.
void WaitForHandler(pid_t child)
{
  for (int i = 0; i < 3000; ++i)
  {
    std::ifstream status("/proc/" + std::to_string(child) + "/status");
    std::string word;
    while (status >> word && word != "SigCgt:")
    {
    }
    unsigned long long caught = 0;
    if (status >> std::hex >> caught && (caught >> (SIGINT - 1)) & 1)
    {
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}

[[noreturn]] void RunChild(const std::vector<std::string>& arguments, const MTRunOptions& options,
  const std::filesystem::path& out, const std::filesystem::path& err)
{
  for (const std::string& entry : options.Environment)
  {
    const std::size_t equals = entry.find('=');
    if (equals == std::string::npos)
    {
      unsetenv(entry.c_str());
    }
    else
    {
      setenv(entry.substr(0, equals).c_str(), entry.c_str() + equals + 1, 1);
    }
  }
  if (options.LargestFile > 0)
  {
    const rlimit limit{ options.LargestFile, options.LargestFile };
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  std::vector<char*> argv{ const_cast<char*>(BMT_EXECUTABLE) };
  for (const std::string& argument : arguments)
  {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  execv(BMT_EXECUTABLE, argv.data());
  _exit(127);
}

/// Ends without a signal when the child has ended.
void SignalWhen(pid_t child, const std::function<bool()>& condition, int signal)
{
  siginfo_t ended{};
  while (!condition())
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == child)
    {
      return;
    }
  }
  kill(child, signal);
}
}

nlohmann::json MTRun::Json() const
{
  nlohmann::json json = nlohmann::json::parse(this->Out, nullptr, false);
  EXPECT_TRUE(json.is_object()) << "standard output is no JSON object: '" << this->Out
                                << "', standard error: " << this->Err;
  return json.is_object() ? json : nlohmann::json::object();
}

void MTBmtTest::SetUp()
{
  const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
  this->Folder =
    std::filesystem::path(MT_TEST_OUTPUT_DIRECTORY) / (std::string(test->test_suite_name()) + "." + test->name());
  std::filesystem::remove_all(this->Folder);
  std::filesystem::create_directories(this->Folder);
}

void MTBmtTest::TearDown()
{
  if (!this->HasFailure())
  {
    std::filesystem::remove_all(this->Folder);
  }
}

MTRun MTBmtTest::Bmt(const std::vector<std::string>& arguments, const MTRunOptions& options) const
{
  const std::filesystem::path out = this->Folder.string() + ".out";
  const std::filesystem::path err = this->Folder.string() + ".err";
  const pid_t child = fork();
  if (child == 0)
  {
    RunChild(arguments, options, out, err);
  }
  if (options.InterruptAfterMilliseconds >= 0)
  {
    WaitForHandler(child);
    std::this_thread::sleep_for(std::chrono::milliseconds(options.InterruptAfterMilliseconds));
    kill(child, options.Signal);
  }
  int status = 0;
  if (options.InterruptWhen)
  {
    SignalWhen(child, options.InterruptWhen, options.Signal);
  }
  while (waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  MTRun run;
  run.Exit = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  run.Out = Slurp(out);
  run.Err = Slurp(err);
  std::filesystem::remove(out);
  std::filesystem::remove(err);
  return run;
}

nlohmann::json MTBmtTest::BmtJson(std::vector<std::string> arguments) const
{
  arguments.emplace_back("--json");
  const MTRun run = this->Bmt(arguments);
  EXPECT_EQ(run.Exit, 0) << arguments.front() << ": " << run.Err;
  return run.Json();
}

void MTBmtTest::WriteFile(const std::string& name, const std::string& bytes) const
{
  std::ofstream(this->Folder / name, std::ios::binary) << bytes;
}

std::string MTBmtTest::ReadFile(const std::string& name) const
{
  return Slurp(this->Folder / name);
}

std::vector<std::string> MTBmtTest::List() const
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(this->Folder))
  {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void MTBmtTest::MakeSphere(int triangles) const
{
  this->BmtJson(
    { "generate", "fractal-sphere", "--triangles", std::to_string(triangles), "-o", this->Path("sphere.ply") });
}

void MTBmtTest::MakeModel(int triangles, int patchTriangles, const std::vector<std::string>& options) const
{
  this->MakeSphere(triangles);
  std::vector<std::string> call = { "build", this->Path("sphere.ply"), "-o", this->Path("sphere.bmt"),
    "--patch-triangles", std::to_string(patchTriangles) };
  call.insert(call.end(), options.begin(), options.end());
  this->BmtJson(call);
}
