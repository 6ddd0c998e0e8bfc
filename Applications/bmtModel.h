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

/// Whether the file can be read and begins as a Multi-Triangulation file does.
bool bmtIsModel(const std::string& path);

/// Opens a Multi-Triangulation file; its DAG has been checked when this returns.
std::shared_ptr<const vtkMTPatchSource> bmtOpenModel(const std::string& path);

/**
 * Reads meshes of any kind that the toolkit knows and puts them into one, with the arrays that all of them have; of a
 * Multi-Triangulation file the finest level. Gives the number of arrays that were left out because not all meshes have
 * them.
 */
std::int64_t bmtReadMeshes(const std::vector<std::string>& paths, vtkPolyData* mesh);

/// Throws unless the name has an ending of a mesh that can be written.
void bmtRequireMeshEnding(const std::string& path);
/// Writes a mesh by the ending of the name, whole or not at all.
void bmtWriteMesh(const std::string& path, vtkPolyData* mesh);

/// The figures of a model: what `bmt info` prints.
bmtJson bmtDescribeModel(const vtkMTGraph& graph, std::uint64_t bytes);

/// Adds the positional argument FILE that names a Multi-Triangulation file.
void bmtAddModelArgument(CLI::App& command, std::string& path);

#endif
