#include "raster/reference/surfel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "raster/reference/clip.h"
#include "raster/reference/surfel_bounds.h"

namespace lode::raster::reference {
namespace {

/// Relative error of z and of w with which z/w rounds within 0.501 ULP: a float's ULP is at least 2^-24 of its
/// value, so both together move it by 2^-11 ULP.
constexpr double kDepthError = 0x1p-36;
bool is_precise(const Bounded& a) { return a.error <= kDepthError * std::abs(a.value); }

/// Infinities are read as ±2^128 (frame.h).
double read(float x) { return std::clamp(double(x), -0x1p128, 0x1p128); }

bool all_finite(const glm::dmat4& m) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (!std::isfinite(m[i][j])) return false;
    }
  }
  return true;
}

/// The map in doubles, after powers of two have brought the rows and the normal near 1; not turned.
HitMap<Bounded> bounded_hit_map(const SurfelInput& s) {
  const int exponent = matrix_exponent(s.clip_from_object);
  const double longest = std::max({std::abs(s.normal.x), std::abs(s.normal.y), std::abs(s.normal.z)});
  SurfelTerms<Bounded> terms;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      terms.rows[std::size_t(i)][std::size_t(j)] = scaled(s.clip_from_object[j][i], -exponent);
    }
  }
  for (int i = 0; i < 3; ++i) {
    terms.centre[std::size_t(i)] = {s.centre[i], 0.0};
    terms.normal[std::size_t(i)] = scaled(s.normal[i], -std::ilogb(longest));
  }
  terms.radius = {s.radius, 0.0};
  terms.one = terms.w_factor = {1.0, 0.0};
  terms.half_width = {128.0 * s.viewport_size_px.x, 0.0};
  terms.half_height = {128.0 * s.viewport_size_px.y, 0.0};
  terms.w_min = scaled(kMinW, -exponent);
  return make_hit_map(terms);
}

Triple<Bounded> bounded_from_centre(const SurfelInput& s, glm::ivec2 p_fx8) {
  const Triple<double> k = from_centre(s, p_fx8);  // exact
  return {Bounded{k[0], 0.0}, Bounded{k[1], 0.0}, Bounded{k[2], 0.0}};
}

/// What the doubles know about a condition.
enum class Answer { no, yes, unknown };
Answer is_positive(const Bounded& a) {
  return surely_positive(a) ? Answer::yes : surely_not_positive(a) ? Answer::no : Answer::unknown;
}
Answer is_not_negative(const Bounded& a) {
  return surely_not_negative(a) ? Answer::yes : surely_negative(a) ? Answer::no : Answer::unknown;
}
Answer both(Answer a, Answer b) {
  if (a == Answer::no || b == Answer::no) return Answer::no;
  return a == Answer::yes && b == Answer::yes ? Answer::yes : Answer::unknown;
}

/// In front of the eye and between near and far plane at this sample's hit.
Answer hits_clip_volume(const HitMap<Bounded>& map, const Triple<Bounded>& k) {
  return both(both(is_positive(at(map.det, k)), is_not_negative(at(map.w_margin, k))),
              both(is_not_negative(at(map.z, k)), is_not_negative(at(map.gap, k))));
}

Answer hits_disc(const HitMap<Bounded>& map, const Triple<Bounded>& k) {
  const Bounded reach = at(map.reach, k);
  const Triple<Bounded> q{at(map.q[0], k), at(map.q[1], k), at(map.q[2], k)};
  return is_not_negative(reach * reach - dot(q, q));
}

/// Linear functions that are positive at the box's corners are positive in the box.
Answer box_in_clip_volume(const SurfelInput& s, const HitMap<Bounded>& map, const WindowBox& box) {
  Answer answer = Answer::yes;
  for (const int x : {box.low_fx8.x, box.high_fx8.x}) {
    for (const int y : {box.low_fx8.y, box.high_fx8.y}) {
      const Answer corner = hits_clip_volume(map, bounded_from_centre(s, {x, y}));
      if (corner == Answer::unknown) return Answer::unknown;
      if (corner == Answer::no) answer = Answer::no;
    }
  }
  return answer;
}

double value_at(const Linear<Bounded>& f, const Triple<double>& k) {
  return f[0].value * k[0] + f[1].value * k[1] + f[2].value * k[2];
}

/// Two unit vectors across a normal. Duff et al. 2017, listing 3; −0 counts as +0 here.
std::array<glm::dvec3, 2> basis_across(const glm::dvec3& normal) {
  const glm::dvec3 n = normal / std::sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
  const double sign = n.z < 0.0 ? -1.0 : 1.0;
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  return {glm::dvec3{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x}, glm::dvec3{b, sign + n.y * n.y * a, -n.y}};
}

}  // namespace

bool has_nan(const glm::vec3& centre, const glm::vec3& normal) {
  for (int i = 0; i < 3; ++i) {
    if (std::isnan(centre[i]) || std::isnan(normal[i])) return true;
  }
  return false;
}

