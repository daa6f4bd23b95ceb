#pragma once

#include <array>
#include <vector>

#include "adapt/flux.hpp"

namespace anisofront {

/// Coordinates of a patch, L^-1 (x - origin), with L the lower Cholesky factor of the covariance of
/// the patch about its centre, the origin: they have mean 0 and unit covariance whatever the
/// stretch. Without them the normal equations of a patch stretched by a lose a^4 digits.
struct PatchFrame {
  Point origin;
  double l11 = 1, l21 = 0, l22 = 1;

  Vector coordinates(Point x) const {
    const double s = (x.x - origin.x) / l11;
    return {s, (x.y - origin.y - l21 * s) / l22};
  }
};

/// Sums over the points of a patch, given by vectors d from a point near by.
struct PatchMoments {
  Vector sum;
  double xx = 0, xy = 0, yy = 0;
  int count = 0;

  void add(Vector d) {
    sum = sum + d;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
    ++count;
  }
};
/// Precondition: the points do not lie on a line.
PatchFrame patch_frame(Point near, const PatchMoments& moments);

/// 1, x, y and, for degree 2, x^2, xy, y^2.
inline constexpr int kMaxTerms = 6;
using Terms = std::array<double, kMaxTerms>;
inline int term_count(int degree) { return degree == 1 ? 3 : 6; }
inline Terms terms_at(Vector y) { return {1, y.x, y.y, y.x * y.x, y.x * y.y, y.y * y.y}; }

/// Polynomials of several components: coefficients[term][component]. Those of higher degree than
/// fitted are 0.
struct PatchPolynomial {
  PatchFrame frame;
  std::array<std::array<double, kMaxFluxComponents>, kMaxTerms> coefficients{};
};

/// The same polynomial in another frame.
PatchPolynomial in_frame(const PatchFrame& frame, const PatchPolynomial& polynomial);

/// One polynomial per patch, stored without the terms and components that are not used.
class PatchPolynomials {
 public:
  PatchPolynomials() = default;
  PatchPolynomials(Index patches, int degree, int components)
      : terms_(term_count(degree)),
        components_(components),
        frames_(patches),
        coefficients_(place(patches)) {}

  /// Of different patches by several threads at once.
  void set(Index patch, const PatchPolynomial& polynomial);
  PatchPolynomial operator[](Index patch) const;
  /// Adds weight * p(x) to the result, one value per component.
  void add_value(Index patch, Point x, double weight, double* result) const;

 private:
  std::size_t place(Index patch) const {
    return static_cast<std::size_t>(patch) * static_cast<std::size_t>(terms_ * components_);
  }

  int terms_ = 0, components_ = 0;
  std::vector<PatchFrame> frames_;
  std::vector<double> coefficients_;  ///< patch by patch, [term][component]
};

/// Normal equations of a weighted least-squares fit in patch coordinates.
class PatchFit {
 public:
  PatchFit(const PatchFrame& frame, int degree, int components)
      : frame_(frame), terms_(term_count(degree)), components_(components) {}

  /// `values`: one per component.
  void add(Point x, double weight, const double* values);

  /// Terms that the samples do not tell apart from those before them are left out (coefficient 0),
  /// so that few samples give a polynomial of lower degree.
  PatchPolynomial solve() const;
  /// All terms are well determined.
  bool is_determined() const { return independent_terms(kWellDetermined) == terms_; }

 private:
  static constexpr double kWellDetermined = 1e-3;

  /// L D L' of the matrix; D 0 where a pivot is below `tolerance` times its diagonal entry.
  struct Factors {
    std::array<Terms, kMaxTerms> lower{};
    Terms pivots{};
  };
  Factors factors(double tolerance) const;
  int independent_terms(double tolerance) const;

  PatchFrame frame_;
  int terms_, components_;
  std::array<Terms, kMaxTerms> matrix_{};  ///< lower triangle
  std::array<std::array<double, kMaxFluxComponents>, kMaxTerms> rhs_{};
};

}  // namespace anisofront
