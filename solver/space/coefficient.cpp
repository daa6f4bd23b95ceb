#include "solver/space/coefficient.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/geometry/error.hpp"

namespace anisofront {

void RegionCoefficient::set(Index region, Coefficient value) {
  for (auto& [tag, old] : regions_)
    if (tag == region) {
      old = std::move(value);
      return;
    }
  regions_.emplace_back(region, std::move(value));
}

const Coefficient& RegionCoefficient::in(Index region) const {
  for (const auto& [tag, value] : regions_)
    if (tag == region) return value;
  return everywhere_;
}

bool RegionCoefficient::is_zero() const {
  return everywhere_.is_zero() && std::all_of(regions_.begin(), regions_.end(),
                                              [](const auto& r) { return r.second.is_zero(); });
}

double finite_value(const Coefficient& coefficient, Point p, const char* what) {
  const double value = coefficient(p);
  if (!std::isfinite(value))
    throw InputError(std::string(what) + " is " + std::to_string(value) + " at (" +
                     std::to_string(p.x) + ", " + std::to_string(p.y) +
                     "), expected a finite number");
  return value;
}

}  // namespace anisofront
