#pragma once

#include <span>
#include <vector>

#include "mesher/mesh/mesh.hpp"

namespace anisofront {

/// Second derivatives of a scalar.
struct Hessian {
  double xx = 0;
  double xy = 0;
  double yy = 0;
};

/// Derivatives at a vertex of the quadratic that fits the values around it.
struct LocalQuadratic {
  Vector gradient;
  Hessian hessian;
};

/// What values do where elements of different region tags meet.
enum class AcrossInterfaces {
  smooth,  ///< nothing: patches ignore the regions
  kink,    ///< continuous with another slope on each side (u where the coefficient jumps)
  jump     ///< take another value on each side (stresses): one value at a vertex says nothing
};

/// Weighted least-squares quadratic through the values around each vertex, in coordinates divided
/// by the root of the patch covariance, weights 1/(1 + r^2). The patch: the neighbours along edges
/// and all vertices of their elements, on triangles the two-ring; one ring more where those are
/// fewer than 10, as in corners (on whole edges a third ring measured worse).
/// kink, jump: patches hold elements of one region only; a vertex of an interface takes the larger
/// Hessian of its sides, and `jump` leaves out the values at the vertices of interfaces.
/// `values`: one per vertex. Laws: exact for quadratics on any mesh whose patches determine one; an
/// affine map of the mesh transforms the result; independent of the number of threads. A patch that
/// does not determine a quadratic (fewer than 6 vertices, or all on a conic) gives the fit of least
/// norm in the patch coordinates.
/// Throws InputError when the number of values is not that of the vertices.
std::vector<LocalQuadratic> fit_quadratics(const Mesh& mesh, std::span<const double> values);

/// The same for several fields at once, which share patches and factorisations: `components` values
/// per vertex, field c of vertex v at values[v * components + c]. Result [c][v].
std::vector<std::vector<LocalQuadratic>> fit_quadratics(
    const Mesh& mesh, std::span<const double> values, int components,
    AcrossInterfaces across = AcrossInterfaces::smooth);

}  // namespace anisofront
