#include <unistd.h>

#include <iostream>

#include "experiments/lodestone.h"
#include "experiments/whole_file.h"

int main(int argc, char** argv) {
  lode::experiments::remove_temporary_files_on_signals();
  std::ios::sync_with_stdio(false);
  return lode::experiments::run_lodestone(argc, argv, {std::cin, std::cout, std::cerr, ::isatty(STDERR_FILENO) != 0});
}
