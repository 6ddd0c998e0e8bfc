// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTModelTextures.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataSetAttributes.h"
#include "vtkExecutive.h"
#include "vtkImageReader2.h"
#include "vtkJPEGReader.h"
#include "vtkMTGraph.h"
#include "vtkMTPatchSource.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace
{
std::string Get(const vtkMTBlobInfo& blob, const std::string& property)
{
  const auto found = blob.Properties.find(property);
  return found == blob.Properties.end() ? "" : found->second;
}

int GetNumber(const vtkMTBlobInfo& blob, const std::string& property)
{
  const std::string text = Get(blob, property);
  return text.empty() ? -1 : std::atoi(text.c_str());
}

std::string GetCoordinates(const vtkMTGraph& graph)
{
  const auto found = std::find_if(graph.Arrays.begin(), graph.Arrays.end(),
    [](const vtkMTArrayInfo& array)
    { return array.Attribute == vtkDataSetAttributes::TCOORDS && array.Association == vtkMTArrayInfo::Point; });
  return found == graph.Arrays.end() ? "" : found->Name;
}

// Null, with the reason, where the bytes are no image of these types and of 8 bits.
vtkSmartPointer<vtkImageData> ReadImage(
  const std::string& type, const std::vector<unsigned char>& bytes, std::string& problem)
{
  vtkSmartPointer<vtkImageReader2> reader;
  if (type == "image/png")
  {
    reader = vtkSmartPointer<vtkPNGReader>::New();
  }
  else if (type == "image/jpeg")
  {
    reader = vtkSmartPointer<vtkJPEGReader>::New();
  }
  else
  {
    problem = "images of type '" + type + "' are not read";
    return nullptr;
  }
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&problem);
  command->SetCallback([](vtkObject*, unsigned long, void* client, void*)
    { *static_cast<std::string*>(client) = "the image is damaged"; });
  reader->AddObserver(vtkCommand::ErrorEvent, command);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, command);
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  reader->Update();
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  if (problem.empty() && (image->GetNumberOfPoints() == 0 || image->GetScalarType() != VTK_UNSIGNED_CHAR))
  {
    problem = "the image is empty or not of 8 bits";
  }
  return problem.empty() ? image : nullptr;
}
}

vtkMTModelTextures vtkMTModelTextures::Read(const vtkMTPatchSource& source)
{
  vtkMTModelTextures result;
  const vtkMTGraph& graph = source.GetGraph();
  const std::string coordinates = GetCoordinates(graph);
  for (std::uint32_t i = 0; i < graph.Blobs.size(); ++i)
  {
    const vtkMTBlobInfo& blob = graph.Blobs[i];
    if (Get(blob, "use") != "texture")
    {
      continue;
    }
    Texture texture;
    std::string problem;
    std::vector<unsigned char> bytes;
    if (Get(blob, "coordinates") != coordinates)
    {
      problem = "its coordinates '" + Get(blob, "coordinates") + "' are not the active ones";
    }
    else if (result.Textures.size() == NumberLimit)
    {
      problem = "only " + std::to_string(NumberLimit) + " textures are drawn";
    }
    else if (source.ReadBlob(i, bytes, problem))
    {
      texture.Image = ReadImage(blob.Type, bytes, problem);
    }
    if (!texture.Image)
    {
      result.Problems.push_back(blob.Name + ": " + problem);
      continue;
    }
    texture.Name = "modelTexture" + std::to_string(i);
    texture.Material = GetNumber(blob, "material");
    texture.Part = GetNumber(blob, "part");
    result.Textures.push_back(texture);
  }
  return result;
}

bool vtkMTModelTextures::ReplaceByFile(const std::string& path, std::string& error)
{
  std::ifstream file(path, std::ios::binary);
  const std::vector<unsigned char> bytes{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  const bool isJpeg = bytes.size() > 1 && bytes[0] == 0xff && bytes[1] == 0xd8;
  std::string problem = file ? "" : "cannot be read";
  Texture texture{ "fileTexture", -1, -1, nullptr };
  if (problem.empty())
  {
    texture.Image = ReadImage(isJpeg ? "image/jpeg" : "image/png", bytes, problem);
  }
  error = problem.empty() ? "" : path + ": " + problem;
  if (texture.Image)
  {
    this->Textures = { texture };
    this->Problems.clear();
  }
  return texture.Image != nullptr;
}
