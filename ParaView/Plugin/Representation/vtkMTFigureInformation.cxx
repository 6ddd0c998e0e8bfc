// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTFigureInformation.h"

#include "vtkClientServerStream.h"
#include "vtkMultiTriangulationRepresentation.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkMTFigureInformation);

//------------------------------------------------------------------------------
vtkMTFigureInformation::vtkMTFigureInformation() = default;

//------------------------------------------------------------------------------
vtkMTFigureInformation::~vtkMTFigureInformation() = default;

//------------------------------------------------------------------------------
void vtkMTFigureInformation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfProcesses: " << this->NumberOfProcesses << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "LargestShare: " << this->LargestShare << "\n";
  os << indent << "NumberOfPatches: " << this->NumberOfPatches << "\n";
  os << indent << "AchievedPixelError: " << this->AchievedPixelError << "\n";
  os << indent << "Converged: " << this->Converged << "\n";
  os << indent << "Loading: " << this->Loading << "\n";
  os << indent << "FrameTime: " << this->FrameTime << "\n";
  os << indent << "GraphicsMemory: " << this->GraphicsMemory << "\n";
  os << indent << "PatchMemory: " << this->PatchMemory << "\n";
}

//------------------------------------------------------------------------------
void vtkMTFigureInformation::CopyFromObject(vtkObject* object)
{
  auto* representation = vtkMultiTriangulationRepresentation::SafeDownCast(object);
  if (!representation || !representation->ShowsModel())
  {
    return;
  }
  this->NumberOfProcesses = 1;
  this->NumberOfTriangles = representation->GetNumberOfTriangles();
  this->LargestShare = this->NumberOfTriangles;
  this->NumberOfPatches = representation->GetNumberOfPatches();
  this->AchievedPixelError = representation->GetAchievedPixelError();
  this->Converged = representation->GetConverged();
  this->Loading = representation->GetLoading();
  this->FrameTime = representation->GetFrameTime();
  this->GraphicsMemory = representation->GetGraphicsMemory();
  this->PatchMemory = representation->GetPatchMemory();
}

//------------------------------------------------------------------------------
void vtkMTFigureInformation::AddInformation(vtkPVInformation* information)
{
  auto* other = vtkMTFigureInformation::SafeDownCast(information);
  if (!other || other->NumberOfProcesses == 0)
  {
    return;
  }
  this->Converged = this->NumberOfProcesses == 0 ? other->Converged : std::min(this->Converged, other->Converged);
  this->NumberOfProcesses += other->NumberOfProcesses;
  this->NumberOfTriangles += other->NumberOfTriangles;
  this->LargestShare = std::max(this->LargestShare, other->LargestShare);
  this->NumberOfPatches += other->NumberOfPatches;
  this->AchievedPixelError = std::max(this->AchievedPixelError, other->AchievedPixelError);
  this->Loading = std::max(this->Loading, other->Loading);
  this->FrameTime = std::max(this->FrameTime, other->FrameTime);
  this->GraphicsMemory += other->GraphicsMemory;
  this->PatchMemory += other->PatchMemory;
}

//------------------------------------------------------------------------------
void vtkMTFigureInformation::CopyToStream(vtkClientServerStream* stream)
{
  stream->Reset();
  *stream << vtkClientServerStream::Reply << this->NumberOfProcesses << this->NumberOfTriangles << this->LargestShare
          << this->NumberOfPatches << this->AchievedPixelError << this->Converged << this->Loading << this->FrameTime
          << this->GraphicsMemory << this->PatchMemory << vtkClientServerStream::End;
}

//------------------------------------------------------------------------------
void vtkMTFigureInformation::CopyFromStream(const vtkClientServerStream* stream)
{
  const bool complete = stream->GetArgument(0, 0, &this->NumberOfProcesses) &&
    stream->GetArgument(0, 1, &this->NumberOfTriangles) && stream->GetArgument(0, 2, &this->LargestShare) &&
    stream->GetArgument(0, 3, &this->NumberOfPatches) && stream->GetArgument(0, 4, &this->AchievedPixelError) &&
    stream->GetArgument(0, 5, &this->Converged) && stream->GetArgument(0, 6, &this->Loading) &&
    stream->GetArgument(0, 7, &this->FrameTime) && stream->GetArgument(0, 8, &this->GraphicsMemory) &&
    stream->GetArgument(0, 9, &this->PatchMemory);
  if (!complete)
  {
    vtkErrorMacro("The figures of a process came incomplete.");
  }
}
