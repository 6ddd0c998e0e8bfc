// SPDX-License-Identifier: BSD-3-Clause
// Edges, wireframes, points, and what lies at the same depth.
#include "MTMapperStates.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkProperty.h"

void MTMapperStates::AddLines()
{
  this->Add(
    "Edges",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->EdgeVisibilityOn();
      scene.Actor->GetProperty()->SetEdgeColor(0.9, 0.2, 0.1);
    },
    EqualDepths);
  this->Add(
    "Wireframe",
    [](MTScene& scene)
    {
      scene.Actor->GetProperty()->SetRepresentationToWireframe();
      scene.Actor->GetProperty()->LightingOff();
      Plain(scene);
    },
    EqualDepths);
  this->Add(
    "WireframeCellArray",
    [](MTScene& scene)
    {
      scene.Actor->GetProperty()->SetRepresentationToWireframe();
      scene.Actor->GetProperty()->LightingOff();
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
      scene.Mapper->SetScalarRange(0.0, 63.0);
    },
    EqualDepths);
  this->Add(
    "Points",
    [](MTScene& scene)
    {
      scene.Actor->GetProperty()->SetRepresentationToPoints();
      scene.Actor->GetProperty()->SetPointSize(3.0);
    },
    EqualDepths);
  this->Add(
    "PointsLit",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetRepresentationToPoints();
      scene.Actor->GetProperty()->SetPointSize(2.0);
    },
    EqualDepths);
  this->Add(
    "PointsAsSpheres",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetRepresentationToPoints();
      scene.Actor->GetProperty()->SetPointSize(6.0);
      scene.Actor->GetProperty()->RenderPointsAsSpheresOn();
    },
    EqualDepths);
  this->Add(
    "WireframeLit",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetRepresentationToWireframe();
    },
    EqualDepths);
  this->Add(
    "WireframeWide",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetRepresentationToWireframe();
      scene.Actor->GetProperty()->SetLineWidth(3.0);
      scene.Actor->GetProperty()->LightingOff();
    },
    EqualDepths);
  this->Add(
    "WireframeAsTubes",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->SetRepresentationToWireframe();
      scene.Actor->GetProperty()->SetLineWidth(4.0);
      scene.Actor->GetProperty()->RenderLinesAsTubesOn();
    },
    WideLines);
  this->Add(
    "EdgesOfCells",
    [](MTScene& scene)
    {
      scene.Actor->GetProperty()->EdgeVisibilityOn();
      scene.Actor->GetProperty()->SetLineWidth(2.0);
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectColorArray("Block");
      scene.Mapper->SetScalarRange(0.0, 63.0);
    },
    EqualDepths);
  this->Add(
    "EdgesAndVertices",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Actor->GetProperty()->EdgeVisibilityOn();
      scene.Actor->GetProperty()->VertexVisibilityOn();
      scene.Actor->GetProperty()->SetVertexColor(1.0, 1.0, 0.0);
      scene.Actor->GetProperty()->SetPointSize(4.0);
    },
    EqualDepths);
  this->Add("CoincidentPolygonOffset",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Mapper->SetResolveCoincidentTopologyToPolygonOffset();
      scene.Mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 2.0);
    });
  this->Add("CoincidentShiftScale",
    [](MTScene& scene)
    {
      Plain(scene);
      scene.Mapper->SetResolveCoincidentTopologyToShiftZBuffer();
    });
}
