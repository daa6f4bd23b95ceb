#include "solver/system/memory.hpp"

#include <cstdio>
#include <fstream>
#include <limits>

#include "mesher/geometry/error.hpp"

namespace anisofront {
namespace {

/// Share of the free memory that factors may take.
constexpr double kShareOfFree = 0.8;

std::string gibibytes(double bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g GiB", bytes / (1024. * 1024 * 1024));
  return text;
}

}  // namespace

double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string word; file >> word;) {
    double kilobytes = 0;
    if (word == "MemAvailable:" && file >> kilobytes) return 1024 * kilobytes;
  }
  return std::numeric_limits<double>::infinity();
}

MemoryLimit memory_limit(double wanted) {
  if (wanted > 0) return {wanted, "the memory limit that was set"};
  return {kShareOfFree * available_memory(), "80 % of the free memory"};
}

void require_memory(double bytes, std::int64_t unknowns, const MemoryLimit& limit) {
  if (bytes <= limit.bytes) return;
  throw BudgetError("the factors of the linear system of " + std::to_string(unknowns) +
                    " unknowns need about " + gibibytes(bytes) + ", allowed are " +
                    gibibytes(limit.bytes) + " (" + limit.meaning +
                    "): take a coarser mesh or lower order, raise the limit, or free memory");
}

}  // namespace anisofront