std::optional<Surfel> make_surfel(const glm::vec3& centre, const glm::vec3& normal, float radius,
                                  const glm::dmat4& clip_from_object, glm::ivec2 viewport_origin_px,
                                  glm::ivec2 viewport_size_px) {
  if (has_nan(centre, normal) || !(radius > 0.0f) || normal == glm::vec3(0.0f)) return std::nullopt;
  if (!all_finite(clip_from_object) || viewport_size_px.x <= 0 || viewport_size_px.y <= 0) return std::nullopt;
  Surfel s;
  s.input.centre = {read(centre.x), read(centre.y), read(centre.z)};
  s.input.normal = {read(normal.x), read(normal.y), read(normal.z)};
  s.input.radius = read(radius);
  s.input.clip_from_object = clip_from_object;
  s.input.viewport_origin_px = viewport_origin_px;
  s.input.viewport_size_px = viewport_size_px;

  const std::optional<WindowBox> box = surfel_bounds(s.input);
  if (!box) return std::nullopt;
  s.low_fx8 = box->low_fx8;
  s.high_fx8 = box->high_fx8;

  // Integers take over where doubles leave w or the clipping of the box's corners open: a whole disc may lie
  // exactly in the near plane, and then each of its samples would come to them.
  s.map = bounded_hit_map(s.input);
  if (surely_negative(s.map.w)) turn(s.map);
  Answer in_clip_volume =
      is_precise(s.map.w) && surely_positive(s.map.w) ? box_in_clip_volume(s.input, s.map, *box) : Answer::unknown;
  if (in_clip_volume == Answer::unknown) {
    const std::optional<HitMap<Bounded>> map = exact_hit_map(s.input);
    if (!map) return std::nullopt;
    s.map = *map;
    in_clip_volume = box_in_clip_volume(s.input, s.map, *box);
  }
  s.inside_clip_volume = in_clip_volume == Answer::yes;
  return s;
}

bool covers(const Surfel& s, glm::ivec2 p_fx8) {
  const bool in_box =
      p_fx8.x >= s.low_fx8.x && p_fx8.x <= s.high_fx8.x && p_fx8.y >= s.low_fx8.y && p_fx8.y <= s.high_fx8.y;
  if (!in_box) return false;
  const Triple<Bounded> k = bounded_from_centre(s.input, p_fx8);
  Answer answer = hits_disc(s.map, k);
  if (!s.inside_clip_volume) answer = both(answer, hits_clip_volume(s.map, k));
  return answer == Answer::unknown ? exact_covers(s.input, p_fx8) : answer == Answer::yes;
}

PixelBox bounds_px(const Surfel& s, glm::ivec2 sample_fx8) {
  return pixels_with_samples_in(s.low_fx8, s.high_fx8, sample_fx8);
}

float depth_at(const Surfel& s, glm::ivec2 p_fx8) {
  const Bounded z = at(s.map.z, bounded_from_centre(s.input, p_fx8));
  const bool precise = is_precise(z) && is_precise(s.map.w) && surely_positive(s.map.w);  // also where z is exactly 0
  const double depth = precise ? z.value / s.map.w.value : exact_depth(s.input, p_fx8);
  return static_cast<float>(std::clamp(depth, 0.0, 1.0));
}

Footprint footprint_at(const Surfel& s, const VertexUvs& uvs, glm::ivec2 p_fx8) {
  if (uvs) return {glm::dvec2((*uvs)[0]), {0.0, 0.0}, {0.0, 0.0}};
  const Triple<double> k = from_centre(s.input, p_fx8);
  const auto& q = s.map.q;
  const double reach = value_at(s.map.reach, k);
  const glm::dvec3 hit = glm::dvec3{value_at(q[0], k), value_at(q[1], k), value_at(q[2], k)} / reach;  // |hit| ≤ 1
  // ∂(q/reach) = (∂q − (q/reach)·∂reach) / reach; one pixel further is k − 256.
  const auto moved = [&](std::size_t j) {
    return -256.0 * (glm::dvec3{q[0][j].value, q[1][j].value, q[2][j].value} - hit * s.map.reach[j].value) / reach;
  };
  const glm::dvec3 dx = moved(0), dy = moved(1);
  const std::array<glm::dvec3, 2> basis = basis_across(s.input.normal);
  const auto along = [](const glm::dvec3& a, const glm::dvec3& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; };
  const auto finite_or_0 = [](double x) { return std::isfinite(x) ? x : 0.0; };  // coefficients may leave the range
  Footprint f;
  for (int c = 0; c < 2; ++c) {
    const glm::dvec3& axis = basis[std::size_t(c)];
    f.uv[c] = std::clamp(0.5 + 0.5 * finite_or_0(along(hit, axis)), 0.0, 1.0);
    f.duv_dx[c] = finite_or_0(0.5 * along(dx, axis));
    f.duv_dy[c] = finite_or_0(0.5 * along(dy, axis));
  }
  return f;
}

}  // namespace lode::raster::reference
