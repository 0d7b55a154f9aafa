#include "experiments/sample_positions.h"

namespace lode::experiments {

std::vector<glm::ivec2> sample_positions_fx8(int n) {
  std::vector<glm::ivec2> positions;
  for (int k = 0; k < n; ++k) {
    int reversed = 0;  // k's bits in reverse order, as many as n has places for
    for (int bit = 1; bit < n; bit *= 2) reversed = 2 * reversed + ((k & bit) != 0 ? 1 : 0);
    // In units of 1/(2n) px both are odd numbers; n divides 128, so that 1/256 px holds them exactly.
    positions.emplace_back((2 * k + 1) * (128 / n), (2 * reversed + 1) * (128 / n));
  }
  return positions;
}

}  // namespace lode::experiments
