#include "raster/reference/line.h"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace lode::raster::reference {
namespace {

/// Half a diamond's diagonal: ½ px.
constexpr std::int64_t kHalf_fx8 = 128;

/// Turned by 45°: u = x + y, v = x − y. A diamond becomes the square |u − uₛ| < ½ px, |v − vₛ| < ½ px.
struct Turned {
  std::int64_t u, v;
};
Turned turn(glm::ivec2 p) { return {std::int64_t(p.x) + p.y, std::int64_t(p.x) - p.y}; }

/// Moving the segment by (−ε, −ε²) is moving the diamonds by (+ε, +ε²): by ε + ε² in u and ε − ε² in v, both
/// positive. So low sides become inclusive for diamonds and exclusive for points, high sides the reverse.
bool point_in_diamond(Turned p, Turned s) {
  return s.u - kHalf_fx8 < p.u && p.u <= s.u + kHalf_fx8 && s.v - kHalf_fx8 < p.v && p.v <= s.v + kHalf_fx8;
}

/// Convex sets in the plane that do not meet are separated along the normal of one of their sides. Here these
/// are u, v, and the normal of the segment.
bool segment_meets_diamond(Turned a, Turned b, Turned s) {
  if (std::max(a.u, b.u) <= s.u - kHalf_fx8 || std::min(a.u, b.u) > s.u + kHalf_fx8) return false;
  if (std::max(a.v, b.v) <= s.v - kHalf_fx8 || std::min(a.v, b.v) > s.v + kHalf_fx8) return false;

  // cross(b − a, corner − a) over the four corners runs from side − reach to side + reach; |…| < 2^52.
  const std::int64_t du = b.u - a.u, dv = b.v - a.v;
  const std::int64_t side = du * (s.v - a.v) - dv * (s.u - a.u);
  const std::int64_t reach = kHalf_fx8 * (std::abs(du) + std::abs(dv));
  // The diamond's own move adds du·(ε − ε²) − dv·(ε + ε²) = ε·(du − dv) − ε²·(du + dv), never 0.
  const bool moved_up = du != dv ? du > dv : du + dv < 0;
  if (side > reach || (side == reach && moved_up)) return false;
  if (side < -reach || (side == -reach && !moved_up)) return false;
  return true;
}

/// Where the sample projects onto the segment: n / d of the way from a to b, both exact, |…| < 2^52, held
/// to 0 ≤ n ≤ d.
struct Fraction {
  double n, d;
};
Fraction projection(const Line& line, glm::ivec2 p_fx8) {
  const std::int64_t dx = line.b_fx8.x - line.a_fx8.x, dy = line.b_fx8.y - line.a_fx8.y;
  const std::int64_t d = dx * dx + dy * dy;
  const std::int64_t n = dx * (p_fx8.x - line.a_fx8.x) + dy * (p_fx8.y - line.a_fx8.y);
  return {double(std::clamp(n, std::int64_t(0), d)), double(d)};
}

/// Weights of a and b over w, times d: not yet normalised.
std::array<double, 2> end_weights(const Line& line, const Fraction& t) {
  if (std::memcmp(&line.w_a, &line.w_b, sizeof line.w_a) == 0) return {t.d - t.n, t.n};
  return {(t.d - t.n) / line.w_a, t.n / line.w_b};
}

double mix(double b0, double x0, double b1, double x1) {
  return std::clamp(b0 * x0 + b1 * x1, std::min(x0, x1), std::max(x0, x1));
}

}  // namespace

std::optional<Line> make_line(const WindowVertex& a, const WindowVertex& b) {
  if (a.p_fx8 == b.p_fx8) return std::nullopt;
  Line line;
  line.a_fx8 = a.p_fx8;
  line.b_fx8 = b.p_fx8;
  line.z_a = a.z;
  line.z_b = b.z;
  line.w_a = a.w;
  line.w_b = b.w;
  return line;
}

bool exits_diamond(const Line& line, glm::ivec2 p_fx8) {
  const Turned a = turn(line.a_fx8), b = turn(line.b_fx8), s = turn(p_fx8);
  return segment_meets_diamond(a, b, s) && !point_in_diamond(b, s);
}

