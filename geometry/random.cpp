#include "geometry/random.h"

namespace lode::geometry {

RandomBlock philox(RandomBlock c, std::array<std::uint32_t, 2> key) {
  constexpr std::uint64_t kMultiply0 = 0xD2511F53u, kMultiply1 = 0xCD9E8D57u;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9u, kWeyl1 = 0xBB67AE85u;  // the golden ratio, √3 − 1
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t p0 = kMultiply0 * c[0], p1 = kMultiply1 * c[2];
    c = {std::uint32_t(p1 >> 32) ^ c[1] ^ key[0], std::uint32_t(p1), std::uint32_t(p0 >> 32) ^ c[3] ^ key[1],
         std::uint32_t(p0)};
    key = {key[0] + kWeyl0, key[1] + kWeyl1};
  }
  return c;
}

// Counter: the block's number, the purpose, the element; key: the seed.
Random::Random(std::uint64_t seed, std::uint32_t purpose, std::uint64_t element)
    : counter_{0, purpose, std::uint32_t(element), std::uint32_t(element >> 32)},
      key_{std::uint32_t(seed), std::uint32_t(seed >> 32)} {}

std::uint32_t Random::word() {
  if (used_ == 4) {
    block_ = philox(counter_, key_);
    ++counter_[0];
    used_ = 0;
  }
  return block_[std::size_t(used_++)];
}

double Random::uniform() {
  const std::uint64_t high = word() >> 5, low = word() >> 6;  // 27 and 26 bits, in this order
  return double(high << 26 | low) * 0x1p-53;
}

std::uint32_t Random::below(std::uint32_t n) {
  const std::uint32_t smallest = std::uint32_t(-n) % n;  // 2^32 mod n products are one too many
  std::uint64_t product;
  do product = std::uint64_t(word()) * n;
  while (std::uint32_t(product) < smallest);
  return std::uint32_t(product >> 32);
}

}  // namespace lode::geometry
