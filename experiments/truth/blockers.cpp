#include "experiments/truth/blockers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>

#include "raster/parallel.h"

namespace lode::experiments::truth {
namespace {

glm::dvec2 centre(glm::ivec2 px) { return glm::dvec2(px) + 0.5; }

std::uint64_t key(raster::Ids ids) { return std::uint64_t(ids.draw) << 32 | ids.primitive; }

/// The answers by row, and how many lie in any rectangle.
class AnswerGrid {
 public:
  AnswerGrid(glm::ivec2 size_px, std::span<const Answer> answers)
      : size_px_(size_px), answers_(answers), row_(std::size_t(size_px.y) + 1) {
    for (const Answer& a : answers) ++row_[std::size_t(a.px.y) + 1];
    for (std::size_t y = 0; y < std::size_t(size_px.y); ++y) row_[y + 1] += row_[y];
  }

  /// visit(index) for each answer whose sample lies in the box, whose ends are in px.
  template <class Visit>
  void for_each_in(glm::dvec2 low, glm::dvec2 high, Visit visit) const {
    const auto first = [](double at, int n) { return int(std::clamp(std::ceil(at - 0.5), 0.0, double(n))); };
    const auto last = [](double at, int n) { return int(std::clamp(std::floor(at - 0.5), -1.0, double(n - 1))); };
    const int x0 = first(low.x, size_px_.x), x1 = last(high.x, size_px_.x);
    const int y0 = first(low.y, size_px_.y), y1 = last(high.y, size_px_.y);
    if (x0 > x1 || y0 > y1 || row_[std::size_t(y0)] == row_[std::size_t(y1) + 1]) return;
    for (int y = y0; y <= y1; ++y) {
      const auto begin = answers_.begin() + std::ptrdiff_t(row_[std::size_t(y)]);
      const auto end = answers_.begin() + std::ptrdiff_t(row_[std::size_t(y) + 1]);
      auto at = std::lower_bound(begin, end, x0, [](const Answer& a, int x) { return a.px.x < x; });
      for (; at != end && at->px.x <= x1; ++at) visit(std::size_t(at - answers_.begin()));
    }
  }

 private:
  glm::ivec2 size_px_;
  std::span<const Answer> answers_;
  std::vector<std::size_t> row_;  ///< where a row's answers begin
};

/// Whether two triangles have the same corners, in any order, under the same matrix.
bool coincide(const SourceTriangle& a, const SourceTriangle& b) {
  const auto& p = a.p_object;
  std::array<int, 3> q = {0, 1, 2};
  do {
    const auto same = [&](std::size_t i) { return p[i] == b.p_object[std::size_t(q[i])]; };
    if (same(0) && same(1) && same(2)) return *a.clip_from_object == *b.clip_from_object;
  } while (std::next_permutation(q.begin(), q.end()));
  return false;
}

/// Whether the triangle must have won where the answer, which may be of another triangle, stands. Its float depth is at
/// least that of the low end.
bool blocks(const PreparedTriangle& t, raster::Ids ids, const Answer& answer,
            const std::optional<SourceTriangle>& answered) {
  if (answer.ids == ids) return false;
  const bool before = answered && key(ids) < key(answer.ids) && coincide(t.source, *answered);
  if (answered && !before && float(t.range.high) <= answer.depth) return false;
  const glm::dvec2 sample = centre(answer.px);
  if (judge_coverage(t, sample).coverage != Coverage::in) return false;
  return !answered || before || float(judge_depth(t, sample).low) > answer.depth;
}

struct Step {
  std::size_t draw, first, end;
};

std::vector<Step> steps_of(const TriangleTable& table) {
  std::vector<Step> steps;
  for (std::size_t d = 0; d < table.n_draws(); ++d) {
    const std::size_t n = table.n_triangles(d);
    for (std::size_t first = 0; first < n; first += kTrianglesPerStep) {
      steps.push_back({d, first, std::min(n, first + kTrianglesPerStep)});
    }
  }
  return steps;
}

}  // namespace

std::size_t blocker_steps(const TriangleTable& table) { return steps_of(table).size(); }

std::vector<raster::Ids> find_blockers(const TriangleTable& table, glm::ivec2 size_px, std::span<const Answer> answers,
                                       int threads, const std::function<void()>& on_step) {
  const AnswerGrid grid(size_px, answers);
  std::vector<std::uint64_t> lowest(answers.size(), ~std::uint64_t{0});
  std::vector<std::optional<SourceTriangle>> answered;
  for (const Answer& answer : answers) answered.push_back(table.find(answer.ids));
  const std::vector<Step> steps = steps_of(table);
  raster::parallel_for(steps.size(), raster::worker_count(threads), [&](std::size_t s, int) {
    for (std::size_t i = steps[s].first; !answers.empty() && i < steps[s].end; ++i) {
      const raster::Ids ids = table.ids(steps[s].draw, i);
      const PreparedTriangle t = table.prepared(table.source(steps[s].draw, i));
      if (t.outer.n == 0) continue;
      glm::dvec2 low(HUGE_VAL), high(-HUGE_VAL);
      for (int k = 0; k < t.outer.n; ++k) {
        const glm::dvec2 p(t.outer.v[std::size_t(k)].x_px, t.outer.v[std::size_t(k)].y_px);
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
      grid.for_each_in(low, high, [&](std::size_t a) {  // what it covers in every placement lies in its own bounds
        if (!blocks(t, ids, answers[a], answered[a])) return;
        std::atomic_ref<std::uint64_t> least(lowest[a]);
        std::uint64_t seen = least.load(std::memory_order_relaxed);
        while (key(ids) < seen && !least.compare_exchange_weak(seen, key(ids), std::memory_order_relaxed)) {
        }
      });
    }
    if (on_step) on_step();
  });
  std::vector<raster::Ids> found;
  found.reserve(lowest.size());
  for (const std::uint64_t k : lowest) found.push_back({std::uint32_t(k >> 32), std::uint32_t(k)});
  return found;
}

}  // namespace lode::experiments::truth
