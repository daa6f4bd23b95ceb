#include "solver/system/memory.hpp"

#include <doctest/doctest.h>

#include "mesher/geometry/error.hpp"

using namespace anisofront;

TEST_SUITE("unit") {
  TEST_CASE("the machine has some memory") {
    CHECK(available_memory() > 1e6);
    CHECK(memory_limit(0).bytes == doctest::Approx(0.8 * available_memory()).epsilon(0.2));
    CHECK(memory_limit(12345).bytes == 12345);
  }

  TEST_CASE("the error tells the estimate and the limit and what to do") {
    const MemoryLimit limit{1 << 30, "a test"};
    require_memory(1 << 30, 10, limit);
    CHECK_THROWS_WITH_AS(
        require_memory(3.5 * (1 << 30), 1234567, limit),
        "the factors of the linear system of 1234567 unknowns need about 3.5 GiB, "
        "allowed are 1 GiB (a test): take a coarser mesh or lower order, raise the "
        "limit, or free memory",
        BudgetError);
  }
}
