#include "solver/system/factors.hpp"

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

std::string at_unknown(double pivot, std::int64_t unknown) {
  return "pivot " + describe(pivot) + " (of the matrix scaled to diagonal 1) at unknown " +
         std::to_string(unknown) + " (counted from 0)";
}

}  // namespace

void refuse_pivot(double pivot, std::int64_t unknown) {
  throw MeshingError("the matrix is not positive definite: " + at_unknown(pivot, unknown) +
                     "; some part of the model is held by no boundary condition and no reaction,"
                     " or a coefficient is negative");
}

void refuse_singular_pivot(double pivot, std::int64_t unknown) {
  throw MeshingError("the matrix is singular: " + at_unknown(pivot, unknown) +
                     "; some part of the model is held by no boundary condition and no reaction");
}

}  // namespace anisofront
