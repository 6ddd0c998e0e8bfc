// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTChildProcess
 * @brief work in a process of its own, which reports by lines of text and can be ended at any time
 *
 * The child is a copy of this process (fork) that does the work and nothing else. It shares no memory with its parent:
 * its limits, its threads and its end, however it comes about, are its own. It must be started before this process has
 * other threads or a window, as a copy has neither.
 *
 * When the parent ends first, the child gets SIGTERM. Its standard output is that of the parent, but what the parent
 * had in its buffers is not written twice.
 */
#ifndef vtkMTChildProcess_h
#define vtkMTChildProcess_h

#include "vtkMTIOCoreModule.h" // For export macro

#include <functional>
#include <string>
#include <vector>

class VTKMTIOCORE_EXPORT vtkMTChildProcess
{
public:
  /// Of the child: hands a line to the parent; line ends in it become blanks. Waits while the parent has more than some
  /// 60 KiB to read.
  using Report = std::function<void(const std::string& line)>;

  vtkMTChildProcess();
  /// Ends the child, if there is one.
  ~vtkMTChildProcess();
  vtkMTChildProcess(const vtkMTChildProcess&) = delete;
  void operator=(const vtkMTChildProcess&) = delete;

  /// Runs work in a new child, whose exit code is what it gives, or 1 where it throws. False on failure, with the
  /// reason. One child at a time.
  bool Start(const std::function<int(const Report&)>& work, std::string& error);

  /// The lines that have come since, in order, and whether the child has ended. Never waits. After the end and the last
  /// line IsRunning is false.
  std::vector<std::string> TakeLines();
  bool IsRunning() const { return this->Child > 0; }
  /// Of the last child that ended: 0 to 255, or 1000 + the signal that ended it.
  int GetExitCode() const { return this->ExitCode; }

  /// Of the child: whether SIGTERM or SIGINT has come; neither ends it, so that it can clean up. Any thread may ask.
  static bool IsAskedToEnd();

  /// Asks the child to end (SIGTERM), waits so many seconds at most, and then ends it (SIGKILL).
  void End(double patience = 3.0);

private:
  void Reap(int status);

  int Child = 0;
  int Pipe = -1;
  int ExitCode = 0;
  std::string Begun; // a line whose end has not come yet
};

#endif
