#include "experiments/image_reuse/cost_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lode::experiments {

std::optional<double> CostModel::break_even_deg(double without) const {
  if (!(k > 0.0) || !(without > t0)) return std::nullopt;
  return k / (without - t0);
}

CostModel fit_cost_model(std::span<const double> threshold_deg, std::span<const double> time) {
  if (threshold_deg.size() != time.size()) throw std::logic_error("cost model: as many times as thresholds");
  const auto n = double(time.size());
  double x_sum = 0.0, y_sum = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (!(threshold_deg[i] > 0.0)) throw std::logic_error("cost model: thresholds above 0");
    const double x = 1.0 / threshold_deg[i];
    x_sum += x, y_sum += time[i], xx += x * x, xy += x * time[i];
  }
  const double spread = n * xx - x_sum * x_sum;
  if (!(spread > 0.0)) throw std::logic_error("cost model: at least two thresholds");
  CostModel model;
  model.k = (n * xy - x_sum * y_sum) / spread;
  model.t0 = (y_sum - model.k * x_sum) / n;
  for (std::size_t i = 0; i < time.size(); ++i) {
    model.residual = std::max(model.residual, std::abs(model.at(threshold_deg[i]) - time[i]) / time[i]);
  }
  return model;
}

std::optional<double> crossover(std::span<const double> size, std::span<const double> speedup) {
  for (std::size_t i = 0; i < size.size(); ++i) {
    if (speedup[i] < 1.0) continue;
    if (i == 0) return size[0];
    const double part = (1.0 - speedup[i - 1]) / (speedup[i] - speedup[i - 1]);
    return std::exp(std::log(size[i - 1]) + part * (std::log(size[i]) - std::log(size[i - 1])));
  }
  return std::nullopt;
}

}  // namespace lode::experiments
