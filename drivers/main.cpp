#include "drivers/program.hpp"

int main(int argc, char** argv) { return anisofront::run_program(argc, argv); }
