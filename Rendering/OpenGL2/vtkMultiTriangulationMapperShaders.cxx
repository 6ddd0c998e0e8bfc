// SPDX-License-Identifier: BSD-3-Clause
// vtkMultiTriangulationMapper: what it changes in VTK's shaders, and the numbers that it gives them.
//
// Nothing that is computed in single precision may depend on where the model is or how large. Positions are lattice
// integers; the matrices are multiplied in double precision; and directions, which VTK's shaders derive from eye
// coordinates, are taken from eye coordinates in units near 1, for the squares of 1e-20 and of 1e20 are no floats. The
// units are powers of two, so at ordinary sizes the shaders compute what VTK's do, bit for bit.
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMTCellTexturesDec.h"
#include "vtkMTLatticeDec.h"
#include "vtkMTLatticeImpl.h"
#include "vtkMTLightDistance.h"
#include "vtkMTOpenGL.h"
#include "vtkMTPackedVertexDec.h"
#include "vtkMTPackedVertexImpl.h"
#include "vtkMTPbrLightDistance.h"
#include "vtkMTViewUnitDec.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiTriangulationMapper.h"
#include "vtkMultiTriangulationMapperInternals.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLCamera.h"
#include "vtkPlaneCollection.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>

namespace
{
// 1 over the largest power of two that is not above x; 1 where x is no positive number.
double GetUnit(double x)
{
  return std::isnormal(x) && x > 0.0 ? std::ldexp(1.0, -std::ilogb(x)) : 1.0;
}

//------------------------------------------------------------------------------
// 1 over about the largest of some numbers.
double GetUnit(const double* values, int count)
{
  double largest = 0.0;
  for (int i = 0; i < count; ++i)
  {
    largest = std::max(largest, std::abs(values[i]));
  }
  return GetUnit(largest);
}

//------------------------------------------------------------------------------
// Only the direction of what it gives is looked at. VTK's normal matrices are inverses, transposed as OpenGL wants
// them: that of a product has the other order.
void SetNormalMatrix(
  vtkShaderProgram* program, const vtkMTPlacement& placement, vtkMatrix3x3* modelToWorld, vtkMatrix3x3* worldToView)
{
  if (!program->IsUniformUsed("normalMatrix"))
  {
    return;
  }
  const std::array<double, 16> inverse = placement.GetInverse().Matrix;
  vtkNew<vtkMatrix3x3> frame;
  double* elements = frame->GetData();
  for (int i = 0; i < 9; ++i)
  {
    elements[i] = inverse[4 * (i / 3) + i % 3];
  }
  const double frameUnit = GetUnit(elements, 9);
  std::transform(elements, elements + 9, elements, [frameUnit](double element) { return frameUnit * element; });
  vtkNew<vtkMatrix3x3> matrix;
  vtkMatrix3x3::Multiply3x3(modelToWorld, worldToView, matrix);
  vtkMatrix3x3::Multiply3x3(frame, matrix, matrix);
  elements = matrix->GetData();
  const double unit = GetUnit(elements, 9);
  std::transform(elements, elements + 9, elements, [unit](double element) { return unit * element; });
  program->SetUniformMatrix("normalMatrix", matrix);
}
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::GetShaderTemplate(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::GetShaderTemplate(shaders, renderer, actor);
  if (!this->HasPatches())
  {
    return;
  }
  const bool isPacked = this->Implementation->Plan.PackedNormals >= 0;
  std::string source = shaders[vtkShader::Vertex]->GetSource();
  vtkShaderProgram::Substitute(source, "in vec4 vertexMC;", isPacked ? vtkMTPackedVertexDec : vtkMTLatticeDec);
  vtkShaderProgram::Substitute(source, "//VTK::CustomBegin::Impl",
    std::string(isPacked ? vtkMTPackedVertexImpl : vtkMTLatticeImpl) + "  //VTK::CustomBegin::Impl\n");
  shaders[vtkShader::Vertex]->SetSource(source);
}

//------------------------------------------------------------------------------
// The superclass does not see that another model of the same array's names has vertices of another form.
bool vtkMultiTriangulationMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  const bool needed = this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor);
  if (needed || !this->HasPatches() || !cellBO.Program)
  {
    return needed;
  }
  const GLint packed =
    glGetAttribLocation(static_cast<GLuint>(cellBO.Program->GetHandle()), vtkMTPatchStreams::PackedPositions);
  return (packed >= 0) != (this->Implementation->Plan.PackedNormals >= 0);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::ReplaceShaderValues(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  if (!this->HasPatches())
  {
    return;
  }
  if (this->Implementation->Plan.PackedNormals >= 0)
  {
    std::string vertex = shaders[vtkShader::Vertex]->GetSource();
    vtkShaderProgram::Substitute(vertex, "in vec3 normalMC;", "");
    shaders[vtkShader::Vertex]->SetSource(vertex);
  }
  std::string source = shaders[vtkShader::Fragment]->GetSource();
  const auto substitute = [&source](const std::string& from, const std::string& to)
  { vtkShaderProgram::Substitute(source, from, to); };
  for (const char* coordinates : { "xyz", "x", "y", "z" })
  {
    for (const char* function : { "dFdx(", "dFdy(" })
    {
      const std::string place = std::string("vertexVC.") + coordinates + ")";
      substitute(function + place, std::string(function) + "viewUnit * " + place);
    }
  }
  substitute("normalize(-vertexVC.xyz)", "normalize(-viewUnit * vertexVC.xyz)");
  substitute("normalize(vertexVC.xyz)", "normalize(viewUnit * vertexVC.xyz)");
  substitute("float distanceVC = length(vertLightDirectionVC);", vtkMTLightDistance);
  substitute("  distanceVC = length(L);\n", vtkMTPbrLightDistance);
  const char* const declaration = "uniform int PrimitiveIDOffset;";
  this->SubstituteCellTextures(source);
  substitute(declaration, std::string(declaration) + "\n" + vtkMTViewUnitDec);
  shaders[vtkShader::Fragment]->SetSource(source);
}

