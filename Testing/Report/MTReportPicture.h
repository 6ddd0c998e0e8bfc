// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class MTReportPicture
 * @brief a rendered picture, and how much it differs from another one
 *
 * Only pixels that show the model in one of both pictures count; a difference is that of the component that differs
 * most, in grey levels, 255 being all there is.
 */
#ifndef MTReportPicture_h
#define MTReportPicture_h

#include <array>
#include <string>
#include <vector>

class vtkRenderWindow;

struct MTReportDifference
{
  double Largest = 0.0;
  double RootMeanSquare = 0.0;
  double ShareAbove8 = 0.0;
  double ShareAbove20 = 0.0;
  /// Structural similarity of brightness (Wang et al., "Image Quality Assessment", 2004), the mean over blocks of 8 x 8
  /// pixels every four pixels: 1 where there is no difference.
  double Similarity = 1.0;
  /// Pixels: no pixel that shows the model in one picture is farther than this from one that does in the other. At most
  /// MTReportPicture::FarthestOutline, which means that or more; pixels nearer than that to the edge are left out.
  double Outline = 0.0;
};

class MTReportPicture
{
public:
  static constexpr int FarthestOutline = 12;
  /// What windows must have as their background: grey models never have this colour.
  static constexpr std::array<unsigned char, 3> Background{ 26, 51, 102 };

  /// Of what the window shows.
  explicit MTReportPicture(vtkRenderWindow* window);

  MTReportDifference Compare(const MTReportPicture& other) const;

  /// Writes pictures of one size as one, side by side and below each other, each a share as wide and high. Throws
  /// std::runtime_error where that fails.
  static void Write(const std::vector<std::vector<MTReportPicture>>& rows, int share, const std::string& path);

private:
  bool ShowsModel(int x, int y) const;
  double GetBrightness(int x, int y) const;
  double GetSimilarity(const MTReportPicture& other, int left, int bottom) const;
  double GetFarthest(const MTReportPicture& other) const;
  double GetSimilarity(const MTReportPicture& other) const;
  unsigned char GetMean(int left, int bottom, int side, int component) const;

  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Pixels; // three components each
};

#endif
