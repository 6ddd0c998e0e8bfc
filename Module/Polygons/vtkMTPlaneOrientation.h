// SPDX-License-Identifier: BSD-3-Clause
// On which side of a line a point lies, without rounding errors. Not installed.
#ifndef vtkMTPlaneOrientation_h
#define vtkMTPlaneOrientation_h

#include <array>
#include <cmath>

/**
 * Twice the signed area of the triangle a b c, positive counterclockwise, with the right sign: computed in double
 * precision where the error bound of that is small enough, else summed up exactly (J. R. Shewchuk, Adaptive Precision
 * Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997). Products must not overflow or underflow.
 */
class vtkMTPlaneOrientation
{
public:
  using Point = std::array<double, 2>;

  static double Of(const Point& a, const Point& b, const Point& c)
  {
    constexpr double bound = 3.3306690738754716e-16; // (3 + 16 u) u, where u is 2^-53
    const double left = (a[0] - c[0]) * (b[1] - c[1]);
    const double right = (a[1] - c[1]) * (b[0] - c[0]);
    const double area = left - right;
    return std::abs(area) > bound * (std::abs(left) + std::abs(right)) ? area : Exact(a, b, c);
  }

private:
  // A sum of doubles that do not overlap, the largest last.
  struct Expansion
  {
    void Add(double value)
    {
      int kept = 0;
      for (int i = 0; i < this->Count; ++i)
      {
        const double sum = value + this->Terms[i];
        const double part = sum - value;
        const double error = (value - (sum - part)) + (this->Terms[i] - part);
        value = sum;
        if (error != 0.0)
        {
          this->Terms[kept++] = error;
        }
      }
      if (value != 0.0)
      {
        this->Terms[kept++] = value;
      }
      this->Count = kept;
    }
    void AddProduct(double a, double b)
    {
      const double product = a * b;
      this->Add(std::fma(a, b, -product));
      this->Add(product);
    }
    double Terms[12];
    int Count = 0;
  };

  static double Exact(const Point& a, const Point& b, const Point& c)
  {
    Expansion sum;
    sum.AddProduct(a[0], b[1]);
    sum.AddProduct(-a[1], b[0]);
    sum.AddProduct(b[0], c[1]);
    sum.AddProduct(-b[1], c[0]);
    sum.AddProduct(c[0], a[1]);
    sum.AddProduct(-c[1], a[0]);
    return sum.Count > 0 ? sum.Terms[sum.Count - 1] : 0.0;
  }
};

#endif
