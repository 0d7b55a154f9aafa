#include "geometry/procedural/furniture.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/procedural/parts.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

using Profile = std::vector<glm::dvec2>;

void expect_counts(const Model& model, std::size_t triangles, std::size_t vertices) {
  expect_triangles(model, triangles);
  if (n_positions(model) == vertices) return;
  throw Error(ErrorKind::bad_input, "model " + model.name + ": expected " + std::to_string(vertices) +
                                        " vertices, found " + std::to_string(n_positions(model)));
}

/// A square with its corners cut off, as a ring of a loft along +y with x and z for its coordinates.
constexpr glm::dvec2 kOctagon[] = {{0.6, 1.0},   {1.0, 0.6},   {1.0, -0.6}, {0.6, -1.0},
                                   {-0.6, -1.0}, {-1.0, -0.6}, {-1.0, 0.6}, {-0.6, 1.0}};

/// A bar with eased edges from a to b: 32 triangles. Its width is level, its height across it.
void add_bar(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, double half_width, double half_height) {
  const glm::dmat4 frame = frame_along(a, b);
  const double length = glm::length(b - a);
  std::vector<std::vector<glm::dvec3>> rings;
  for (const double y : {0.0, length}) {
    std::vector<glm::dvec3>& ring = rings.emplace_back();
    const double w = half_width, h = half_height, e = 0.25 * std::min(w, h);
    for (const glm::dvec2& p : kOctagon) {
      const glm::dvec2 eased(p.x > 0 ? w : -w, p.y > 0 ? h : -h);
      const glm::dvec2 off = glm::dvec2(std::abs(p.x) < 1.0 ? e : 0.0, std::abs(p.y) < 1.0 ? e : 0.0) * glm::sign(p);
      ring.emplace_back(frame * glm::dvec4(eased.x - off.x, y, eased.y - off.y, 1.0));
    }
  }
  add_loft(mesh, rings, a, b);
}

/// The profile stretched to a thickness and a length.
Profile scaled(const Profile& profile, double radius, double length) {
  Profile result;
  for (const glm::dvec2& p : profile) result.emplace_back(radius * p.x, length * p.y);
  return result;
}

/// Four rings, 8 segments: 64 triangles.
const Profile kStretcher = {{0.62, 0.0}, {1.0, 0.42}, {1.0, 0.58}, {0.62, 1.0}};

/// Of unit radius and length: square-shouldered foot, a ball, a vase, rings, and the block that the apron joins.
const Profile kTableLeg = {{0.52, 0.0},  {0.70, 0.03}, {0.74, 0.07}, {0.50, 0.10}, {0.46, 0.13}, {0.60, 0.20},
                           {0.74, 0.32}, {0.82, 0.44}, {0.80, 0.53}, {0.66, 0.60}, {0.48, 0.64}, {0.46, 0.67},
                           {0.76, 0.69}, {0.78, 0.72}, {0.52, 0.74}, {0.90, 0.77}, {1.00, 0.79}, {1.00, 1.0}};

const Profile kSpindle = {{0.55, 0.0},  {0.70, 0.15}, {1.0, 0.35}, {0.85, 0.52},
                          {0.70, 0.70}, {0.60, 0.86}, {0.50, 1.0}};

const Profile kPost = {{0.60, 0.0},  {0.74, 0.02}, {0.80, 0.06}, {0.72, 0.10}, {0.82, 0.15}, {0.92, 0.22}, {0.96, 0.28},
                       {0.90, 0.33}, {0.78, 0.36}, {0.92, 0.38}, {1.00, 0.41}, {1.00, 0.45}, {0.92, 0.48}, {0.80, 0.51},
                       {0.92, 0.55}, {0.94, 0.63}, {0.88, 0.72}, {0.80, 0.82}, {0.74, 0.92}, {0.70, 1.0}};