//------------------------------------------------------------------------------
// Where a texture is not that of the cell, its colour is 1.
void vtkMultiTriangulationMapper::SubstituteCellTextures(std::string& source) const
{
  const Internals& self = *this->Implementation;
  for (std::size_t i = 0; self.HasCellTextures && i < self.Plan.CellTextures.size(); ++i)
  {
    const std::string read = "= texture(" + self.Plan.CellTextures[i].Name + ",";
    const std::string number = std::to_string(i);
    vtkShaderProgram::Substitute(source, read,
      "= vec4(float(getCellTexture() != " + number + ")) + float(getCellTexture() == " + number + ") " +
        std::string("* ") + read.substr(2));
  }
  const std::string declaration = "uniform int PrimitiveIDOffset;";
  if (self.HasCellTextures)
  {
    vtkShaderProgram::Substitute(source, declaration, declaration + "\n" + vtkMTCellTexturesDec);
  }
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cellBO, renderer, actor);
  if (!this->HasPatches())
  {
    return;
  }
  const vtkMTPatchStreams::Plan& plan = this->Implementation->Plan;
  const auto program = static_cast<GLuint>(cellBO.Program->GetHandle());
  vtkMTPoint origin = this->Implementation->Origin;
  if (plan.PackedNormals >= 0)
  {
    // Packed positions are counted from the box's corner, in which the origin lies.
    std::transform(origin.begin(), origin.end(), plan.Packing.Corner.begin(), origin.begin(), std::minus<>());
    glUniform2i(glGetUniformLocation(program, "packedBits"), plan.Packing.Shift, plan.Packing.GetNormalBits());
  }
  glUniform3i(glGetUniformLocation(program, "latticeOrigin"), origin[0], origin[1], origin[2]);
  this->UseClippingPlanes(cellBO);
  if (this->Implementation->HasCellTextures && cellBO.Program->IsUniformUsed("cellTextures"))
  {
    cellBO.Program->SetUniformi("cellTextures", this->Implementation->CellTextureBuffer->GetTextureUnit());
  }
}

