#include "solver/system/condense.hpp"

#include <cmath>
#include <string>

#include "mesher/geometry/error.hpp"

namespace anisofront {

void condense(const Element& element, int outer, ElementSystem& system) {
  auto& a = system.matrix;
  for (int k = static_cast<int>(a.rows()) - 1; k >= outer; --k) {
    const double pivot = a(k, k);
    if (!(std::abs(pivot) > 0) || !std::isfinite(pivot))
      throw MeshingError("the inner unknowns of element " + std::to_string(element.number + 1) +
                         " near (" + std::to_string(element.nodes[0].x) + ", " +
                         std::to_string(element.nodes[0].y) + ") cannot be eliminated");
    for (int j = 0; j < k; ++j) {
      const double factor = a(k, j) / pivot;
      for (int i = 0; i < k; ++i) a(i, j) -= a(i, k) * factor;
    }
    const double factor = system.rhs[k] / pivot;
    for (int i = 0; i < k; ++i) system.rhs[i] -= a(i, k) * factor;
  }
}

void expand(int outer, const ElementSystem& condensed, LocalValues& values) {
  const auto& a = condensed.matrix;
  for (int k = outer; k < a.rows(); ++k) {
    double sum = condensed.rhs[k];
    for (int j = 0; j < k; ++j) sum -= a(k, j) * values[j];
    values[k] = sum / a(k, k);
  }
}

}  // namespace anisofront
