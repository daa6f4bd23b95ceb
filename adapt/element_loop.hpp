#pragma once

#include "solver/scalar/element_sum.hpp"

namespace anisofront {

/// body(0), body(1), ... in parallel on all cores, in blocks: for elements, vertices or edges. What
/// a body throws is thrown on. Bodies write to places of their own.
template <class Body>
void for_each_index(Index count, const Body& body) {
  struct Nothing {
    Nothing& operator+=(const Nothing&) { return *this; }
  };
  element_sum<Nothing>(count, 0, [&](Index i) {
    body(i);
    return Nothing{};
  });
}

}  // namespace anisofront
