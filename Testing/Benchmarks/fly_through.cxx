// SPDX-License-Identifier: BSD-3-Clause
// A flight past a model, frame by frame: what a frame costs, how much is drawn, held and loaded. The same path can be
// flown with the whole mesh in a vtkPolyDataMapper and in a vtkQuadricLODActor, and pictures can be compared with those
// of the whole mesh. Where the CPU draws and the machine has other work to do, the CPU time of a frame says more than
// its duration. fly_through --help lists the options. Needs a display: CMake/with-display fly_through ...
#include "FlightPath.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkMTFileSource.h"
#include "vtkMTGraph.h"
#include "vtkMTTargetCut.h"
#include "vtkMultiTriangulation.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkQuadricLODActor.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

namespace
{
using Json = nlohmann::ordered_json;

struct Options
{
  std::string Model;
  std::array<int, 2> Size{ 1920, 1080 };
  int Frames = 240;
  double PixelError = 1.0;
  std::string Error = "distance";
  double PatchMegabytes = 90.0;
  double GraphicsMegabytes = 512.0;
  std::int64_t Budget = 0;
  double Rate = 0.0;
  std::vector<std::string> Who{ "mapper" };
  int Stride = 20;
  std::string PathFile;
  std::string PathOutput;
  std::string Csv;
  std::string Output;
  std::string Strip;
  bool Moving = false;
  bool Compare = false;
};

// One row of the table; a frame of one of the three.
struct Row
{
  std::string Who;
  int Frame = 0;
  std::string Part;
  double FrameSeconds = 0.0;
  double CpuSeconds = 0.0;    // of all threads of the process during the frame
  double MapperSeconds = 0.0; // until the mapper has given OpenGL its last command
  double CutSeconds = 0.0;
  double OverheadSeconds = 0.0; // of MapperSeconds, outside draw calls
  std::int64_t Triangles = 0;
  std::int64_t Finest = 0; // of them, of full resolution
  std::int64_t Patches = 0;
  std::int64_t Culled = 0;
  double PixelError = 0.0;
  std::int64_t PatchBytes = 0;
  std::int64_t GraphicsBytes = 0;
  std::int64_t ProcessBytes = 0;
  std::int64_t Loads = 0;
  std::int64_t UploadedBytes = 0;
  std::int64_t MostPatchBytes = 0; // so far, with what was under way
  double LongestLock = 0.0;        // seconds, so far, that a frame spent on the loader's lock
  bool Loading = false;            // the picture is not yet what the view asks for
  bool Stall = false;              // took more than three times as long as the median frame
};

std::int64_t GetProcessBytes()
{
  std::ifstream file("/proc/self/statm");
  std::int64_t total = 0;
  std::int64_t resident = 0;
  file >> total >> resident;
  return resident * sysconf(_SC_PAGESIZE);
}

double GetCpuSeconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double GetQuantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[at];
}

struct Window
{
  explicit Window(const Options& options)
  {
    this->Scene->SetOffScreenRendering(1);
    this->Scene->SetMultiSamples(0);
    this->Scene->SetSize(options.Size[0], options.Size[1]);
    this->Scene->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
  }

  Row Draw()
  {
    Row row;
    const double cpu = GetCpuSeconds();
    const auto start = std::chrono::steady_clock::now();
    this->Scene->Render();
    this->Scene->WaitForCompletion();
    row.FrameSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    row.CpuSeconds = GetCpuSeconds() - cpu;
    row.ProcessBytes = GetProcessBytes();
    return row;
  }

