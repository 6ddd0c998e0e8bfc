// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmt.cxx
 * @brief the command bmt: Multi-Triangulations from the command line
 */
#include "bmtCommon.h"

#include "vtkMTVersion.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <new>
#include <string>

namespace
{
void DescribeCommands(CLI::App& app, bmtContext& context)
{
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.set_version_flag("--version", std::string("bmt ") + vtkMTVersion::GetVersion());
  app.require_subcommand(1);
  app.footer(
    "Exit code: 0 success, 1 failure or a check that did not pass, 2 wrong usage,\n"
    "3 not all could be checked (verify), 130 interrupted.\n"
    "Results go to standard output, messages and progress to standard error. Outputs are replaced only when whole.\n"
    "'bmt COMMAND --help' says more.");
  bmtAddGenerate(app, context);
  bmtAddBuild(app, context);
  bmtAddInfo(app, context);
  bmtAddVerify(app, context);
  bmtAddExtract(app, context);
  bmtAddCompare(app, context);
  bmtAddRender(app, context);
  bmtAddView(app, context);
}

int RunCommand(const bmtContext& context)
{
  try
  {
    return context.Run();
  }
  catch (const bmtInterrupt& interrupt)
  {
    bmtWarn(interrupt.what());
    return bmtExit::Interrupted;
  }
  catch (const std::bad_alloc&)
  {
    bmtWarn("out of memory; use a smaller input or a machine with more memory");
  }
  catch (const std::exception& error)
  {
    bmtWarn(error.what());
  }
  return bmtExit::Failure;
}

int ParseAndRun(int argc, char* argv[])
{
  bmtCatchInterrupts();
  bmtInstallOutputWindow();
  bmtContext context;
  CLI::App app("Builds, checks, measures and draws Multi-Triangulations of large triangle meshes.", "bmt");
  DescribeCommands(app, context);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& help)
  {
    return app.exit(help);
  }
  catch (const CLI::ParseError& error)
  {
    bmtWarn(std::string(error.what()) + "; 'bmt --help' and 'bmt COMMAND --help' list what there is");
    return bmtExit::Usage;
  }
  return RunCommand(context);
}
}

int main(int argc, char* argv[])
{
  try
  {
    return ParseAndRun(argc, argv);
  }
  catch (...)
  {
    std::fputs("bmt: out of memory before the work began\n", stderr);
    return bmtExit::Failure;
  }
}
