#pragma once
/// The area of a union of shapes in a plane, measured on equally spaced upright lines: on each line the shapes are
/// intervals, and these are united. Onozawa & Kitazawa, sec. 2.1 (silhouette areas in O(|S|)); in contrast to the
/// paper, which does not say it, shapes that overlap count once.

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace lode::techniques::convex_culling {

/// n lines in the middles of n strips from left to right.
struct Lines {
  double left = 0.0;
  double right = 0.0;
  int n = 0;

  [[nodiscard]] double spacing() const { return n > 0 ? (right - left) / double(n) : 0.0; }
  [[nodiscard]] double x(int i) const { return left + (double(i) + 0.5) * spacing(); }
  /// The first line at `x` or right of it, 0…n.
  [[nodiscard]] int first_from(double x) const;
};

/// Intervals on lines. Made to be used again: clear() keeps its memory.
class LineUnion {
 public:
  struct Interval {
    double low, high;
  };

  void clear(const Lines& lines);
  void add_triangle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);
  /// The convex hull of the points, up to rounding.
  void add_hull(std::span<const glm::dvec2> points);

  /// Sorts and unites what was added. Called by the two below; nothing may be added afterwards.
  void unite();
  /// Of the union: lengths times spacing. The error is about the perimeter times the spacing.
  [[nodiscard]] double area();
  /// Of what is in this one and not in the other. Same lines.
  [[nodiscard]] double area_without(LineUnion& other);

 private:
  void add(int line, double y0, double y1);

  Lines lines_;
  std::vector<std::vector<Interval>> on_line_;  ///< [at least lines_.n]
  bool united_ = false;
};

/// Heights over x of the convex hull of some points, rounded: lower and upper chain, each of growing x.
struct RoundedChains {
  std::vector<glm::dvec2> lower, upper;
};
/// In double, without exact signs: for areas, where a rounded corner more or less is no matter.
[[nodiscard]] RoundedChains rounded_chains(std::span<const glm::dvec2> points);
/// The chain's y at x, between its ends; `from` is an edge's index that only grows with x.
[[nodiscard]] double height(std::span<const glm::dvec2> chain, double x, std::size_t& from);

}  // namespace lode::techniques::convex_culling
