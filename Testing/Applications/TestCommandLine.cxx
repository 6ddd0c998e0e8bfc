// SPDX-License-Identifier: BSD-3-Clause
// What the command line promises whatever the command: help, messages, exit codes, JSON, and outputs that are whole or
// untouched.
#include "MTRunBmt.h"

#include <string>
#include <vector>

namespace
{
const std::vector<std::string> Commands = { "generate", "build", "info", "verify", "extract", "compare", "render",
  "view" };

// The commands that read a file, as they are called for that file.
std::vector<std::vector<std::string>> CallsThatRead(const std::string& file, const std::string& output)
{
  return {
    { "build", file, "-o", output },
    { "info", file },
    { "verify", file },
    { "extract", file, "-o", output + ".ply", "--level", "0" },
    { "compare", file, file },
    { "render", file, "-o", output + ".png" },
  };
}

const std::string DegeneratePly =
  "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
  "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
  "0 0 0\n1 0 0\n2 0 0\n3 0 0 1\n";
}

class CommandLine : public MTBmtTest
{
protected:
  // Exit code 1, nothing on standard output, and a message that names the file.
  void ExpectFailure(const MTRun& run, const std::string& what, const std::string& mentions) const
  {
    EXPECT_EQ(run.Exit, 1) << what << ": " << run.Err;
    EXPECT_EQ(run.Out, "") << what;
    EXPECT_EQ(run.Err.rfind("bmt: ", 0), 0u) << what << ": " << run.Err;
    EXPECT_NE(run.Err.find(mentions), std::string::npos) << what << ": " << run.Err;
  }
};

TEST_F(CommandLine, HelpNamesEveryCommandAndEachHasItsOwn)
{
  const MTRun run = this->Bmt({ "--help" });
  EXPECT_EQ(run.Exit, 0);
  EXPECT_EQ(run.Err, "");
  for (const std::string& command : Commands)
  {
    EXPECT_NE(run.Out.find("  " + command), std::string::npos) << command;
    const MTRun own = this->Bmt({ command, "--help" });
    EXPECT_EQ(own.Exit, 0) << command;
    EXPECT_NE(own.Out.find("--json"), std::string::npos) << own.Out;
    EXPECT_EQ(own.Err, "");
  }
}

TEST_F(CommandLine, VersionIsPrinted)
{
  const MTRun run = this->Bmt({ "--version" });
  EXPECT_EQ(run.Exit, 0);
  EXPECT_EQ(run.Out.rfind("bmt ", 0), 0u) << run.Out;
}

TEST_F(CommandLine, WrongUsageHasExitCode2AndAMessage)
{
  const std::vector<std::vector<std::string>> wrong = {
    {},
    { "paint" },
    { "info" },
    { "info", "--depth", "3", "x.bmt" },
    { "build", "x.ply" },
    { "build", "x.ply", "-o", "x.bmt", "--simplifier", "none" },
    { "build", "x.ply", "-o", "x.bmt", "--partition", "bsp" },
    { "build", "x.ply", "-o", "x.bmt", "--threads", "many" },
    { "build", "x.ply", "-o", "x.bmt", "--patch-triangles", "0" },
    { "generate", "cube", "--triangles", "10", "-o", "x.ply" },
    { "generate", "plane", "--triangles", "-5", "-o", "x.ply" },
    { "extract", "x.bmt", "-o", "x.ply" },
    { "extract", "x.bmt", "-o", "x.ply", "--level", "0", "--triangles", "10" },
    { "extract", "x.bmt", "-o", "x.ply", "--error", "-1" },
    { "compare", "a.ply", "b.ply", "--samples", "0" },
    { "render", "x.bmt", "-o", "x.png", "--size", "12" },
    { "render", "x.bmt", "-o", "x.png", "--camera", "1,2,3" },
  };
  for (const std::vector<std::string>& arguments : wrong)
  {
    const MTRun run = this->Bmt(arguments);
    const std::string what = testing::PrintToString(arguments);
    EXPECT_EQ(run.Exit, 2) << what << run.Err;
    EXPECT_EQ(run.Out, "") << what;
    EXPECT_EQ(run.Err.rfind("bmt: ", 0), 0u) << what << run.Err;
  }
}

