// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file bmtModel.h
 * @brief meshes and Multi-Triangulation files as the sub-commands read and write them; everything here throws bmtError
 */
#ifndef bmtModel_h
#define bmtModel_h

#include "bmtCommon.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTGraph;
class vtkMTPatchSource;
class vtkPolyData;

/// Opens a Multi-Triangulation file; its DAG has been checked when this returns.
std::shared_ptr<const vtkMTPatchSource> bmtOpenModel(const std::string& path);

/// Throws unless the name has an ending of a mesh that can be written.
void bmtRequireMeshEnding(const std::string& path);
/// Writes a mesh by the ending of the name, whole or not at all; gives the arrays that the format has no form for.
std::vector<std::string> bmtWriteMesh(const std::string& path, vtkPolyData* mesh);

/// The figures of a model: what `bmt info` prints.
bmtJson bmtDescribeModel(const vtkMTGraph& graph, std::uint64_t bytes);

/// Adds the positional argument FILE that names a Multi-Triangulation file.
void bmtAddModelArgument(CLI::App& command, std::string& path);

#endif
