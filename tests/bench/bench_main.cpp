#include <benchmark/benchmark.h>

#include "bench.h"

int main(int n_arguments, char** arguments) {
  lode::bench::register_samples();
  lode::bench::register_kernels();
  lode::bench::register_shading();
  lode::bench::register_frames();
  benchmark::Initialize(&n_arguments, arguments);
  if (benchmark::ReportUnrecognizedArguments(n_arguments, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
