#pragma once

#include "solver/plate/plate_problem.hpp"
#include "solver/space/element_map.hpp"
#include "solver/system/assemble.hpp"

namespace anisofront {

/// Families of elements. mitc is for all meshes and stays right on thin, stretched elements; the
/// two others are the low-order baselines with three unknowns per vertex or so; they take every
/// element as straight.
enum class PlateElement {
  mitc,        ///< MITC7 on triangles, Bathe-Brezzi MITC9 (8-node w) on quadrilaterals
  mitc4,       ///< quadrilaterals only
  arnold_falk  ///< triangles only: Crouzeix-Raviart w (its unknown on an edge is the mean over
               ///< the chord), P1 + bubble theta, constant shear
};

/// Unknowns. mitc: w, theta_x, theta_y on each vertex and edge, 2 rotations inside each element.
/// mitc4: w, theta_x, theta_y on each vertex. arnold_falk: theta_x, theta_y on each vertex, w on
/// each edge, 2 rotations inside.
DofLayout plate_layout(PlateElement element);

/// Component of the unknowns of a vertex (or of an edge), or -1 where it has none.
struct PlateComponents {
  int w = 0;
  int rotation = 1;  ///< theta_x; theta_y is the next
};
PlateComponents vertex_components(PlateElement element);
PlateComponents edge_components(PlateElement element);

/// Stiffness and load (q on w, by a rule of degree 6, on bent elements 8) of one element. Throws
/// UsageError for an element of the wrong shape, InputError for one that is inside out and for a
/// load that is not finite, each with the place. `problem` must outlive the kernel.
ElementKernel plate_kernel(PlateElement element, const PlateProblem& problem);

/// Symmetric tensor of moments, force.
struct Moments {
  double xx = 0, yy = 0, xy = 0;
};

/// What holds at a point of an element.
struct PlateState {
  Point x;
  double w = 0;
  Vector rotation;
  Moments moments;  ///< M
  Vector shear;     ///< Q, from the reduced (tied) shear strain
};

/// From the element's unknowns (see local_values()). Throws UsageError for the wrong shape.
PlateState plate_state(PlateElement kind, const PlateMaterial& material, const Element& element,
                       const LocalValues& values, ReferencePoint at);

/// Energy of bending and of shear of one element.
struct PlateEnergy {
  double bending = 0;  ///< 1/2 int M : C^-1 : M
  double shear = 0;    ///< 1/2 int Q . Q / (k G t)
  double total() const { return bending + shear; }
};
PlateEnergy element_energy(PlateElement kind, const PlateMaterial& material, const Element& element,
                           const LocalValues& values);

}  // namespace anisofront