TEST_F(CommandLine, MissingFilesAreNamed)
{
  const std::string missing = this->Path("no-such-file.bmt");
  for (const std::vector<std::string>& call : CallsThatRead(missing, this->Path("out")))
  {
    this->ExpectFailure(this->Bmt(call), call.front(), missing);
  }
  EXPECT_TRUE(this->List().empty()) << testing::PrintToString(this->List());
}

TEST_F(CommandLine, EmptyAndGarbageFilesAreRefused)
{
  std::string noise;
  for (unsigned i = 0; i < 5000; ++i)
  {
    noise.push_back(static_cast<char>((i * 2654435761u) >> 13));
  }
  for (const std::string name : { "empty.ply", "empty.stl", "empty.obj", "empty.bmt", "noise.ply", "noise.stl",
         "noise.obj", "noise.vtp", "noise.vtk", "noise.glb", "noise.bmt", "noise.what" })
  {
    this->WriteFile(name, name[0] == 'e' ? "" : noise);
    for (const std::vector<std::string>& call : CallsThatRead(this->Path(name), this->Path("out")))
    {
      this->ExpectFailure(this->Bmt(call), call.front() + " " + name, name);
    }
    std::filesystem::remove(this->Path(name));
  }
  EXPECT_TRUE(this->List().empty()) << testing::PrintToString(this->List());
}

