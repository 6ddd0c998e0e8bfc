// SPDX-License-Identifier: BSD-3-Clause
#include "MTReportPicture.h"

#include "MTReportImage.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace
{
constexpr int Block = 8;
constexpr int BlockStep = 4;
}

MTReportPicture::MTReportPicture(vtkRenderWindow* window)
  : Width(window->GetSize()[0])
  , Height(window->GetSize()[1])
{
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, this->Width - 1, this->Height - 1, 1, pixels);
  this->Pixels.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
}

bool MTReportPicture::ShowsModel(int x, int y) const
{
  const unsigned char* pixel = this->Pixels.data() + 3 * (std::size_t(y) * this->Width + x);
  return !std::equal(Background.begin(), Background.end(), pixel);
}

double MTReportPicture::GetBrightness(int x, int y) const
{
  const unsigned char* pixel = this->Pixels.data() + 3 * (std::size_t(y) * this->Width + x);
  return 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
}

// Of one block.
double MTReportPicture::GetSimilarity(const MTReportPicture& other, int left, int bottom) const
{
  constexpr double C1 = 0.01 * 0.01 * 255.0 * 255.0;
  constexpr double C2 = 0.03 * 0.03 * 255.0 * 255.0;
  constexpr double Count = Block * Block;
  double sums[2] = { 0.0, 0.0 };
  double products[3] = { 0.0, 0.0, 0.0 };
  for (int y = bottom; y < bottom + Block; ++y)
  {
    for (int x = left; x < left + Block; ++x)
    {
      const double a = this->GetBrightness(x, y);
      const double b = other.GetBrightness(x, y);
      sums[0] += a;
      sums[1] += b;
      products[0] += a * a;
      products[1] += b * b;
      products[2] += a * b;
    }
  }
  const double means[2] = { sums[0] / Count, sums[1] / Count };
  const double variances[2] = { products[0] / Count - means[0] * means[0], products[1] / Count - means[1] * means[1] };
  const double covariance = products[2] / Count - means[0] * means[1];
  return (2.0 * means[0] * means[1] + C1) * (2.0 * covariance + C2) /
    ((means[0] * means[0] + means[1] * means[1] + C1) * (variances[0] + variances[1] + C2));
}

double MTReportPicture::GetSimilarity(const MTReportPicture& other) const
{
  double sum = 0.0;
  int blocks = 0;
  for (int y = 0; y + Block <= this->Height; y += BlockStep)
  {
    for (int x = 0; x + Block <= this->Width; x += BlockStep)
    {
      const int middle[2] = { x + Block / 2, y + Block / 2 };
      if (this->ShowsModel(middle[0], middle[1]) || other.ShowsModel(middle[0], middle[1]))
      {
        sum += this->GetSimilarity(other, x, y);
        ++blocks;
      }
    }
  }
  return blocks > 0 ? sum / blocks : 1.0;
}

// From pixels that show the model to the nearest ones of the other picture that do.
double MTReportPicture::GetFarthest(const MTReportPicture& other) const
{
  double farthest = 0.0;
  // Near the picture's edge the nearest one may lie outside.
  for (int y = FarthestOutline; y < this->Height - FarthestOutline; ++y)
  {
    for (int x = FarthestOutline; x < this->Width - FarthestOutline; ++x)
    {
      if (!this->ShowsModel(x, y) || other.ShowsModel(x, y))
      {
        continue;
      }
      double nearest = FarthestOutline;
      for (int j = y - FarthestOutline; j <= y + FarthestOutline; ++j)
      {
        for (int i = x - FarthestOutline; i <= x + FarthestOutline; ++i)
        {
          const double distance = std::hypot(i - x, j - y);
          nearest = distance < nearest && other.ShowsModel(i, j) ? distance : nearest;
        }
      }
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

MTReportDifference MTReportPicture::Compare(const MTReportPicture& other) const
{
  MTReportDifference difference;
  std::int64_t shown = 0;
  std::int64_t above8 = 0;
  std::int64_t above20 = 0;
  double squares = 0.0;
  for (int y = 0; y < this->Height; ++y)
  {
    for (int x = 0; x < this->Width; ++x)
    {
      if (!this->ShowsModel(x, y) && !other.ShowsModel(x, y))
      {
        continue;
      }
      const std::size_t pixel = 3 * (std::size_t(y) * this->Width + x);
      int largest = 0;
      for (std::size_t c = pixel; c < pixel + 3; ++c)
      {
        largest = std::max(largest, std::abs(int(this->Pixels[c]) - int(other.Pixels[c])));
      }
      ++shown;
      above8 += largest > 8 ? 1 : 0;
      above20 += largest > 20 ? 1 : 0;
      squares += static_cast<double>(largest) * largest;
      difference.Largest = std::max<double>(difference.Largest, largest);
    }
  }
  const auto count = static_cast<double>(std::max<std::int64_t>(shown, 1));
  difference.RootMeanSquare = std::sqrt(squares / count);
  difference.ShareAbove8 = static_cast<double>(above8) / count;
  difference.ShareAbove20 = static_cast<double>(above20) / count;
  difference.Similarity = this->GetSimilarity(other);
  difference.Outline = std::max(this->GetFarthest(other), other.GetFarthest(*this));
  return difference;
}

unsigned char MTReportPicture::GetMean(int left, int bottom, int side, int component) const
{
  int sum = 0;
  for (int y = bottom; y < bottom + side; ++y)
  {
    for (int x = left; x < left + side; ++x)
    {
      sum += this->Pixels[3 * (std::size_t(y) * this->Width + x) + component];
    }
  }
  return static_cast<unsigned char>(sum / (side * side));
}

void MTReportPicture::Write(const std::vector<std::vector<MTReportPicture>>& rows, int share, const std::string& path)
{
  const int width = rows[0][0].Width / share;
  const int height = rows[0][0].Height / share;
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(rows[0].size()) * width, static_cast<int>(rows.size()) * height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image->GetDimensions()[1]; ++y)
  {
    for (int x = 0; x < image->GetDimensions()[0]; ++x)
    {
      const MTReportPicture& picture = rows[rows.size() - 1 - std::size_t(y / height)][x / width];
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      for (int c = 0; c < 3; ++c)
      {
        pixel[c] = picture.GetMean(share * (x % width), share * (y % height), share, c);
      }
    }
  }
  MTReportImage::Write(image, 64, path);
}