//------------------------------------------------------------------------------
// The superclass's planes are in model units; these are in lattice steps.
void vtkMultiTriangulationMapper::TakeClippingPlanes(vtkActor* actor)
{
  Internals& self = *this->Implementation;
  constexpr int maximum = 6; // of the superclass's shader
  self.Planes.resize(static_cast<std::size_t>(std::min(this->GetNumberOfClippingPlanes(), maximum)));
  const vtkMTLattice& lattice = self.Graph().Lattice;
  const std::array<double, 3> corner = lattice.ToWorld(vtkMTPoint{ 0, 0, 0 });
  vtkNew<vtkMatrix4x4> modelToWorld;
  modelToWorld->DeepCopy(self.GetModelToWorld(actor).data());
  for (std::size_t i = 0; i < self.Planes.size(); ++i)
  {
    double plane[4];
    this->GetClippingPlaneInDataCoords(modelToWorld, static_cast<int>(i), plane);
    // In steps all along, and of a length near 1, so that the smallest and largest models stay within the range of
    // floats; the shader looks at the sign only.
    const double unit = GetUnit(std::max({ std::abs(plane[0]), std::abs(plane[1]), std::abs(plane[2]) }));
    const double offset = plane[0] * corner[0] + plane[1] * corner[1] + plane[2] * corner[2] + plane[3];
    self.Planes[i] = { unit * plane[0], unit * plane[1], unit * plane[2], unit * (offset / lattice.Step) };
  }
}

//------------------------------------------------------------------------------
// The shader's places are relative to the origin.
void vtkMultiTriangulationMapper::UseClippingPlanes(vtkOpenGLHelper& cellBO)
{
  const Internals& self = *this->Implementation;
  constexpr int maximum = 6;
  if (self.Planes.empty() || !cellBO.Program->IsUniformUsed("clipPlanes"))
  {
    return;
  }
  float equations[maximum][4] = {};
  for (std::size_t i = 0; i < self.Planes.size(); ++i)
  {
    double offset = self.Planes[i][3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      equations[i][k] = static_cast<float>(self.Planes[i][k]);
      offset += self.Planes[i][k] * self.Origin[k];
    }
    equations[i][3] = static_cast<float>(offset);
  }
  cellBO.Program->SetUniform4fv("clipPlanes", maximum, equations);
}

//------------------------------------------------------------------------------
void vtkMultiTriangulationMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetCameraShaderParameters(cellBO, renderer, actor);
  if (!this->HasPatches())
  {
    return;
  }
  // VTK keeps these matrices transposed, as OpenGL wants them.
  vtkMatrix4x4* worldToView;
  vtkMatrix4x4* viewToDevice;
  vtkMatrix4x4* worldToDevice;
  vtkMatrix3x3* viewNormals;
  vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera())
    ->GetKeyMatrices(renderer, worldToView, viewNormals, viewToDevice, worldToDevice);

  const vtkMTLattice& lattice = this->Implementation->Graph().Lattice;
  const std::array<double, 3> origin = lattice.ToWorld(this->Implementation->Origin);
  vtkNew<vtkMatrix4x4> toWorld;
  for (int i = 0; i < 3; ++i)
  {
    toWorld->SetElement(i, i, lattice.Step);
    toWorld->SetElement(3, i, origin[i]);
  }
  const vtkMTPlacement& placement = this->Implementation->Placement;
  if (!placement.IsIdentity())
  {
    double transposed[16];
    vtkMatrix4x4::Transpose(placement.Matrix.data(), transposed);
    vtkMatrix4x4::Multiply4x4(toWorld->GetData(), transposed, toWorld->GetData());
  }
  if (!actor->GetIsIdentity() || !placement.IsIdentity())
  {
    vtkMatrix4x4* modelToWorld;
    vtkMatrix3x3* normals;
    vtkOpenGLActor::SafeDownCast(actor)->GetKeyMatrices(modelToWorld, normals);
    vtkMatrix4x4::Multiply4x4(toWorld, modelToWorld, toWorld);
    SetNormalMatrix(cellBO.Program, placement, normals, viewNormals);
  }
  const auto set = [&cellBO](const char* name, vtkMatrix4x4* matrix)
  {
    if (cellBO.Program->IsUniformUsed(name))
    {
      cellBO.Program->SetUniformMatrix(name, matrix);
    }
  };
  set("MCWCMatrix", toWorld);
  vtkMatrix4x4::Multiply4x4(toWorld, worldToView, this->TempMatrix4);
  set("MCVCMatrix", this->TempMatrix4);
  vtkMatrix4x4::Multiply4x4(this->TempMatrix4, viewToDevice, this->TempMatrix4);
  set("MCDCMatrix", this->TempMatrix4);
  if (cellBO.Program->IsUniformUsed("viewUnit"))
  {
    const double unit = GetUnit(renderer->GetActiveCamera()->GetClippingRange()[1]);
    cellBO.Program->SetUniformf("viewUnit", static_cast<float>(unit));
  }
}