// Large enough to be streamed: the memory that it claims to need is not requested.
TEST_F(CommandLine, ClaimOfImpossiblyManyPointsIsRefusedForThat)
{
  std::string points;
  for (int i = 0; i < 1000000; ++i)
  {
    points += "0 0 1\n";
  }
  this->WriteFile("boast.vtp",
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>"
    "<Piece NumberOfPoints=\"56464000000000000\" NumberOfPolys=\"1\"><Points>"
    "<DataArray type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">" +
      points +
      "</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>"
      "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">3</DataArray></Polys></Piece></PolyData></VTKFile>");
  this->ExpectFailure(
    this->Bmt({ "build", this->Path("boast.vtp"), "-o", this->Path("out.bmt"), "--memory", "160MiB" }), "build",
    "56464000000000000 points");
}

TEST_F(CommandLine, TruncatedFilesAreRefused)
{
  this->MakeModel(1280, 64);
  const std::string mesh = this->ReadFile("sphere.ply");
  const std::string model = this->ReadFile("sphere.bmt");
  this->WriteFile("cut.ply", mesh.substr(0, mesh.size() / 2));
  this->WriteFile("cut.bmt", model.substr(0, model.size() / 2));
  this->WriteFile("short.bmt", model.substr(0, 40));
  this->ExpectFailure(this->Bmt({ "build", this->Path("cut.ply"), "-o", this->Path("out.bmt") }), "build", "cut.ply");
  this->ExpectFailure(this->Bmt({ "info", this->Path("cut.bmt") }), "info", "cut.bmt");
  this->ExpectFailure(this->Bmt({ "info", this->Path("short.bmt") }), "info", "short.bmt");
  EXPECT_FALSE(std::filesystem::exists(this->Path("out.bmt")));
}

TEST_F(CommandLine, AMeshOfDegenerateTrianglesOnlyIsRefused)
{
  this->WriteFile("degenerate.ply", DegeneratePly);
  this->ExpectFailure(
    this->Bmt({ "build", this->Path("degenerate.ply"), "-o", this->Path("out.bmt") }), "build", "degenerate");
  EXPECT_EQ(this->List(), std::vector<std::string>{ "degenerate.ply" });
}

TEST_F(CommandLine, AnUnwritableOutputIsRefusedBeforeTheWork)
{
  this->MakeModel(1280, 64);
  const std::string nowhere = this->Path("nowhere/out");
  this->ExpectFailure(this->Bmt({ "build", this->Path("sphere.ply"), "-o", nowhere }), "build", nowhere);
  this->ExpectFailure(
    this->Bmt({ "generate", "plane", "--triangles", "10", "-o", nowhere + ".ply" }), "generate", nowhere);
  this->ExpectFailure(
    this->Bmt({ "extract", this->Path("sphere.bmt"), "-o", nowhere + ".ply", "--level", "0" }), "extract", nowhere);
  this->ExpectFailure(this->Bmt({ "extract", this->Path("sphere.bmt"), "-o", this->Path("out.xyz"), "--level", "0" }),
    "extract", "out.xyz");
}

TEST_F(CommandLine, AFailedCommandLeavesAnEarlierOutputUntouched)
{
  this->WriteFile("degenerate.ply", DegeneratePly);
  this->MakeModel(1280, 64);
  for (const std::string name : { "old.bmt", "old.ply" })
  {
    this->WriteFile(name, "what was there before");
  }
  const std::vector<std::string> before = this->List();
  EXPECT_EQ(this->Bmt({ "build", this->Path("degenerate.ply"), "-o", this->Path("old.bmt") }).Exit, 1);
  EXPECT_EQ(
    this->Bmt({ "extract", this->Path("sphere.bmt"), "-o", this->Path("old.ply"), "--triangles", "1" }).Exit, 1);
  EXPECT_EQ(this->ReadFile("old.bmt"), "what was there before");
  EXPECT_EQ(this->ReadFile("old.ply"), "what was there before");
  EXPECT_EQ(this->List(), before) << "something was left behind";
}

TEST_F(CommandLine, JsonIsOneObjectAloneOnStandardOutput)
{
  this->MakeModel(1280, 64);
  const std::string mesh = this->Path("sphere.ply");
  const std::string model = this->Path("sphere.bmt");
  const std::vector<std::vector<std::string>> calls = {
    { "generate", "plane", "--triangles", "100", "-o", this->Path("plane.ply"), "--json" },
    { "build", mesh, "-o", this->Path("again.bmt"), "--json" },
    { "info", model, "--json" },
    { "verify", model, "--cuts", "5", "--json" },
    { "extract", model, "-o", this->Path("out.ply"), "--level", "0", "--json" },
    { "compare", mesh, mesh, "--samples", "1000", "--json" },
  };
  for (const std::vector<std::string>& call : calls)
  {
    const MTRun run = this->Bmt(call);
    EXPECT_EQ(run.Exit, 0) << call.front() << ": " << run.Err;
    EXPECT_EQ(run.Err, "") << call.front() << ": progress is for terminals, and there was nothing to complain of";
    EXPECT_FALSE(run.Json().empty()) << call.front();
  }
}

TEST_F(CommandLine, ControlCEndsWithExitCode130AndNoOutput)
{
  this->MakeSphere(327680);
  const std::vector<std::string> before = this->List();
  MTRunOptions options;
  options.InterruptAfterMilliseconds = 1000;
  const std::vector<std::vector<std::string>> calls = {
    { "build", this->Path("sphere.ply"), "-o", this->Path("out.bmt"), "--threads", "1", "--simplifier", "best" },
    { "generate", "fractal-sphere", "--triangles", "300000000", "-o", this->Path("out.ply") },
    { "compare", this->Path("sphere.ply"), this->Path("sphere.ply"), "--samples", "1000000000" },
  };
  for (const std::vector<std::string>& call : calls)
  {
    const MTRun run = this->Bmt(call, options);
    EXPECT_EQ(run.Exit, 130) << call.front() << ": " << run.Out << run.Err;
    EXPECT_EQ(run.Out, "") << call.front();
    EXPECT_NE(run.Err.find("interrupted"), std::string::npos) << run.Err;
    EXPECT_EQ(this->List(), before) << call.front() << " left something behind";
  }
}