/// The closed sheet's rim has 33 edges: an odd number of triangles, 33·(2·rings − 1).
void add_woven_seat(Mesh& mesh) {
  const int n = 33, rings = 8;
  const double half_x = 0.225, half_z = 0.215, y = 0.462, sag = 0.018;
  mesh.positions.emplace_back(0.0, y - sag, 0.0);
  const auto root = [](double x) { return x < 0.0 ? -std::sqrt(-x) : std::sqrt(x); };
  for (int j = 1; j <= rings; ++j) {
    const double r = double(j) / rings;
    for (int i = 0; i < n; ++i) {
      const SinCos a = sin_cos(2.0 * kPi * (i + 0.5) / n);
      mesh.positions.emplace_back(r * half_x * root(a.sin), y - sag * (1.0 - r * r), r * half_z * root(a.cos));
    }
  }
  const auto at = [](int i, int j) { return std::uint32_t(1 + (j - 1) * n + i % n); };
  for (int i = 0; i < n; ++i) {
    mesh.indices.insert(mesh.indices.end(), {0u, at(i, 1), at(i + 1, 1)});
    for (int j = 1; j < rings; ++j) {
      mesh.indices.insert(mesh.indices.end(), {at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.indices.insert(mesh.indices.end(), {at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
}

/// Where the chair's rear posts stand at height y: splayed below the seat, leaning back above it.
double post_z(double y) {
  const double t = (y - 0.45) / 0.5;
  return -0.195 - (t < 0.0 ? 0.05 : 0.11) * t * t;
}

/// A rear leg and the post of the back that it goes on as, of round section.
void add_rear_post(Mesh& mesh, double x) {
  const int n = 20;
  std::vector<std::vector<glm::dvec3>> rings;
  for (int j = 0; j < n; ++j) {
    const double y = 0.95 * j / (n - 1.0), radius = 0.019 - 0.006 * (y > 0.45 ? (y - 0.45) / 0.5 : (0.45 - y) / 0.45);
    std::vector<glm::dvec3>& ring = rings.emplace_back();
    for (int i = 0; i < 12; ++i) {
      const SinCos a = sin_cos(2.0 * kPi * (i + 0.5) / 12);
      ring.emplace_back(x + radius * a.sin, y, post_z(y) + radius * a.cos);
    }
  }
  add_loft(mesh, rings, {x, 0.0, post_z(0.0)}, {x, 0.95, post_z(0.95)});
}

/// A rail of the chair's back from post to post, bowed backwards: 64 triangles.
void add_back_rail(Mesh& mesh, double y, double half_height) {
  std::vector<std::vector<glm::dvec3>> rings;
  const auto z = [&](double x) { return post_z(y) - 0.02 * (1.0 - (x / 0.2) * (x / 0.2)); };
  for (const double x : {-0.2, -0.07, 0.07, 0.2}) {
    std::vector<glm::dvec3>& ring = rings.emplace_back();
    for (const glm::dvec2& p : kOctagon) ring.emplace_back(x, y + half_height * p.y, z(x) + 0.011 * p.x);
  }
  add_loft(mesh, rings, {-0.2, y, z(-0.2)}, {0.2, y, z(0.2)});
}

void add_turned_between(Mesh& mesh, const Profile& profile, double radius, const glm::dvec3& a, const glm::dvec3& b,
                        int segments) {
  add_turned(mesh, scaled(profile, radius, glm::length(b - a)), segments, frame_along(a, b));
}

/// Seven spindles from rail to rail of the chair's back, and five below them.
void add_spindles(Mesh& mesh) {
  for (int i = 0; i < 7; ++i) {
    const double x = 0.05 * (i - 3);
    add_turned_between(mesh, kSpindle, 0.009, {x, 0.66, post_z(0.64) - 0.016}, {x, 0.9, post_z(0.9) - 0.016}, 8);
  }
  for (int i = 0; i < 5; ++i) {
    const double x = 0.07 * (i - 2);
    add_turned_between(mesh, kSpindle, 0.009, {x, 0.46, post_z(0.46)}, {x, 0.625, post_z(0.625) - 0.016}, 8);
  }
}

}  // namespace

Model table() {
  Model model{.name = "table", .surfaces = {}};
  Mesh& wood = model.surface(paint("oak", 0.40f, 0.23f, 0.10f));
  const double half_x = 0.80, half_z = 0.45, leg_x = half_x - 0.09, leg_z = half_z - 0.09;
  add_rounded_box(wood, {-half_x, 0.715, -half_z}, {half_x, 0.755, half_z}, 0.019, 28, 6);  // 336 triangles
  for (const double x : {-leg_x, leg_x}) {                                                  // 4 · 576
    for (const double z : {-leg_z, leg_z}) {
      add_turned(wood, scaled(kTableLeg, 0.042, 0.716), 16, turned_frame({x, 0.0, z}, 0.0));
    }
  }
  // Aprons under the top, rails for the shelf, braces across the corners: 12 · 32.
  for (const double side : {-1.0, 1.0}) {
    // They end short of a leg's axis, so that no two ends meet.
    const double x = side * leg_x, z = side * leg_z, end_x = leg_x - 0.02, end_z = leg_z - 0.02;
    add_bar(wood, {-end_x, 0.665, z}, {end_x, 0.665, z}, 0.011, 0.049);
    add_bar(wood, {x, 0.665, -end_z}, {x, 0.665, end_z}, 0.011, 0.049);
    add_bar(wood, {-end_x, 0.205, z}, {end_x, 0.205, z}, 0.011, 0.02);
    add_bar(wood, {x, 0.205, -end_z}, {x, 0.205, end_z}, 0.011, 0.02);
    for (const double end : {-1.0, 1.0}) {
      add_bar(wood, {x - side * 0.18, 0.69, end * leg_z}, {x, 0.69, end * (leg_z - 0.18)}, 0.011, 0.02);
    }
  }
  for (int i = 0; i < 20; ++i) {  // the slats of the shelf: 20 · 32
    const double x = (i - 9.5) * 0.0655;
    add_bar(wood, {x, 0.233, -leg_z - 0.005}, {x, 0.233, leg_z + 0.005}, 0.026, 0.0075);
  }
  // Pegs through the legs into the aprons and rails, two a leg and height: 16 · 16.
  const Profile peg = {{0.007, 0.0}, {0.005, 0.006}};
  for (const double y : {0.665, 0.205}) {
    for (const double x : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) {
        const glm::dvec3 leg(x * leg_x, y, z * leg_z);
        const double reach = y > 0.5 ? 0.039 : 0.026;  // just inside the leg's surface
        const glm::dvec3 out_x = leg + glm::dvec3(x * reach, 0, 0), out_z = leg + glm::dvec3(0, 0, z * reach);
        add_turned(wood, peg, 4, frame_along(out_x, out_x + glm::dvec3(x, 0, 0)));
        add_turned(wood, peg, 4, frame_along(out_z, out_z + glm::dvec3(0, 0, z)));
      }
    }
  }
  fill_up(model, wood, 3948);
  expect_counts(model, 3948, 2080);
  return model;
}

Model chair() {
  Model model{.name = "chair", .surfaces = {}};
  add_woven_seat(model.surface(two_sided(paint("rush", 0.52f, 0.38f, 0.17f))));  // 495 triangles
  Mesh& wood = model.surface(paint("beech", 0.36f, 0.19f, 0.08f));
  const double front_x = 0.205, front_z = 0.185, rear_x = 0.19;
  const double seat = 0.44;
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 front(side * front_x, seat, front_z);
    add_turned(wood, scaled(kPost, 0.021, 0.455), 12, turned_frame({front.x, 0.0, front.z}, 0.0));  // 480 each
    add_rear_post(wood, side * rear_x);                                                             // 480 each
    // Knobs on the front legs and finials on the posts: 4 · 48.
    const Profile knob = {{0.012, 0.0}, {0.016, 0.010}, {0.008, 0.022}};
    add_turned(wood, knob, 8, turned_frame({front.x, 0.456, front.z}, 0.0));
    add_turned(wood, knob, 8, turned_frame({side * rear_x, 0.951, post_z(0.95)}, 0.0));
    // A side's seat rail (32) and two stretchers (64 each).
    const glm::dvec3 rear(side * rear_x, seat, post_z(seat));
    add_bar(wood, rear + glm::dvec3(0, 0, 0.01), front - glm::dvec3(0, 0, 0.01), 0.011, 0.021);
    for (const double y : {0.15, 0.26}) {
      add_turned_between(wood, kStretcher, 0.011, {side * rear_x, y, post_z(y)}, {side * front_x, y, front_z}, 8);
    }
  }
  add_bar(wood, {-front_x, seat, front_z}, {front_x, seat, front_z}, 0.011, 0.021);
  add_bar(wood, {-rear_x, seat, post_z(seat)}, {rear_x, seat, post_z(seat)}, 0.011, 0.021);
  add_turned_between(wood, kStretcher, 0.012, {-front_x, 0.22, front_z}, {front_x, 0.22, front_z}, 8);
  add_turned_between(wood, kStretcher, 0.012, {-rear_x, 0.2, post_z(0.2)}, {rear_x, 0.2, post_z(0.2)}, 8);
  add_back_rail(wood, 0.91, 0.032);
  add_back_rail(wood, 0.64, 0.018);
  add_spindles(wood);  // 12 · 112
  fill_up(model, wood, 4617);
  expect_counts(model, 4617, 2390);
  return model;
}

Model sofa(const Material& fabric, const Material& cushions) {
  Model model{.name = "sofa", .surfaces = {}};
  Mesh& body = model.surface(fabric);
  add_rounded_box(body, {-0.86, 0.0, -0.40}, {0.86, 0.28, 0.44}, 0.04, 40, 16);    // 1280 triangles
  add_rounded_box(body, {-0.88, 0.04, -0.48}, {0.88, 0.84, -0.22}, 0.11, 44, 20);  // 1760
  for (const double side : {-1.0, 1.0}) {                                          // 1008 each
    const double inner = side * 0.84, outer = side * 1.08;
    add_rounded_box(body, {std::min(inner, outer), 0.0, -0.46}, {std::max(inner, outer), 0.60, 0.46}, 0.10, 36, 14);
  }
  Mesh& seats = model.surface(cushions);
  for (const double x : {-0.425, 0.425}) {  // 2112 each
    add_superellipsoid(seats, {x, 0.36, 0.11}, {0.425, 0.11, 0.36}, {2, 1}, 48, 22);
  }
  expect_counts(model, 9280, 4652);
  return model;
}

}  // namespace lode::geometry