  vtkSmartPointer<vtkUnsignedCharArray> GetPicture()
  {
    const int* size = this->Scene->GetSize();
    auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
    this->Scene->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
    return pixels;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Scene;
};

const std::map<std::string, int> Metrics{ { "distance", vtkMultiTriangulationMapper::DISTANCE },
  { "edges", vtkMultiTriangulationMapper::EDGE_LENGTH }, { "normals", vtkMultiTriangulationMapper::NORMAL_DEVIATION } };

vtkSmartPointer<vtkMultiTriangulationMapper> MakeMapper(vtkMultiTriangulation* model, const Options& options)
{
  auto mapper = vtkSmartPointer<vtkMultiTriangulationMapper>::New();
  mapper->SetInputData(model);
  mapper->ScalarVisibilityOff();
  mapper->SetPixelError(options.PixelError);
  mapper->SetErrorMetric(Metrics.at(options.Error));
  mapper->SetPatchMemoryLimit(static_cast<vtkIdType>(options.PatchMegabytes * 1e6));
  mapper->SetGraphicsMemoryLimit(static_cast<vtkIdType>(options.GraphicsMegabytes * 1e6));
  mapper->SetTriangleLimit(options.Budget);
  mapper->SetWaitForConvergence(
    options.Moving ? vtkMultiTriangulationMapper::WAIT_NEVER : vtkMultiTriangulationMapper::WAIT_ALWAYS);
  return mapper;
}

// Every triangle of the finest level.
vtkSmartPointer<vtkPolyData> MakeMesh(const vtkMTPatchSource& source, std::string& error)
{
  vtkMTCut cut(source.GetGraph());
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  if (!vtkMTTargetCut::ByLevel(source.GetGraph(), 0, cut, error) ||
    !vtkMultiTriangulation::CutToPolyData(source, cut, mesh, error))
  {
    return nullptr;
  }
  return mesh;
}

// A picture of each part of the flight, side by side and small.
class FilmStrip
{
public:
  static constexpr int Width = 240;
  static constexpr int Height = 135;

  explicit FilmStrip(int frames)
  {
    for (const double time : { 0.0, 0.36, 0.60, 0.73, 0.90 })
    {
      this->Wanted.push_back(static_cast<int>(time * (frames - 1)));
    }
    this->Image->SetDimensions(static_cast<int>(this->Wanted.size()) * Width, Height, 1);
    this->Image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  }

  void Take(int frame, Window& window)
  {
    for (std::size_t i = 0; i < this->Wanted.size(); ++i)
    {
      if (this->Wanted[i] == frame)
      {
        this->Put(static_cast<int>(i) * Width, window.GetPicture(), window.Scene->GetSize());
      }
    }
  }

  void Write(const std::string& file)
  {
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(this->Image);
    writer->SetCompressionLevel(9);
    writer->SetFileName(file.c_str());
    writer->Write();
  }

private:
  void Put(int left, vtkUnsignedCharArray* pixels, const int size[2])
  {
    for (int y = 0; y < Height; ++y)
    {
      for (int x = 0; x < Width; ++x)
      {
        const std::array<int, 4> box{ x * size[0] / Width, std::max((x + 1) * size[0] / Width, x * size[0] / Width + 1),
          y * size[1] / Height, std::max((y + 1) * size[1] / Height, y * size[1] / Height + 1) };
        auto* to = static_cast<unsigned char*>(this->Image->GetScalarPointer(left + x, y, 0));
        for (int c = 0; c < 3; ++c)
        {
          to[c] = FilmStrip::GetMean(pixels, box, c, size[0]);
        }
      }
    }
  }

  static unsigned char GetMean(vtkUnsignedCharArray* pixels, const std::array<int, 4>& box, int component, int width)
  {
    int sum = 0;
    for (int j = box[2]; j < box[3]; ++j)
    {
      for (int i = box[0]; i < box[1]; ++i)
      {
        sum += pixels->GetTypedComponent(vtkIdType(j) * width + i, component);
      }
    }
    return static_cast<unsigned char>(sum / ((box[1] - box[0]) * (box[3] - box[2])));
  }

