// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMTFigureInformation
 * @brief what the processes of a session drew of a Multi-Triangulation in the last frame
 *
 * Gathered from a vtkMultiTriangulationRepresentation. Of several processes counts and bytes are summed up, the largest
 * error and time are taken, and the whole has converged where all have. Processes that show no model, as the client of
 * a server, do not count.
 */
#ifndef vtkMTFigureInformation_h
#define vtkMTFigureInformation_h

#include "vtkMTParaViewModule.h" // For export macro
#include "vtkPVInformation.h"
#include "vtkType.h"

class VTKMTPARAVIEW_EXPORT vtkMTFigureInformation : public vtkPVInformation
{
public:
  static vtkMTFigureInformation* New();
  vtkTypeMacro(vtkMTFigureInformation, vtkPVInformation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// ParaView calls these, in the processes that have the representation and on the way to who asks.
  void CopyFromObject(vtkObject* object) override;
  void AddInformation(vtkPVInformation* information) override;
  void CopyToStream(vtkClientServerStream* stream) override;
  void CopyFromStream(const vtkClientServerStream* stream) override;
  ///@}

  ///@{
  /// The figures of vtkMultiTriangulationRepresentation, and the largest number of triangles that a process drew; all
  /// 0 where no process shows a model.
  vtkGetMacro(NumberOfTriangles, vtkTypeInt64);
  vtkGetMacro(LargestShare, vtkTypeInt64);
  vtkGetMacro(NumberOfPatches, vtkTypeInt64);
  vtkGetMacro(AchievedPixelError, double);
  vtkGetMacro(Converged, int);
  vtkGetMacro(Loading, int);
  vtkGetMacro(FrameTime, double);
  vtkGetMacro(GraphicsMemory, vtkTypeInt64);
  vtkGetMacro(PatchMemory, vtkTypeInt64);
  ///@}

  /// How many processes show the model.
  vtkGetMacro(NumberOfProcesses, int);

protected:
  vtkMTFigureInformation();
  ~vtkMTFigureInformation() override;

private:
  vtkMTFigureInformation(const vtkMTFigureInformation&) = delete;
  void operator=(const vtkMTFigureInformation&) = delete;

  int NumberOfProcesses = 0;
  vtkTypeInt64 NumberOfTriangles = 0;
  vtkTypeInt64 LargestShare = 0;
  vtkTypeInt64 NumberOfPatches = 0;
  double AchievedPixelError = 0.0;
  int Converged = 0;
  int Loading = 0;
  double FrameTime = 0.0;
  vtkTypeInt64 GraphicsMemory = 0;
  vtkTypeInt64 PatchMemory = 0;
};

#endif
