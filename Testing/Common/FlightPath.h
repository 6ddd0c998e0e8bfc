// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class FlightPath
 * @brief a camera's way past a model, the same in every run
 *
 * Either made for a model - from afar to the surface, along it, around, and back again, in shares of the model's size -
 * or read from a file with one line of nine numbers per frame: position, focal point, view up.
 */
#ifndef FlightPath_h
#define FlightPath_h

#include <array>
#include <string>
#include <vector>

class vtkPolyData;
class vtkRenderer;

class FlightPath
{
public:
  using View = std::array<double, 9>;

  /// bounds: of the model; mesh: any version of it, by which the path finds the surface.
  static FlightPath Make(const double bounds[6], vtkPolyData* mesh, int frames);

  bool Read(const std::string& file, std::string& error);
  bool Write(const std::string& file, std::string& error) const;

  int GetNumberOfFrames() const { return static_cast<int>(this->Views.size()); }
  /// Sets the renderer's camera and its clipping range.
  void Apply(int frame, vtkRenderer* renderer) const;
  /// far, approach, close, turn or back.
  std::string GetPart(int frame) const;

private:
  std::vector<View> Views;
};

#endif