  std::vector<int> Wanted; // frames
  vtkNew<vtkImageData> Image;
};

std::int64_t CountFinest(const vtkMTGraph& graph, const std::vector<std::uint32_t>& arcs)
{
  std::int64_t triangles = 0;
  for (const std::uint32_t arc : arcs)
  {
    triangles += graph.Arcs[arc].To == graph.GetSink() ? graph.Arcs[arc].Triangles : 0;
  }
  return triangles;
}

std::vector<Row> FlyMapper(vtkMultiTriangulation* model, const FlightPath& path, const Options& options)
{
  Window window(options);
  const auto mapper = MakeMapper(model, options);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  window.Renderer->AddActor(actor);
  if (options.Rate > 0.0)
  {
    window.Scene->SetDesiredUpdateRate(options.Rate);
  }
  FilmStrip strip(path.GetNumberOfFrames());
  std::vector<Row> rows;
  for (int frame = 0; frame < path.GetNumberOfFrames(); ++frame)
  {
    path.Apply(frame, window.Renderer);
    const vtkIdType reads = mapper->GetNumberOfReads();
    const vtkIdType uploaded = mapper->GetNumberOfUploadedBytes();
    Row row = window.Draw();
    row.Who = "mapper";
    row.Frame = frame;
    row.MapperSeconds = mapper->GetFrameTime();
    row.CutSeconds = mapper->GetCutTime();
    row.OverheadSeconds = mapper->GetOverheadTime();
    row.Finest = CountFinest(model->GetSource()->GetGraph(), mapper->GetDrawnArcs());
    row.Triangles = mapper->GetNumberOfTriangles();
    row.Patches = mapper->GetNumberOfPatches();
    row.Culled = mapper->GetNumberOfCulledPatches();
    row.PixelError = mapper->GetAchievedPixelError();
    row.PatchBytes = mapper->GetPatchMemory();
    row.GraphicsBytes = mapper->GetGraphicsMemory();
    row.Loads = mapper->GetNumberOfReads() - reads;
    row.UploadedBytes = mapper->GetNumberOfUploadedBytes() - uploaded;
    row.MostPatchBytes = mapper->GetMostPatchMemory();
    row.LongestLock = mapper->GetLongestLock();
    row.Loading = mapper->GetLoading();
    rows.push_back(row);
    if (!options.Strip.empty())
    {
      strip.Take(frame, window);
    }
  }
  if (!options.Strip.empty())
  {
    strip.Write(options.Strip);
  }
  return rows;
}

std::vector<Row> FlyMesh(
  const std::string& who, vtkActor* actor, vtkIdType triangles, const FlightPath& path, const Options& options)
{
  Window window(options);
  window.Renderer->AddActor(actor);
  vtkNew<vtkRenderWindowInteractor> interactor; // vtkQuadricLODActor asks it
  interactor->SetRenderWindow(window.Scene);
  window.Scene->SetDesiredUpdateRate(options.Rate > 0.0 ? options.Rate : 15.0);
  path.Apply(0, window.Renderer);
  window.Draw(); // uploads, and builds the coarse mesh
  std::vector<Row> rows;
  for (int frame = 0; frame < path.GetNumberOfFrames(); frame += options.Stride)
  {
    path.Apply(frame, window.Renderer);
    Row row = window.Draw();
    row.Who = who;
    row.Frame = frame;
    row.Triangles = triangles;
    rows.push_back(row);
  }
  window.Scene->SetInteractor(nullptr);
  return rows;
}

std::vector<Row> Fly(
  const std::string& who, vtkMultiTriangulation* model, const FlightPath& path, const Options& options)
{
  if (who == "mapper")
  {
    return FlyMapper(model, path, options);
  }
  std::string error;
  const auto mesh = MakeMesh(*model->GetSource(), error);
  if (!mesh)
  {
    std::cerr << error << "\n";
    return {};
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  mapper->ScalarVisibilityOff();
  vtkSmartPointer<vtkActor> actor;
  if (who == "lod")
  {
    actor = vtkSmartPointer<vtkQuadricLODActor>::New();
  }
  else
  {
    actor = vtkSmartPointer<vtkActor>::New();
  }
  actor->SetMapper(mapper);
  return FlyMesh(who, actor, who == "lod" ? 0 : mesh->GetNumberOfCells(), path, options);
}

Json Summarise(const std::string& who, std::vector<Row>& rows)
{
  const auto collect = [&rows](auto get)
  {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const Row& row : rows)
    {
      values.push_back(static_cast<double>(get(row)));
    }
    return values;
  };
  const std::vector<double> times = collect([](const Row& row) { return 1e3 * row.FrameSeconds; });
  const double median = GetQuantile(times, 0.5);
  for (Row& row : rows)
  {
    row.Stall = 1e3 * row.FrameSeconds > 3.0 * median;
  }
  Json json;
  json["who"] = who;
  json["frames"] = rows.size();
  json["frame_ms_median"] = median;
  json["frame_ms_95"] = GetQuantile(times, 0.95);
  json["frame_ms_worst"] = GetQuantile(times, 1.0);
  json["cpu_ms_median"] = GetQuantile(collect([](const Row& row) { return 1e3 * row.CpuSeconds; }), 0.5);
  json["stalls"] = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.Stall; });
  json["triangles_median"] = GetQuantile(collect([](const Row& row) { return row.Triangles; }), 0.5);
  json["triangles_most"] = GetQuantile(collect([](const Row& row) { return row.Triangles; }), 1.0);
  if (who == "mapper")
  {
    json["cut_ms_median"] = GetQuantile(collect([](const Row& row) { return 1e3 * row.CutSeconds; }), 0.5);
    json["cut_ms_worst"] = GetQuantile(collect([](const Row& row) { return 1e3 * row.CutSeconds; }), 1.0);
    json["overhead_ms_median"] = GetQuantile(collect([](const Row& row) { return 1e3 * row.OverheadSeconds; }), 0.5);
    json["finest_triangles_most"] = GetQuantile(collect([](const Row& row) { return row.Finest; }), 1.0);
    json["patch_megabytes_most"] = GetQuantile(collect([](const Row& row) { return 1e-6 * row.PatchBytes; }), 1.0);
    json["gpu_megabytes_most"] = GetQuantile(collect([](const Row& row) { return 1e-6 * row.GraphicsBytes; }), 1.0);
    json["patch_megabytes_with_those_under_way_most"] = 1e-6 * rows.back().MostPatchBytes;
    json["longest_lock_ms"] = 1e3 * rows.back().LongestLock;
    json["frames_still_loading"] = std::count_if(rows.begin(), rows.end(), [](const Row& row) { return row.Loading; });
    const std::vector<double> loads = collect([](const Row& row) { return row.Loads; });
    double all = 0.0;
    for (const double one : loads)
    {
      all += one;
    }
    json["loads"] = all;
    json["loads_in_a_frame_most"] = GetQuantile(loads, 1.0);
    json["uploaded_megabytes_in_a_frame_most"] =
      GetQuantile(collect([](const Row& row) { return 1e-6 * row.UploadedBytes; }), 1.0);
  }
  json["process_megabytes_most"] = GetQuantile(collect([](const Row& row) { return 1e-6 * row.ProcessBytes; }), 1.0);
  return json;
}

