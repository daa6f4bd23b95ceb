#pragma once

#include <cstdint>
#include <string>

namespace anisofront {

/// Bytes that can be taken without swapping (MemAvailable of /proc/meminfo); infinite where the
/// system does not tell.
double available_memory();

/// The largest memory that factors may take.
struct MemoryLimit {
  double bytes = 0;
  std::string meaning;  ///< where the limit comes from, for messages
};

/// `wanted` bytes, or 80 % of available_memory() when it is 0.
MemoryLimit memory_limit(double wanted);

/// Throws BudgetError with the estimate, the limit and what to do unless the factors of a system
/// of so many unknowns, estimated at `bytes`, fit.
void require_memory(double bytes, std::int64_t unknowns, const MemoryLimit& limit);

}  // namespace anisofront
