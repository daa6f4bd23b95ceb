#pragma once

#include <omp.h>

/// Of OpenBLAS; with another BLAS both are null.
extern "C" {
[[gnu::weak]] void openblas_set_num_threads(int threads);
[[gnu::weak]] int openblas_get_num_threads();
}

namespace anisofront {

/// Holds OpenBLAS and OpenMP to one thread as long as it lives: OpenBLAS rounds differently with
/// two, and CHOLMOD opens a parallel region for each of its many small supernodes, which takes
/// longer than it saves (on a busy machine, a hundred times).
class SingleThread {
 public:
  SingleThread()
      : levels_(omp_get_max_active_levels()),
        threads_(openblas_get_num_threads ? openblas_get_num_threads() : 1) {
    set(0, 1);
  }
  ~SingleThread() { set(levels_, threads_); }
  SingleThread(const SingleThread&) = delete;
  SingleThread& operator=(const SingleThread&) = delete;

 private:
  static void set(int levels, int threads) {
    omp_set_max_active_levels(levels);
    if (openblas_set_num_threads) openblas_set_num_threads(threads);
  }
  int levels_;
  int threads_;
};

}  // namespace anisofront
