#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace anisofront {

using ErrorPoint = std::pair<double, double>;  ///< unknowns and error, both positive

/// p of error = C unknowns^-p by least squares of the logarithms. Nothing when there are fewer than
/// two points or the unknowns span less than a factor 2.
std::optional<double> measured_order(const std::vector<ErrorPoint>& points);

/// A straight line below the curves that follow it: error = factor unknowns^-order.
struct ReferenceSlope {
  double order = 0.5;  ///< a multiple of 1/2
  double factor = 1;
  double first = 0, last = 0;  ///< range of the unknowns
};

/// One per order, each curve being counted by its measured order, rounded to halves. Of more than
/// twelve curves only the commonest order, below all of them.
std::vector<ReferenceSlope> reference_slopes(const std::vector<std::vector<ErrorPoint>>& curves);

}  // namespace anisofront
