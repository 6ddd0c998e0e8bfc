// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtInput.h
 * @brief the options that say what the input of a command is, and reading it whole
 */
#ifndef bmtInput_h
#define bmtInput_h

#include "bmtCommon.h"

#include "vtkMTInputSettings.h"

class vtkPolyData;

/// What the command line says of the input.
struct bmtInput : vtkMTInputSettings
{
  bmtInput() = default;
  explicit bmtInput(const std::string& path) { this->Paths = { path }; }
};

/// The kinds of files, for help texts.
const char* bmtGetInputKinds();

/// Adds --iso, --gradient-normals, --vertical-scale and --degrees.
void bmtAddInputOptions(CLI::App& command, bmtInput& input);

/// What to do about an error of the library, by its code, in terms of options; empty where the message suffices.
std::string bmtGetAdvice(unsigned long errorCode);

/// Reads all of it as one mesh (vtkMTBuildInput). Throws bmtError.
void bmtReadInput(const bmtInput& input, vtkPolyData* mesh);

#endif
