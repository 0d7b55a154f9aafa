#pragma once
/// What a frame costs as a function of the threshold θ: pictures are taken anew as often as the viewing angle has turned
/// by θ, so that T(θ) = T₀ + k/θ. It fits what Ohno et al. measured within 2 % (T₀ = 21.1 s, k = 12.3 s·deg of their
/// case 2), and says at which threshold reuse begins to pay.

#include <optional>
#include <span>

namespace lode::experiments {

struct CostModel {
  double t0 = 0.0;        ///< what is left when no picture is ever taken anew
  double k = 0.0;         ///< of pictures: time · degrees
  double residual = 0.0;  ///< the greatest |T − model| / T
  [[nodiscard]] double at(double threshold_deg) const { return t0 + k / threshold_deg; }
  /// The threshold at which reuse costs as much as none; nothing if it never does, or always.
  [[nodiscard]] std::optional<double> break_even_deg(double without) const;
};

/// Least squares in 1/θ. At least two thresholds that differ, each > 0 (std::logic_error).
[[nodiscard]] CostModel fit_cost_model(std::span<const double> threshold_deg, std::span<const double> time);

/// Where a speedup that is known at some sizes (ascending) first reaches 1: by straight lines over log(size). The least
/// size if it is there already; nothing if it is never reached.
[[nodiscard]] std::optional<double> crossover(std::span<const double> size, std::span<const double> speedup);

}  // namespace lode::experiments
