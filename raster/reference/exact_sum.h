#pragma once
/// A sum of products of doubles without rounding, as a list of doubles that do not overlap (Shewchuk, Adaptive
/// Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, Discrete & Computational Geometry 18,
/// 1997). Exact as long as no product overflows or falls below 2^-969.

#include <array>
#include <cstddef>

namespace lode::raster::reference {

class ExactSum {
 public:
  /// Grow-expansion (fig. 6); zeros are dropped.
  void add(double x) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const double sum = x + terms_[i], of_term = sum - x;
      const double lost = (x - (sum - of_term)) + (terms_[i] - of_term);  // two-sum (fig. 2)
      if (lost != 0.0) terms_[n++] = lost;
      x = sum;
    }
    if (x != 0.0) terms_[n++] = x;
    n_ = n;
  }

  /// Two-product (fig. 5) with Dekker's split: no fused multiply-add.
  void add_product(double x, double y) {
    const Halves a = split(x), b = split(y);
    const double product = x * y;
    add(a.low * b.low - (((product - a.high * b.high) - a.low * b.high) - a.high * b.low));
    add(product);
  }
  void add_product(const ExactSum& sum, double y) {
    for (std::size_t i = 0; i < sum.n_; ++i) add_product(sum.terms_[i], y);
  }

  /// Within 1 ULP: terms grow, so the small ones are added first.
  [[nodiscard]] double value() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < n_; ++i) sum += terms_[i];
    return sum;
  }

 private:
  struct Halves {
    double high, low;
  };
  static Halves split(double x) {
    const double c = 134217729.0 * x;  // 2^27 + 1
    const double high = c - (c - x);
    return {high, x - high};
  }

  static constexpr std::size_t kMaxTerms = 32;  // one for each `add`
  std::array<double, kMaxTerms> terms_;
  std::size_t n_ = 0;
};

}  // namespace lode::raster::reference
