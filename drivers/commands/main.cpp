#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

#include "drivers/commands/program.hpp"

int main(int argc, char** argv) {
#ifdef M_MMAP_THRESHOLD
  // Large arrays go back to the system when they are freed, at any size: the peak is what is in
  // use.
  mallopt(M_MMAP_THRESHOLD, 1 << 18);
#endif
  return anisofront::run_program(argc, argv);
}
