// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtCommon.h
 * @brief what all sub-commands of bmt share: errors, interruption, progress, output, and how a sub-command is added
 *
 * Each sub-command lives in a file of its own, bmt<Name>.cxx, and gives one function, bmtAdd<Name>, that describes its
 * options to CLI11 and says what to run. Errors are thrown as bmtError and reported once, in main.
 */
#ifndef bmtCommon_h
#define bmtCommon_h

#include <nlohmann/json.hpp>

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

namespace CLI
{
class App;
}
class vtkAlgorithm;

using bmtJson = nlohmann::ordered_json;

/// What went wrong, where, and what to do about it, in one line.
class bmtError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// The user pressed Ctrl-C.
class bmtInterrupt : public std::runtime_error
{
public:
  explicit bmtInterrupt(const std::string& what = "interrupted; outputs are as they were")
    : std::runtime_error(what)
  {
  }
};

struct bmtExit
{
  static constexpr int Success = 0;
  static constexpr int Failure = 1;   ///< an error, or a check that did not pass
  static constexpr int Usage = 2;     ///< options that make no sense
  static constexpr int Unchecked = 3; ///< nothing wrong was found, but not all could be checked
  static constexpr int Interrupted = 130;
};

///@{
/// Ctrl-C and SIGTERM set a flag that long loops ask for; a second one ends the program at once. A write beyond the
/// largest size that files may have (ulimit -f) is an error like any other instead of a signal.
void bmtCatchInterrupts();
bool bmtIsInterrupted();
void bmtThrowIfInterrupted();
///@}

/**
 * While it lives an interruption ends the program within a second, whatever that is doing: for work that loses nothing
 * by it. Where the work does not end by itself in `patience` seconds, `leave` runs in a thread of its own; it cleans up
 * and gives what is to be reported.
 */
class bmtInterruptWatch
{
public:
  bmtInterruptWatch(double patience, std::function<std::string()> leave);
  ~bmtInterruptWatch();
  bmtInterruptWatch(const bmtInterruptWatch&) = delete;
  void operator=(const bmtInterruptWatch&) = delete;

private:
  void Watch(double patience, const std::function<std::string()>& leave);

  std::mutex Mutex;
  std::condition_variable Ended;
  bool HasEnded = false;
  std::thread Thread;
};

/**
 * A line of progress on standard error while the object lives; nothing at all when standard error is no terminal.
 */
class bmtProgress
{
public:
  explicit bmtProgress(const char* what);
  ~bmtProgress();
  bmtProgress(const bmtProgress&) = delete;
  void operator=(const bmtProgress&) = delete;
  /// With what is being done, if anything is to be reported of it, and how long it may still take.
  void Update(double fraction, const std::string& step = "");

private:
  std::string GetTimeLeft(double fraction, double now);

  std::string What;
  double LastTime = -1.0;
  double FirstTime = -1.0; // since when there is progress
  double FirstFraction = 0.0;
};

/// Shows the algorithm's progress, and aborts it on Ctrl-C. progress must outlive the work.
void bmtFollow(vtkAlgorithm* algorithm, bmtProgress& progress);

/// VTK's errors and warnings go to standard error in the form of all other messages: one line each, "bmt: ...".
void bmtInstallOutputWindow();

/// What an error or warning of VTK says, without its place in the sources.
std::string bmtGetEssence(const std::string& text);

/// Says something that is no error on standard error.
void bmtWarn(const std::string& text);

/// Seconds since some fixed moment.
double bmtWallSeconds();

/// What the command line gave, filled by the sub-command's options.
struct bmtContext
{
  bool Json = false;
  std::function<int()> Run; ///< of the sub-command that was named; gives the exit code
};

/// Adds the options that every sub-command has.
void bmtAddCommonOptions(CLI::App& command, bmtContext& context);

/// The result of a command on standard output: one JSON object, or the same as lines of "name: value".
void bmtPrint(const bmtContext& context, const bmtJson& result);

/// Flushes standard output; throws bmtError when it could not take everything.
void bmtFinishOutput();

/// Throws bmtError unless a file can be made in the folder of path; nothing is made or changed.
void bmtRequireWritable(const std::string& path);
/// The ending of a file name, in lower case, with its dot.
std::string bmtGetEnding(const std::string& path);

///@{
void bmtAddGenerate(CLI::App& app, bmtContext& context);
void bmtAddBuild(CLI::App& app, bmtContext& context);
void bmtAddInfo(CLI::App& app, bmtContext& context);
void bmtAddVerify(CLI::App& app, bmtContext& context);
void bmtAddExtract(CLI::App& app, bmtContext& context);
void bmtAddCompare(CLI::App& app, bmtContext& context);
void bmtAddRender(CLI::App& app, bmtContext& context);
void bmtAddView(CLI::App& app, bmtContext& context);
///@}

#endif
