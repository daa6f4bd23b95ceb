#pragma once

#include <iosfwd>
#include <iostream>

namespace anisofront {

/// The whole program `anisofront`: reads the command line, does the work, reports errors. Returns
/// the exit code: 0 done; 1 done but the target was missed; 2 failed; 3 usage or study file;
/// 4 invalid input; 5 budget reached; 130 interrupted. Never throws.
int run_program(int argc, char** argv, std::ostream& out = std::cout,
                std::ostream& err = std::cerr);

}  // namespace anisofront