void WriteCsv(const std::string& file, const std::vector<Row>& rows)
{
  std::ofstream out(file);
  out << "who,frame,part,frame_ms,cpu_ms,mapper_ms,cut_ms,triangles,patches,culled,pixel_error,patch_bytes,gpu_bytes,"
         "process_bytes,loads,"
         "uploaded_bytes,stall\n";
  for (const Row& row : rows)
  {
    out << row.Who << ',' << row.Frame << ',' << row.Part << ',' << 1e3 * row.FrameSeconds << ','
        << 1e3 * row.CpuSeconds << ',' << 1e3 * row.MapperSeconds << ',' << 1e3 * row.CutSeconds << ',' << row.Triangles
        << ',' << row.Patches << ',' << row.Culled << ',' << row.PixelError << ',' << row.PatchBytes << ','
        << row.GraphicsBytes << ',' << row.ProcessBytes << ',' << row.Loads << ',' << row.UploadedBytes << ','
        << row.Stall << '\n';
  }
}

struct Difference
{
  std::int64_t Drawn = 0; // pixels that are not background in either picture
  std::int64_t Off = 0;   // that differ by more than 8 of 255
  double Squares = 0.0;
  int Largest = 0;

  void Add(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
  {
    for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
    {
      int largest = 0;
      bool background = true;
      for (int c = 0; c < 3; ++c)
      {
        const int x = a->GetTypedComponent(i, c);
        const int y = b->GetTypedComponent(i, c);
        largest = std::max(largest, std::abs(x - y));
        background = background && x == 255 && y == 255;
      }
      this->Drawn += !background;
      this->Off += largest > 8;
      this->Squares += static_cast<double>(largest) * largest;
      this->Largest = std::max(this->Largest, largest);
    }
  }
};

// Pictures of cuts beside those of the whole mesh, at six places of the path.
Json Compare(vtkMultiTriangulation* model, const FlightPath& path, Options options)
{
  constexpr int Places = 6;
  std::string error;
  const auto mesh = MakeMesh(*model->GetSource(), error);
  if (!mesh)
  {
    std::cerr << error << "\n";
    return {};
  }
  const auto getFrame = [&path](int place) { return (2 * place + 1) * (path.GetNumberOfFrames() - 1) / (2 * Places); };
  std::vector<vtkSmartPointer<vtkUnsignedCharArray>> wanted;
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    Window window(options);
    window.Renderer->AddActor(actor);
    for (int place = 0; place < Places; ++place)
    {
      path.Apply(getFrame(place), window.Renderer);
      window.Draw();
      wanted.push_back(window.GetPicture());
    }
  }
  Json rows;
  for (const char* choice : { "distance", "edges", "normals" })
  {
    for (const double pixels : { 0.5, 1.0, 2.0, 4.0 })
    {
      options.Error = choice;
      options.PixelError = pixels;
      const auto mapper = MakeMapper(model, options);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      Window window(options);
      window.Renderer->AddActor(actor);
      Difference difference;
      std::int64_t triangles = 0;
      double certified = 0.0;
      for (int place = 0; place < Places; ++place)
      {
        path.Apply(getFrame(place), window.Renderer);
        window.Draw();
        difference.Add(window.GetPicture(), wanted[place]);
        triangles += mapper->GetNumberOfTriangles();
        certified = std::max(certified, mapper->GetAchievedPixelError());
      }
      const auto drawn = static_cast<double>(std::max<std::int64_t>(difference.Drawn, 1));
      Json row;
      row["error_choice"] = choice;
      row["pixel_error"] = pixels;
      row["triangles_mean"] = triangles / Places;
      row["rms_of_255"] = std::sqrt(difference.Squares / drawn);
      row["share_off_by_more_than_8"] = static_cast<double>(difference.Off) / drawn;
      row["largest"] = difference.Largest;
      row["certified_pixels_most"] = certified;
      std::cout << row.dump() << std::endl;
      rows.push_back(row);
    }
  }
  return rows;
}

