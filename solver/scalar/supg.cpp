#include "solver/scalar/supg.hpp"

#include <cmath>

namespace anisofront {
namespace {

double contract(const std::array<double, 3>& g, const ReferenceHessian& h) {
  return g[0] * h.xi_xi + 2 * g[1] * h.xi_eta + g[2] * h.eta_eta;
}

/// G : H(x), the part of the Laplacians that comes from the map. Straight elements too are mapped
/// by the second-order functions of their nodes.
Vector map_laplacian(const Element& element, ReferencePoint at, const std::array<double, 3>& g) {
  if (element.shape == Shape::triangle && !element.bent) return {};
  const auto hessians = scalar_basis_hessians(element.shape, 2, at);
  Vector sum;
  for (int k = 0; k < (element.shape == Shape::triangle ? 6 : 9); ++k)
    sum = sum + contract(g, hessians[k]) * element.nodes[k];
  return sum;
}

}  // namespace

double flow_length(Vector velocity, int corners, const std::array<Vector, 9>& gradients) {
  double sum = 0;
  for (int k = 0; k < corners; ++k) sum += std::abs(dot(velocity, gradients[k]));
  return sum > 0 ? 2 * norm(velocity) / sum : 0;
}

double supg_time(Vector velocity, double diffusion, double node_distance) {
  const double speed = norm(velocity);
  const double peclet = 0.5 * speed * node_distance / diffusion;
  if (!(peclet >= 1)) return 0;
  return 0.5 * node_distance / speed * (1 / std::tanh(peclet) - 1 / peclet);
}

std::array<double, 9> basis_laplacians(const Element& element, int order, ReferencePoint at,
                                       const std::array<Vector, 9>& gradients) {
  std::array<double, 9> laplacians{};
  if (order == 1 && element.shape == Shape::triangle && !element.bent) return laplacians;
  const MapPoint map = map_at(element, at);
  const Vector xi = map.gradient({1, 0}), eta = map.gradient({0, 1});
  const std::array<double, 3> g{dot(xi, xi), dot(xi, eta), dot(eta, eta)};
  const Vector of_map = map_laplacian(element, at, g);
  const auto hessians = scalar_basis_hessians(element.shape, order, at);
  for (int k = 0; k < 9; ++k) laplacians[k] = contract(g, hessians[k]) - dot(gradients[k], of_map);
  return laplacians;
}

}  // namespace anisofront
