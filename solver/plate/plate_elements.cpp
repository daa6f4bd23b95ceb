#include "solver/plate/plate_elements.hpp"

#include <string>

#include "mesher/geometry/describe.hpp"
#include "mesher/geometry/error.hpp"
#include "solver/plate/arnold_falk.hpp"
#include "solver/plate/mitc4.hpp"
#include "solver/plate/mitc7.hpp"
#include "solver/plate/mitc9.hpp"
#include "solver/plate/tied_element.hpp"

namespace anisofront {
namespace {

const char* name_of(PlateElement kind) {
  return kind == PlateElement::mitc4 ? "mitc4" : "arnold_falk";
}
const char* name_of(Shape shape) { return shape == Shape::triangle ? "triangle" : "quadrilateral"; }

void require_shape(PlateElement kind, const Element& element, Shape expected) {
  if (element.shape == expected) return;
  throw UsageError("element " + std::to_string(element.number + 1) + " near " +
                   describe(element.nodes[0]) + " is a " + name_of(element.shape) +
                   ", but the plate element " + name_of(kind) + " is for " + name_of(expected) +
                   "s only; choose mitc, which is for both");
}

/// Calls `action` with the family of the element.
template <class Action>
auto with_family(PlateElement kind, const Element& element, const Action& action) {
  switch (kind) {
    case PlateElement::mitc4:
      require_shape(kind, element, Shape::quadrilateral);
      return action(Mitc4{});
    case PlateElement::arnold_falk:
      require_shape(kind, element, Shape::triangle);
      return action(ArnoldFalk{});
    case PlateElement::mitc:
      break;
  }
  return element.shape == Shape::triangle ? action(Mitc7{}) : action(Mitc9{});
}

}  // namespace

DofLayout plate_layout(PlateElement element) {
  switch (element) {
    case PlateElement::mitc4:
      return {3, 0, 0, 0};
    case PlateElement::arnold_falk:
      return {2, 1, 2, 0};
    case PlateElement::mitc:
      break;
  }
  return {3, 3, 2, 2};
}

PlateComponents vertex_components(PlateElement element) {
  return element == PlateElement::arnold_falk ? PlateComponents{-1, 0} : PlateComponents{0, 1};
}

PlateComponents edge_components(PlateElement element) {
  switch (element) {
    case PlateElement::mitc4:
      return {-1, -1};
    case PlateElement::arnold_falk:
      return {0, -1};
    case PlateElement::mitc:
      break;
  }
  return {0, 1};
}

ElementKernel plate_kernel(PlateElement kind, const PlateProblem& problem) {
  return [kind, &problem](const Element& element, ElementSystem& system) {
    with_family(kind, element, [&]<class Family>(Family) {
      fill_system<Family>(element, problem.material_in(element.region),
                          problem.load.in(element.region), system);
    });
  };
}

PlateState plate_state(PlateElement kind, const PlateMaterial& material, const Element& element,
                       const LocalValues& values, ReferencePoint at) {
  return with_family(kind, element, [&]<class Family>(Family) {
    return state_of<Family>(element, material, values, at);
  });
}

PlateEnergy element_energy(PlateElement kind, const PlateMaterial& material, const Element& element,
                           const LocalValues& values) {
  return with_family(kind, element, [&]<class Family>(Family) {
    return energy_of<Family>(element, material, values);
  });
}

}  // namespace anisofront