void AddOptions(CLI::App& app, Options& options)
{
  app.add_option("model", options.Model, "The Multi-Triangulation file")->required();
  app.add_option("--size", options.Size, "Of the picture, in pixels; 1920 1080");
  app.add_option("--frames", options.Frames, "Of the path that is made for the model; 240")
    ->check(CLI::Range(2, 100000));
  app.add_option("--pixel-error", options.PixelError, "1");
  app.add_option("--error", options.Error, "distance, edges (mean edge length) or normals (normal deviation)")
    ->check(CLI::IsMember(Metrics));
  app.add_option("--memory", options.PatchMegabytes, "Megabytes for patches in main memory; 90");
  app.add_option("--gpu-memory", options.GraphicsMegabytes, "Megabytes for patches on the GPU; 512");
  app.add_option("--budget", options.Budget, "Triangles in a frame at most; 0: no limit");
  app.add_option("--rate", options.Rate, "Frames per second that the window asks for; 0: as many as there are");
  app
    .add_option(
      "--who", options.Who, "Who flies: mapper, full (vtkPolyDataMapper), lod (vtkQuadricLODActor); several may")
    ->check(CLI::IsMember({ "mapper", "full", "lod" }));
  app.add_option("--stride", options.Stride, "full and lod draw every so many frames; 20")
    ->check(CLI::Range(1, 100000));
  app.add_option("--path", options.PathFile, "A recorded path in place of the one made: nine numbers per frame");
  app.add_option("--write-path", options.PathOutput, "Where to write the path");
  app.add_option("--csv", options.Csv, "Where to write the figures of each frame");
  app.add_option("--json", options.Output, "Where to write the summary");
  app.add_option("--strip", options.Strip, "Where to write a picture of each part of the flight, as one PNG");
  app.add_flag("--moving", options.Moving, "Frames do not wait for patches, as while a user moves the camera");
  app.add_flag(
    "--compare", options.Compare, "Compare pictures at 0.5, 1, 2 and 4 pixels of each error with the whole mesh");
}

