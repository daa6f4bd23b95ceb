#pragma once

#include <ctime>

namespace anisofront {

/// CPU seconds of the calling thread (variants of a study may run side by side).
inline double thread_cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Seconds since construction or since the last lap().
class Stopwatch {
 public:
  double lap() {
    const double now = thread_cpu_seconds();
    const double seconds = now - start_;
    start_ = now;
    return seconds;
  }

 private:
  double start_ = thread_cpu_seconds();
};

}  // namespace anisofront
