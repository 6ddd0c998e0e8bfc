// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportFlight
 * @brief flies past a mesh, with cuts and with the whole of it, and compares pictures with those of full resolution
 */
#ifndef MTReportFlight_h
#define MTReportFlight_h

#include "FlightPath.h"
#include "MTReportModel.h"
#include "MTReportPicture.h"

#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class MTReportContext;
class vtkActor;
class vtkMultiTriangulationMapper;
class vtkPolyData;
struct MTReportMesh;

/// What the frames of one flight took and showed, in their order.
struct MTReportFrames
{
  std::vector<double> FrameSeconds; ///< CPU time of all threads; without the first frame, which uploads everything
  std::vector<double> CutSeconds;   ///< likewise
  std::vector<double> Triangles;
  std::vector<double> CertifiedPixels;
  std::vector<MTReportDifference> Differences; ///< to full resolution
  /// Between the cut of the frame before and that of the frame, both seen from the frame's place.
  std::vector<MTReportDifference> Popping;
};

class MTReportFlight
{
public:
  /// Builds the models of the mesh, and flies past it in full resolution.
  MTReportFlight(const MTReportContext& context, const MTReportMesh& mesh);
  ~MTReportFlight();

  /// metric: of vtkMultiTriangulationMapper.
  MTReportFrames FlyModel(int metric, double pixelError) const;
  /// The mesh in full resolution in this actor, of any class, in a window that asks for so many frames per second.
  MTReportFrames FlyMesh(vtkActor* actor, double rate) const;

  /// Writes a picture of three frames, in full resolution above, as cuts of so many pixels of distance below.
  void WritePictures(double pixelError, const std::string& path) const;

private:
  void Configure(vtkMultiTriangulationMapper* mapper, int metric, double pixelError) const;
  MTReportFrames FlyMesh(vtkActor* actor, double rate, std::vector<MTReportPicture>& pictures) const;

  const std::array<int, 2> Size; // of pictures
  const MTReportModel Model;
  const MTReportModel ModelWithNormals; // certified
  vtkSmartPointer<vtkPolyData> Full;    // with normals
  FlightPath Path;
  std::vector<MTReportPicture> Wanted; // the flight in full resolution
};

#endif
