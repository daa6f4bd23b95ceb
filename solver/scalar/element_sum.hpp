#pragma once

#include <algorithm>
#include <exception>
#include <vector>

#include <omp.h>

#include "mesher/geometry/point.hpp"

namespace anisofront {

/// term(0) + term(1) + ... over `count` elements in parallel. Blocks of fixed size make the sum
/// independent of the number of threads (0: all cores). What a term throws is thrown on, that of
/// the first block first. `Value` has operator+=. For sources of the solver only: needs OpenMP.
template <class Value, class Term>
Value element_sum(Index count, int threads, const Term& term) {
  constexpr Index kBlock = 1024;
  const Index blocks = (count + kBlock - 1) / kBlock;
  std::vector<Value> sums(blocks);
  std::vector<std::exception_ptr> errors(blocks);
  const int team = std::min(threads > 0 ? threads : omp_get_max_threads(), blocks);
#pragma omp parallel for schedule(dynamic) num_threads(team)
  for (Index b = 0; b < blocks; ++b) try {
      const Index end = b + 1 == blocks ? count : (b + 1) * kBlock;
      for (Index e = b * kBlock; e < end; ++e) sums[b] += term(e);
    } catch (...) {
      errors[b] = std::current_exception();
    }
  Value total{};
  for (Index b = 0; b < blocks; ++b) {
    if (errors[b]) std::rethrow_exception(errors[b]);
    total += sums[b];
  }
  return total;
}

}  // namespace anisofront
