// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMultiTriangulationWriter.h"

#include "vtkMTFileSink.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

#include <array>
#include <numeric>

vtkStandardNewMacro(vtkMultiTriangulationWriter);

vtkMultiTriangulationWriter::vtkMultiTriangulationWriter() = default;

vtkMultiTriangulationWriter::~vtkMultiTriangulationWriter()
{
  this->SetFileName(nullptr);
}

void vtkMultiTriangulationWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

int vtkMultiTriangulationWriter::ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port, vtkMTimeType* time)
{
  vtkMultiTriangulation::AnnounceUse(inputVector);
  return this->Superclass::ComputePipelineMTime(request, inputVector, outputVector, port, time);
}

int vtkMultiTriangulationWriter::FillInputPortInformation(int, vtkInformation* info)
{
  // Any polydata, so that the one without patches gets a message that says what is missing.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkMultiTriangulationWriter::WriteData()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("no file name given");
    return;
  }
  vtkMultiTriangulation* input = vtkMultiTriangulation::SafeDownCast(this->GetInput());
  const std::shared_ptr<const vtkMTPatchSource> source = input ? input->GetSource() : nullptr;
  if (!source)
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    vtkErrorMacro(<< this->FileName << ": the input has no patches to write: it is "
                  << (input ? "an empty Multi-Triangulation"
                            : "plain polydata, from which vtkMultiTriangulationBuilder makes a "
                              "Multi-Triangulation"));
    return;
  }
  this->WritePatches(*source, *input);
}

void vtkMultiTriangulationWriter::WritePatches(const vtkMTPatchSource& source, const vtkMultiTriangulation& model)
{
  const vtkMTGraph& graph = source.GetGraph();
  if (!graph.IsWhole())
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
    vtkErrorMacro(<< source.GetGraphError());
    return;
  }
  vtkMTFileSink sink(this->FileName);
  if (!sink.Begin(graph.Arrays))
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< sink.GetError());
    return;
  }
  for (std::uint32_t arc = 0; arc < graph.Arcs.size(); ++arc)
  {
    vtkMTPatch patch;
    std::string error;
    if (!source.ReadPatch(arc, nullptr, patch, error))
    {
      this->SetErrorCode(vtkErrorCode::FileFormatError);
      vtkErrorMacro(<< error);
      return;
    }
    if (!sink.WritePatch(std::move(patch)))
    {
      this->SetErrorCode(vtkErrorCode::OutOfDiskSpaceError);
      vtkErrorMacro(<< sink.GetError());
      return;
    }
  }
  std::vector<std::uint32_t> patchOfArc(graph.Arcs.size());
  std::iota(patchOfArc.begin(), patchOfArc.end(), 0u);
  std::array<double, 16> frame;
  model.GetFrame(frame.data());
  constexpr std::array<double, 16> identity{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  // Another place than the source's own: only then is the DAG copied.
  vtkMTGraph placed;
  const bool isMoved = frame != graph.Frame.value_or(identity);
  if (isMoved)
  {
    placed = graph;
    placed.Frame = frame;
  }
  if (!sink.Finish(isMoved ? placed : graph, patchOfArc))
  {
    this->SetErrorCode(vtkErrorCode::OutOfDiskSpaceError);
    vtkErrorMacro(<< sink.GetError());
  }
}
