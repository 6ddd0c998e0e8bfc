// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTPatchUse
 * @brief finds out whether the filters behind a vtkMultiTriangulation know its patches, and warns of those that do not
 *
 * A filter that knows polydata alone works on the mesh that the object holds, the coarsest cut, which is seldom what
 * was meant. VTK does not tell a producer who takes its output; but whenever a consumer updates, ComputePipelineMTime
 * is called on the consumer first and on the producer then. So a consumer that uses the patches leaves a mark on the
 * output there (Announce), and the producer takes it away (Check): where there is none, the consumer does not know
 * them. Nothing is kept of the consumer, which may be gone at any time.
 */
#ifndef vtkMTPatchUse_h
#define vtkMTPatchUse_h

#include "vtkMTCoreModule.h" // For export macro

class vtkAlgorithm;
class vtkInformationVector;

class VTKMTCORE_EXPORT vtkMTPatchUse
{
public:
  /// For the ComputePipelineMTime of consumers.
  static void Announce(vtkInformationVector** inputs);
  /// For the ComputePipelineMTime of producers; port is the one that it is called for, -1 where no consumer asks.
  static void Check(vtkAlgorithm* producer, vtkInformationVector* outputs, int port);
  /// For the end of a producer's RequestData: the warning, once for each output, where Check found that consumer and
  /// the output's own mesh is the coarsest of several cuts.
  static void Warn(vtkAlgorithm* producer, vtkInformationVector* outputs);
};

#endif
