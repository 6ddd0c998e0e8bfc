// SPDX-License-Identifier: BSD-3-Clause
// bmt build of inputs that are streamed gives the bytes that it gives when they are read whole.
#include "MTRunBmt.h"

#include "vtkMTMeshReader.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdio>

class StreamedInput : public MTBmtTest
{
protected:
  // A small limit, in which a few threads have room, makes large files streams; what fits in memory is read otherwise.
  void ExpectSameBytes(const std::string& input, const std::vector<std::string>& options = {}) const
  {
    std::vector<std::string> call{ "build", this->Path(input), "-o", this->Path("whole.bmt"), "--memory", "1000GiB",
      "--threads", "2" };
    call.insert(call.end(), options.begin(), options.end());
    EXPECT_FALSE(this->BmtJson(call)["input_streamed"].get<bool>()) << input;
    call[3] = this->Path("streamed.bmt");
    call[5] = "240MiB";
    const nlohmann::json json = this->BmtJson(call);
    EXPECT_TRUE(json["input_streamed"].get<bool>()) << input;
    EXPECT_TRUE(this->ReadFile("whole.bmt") == this->ReadFile("streamed.bmt")) << input;
    std::printf("%s: %.1f MB, built in %.1f MiB\n", input.c_str(),
      1e-6 * static_cast<double>(std::filesystem::file_size(this->Folder / input)),
      json["peak_memory_bytes"].get<double>() / 1048576.0);
  }

  void ReadSphere(int triangles, vtkPolyData* mesh) const
  {
    this->MakeSphere(triangles);
    std::string error;
    ASSERT_TRUE(vtkMTMeshReader::Read(this->Path("sphere.ply"), mesh, error)) << error;
  }
};

TEST_F(StreamedInput, OfObjWithWedges)
{
  const vtkNew<vtkPolyData> mesh;
  this->ReadSphere(327680, mesh);
  std::string text;
  char line[200];
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double x[3];
    mesh->GetPoint(i, x);
    std::snprintf(line, sizeof(line), "v %.9g %.9g %.9g\nvt %g %g\n", x[0], x[1], x[2], 0.5 + 0.5 * x[0], x[1]);
    text += line;
  }
  for (vtkIdType t = 0; t < mesh->GetNumberOfPolys(); ++t)
  {
    vtkIdType count = 0;
    const vtkIdType* p = nullptr;
    mesh->GetPolys()->GetCellAtId(t, count, p);
    const long long seam = t % 50 == 0 ? 1 : p[0] + 1;
    std::snprintf(line, sizeof(line), "f %lld/%lld %lld/%lld %lld/%lld\n", p[0] + 1LL, seam, p[1] + 1LL, p[1] + 1LL,
      p[2] + 1LL, p[2] + 1LL);
    text += line;
  }
  this->WriteFile("sphere.obj", text);
  this->ExpectSameBytes("sphere.obj");
  this->ExpectSameBytes("sphere.obj", { "--arrays", "TCoords", "--precision", "1e-5" });
}

TEST_F(StreamedInput, OfVtpAndTextOfStl)
{
  const vtkNew<vtkPolyData> mesh;
  this->ReadSphere(327680, mesh);
  const vtkNew<vtkXMLPolyDataWriter> vtp;
  vtp->SetFileName(this->Path("sphere.vtp").c_str());
  vtp->SetInputData(mesh);
  vtp->SetCompressorTypeToNone();
  vtp->SetDataModeToAppended();
  ASSERT_TRUE(vtp->Write());
  this->ExpectSameBytes("sphere.vtp");
  const vtkNew<vtkPolyData> small;
  this->ReadSphere(81920, small);
  const vtkNew<vtkSTLWriter> stl;
  stl->SetFileName(this->Path("sphere.stl").c_str());
  stl->SetFileTypeToASCII();
  stl->SetInputData(small);
  stl->Write();
  this->ExpectSameBytes("sphere.stl");
}
