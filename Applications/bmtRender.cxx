// SPDX-License-Identifier: BSD-3-Clause
#include "bmtModel.h"
#include "bmtScene.h"

#include "vtkMTScreenshot.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace
{
struct RenderOptions : bmtSceneOptions
{
  std::string File;
  std::string Output;
};

double RenderOnce(bmtScene& scene)
{
  const double start = bmtWallSeconds();
  scene.Window->Render();
  scene.Window->WaitForCompletion();
  return 1e3 * (bmtWallSeconds() - start);
}

bmtJson RenderPicture(const RenderOptions& options)
{
  bmtScene scene(options);
  scene.ShowModel(scene.Models->AddItem(), options.File);
  scene.RequireColors(options.ColorBy);
  bmtRequireWritable(options.Output);
  scene.RequireDisplay();
  scene.Window->OffScreenRenderingOn();
  const double first = RenderOnce(scene); // reads and uploads patches, compiles shaders
  bmtThrowIfInterrupted();
  const double second = RenderOnce(scene);
  bmtThrowIfInterrupted();
  if (std::string error; !vtkMTScreenshot::Write(scene.Window, options.Output, error))
  {
    throw bmtError(error);
  }
  bmtJson result;
  result["output"] = options.Output;
  result["width"] = options.Size[0];
  result["height"] = options.Size[1];
  result.update(scene.DescribeFrame());
  result["frame_ms"] = second;
  result["first_frame_ms"] = first;
  return result;
}
}

void bmtAddRender(CLI::App& app, bmtContext& context)
{
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Draw a picture of a Multi-Triangulation into a PNG file");
  command->footer(
    "pixel_error is certified: nothing in the picture is farther, in pixels, from where the input would put it. "
    "frame_ms is the time of\n"
    "a frame when everything is loaded, first_frame_ms that of the first one. Needs a display; without a screen:\n"
    "  xvfb-run -a -s \"-screen 0 1280x1024x24 -noreset\" bmt render ...");
  bmtAddModelArgument(*command, options->File);
  bmtAddSceneOptions(*command, *options);
  command->add_option("-o,--output", options->Output, "The picture to write (.png)")->required();
  bmtAddCommonOptions(*command, context);
  command->callback(
    [options, &context]
    {
      context.Run = [options, &context]
      {
        bmtPrint(context, RenderPicture(*options));
        return bmtExit::Success;
      };
    });
}