bool MakePath(vtkMultiTriangulation* model, const Options& options, FlightPath& path, std::string& error)
{
  if (!options.PathFile.empty())
  {
    return path.Read(options.PathFile, error);
  }
  double bounds[6];
  model->GetSource()->GetGraph().GetBounds(bounds);
  path = FlightPath::Make(bounds, model, options.Frames);
  return options.PathOutput.empty() || path.Write(options.PathOutput, error);
}

int Run(const Options& options)
{
  std::string error;
  const auto source = std::make_shared<vtkMTFileSource>();
  vtkNew<vtkMultiTriangulation> model;
  FlightPath path;
  if (!source->Open(options.Model, error) || !model->SetSource(source) || !MakePath(model, options, path, error))
  {
    std::cerr << options.Model << ": " << error << "\n";
    return 1;
  }
  Json summary;
  summary["triangles"] = source->GetGraph().GetNumberOfFinestTriangles();
  summary["size"] = options.Size;
  summary["pixel_error"] = options.PixelError;
  summary["error_choice"] = options.Error;
  summary["patch_megabytes_limit"] = options.PatchMegabytes;
  if (options.Compare)
  {
    summary["pictures"] = Compare(model, path, options);
  }
  else
  {
    std::vector<Row> all;
    for (const std::string& who : options.Who)
    {
      std::vector<Row> rows = Fly(who, model, path, options);
      for (Row& row : rows)
      {
        row.Part = path.GetPart(row.Frame);
      }
      const Json one = Summarise(who, rows);
      std::cout << one.dump(2) << std::endl;
      summary["flights"].push_back(one);
      all.insert(all.end(), rows.begin(), rows.end());
    }
    if (!options.Csv.empty())
    {
      WriteCsv(options.Csv, all);
    }
  }
  if (!options.Output.empty())
  {
    std::ofstream(options.Output) << summary.dump(2) << "\n";
  }
  return 0;
}
}

int main(int argc, char** argv)
{
  try
  {
    Options options;
    CLI::App app("A flight past a model: what its frames cost");
    AddOptions(app, options);
    CLI11_PARSE(app, argc, argv);
    return Run(options);
  }
  catch (const std::exception& exception)
  {
    std::fprintf(stderr, "%s\n", exception.what());
    return 1;
  }
}
