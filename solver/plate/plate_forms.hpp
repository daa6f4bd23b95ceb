#pragma once

#include "solver/plate/small_blocks.hpp"

namespace anisofront {

/// A quadratic form of two fields x and y with R functions each; the block yx is xy'.
template <int R>
struct RotationBlocks {
  Block<R, R> xx, xy, yy;

  void set_zero() {
    for (auto* block : {&xx, &xy, &yy}) block->setZero();
  }

  /// Adds weight f . f for the vector f = sum of x_i X_i + y_i Y_i, with rows X_i and Y_i.
  template <int Components>
  void add_products(double weight, const Block<R, Components>& x, const Block<R, Components>& y) {
    add_product(weight, x, x, xx);
    add_product(weight, x, y, xy);
    add_product(weight, y, y, yy);
  }

  /// The value for given x and y.
  double square(const Block<R, 1>& x, const Block<R, 1>& y) const {
    return bilinear(x, xx, x) + 2 * bilinear(x, xy, y) + bilinear(y, yy, y);
  }
};

/// Form of x' and y', times `scale`, where x = p.x x' + q.x y' and y = p.y x' + q.y y'.
template <int R>
RotationBlocks<R> substituted(const RotationBlocks<R>& form, double scale, Vector p, Vector q) {
  const Block<R, R> yx = form.xy.transpose();
  const auto block = [&](Vector a, Vector b) {
    return combination({scale * a.x * b.x, scale * a.x * b.y, scale * a.y * b.x, scale * a.y * b.y},
                       {&form.xx, &form.xy, &yx, &form.yy});
  };
  return {block(p, p), block(p, q), block(q, q)};
}

/// A quadratic form of w (W functions) and of the rotations x and y.
template <int W, int R>
struct PlateBlocks {
  Block<W, W> ww;
  Block<W, R> wx, wy;
  RotationBlocks<R> rotation;

  void set_zero() {
    ww.setZero();
    wx.setZero();
    wy.setZero();
    rotation.set_zero();
  }

  /// Adds weight f . f as above, with rows of w too.
  template <int Components>
  void add_products(double weight, const Block<W, Components>& w, const Block<R, Components>& x,
                    const Block<R, Components>& y) {
    add_product(weight, w, w, ww);
    add_product(weight, w, x, wx);
    add_product(weight, w, y, wy);
    rotation.add_products(weight, x, y);
  }

  double square(const Block<W, 1>& w, const Block<R, 1>& x, const Block<R, 1>& y) const {
    return bilinear(w, ww, w) + 2 * (bilinear(w, wx, x) + bilinear(w, wy, y)) +
           rotation.square(x, y);
  }
};

/// The sum of factors times forms.
template <int W, int R>
PlateBlocks<W, R> combination(const double (&factors)[3], const PlateBlocks<W, R>* const (&f)[3]) {
  const auto &a = f[0]->rotation, &b = f[1]->rotation, &c = f[2]->rotation;
  return {combination(factors, {&f[0]->ww, &f[1]->ww, &f[2]->ww}),
          combination(factors, {&f[0]->wx, &f[1]->wx, &f[2]->wx}),
          combination(factors, {&f[0]->wy, &f[1]->wy, &f[2]->wy}),
          {combination(factors, {&a.xx, &b.xx, &c.xx}), combination(factors, {&a.xy, &b.xy, &c.xy}),
           combination(factors, {&a.yy, &b.yy, &c.yy})}};
}

/// The integrals over an element that its stiffness consists of.
template <int W, int R>
struct PlateForms {
  RotationBlocks<R> gradients;  ///< block ab: int d_a N_i d_b N_j, a and b in {x, y}
  PlateBlocks<W, R> shear;      ///< int gamma . gamma

  void set_zero() {
    gradients.set_zero();
    shear.set_zero();
  }
};

/// int M : eps(theta) / D with C = [1 nu 0; nu 1 0; 0 0 (1 - nu)/2] on (theta_x,x theta_y,y
/// theta_x,y + theta_y,x), from the products of gradients.
template <int R>
RotationBlocks<R> bending_form(const RotationBlocks<R>& gradients, double poisson) {
  const double half = 0.5 * (1 - poisson);
  const auto& [xx, xy, yy] = gradients;
  const Block<R, R> yx = xy.transpose();
  return {combination({1, half}, {&xx, &yy}), combination({poisson, half}, {&xy, &yx}),
          combination({half, 1}, {&xx, &yy})};
}

}  // namespace anisofront
