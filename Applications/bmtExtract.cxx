// SPDX-License-Identifier: BSD-3-Clause
#include "bmtCommon.h"
#include "bmtModel.h"

#include "vtkMTGraph.h"
#include "vtkMTOutputFile.h"
#include "vtkMTPatchSource.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationCutFilter.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

namespace
{
struct ExtractOptions
{
  std::string File;
  std::string Output;
  std::string BlobFolder;
  std::uint64_t Triangles = 0;
  double Error = -1.0;
  std::uint32_t Level = 0;
  CLI::Option* HasTriangles = nullptr;
  CLI::Option* HasError = nullptr;
  CLI::Option* HasLevel = nullptr;
};

// What VTK reports goes into the one message of the command.
class ErrorText
{
public:
  explicit ErrorText(vtkObject* object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<ErrorText*>(self)->Text = static_cast<const char*>(text); });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  std::string Text;

private:
  vtkNew<vtkCallbackCommand> Command;
};

void ChooseCut(const ExtractOptions& options, vtkMultiTriangulationCutFilter* filter)
{
  if (options.HasTriangles->count() > 0)
  {
    filter->SetTriangleLimit(static_cast<vtkIdType>(std::min<std::uint64_t>(options.Triangles, VTK_ID_MAX)));
  }
  else if (options.HasError->count() > 0)
  {
    filter->SetError(options.Error);
  }
  else
  {
    filter->SetLevel(static_cast<int>(std::min<std::uint32_t>(options.Level, VTK_INT_MAX)));
  }
}

bmtJson DescribeCut(vtkMultiTriangulationCutFilter* filter)
{
  bmtJson json;
  json["triangles"] = filter->GetNumberOfTriangles();
  json["patches"] = filter->GetNumberOfPatches();
  json["error"] = filter->GetCutError();
  json["exact"] = filter->GetExact();
  json["finest_level"] = filter->GetFinestLevel();
  json["coarsest_level"] = filter->GetCoarsestLevel();
  return json;
}

// Names come from the input, of which nothing is known: what is left is one that can only be in the folder.
std::string MakeFileName(const std::string& blob, std::set<std::string>& taken)
{
  constexpr std::size_t longest = 200;
  const std::size_t slash = blob.find_last_of("/\\");
  std::string name = slash == std::string::npos ? blob : blob.substr(slash + 1);
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127 || c == ':'; }, '_');
  name = name.substr(name.size() > longest ? name.size() - longest : 0);
  const bool isName = name.find_first_not_of('.') != std::string::npos;
  name = isName && name[0] != '.' ? name : "blob" + name;
  const std::filesystem::path path(name);
  for (int i = 2; !taken.insert(name).second; ++i)
  {
    name = path.stem().string() + "-" + std::to_string(i) + path.extension().string();
  }
  return name;
}

bmtJson ExtractBlobs(const vtkMTPatchSource& source, const std::string& folder)
{
  std::error_code code;
  if (!std::filesystem::is_directory(folder, code))
  {
    throw bmtError(folder + ": is no folder; make it first");
  }
  bmtJson list = bmtJson::array();
  std::set<std::string> taken;
  for (std::uint32_t i = 0; i < source.GetGraph().Blobs.size(); ++i)
  {
    const vtkMTBlobInfo& blob = source.GetGraph().Blobs[i];
    std::vector<unsigned char> bytes;
    std::string error;
    if (!source.ReadBlob(i, bytes, error))
    {
      throw bmtError(error);
    }
    vtkMTOutputFile file;
    const std::string path = (std::filesystem::path(folder) / MakeFileName(blob.Name, taken)).string();
    if (!file.Open(path) || !file.Write(bytes.data(), bytes.size()) || !file.Commit())
    {
      throw bmtError(file.GetError());
    }
    bmtJson entry;
    entry["name"] = blob.Name;
    entry["file"] = path;
    entry["type"] = blob.Type;
    entry["bytes"] = bytes.size();
    entry.update(bmtJson(blob.Properties));
    list.push_back(entry);
  }
  return list;
}

