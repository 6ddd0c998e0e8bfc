// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTChildProcess.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
volatile std::sig_atomic_t AskedToEnd = 0;

extern "C" void HandleRequest(int)
{
  AskedToEnd = 1;
}

void WriteLine(int pipe, std::string line)
{
  std::replace(line.begin(), line.end(), '\n', ' ');
  line += '\n';
  std::size_t done = 0;
  while (done < line.size())
  {
    const ssize_t written = write(pipe, line.data() + done, line.size() - done);
    if (written < 0 && errno != EINTR)
    {
      return; // the parent has ended; SIGTERM says so too
    }
    done += written > 0 ? static_cast<std::size_t>(written) : 0;
  }
}

[[noreturn]] void RunChild(int pipe, pid_t parent, const sigset_t& mask,
  const std::function<int(const vtkMTChildProcess::Report&)>& work) noexcept
{
  std::signal(SIGTERM, HandleRequest);
  std::signal(SIGINT, HandleRequest);
  std::signal(SIGPIPE, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  int code = 1;
  try
  {
    if (getppid() == parent) // or else it ended before prctl
    {
      code = work([pipe](const std::string& line) { WriteLine(pipe, line); });
    }
  }
  catch (...)
  {
    code = 1;
  }
  _exit(code);
}
}

vtkMTChildProcess::vtkMTChildProcess() = default;

//------------------------------------------------------------------------------
bool vtkMTChildProcess::IsAskedToEnd()
{
  return AskedToEnd != 0;
}

//------------------------------------------------------------------------------
vtkMTChildProcess::~vtkMTChildProcess()
{
  this->End();
}

//------------------------------------------------------------------------------
bool vtkMTChildProcess::Start(const std::function<int(const Report&)>& work, std::string& error)
{
  int ends[2];
  if (this->IsRunning() || pipe2(ends, O_CLOEXEC) != 0)
  {
    error = this->IsRunning() ? "a child process is running" : std::string("no pipe: ") + std::strerror(errno);
    return false;
  }
  const pid_t parent = getpid();
  sigset_t requests; // which wait until the child has handlers of its own
  sigset_t mask;
  sigemptyset(&requests);
  sigaddset(&requests, SIGTERM);
  sigaddset(&requests, SIGINT);
  sigprocmask(SIG_BLOCK, &requests, &mask);
  const pid_t child = fork();
  if (child == 0)
  {
    close(ends[0]);
    RunChild(ends[1], parent, mask, work);
  }
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  close(ends[1]);
  if (child < 0)
  {
    error = std::string("no child process: ") + std::strerror(errno);
    close(ends[0]);
    return false;
  }
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  this->Pipe = ends[0];
  this->Child = child;
  this->Begun.clear();
  return true;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkMTChildProcess::TakeLines()
{
  std::vector<std::string> lines;
  char buffer[4096];
  ssize_t size = -1;
  while (this->IsRunning() && ((size = read(this->Pipe, buffer, sizeof(buffer))) > 0 || (size < 0 && errno == EINTR)))
  {
    this->Begun.append(buffer, size > 0 ? static_cast<std::size_t>(size) : 0);
  }
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = this->Begun.find('\n', begin)) != std::string::npos; begin = end + 1)
  {
    lines.push_back(this->Begun.substr(begin, end - begin));
  }
  this->Begun.erase(0, begin);
  int status = 0;
  if (this->IsRunning() && size == 0 && waitpid(this->Child, &status, 0) == this->Child) // it is ending
  {
    this->Reap(status);
  }
  return lines;
}

//------------------------------------------------------------------------------
void vtkMTChildProcess::Reap(int status)
{
  close(this->Pipe);
  this->Pipe = -1;
  this->Child = 0;
  this->ExitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

//------------------------------------------------------------------------------
void vtkMTChildProcess::End(double patience)
{
  if (!this->IsRunning())
  {
    return;
  }
  kill(this->Child, SIGTERM);
  int status = 0;
  const auto last = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience);
  while (waitpid(this->Child, &status, WNOHANG) == 0)
  {
    if (std::chrono::steady_clock::now() > last)
    {
      kill(this->Child, SIGKILL);
      waitpid(this->Child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  this->Reap(status);
}
