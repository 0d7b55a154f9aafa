#pragma once
/// The sRGB transfer functions (IEC 61966-2-1) in MPFR, from encode(x) itself, not from its inverse.

#include <mpfr.h>

#include <array>
#include <bit>
#include <cstdint>

namespace lode::raster::test {

class SrgbOracle {
 public:
  SrgbOracle() { mpfr_inits2(256, x_, y_, static_cast<mpfr_ptr>(nullptr)); }
  ~SrgbOracle() { mpfr_clears(x_, y_, static_cast<mpfr_ptr>(nullptr)); }
  SrgbOracle(const SrgbOracle&) = delete;
  SrgbOracle& operator=(const SrgbOracle&) = delete;

  /// The float nearest to decode(code/255).
  float decode(int code) {
    mpfr_set_si(x_, code, MPFR_RNDN);
    mpfr_div_ui(x_, x_, 255, MPFR_RNDN);
    if (mpfr_cmp_d(x_, 0.04045) <= 0) {
      mpfr_mul_ui(x_, x_, 100, MPFR_RNDN);
      mpfr_div_ui(x_, x_, 1292, MPFR_RNDN);
    } else {  // ((200·x + 11)/211)^(12/5)
      mpfr_mul_ui(x_, x_, 200, MPFR_RNDN);
      mpfr_add_ui(x_, x_, 11, MPFR_RNDN);
      mpfr_div_ui(x_, x_, 211, MPFR_RNDN);
      mpfr_pow_ui(x_, x_, 12, MPFR_RNDN);
      mpfr_rootn_ui(x_, x_, 5, MPFR_RNDN);
    }
    return mpfr_get_flt(x_, MPFR_RNDN);
  }

  /// ⌊255 · encode(linear) + ½⌋ for linear in [0, 1].
  int encode(float linear) {
    mpfr_set_flt(x_, linear, MPFR_RNDN);
    if (mpfr_cmp_d(x_, 0.0031308) <= 0) {
      mpfr_mul_ui(y_, x_, 1292, MPFR_RNDN);
      mpfr_div_ui(y_, y_, 100, MPFR_RNDN);
    } else {  // (211·x^(5/12) − 11)/200
      mpfr_rootn_ui(y_, x_, 12, MPFR_RNDN);
      mpfr_pow_ui(y_, y_, 5, MPFR_RNDN);
      mpfr_mul_ui(y_, y_, 211, MPFR_RNDN);
      mpfr_sub_ui(y_, y_, 11, MPFR_RNDN);
      mpfr_div_ui(y_, y_, 200, MPFR_RNDN);
    }
    mpfr_mul_ui(y_, y_, 255, MPFR_RNDN);
    mpfr_add_d(y_, y_, 0.5, MPFR_RNDN);
    return static_cast<int>(mpfr_get_si(y_, MPFR_RNDD));
  }

  /// Element k > 0: the smallest float with encode(x) ≥ k, by bisection over the floats of [0, 1], whose bit
  /// patterns ascend with them. encode ascends, so between two of these floats the code cannot change.
  std::array<float, 256> thresholds() {
    std::array<float, 256> result{};
    for (int k = 1; k < 256; ++k) {
      std::uint32_t below = 0, at_least = 0x3F800000u;
      while (at_least - below > 1) {
        const std::uint32_t middle = below + (at_least - below) / 2;
        (encode(std::bit_cast<float>(middle)) >= k ? at_least : below) = middle;
      }
      result[std::size_t(k)] = std::bit_cast<float>(at_least);
    }
    return result;
  }

 private:
  mpfr_t x_, y_;
};

}  // namespace lode::raster::test
