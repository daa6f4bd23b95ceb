#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include <malloc.h>

namespace anisofront {

/// A line of /proc/self/status in bytes (VmRSS: memory in use, VmHWM: its peak).
inline std::int64_t memory_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::int64_t kilobytes = 0;
    if (word == key + ":" && status >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

/// Peak memory above what is in use at construction. Linux only.
class PeakMemory {
 public:
  PeakMemory() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;  // proc(5): resets the peak
    start_ = memory_bytes("VmRSS");
  }
  std::int64_t bytes() const { return memory_bytes("VmHWM") - start_; }

 private:
  std::int64_t start_;
};

}  // namespace anisofront
