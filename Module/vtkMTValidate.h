// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTValidate
 * @brief checks every invariant of a Multi-Triangulation that can be checked, and says what is wrong and where
 *
 * Graph: indices in range, arcs sorted and running forward, one source and one sink, every node on a path, errors and
 * edge lengths saturated, spheres nested, boxes inside spheres, counts that agree. Patch: indices in range, columns of
 * the right size, ids unique, box tight, no triangle with a repeated point. Node: the fragment pastes into its floor,
 * that is, the edges along which both meet the rest of the mesh are the same ones by identity (BMT section 3.2), and
 * shared points are equal bit for bit. Cut: every edge that is inner in the mesh of its own level is inner in the cut,
 * and no edge has more triangles than in its own level's mesh.
 *
 * Conformity needs no mesh of the whole cut: an edge inside a patch is the same in every cut, so only the edges between
 * shared points are compared.
 */
#ifndef vtkMTValidate_h
#define vtkMTValidate_h

#include "vtkMTCoreModule.h" // For export macro
#include "vtkMTPatch.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkMTCut;
class vtkMTGraph;
class vtkMTPatchSource;
struct vtkMTArc;

class VTKMTCORE_EXPORT vtkMTValidate
{
public:
  struct Finding
  {
    std::string Check; ///< "graph", "patch", "paste", "cut"
    std::string What;  ///< what is wrong and where, for a person
  };
  struct Result
  {
    std::uint64_t Tested = 0;
    std::uint64_t Violations = 0;
    std::vector<Finding> Findings; ///< at most MaximumFindings
    bool IsValid() const { return this->Violations == 0; }
    void Report(const std::string& check, const std::string& what);
    void Append(const Result& other);
  };
  static constexpr std::size_t MaximumFindings = 20;

  static Result Graph(const vtkMTGraph& graph);
  /// A patch by itself, against its arc's record and the model's arrays.
  static Result Patch(const vtkMTGraph& graph, std::uint32_t arc, const vtkMTPatch& patch);
  /// A mesh: indices in range, columns of the right size, no triangle with a repeated point.
  static Result Mesh(const vtkMTPatch& mesh, const std::vector<vtkMTArrayInfo>& arrays);

  /// Reads every patch once and keeps its border; then any number of cuts can be checked.
  class VTKMTCORE_EXPORT Borders
  {
  public:
    Borders();
    ~Borders();
    /// Checks every patch and every node's pasting on the way.
    Result Load(const vtkMTPatchSource& source);
    Result Cut(const vtkMTCut& cut) const;
    /// Edges of the cut with one triangle only, each of them with one triangle in its own level's mesh too when the cut
    /// is valid.
    std::uint64_t CountBorderEdges(const vtkMTCut& cut) const;

  private:
    struct Internals;
    std::unique_ptr<Internals> Implementation;
  };

  /// All of the above: graph, patches, nodes and `cuts` random cuts.
  static Result All(const vtkMTPatchSource& source, std::size_t cuts, std::uint32_t seed);
};

#endif
