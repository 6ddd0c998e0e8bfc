// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMTCameraPath.h"

#include "vtkCamera.h"
#include "vtkMTCameraPathFile.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkQuaternion.h"
#include "vtkTupleInterpolator.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
// What is interpolated: focal point, logarithm of the distance, quaternion, logarithms of view angle and parallel
// scale.
constexpr int TupleSize = 10;
using Tuple = std::array<double, TupleSize>;

vtkQuaterniond GetOrientation(const vtkMTCameraView& view)
{
  double axes[3][3]; // the rows are the camera's right, up and back
  vtkMath::Subtract(view.Position.data(), view.FocalPoint.data(), axes[2]);
  vtkMath::Normalize(axes[2]);
  vtkMath::Cross(view.ViewUp.data(), axes[2], axes[0]);
  vtkMath::Normalize(axes[0]);
  vtkMath::Cross(axes[2], axes[0], axes[1]);
  vtkQuaterniond orientation;
  orientation.FromMatrix3x3(axes);
  return orientation;
}

// Of two quaternions for one orientation the one that is nearer to the view before.
Tuple ToTuple(const vtkMTCameraView& view, const Tuple& before)
{
  double back[3];
  vtkMath::Subtract(view.Position.data(), view.FocalPoint.data(), back);
  const vtkQuaterniond q = GetOrientation(view);
  double along = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    along += q[i] * before[4 + i];
  }
  const double sign = along < 0.0 ? -1.0 : 1.0;
  return { view.FocalPoint[0], view.FocalPoint[1], view.FocalPoint[2], std::log(vtkMath::Norm(back)), sign * q[0],
    sign * q[1], sign * q[2], sign * q[3], std::log(view.ViewAngle),
    std::log(view.ParallelScale > 0.0 ? view.ParallelScale : 1.0) };
}

vtkMTCameraView ToView(const Tuple& tuple, bool isParallel)
{
  vtkQuaterniond q(tuple[4], tuple[5], tuple[6], tuple[7]);
  q.Normalize();
  double axes[3][3];
  q.ToMatrix3x3(axes);
  vtkMTCameraView view;
  for (int i = 0; i < 3; ++i)
  {
    view.FocalPoint[i] = tuple[i];
    view.Position[i] = tuple[i] + std::exp(tuple[3]) * axes[2][i];
    view.ViewUp[i] = axes[1][i];
  }
  view.ViewAngle = std::min(std::exp(tuple[8]), 179.9);
  view.ParallelScale = isParallel ? std::exp(tuple[9]) : 0.0;
  return view;
}
}

struct vtkMTCameraPath::Internals
{
  std::vector<vtkMTCameraView> Views;
  vtkNew<vtkTupleInterpolator> Tuples;
  bool IsCurrent = false; // the tuples are those of the views

  void Update()
  {
    if (this->IsCurrent)
    {
      return;
    }
    this->Tuples->Initialize();
    this->Tuples->SetNumberOfComponents(TupleSize);
    this->Tuples->SetInterpolationTypeToSpline();
    Tuple tuple{};
    for (const vtkMTCameraView& view : this->Views)
    {
      tuple = ToTuple(view, tuple);
      this->Tuples->AddTuple(view.Time, tuple.data());
    }
    this->IsCurrent = true;
  }
};

vtkStandardNewMacro(vtkMTCameraPath);

//------------------------------------------------------------------------------
vtkMTCameraPath::vtkMTCameraPath()
  : Implementation(std::make_unique<Internals>())
{
}

vtkMTCameraPath::~vtkMTCameraPath() = default;

//------------------------------------------------------------------------------
void vtkMTCameraPath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfViews: " << this->GetNumberOfViews() << "\n";
  os << indent << "FirstTime: " << this->GetFirstTime() << "\n";
  os << indent << "LastTime: " << this->GetLastTime() << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

//------------------------------------------------------------------------------
bool vtkMTCameraPath::Fail(const std::string& why)
{
  this->ErrorMessage = why;
  return false;
}

//------------------------------------------------------------------------------
bool vtkMTCameraPath::AddView(double time, vtkCamera* camera)
{
  std::vector<vtkMTCameraView>& views = this->Implementation->Views;
  if (!camera)
  {
    return this->Fail("there is no camera");
  }
  if (!std::isfinite(time) || (!views.empty() && time <= views.back().Time))
  {
    return this->Fail("a view's time must be finite and later than that of the view before");
  }
  const vtkMTCameraView view = vtkMTCameraView::Get(time, camera);
  if (const std::string problem = view.FindProblem(); !problem.empty())
  {
    return this->Fail(problem);
  }
  views.push_back(view);
  this->Implementation->IsCurrent = false;
  this->ErrorMessage.clear();
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkMTCameraPath::RemoveAllViews()
{
  this->Implementation->Views.clear();
  this->Implementation->IsCurrent = false;
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkMTCameraPath::GetNumberOfViews() const
{
  return static_cast<int>(this->Implementation->Views.size());
}

//------------------------------------------------------------------------------
double vtkMTCameraPath::GetFirstTime() const
{
  return this->Implementation->Views.empty() ? 0.0 : this->Implementation->Views.front().Time;
}

//------------------------------------------------------------------------------
double vtkMTCameraPath::GetLastTime() const
{
  return this->Implementation->Views.empty() ? 0.0 : this->Implementation->Views.back().Time;
}

//------------------------------------------------------------------------------
bool vtkMTCameraPath::GetView(double time, vtkCamera* camera)
{
  const std::vector<vtkMTCameraView>& views = this->Implementation->Views;
  if (views.empty() || !camera || std::isnan(time))
  {
    return this->Fail("there are no views, no camera or no time");
  }
  this->ErrorMessage.clear();
  const auto after = std::upper_bound(
    views.begin(), views.end(), time, [](double t, const vtkMTCameraView& view) { return t < view.Time; });
  const vtkMTCameraView& before = after == views.begin() ? views.front() : *(after - 1);
  if (after == views.begin() || after == views.end() || before.Time == time)
  {
    before.Set(camera);
    return true;
  }
  this->Implementation->Update();
  Tuple tuple{};
  this->Implementation->Tuples->InterpolateTuple(time, tuple.data());
  ToView(tuple, before.ParallelScale > 0.0).Set(camera);
  return true;
}

//------------------------------------------------------------------------------
bool vtkMTCameraPath::Write(const char* fileName)
{
  std::string error;
  const bool isWritten = vtkMTCameraPathFile::Write(fileName ? fileName : "", this->Implementation->Views, error);
  this->ErrorMessage = error;
  return isWritten;
}

//------------------------------------------------------------------------------
bool vtkMTCameraPath::Read(const char* fileName)
{
  std::string error;
  std::vector<vtkMTCameraView> views;
  const bool isRead = vtkMTCameraPathFile::Read(fileName ? fileName : "", views, error);
  this->ErrorMessage = error;
  if (isRead)
  {
    this->Implementation->Views.swap(views);
    this->Implementation->IsCurrent = false;
    this->Modified();
  }
  return isRead;
}