std::optional<glm::ivec2> fragment_in_column(const Line& line, int major, int column, glm::ivec2 sample_fx8) {
  // A line no steeper than 45° that misses a diamond on the middle of its column misses all of it. So the only
  // candidate is the row in which the line crosses the column's middle. It is this row or the one before: the
  // division rounds towards 0, so up where it is negative; and exactly between two rows ε decides.
  const int minor = 1 - major;
  const glm::ivec2 d = line.b_fx8 - line.a_fx8;
  const std::int64_t along = std::int64_t(column) * 256 + sample_fx8[major] - line.a_fx8[major];
  const std::int64_t crossing = line.a_fx8[minor] + along * d[minor] / d[major];
  const int row = int((crossing - sample_fx8[minor] + kHalf_fx8) >> 8);
  for (const int candidate : {row, row - 1}) {
    glm::ivec2 pixel;
    pixel[major] = column;
    pixel[minor] = candidate;
    if (exits_diamond(line, sample_position_fx8(pixel, sample_fx8))) return pixel;
  }
  return std::nullopt;
}

LineColumns columns_of(const Line& line, glm::ivec2 sample_fx8) {
  const glm::ivec2 d = line.b_fx8 - line.a_fx8;
  LineColumns columns;
  columns.major = std::abs(d.x) >= std::abs(d.y) ? 0 : 1;
  columns.forward = d[columns.major] > 0;
  const PixelBox box = bounds_px(line, sample_fx8);
  columns.begin = box.begin_px[columns.major];
  columns.end = box.end_px[columns.major];
  // Columns that the segment crosses from side to side have a fragment. At most two at either end may not.
  const auto has_fragment = [&](int k) { return fragment_in_column(line, columns.major, k, sample_fx8).has_value(); };
  while (columns.begin < columns.end && !has_fragment(columns.begin)) ++columns.begin;
  while (columns.begin < columns.end && !has_fragment(columns.end - 1)) --columns.end;
  return columns;
}

std::uint64_t fragment_count(const Line& line, glm::ivec2 sample_fx8) {
  const LineColumns columns = columns_of(line, sample_fx8);
  return std::uint64_t(columns.end - columns.begin);
}

PixelBox bounds_px(const Line& line, glm::ivec2 sample_fx8) {
  const glm::ivec2 a = line.a_fx8, b = line.b_fx8;
  const int half = int(kHalf_fx8);
  return pixels_with_samples_in({std::min(a.x, b.x) - half, std::min(a.y, b.y) - half},
                                {std::max(a.x, b.x) + half, std::max(a.y, b.y) + half}, sample_fx8);
}

float depth_at(const Line& line, glm::ivec2 p_fx8) {
  const Fraction t = projection(line, p_fx8);
  const double z = ((t.d - t.n) * line.z_a + t.n * line.z_b) / t.d;  // C5: by division, in this order
  return static_cast<float>(std::clamp(z, std::min(line.z_a, line.z_b), std::max(line.z_a, line.z_b)));
}

VertexWeights weights_at(const Line& line, glm::ivec2 p_fx8) {
  const auto [q_a, q_b] = end_weights(line, projection(line, p_fx8));
  const double sum = q_a + q_b;
  VertexWeights own;
  for (std::size_t i = 0; i < own.size(); ++i) own[i] = mix(q_a / sum, line.weights_a[i], q_b / sum, line.weights_b[i]);
  return own;
}

Footprint footprint_at(const Line& line, const VertexUvs& uvs, glm::ivec2 p_fx8) {
  if (!uvs) return {};
  const Fraction t = projection(line, p_fx8);
  const auto [q_a, q_b] = end_weights(line, t);
  const double sum = q_a + q_b;
  // u = (q_a·u_a + q_b·u_b) / (q_a + q_b) with q linear in n/d, so ∂u/∂(n/d) = (u_b − u_a)·(d/w_a)·(d/w_b) / sum².
  const double q_a_at_a = end_weights(line, {0.0, t.d})[0], q_b_at_b = end_weights(line, {t.d, t.d})[1];
  const double slope = (q_a_at_a / sum) * (q_b_at_b / sum);
  const glm::dvec2 along_per_px = 256.0 * glm::dvec2(line.b_fx8 - line.a_fx8) / t.d;
  Footprint f;
  for (int c = 0; c < 2; ++c) {
    const auto end_uv = [&](const VertexWeights& w) {
      return w[0] * double((*uvs)[0][c]) + w[1] * double((*uvs)[1][c]);
    };
    const double u_a = end_uv(line.weights_a), u_b = end_uv(line.weights_b);
    f.uv[c] = mix(q_a / sum, u_a, q_b / sum, u_b);
    f.duv_dx[c] = (u_b - u_a) * slope * along_per_px.x;
    f.duv_dy[c] = (u_b - u_a) * slope * along_per_px.y;
  }
  return f;
}

}  // namespace lode::raster::reference
