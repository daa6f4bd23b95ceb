// Exact orientation. Reference: J. R. Shewchuk, Adaptive precision floating-point arithmetic and
// fast robust geometric predicates, Discrete Comput. Geom. 18 (1997), doi:10.1007/PL00009321.
// Where he splits factors (Dekker), the error of a product comes from one fused multiply-add.
#include "mesher/geometry/predicates.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace anisofront::detail {
namespace {

/// head + tail is the exact value, head its rounding.
struct TwoTerm {
  double head;
  double tail;
};

TwoTerm two_sum(double a, double b) {
  const double sum = a + b;
  const double b_virtual = sum - a;
  const double a_virtual = sum - b_virtual;
  return {sum, (a - a_virtual) + (b - b_virtual)};
}

TwoTerm two_difference(double a, double b) { return two_sum(a, -b); }

TwoTerm two_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

int sign(double value) { return (value > 0) - (value < 0); }

/// Rounding is monotone: heads that differ decide, equal heads leave it to the tails.
int compare(TwoTerm a, TwoTerm b) {
  return a.head != b.head ? sign(a.head - b.head) : sign(a.tail - b.tail);
}

/// A sum of doubles kept exactly as a non-overlapping expansion, smallest component first.
class Expansion {
 public:
  /// Shewchuk, GROW-EXPANSION (Fig. 6).
  void add(double value) {
    for (std::size_t i = 0; i < size_; ++i) {
      const TwoTerm sum = two_sum(value, components_[i]);
      value = sum.head;
      components_[i] = sum.tail;
    }
    components_[size_++] = value;
  }

  /// Adds (or with factor -1 subtracts) the product of two exact differences.
  void add_product(double factor, TwoTerm a, TwoTerm b) {
    for (const TwoTerm product : {two_product(a.tail, b.tail), two_product(a.head, b.tail),
                                  two_product(a.tail, b.head), two_product(a.head, b.head)}) {
      add(factor * product.tail);
      add(factor * product.head);
    }
  }

  /// The largest component that is not zero outweighs all the others.
  int sign_of_sum() const {
    for (std::size_t i = size_; i-- > 0;)
      if (components_[i] != 0) return sign(components_[i]);
    return 0;
  }

 private:
  std::array<double, 16> components_{};
  std::size_t size_ = 0;
};

}  // namespace

int exact_orientation(Point a, Point b, Point c) {
  const TwoTerm acx = two_difference(a.x, c.x), acy = two_difference(a.y, c.y);
  const TwoTerm bcx = two_difference(b.x, c.x), bcy = two_difference(b.y, c.y);
  if (acx.tail == 0 && acy.tail == 0 && bcx.tail == 0 && bcy.tail == 0)
    return compare(two_product(acx.head, bcy.head), two_product(acy.head, bcx.head));
  Expansion determinant;
  determinant.add_product(1, acx, bcy);
  determinant.add_product(-1, acy, bcx);
  return determinant.sign_of_sum();
}

}  // namespace anisofront::detail