bmtJson ExtractCut(const ExtractOptions& options, const std::shared_ptr<const vtkMTPatchSource>& source)
{
  bmtRequireWritable(options.Output);
  bmtRequireMeshEnding(options.Output);
  vtkNew<vtkMultiTriangulation> model;
  const ErrorText modelErrors(model);
  if (!model->SetSource(source))
  {
    throw bmtError(options.File + ": " + bmtGetEssence(modelErrors.Text));
  }
  vtkNew<vtkMultiTriangulationCutFilter> filter;
  const ErrorText filterErrors(filter);
  const ErrorText pipelineErrors(filter->GetExecutive());
  filter->SetInputData(model);
  ChooseCut(options, filter);
  bmtProgress progress("extracting");
  bmtFollow(filter, progress);
  filter->Update();
  bmtThrowIfInterrupted();
  if (filter->GetErrorCode() != vtkErrorCode::NoError)
  {
    const std::string message = filter->GetErrorMessage();
    const bool namesFile = message.compare(0, options.File.size(), options.File) == 0;
    throw bmtError((namesFile ? "" : options.File + ": ") + message);
  }
  vtkPolyData* mesh = filter->GetOutput();
  const std::vector<std::string> dropped = bmtWriteMesh(options.Output, mesh);
  bmtJson result;
  result["output"] = options.Output;
  result.update(DescribeCut(filter));
  result["points"] = mesh->GetNumberOfPoints();
  result["dropped_arrays"] = dropped;
  return result;
}

bool HasCut(const ExtractOptions& options)
{
  return options.HasTriangles->count() + options.HasError->count() + options.HasLevel->count() > 0;
}

// A cut and the mesh to write it to go together; textures may be all that is wanted.
void CheckUsage(const ExtractOptions& options)
{
  const bool hasCut = HasCut(options);
  if (hasCut && options.Output.empty())
  {
    throw CLI::ValidationError("extract", "-o is missing, which names the mesh to write");
  }
  if (!hasCut && (!options.Output.empty() || options.BlobFolder.empty()))
  {
    throw CLI::ValidationError(
      "extract", "one of --triangles, --error and --level is missing, which say what to write");
  }
}

bmtJson Extract(const ExtractOptions& options)
{
  const bool hasCut = HasCut(options);
  const double start = bmtWallSeconds();
  const std::shared_ptr<const vtkMTPatchSource> source = bmtOpenModel(options.File);
  bmtJson result = bmtJson::object();
  if (hasCut)
  {
    result = ExtractCut(options, source);
  }
  if (!options.BlobFolder.empty())
  {
    result["blobs"] = ExtractBlobs(*source, options.BlobFolder);
  }
  result["seconds"] = bmtWallSeconds() - start;
  return result;
}
}

void bmtAddExtract(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<ExtractOptions>();
  CLI::App* command = app.add_subcommand("extract", "Write one cut as a conforming, welded mesh");
  command->footer(
    "A point appears more than once only where its attribute values differ (wedges). Where N is 50 mean patches or\n"
    "more, at least 90 % of N are used; N below the coarsest cut is an error. dropped_arrays names the arrays that "
    "the\n"
    "format has no form for. Level 0 of a model that was built with --exact is the input bit for bit.");
  bmtAddModelArgument(*command, options->File);
  command->add_option("-o,--output", options->Output, "The mesh to write: .ply, .stl, .obj, .vtp, .gltf or .glb");
  command->add_option("--blobs", options->BlobFolder,
    "Write what the model carries besides, such as textures, into this folder, under the names that the input gave");
  CLI::Option_group* which = command->add_option_group("which cut", "One of these, with -o");
  options->HasTriangles =
    which->add_option("--triangles", options->Triangles, "The most precise cut of at most N triangles");
  options->HasError = which
                        ->add_option("--error", options->Error,
                          "The coarsest cut that is certified to be within E model units of the input")
                        ->check(CLI::NonNegativeNumber);
  options->HasLevel = which->add_option("--level", options->Level, "The cut of one level; 0 is the finest");
  which->require_option(0, 1);
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      CheckUsage(*options);
      context.Run = [options, &context]
      {
        bmtPrint(context, Extract(*options));
        return bmtExit::Success;
      };
    });
}
