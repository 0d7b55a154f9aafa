#include "geometry/procedural/room_models.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/procedural/parts.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

/// Books from x0 to x1 on a board at y, some leaning a little back: 12 triangles each, until the model has `most`.
void add_books(Model& model, const std::vector<Material>& covers, double x0, double x1, double y, Random& random,
               std::size_t most) {
  for (double x = x0; n_triangles(model) + 12 <= most;) {
    const double thickness = random.uniform(0.016, 0.034), height = random.uniform(0.17, 0.255);
    const double depth = random.uniform(0.14, 0.20), gap = random.below(24) == 0 ? 0.04 : 0.0015;
    if (x + thickness > x1) break;
    const Material& cover = covers[random.below(std::uint32_t(covers.size()))];
    add_block(model.surface(cover), {x, y, 0.11 - depth}, {x + thickness, y + height, 0.11});
    x += thickness + gap;
  }
}

/// A frame of four bars with a field inside, and a knob: 600 triangles.
void add_panelled_door(Mesh& wood, Mesh& metal, double x0, double x1, double y0, double y1, double z, double knob_x) {
  constexpr double kRail = 0.07;
  const auto bar = [&](double a, double b, double c, double d) {
    add_rounded_box(wood, {a, c, z}, {b, d, z + 0.022}, 0.006, 8, 6);
  };
  bar(x0, x0 + kRail, y0, y1);
  bar(x1 - kRail, x1, y0, y1);
  bar(x0 + kRail, x1 - kRail, y0, y0 + kRail);
  bar(x0 + kRail, x1 - kRail, y1 - kRail, y1);
  add_rounded_box(wood, {x0 + kRail - 0.01, y0 + kRail - 0.01, z}, {x1 - kRail + 0.01, y1 - kRail + 0.01, z + 0.012},
                  0.005, 8, 6);
  const glm::dvec2 knob[] = {{.008, 0}, {.007, .012}, {.015, .02}, {.017, .028}, {.012, .035}};
  const glm::dvec3 at(knob_x, 0.5 * (y0 + y1), z + 0.02);
  add_turned(metal, knob, 12, frame_along(at, at + glm::dvec3(0, 0, 1)));
}

/// A long leaf that bends down, in a chain of quads, shaded as if round.
void add_frond(Mesh& mesh, const glm::dvec3& from, double yaw, double length, double rise, double width, int n) {
  const SinCos a = sin_cos(yaw);
  const glm::dvec3 out(a.sin, 0.0, a.cos), across(a.cos, 0.0, -a.sin);
  const auto middle = [&](int k) {
    const double t = double(k) / n;
    return from + out * (length * t * (1.0 - 0.25 * t)) + glm::dvec3(0, rise * t - 0.75 * rise * t * t, 0);
  };
  const auto half_width = [&](int k) {
    const double t = double(k) / n;
    return across * (0.5 * width * (k == n ? 0.04 : 0.25 + 3.0 * t * (1.0 - t)));
  };
  for (int k = 0; k < n; ++k) {
    add_quad(mesh, middle(k) - half_width(k), middle(k) + half_width(k), middle(k + 1) + half_width(k + 1),
             middle(k + 1) - half_width(k + 1));
    const glm::dvec3 slope = glm::normalize(middle(k + 1) - middle(k));
    const glm::dvec3 normal = glm::cross(slope, across);
    const glm::dvec3 up = normal.y < 0.0 ? -normal : normal;
    for (const double side : {-0.35, 0.35, 0.35, -0.35}) {
      mesh.normals.emplace_back(glm::normalize(up + side * across));
    }
  }
}

}  // namespace

Model bookcase(std::uint64_t seed) {
  Model model{.name = "bookcase", .surfaces = {}};
  const Material wood = paint("walnut", 0.20f, 0.105f, 0.05f);
  const std::vector<Material> covers = {
      paint("book red", 0.36f, 0.05f, 0.04f),     paint("book green", 0.06f, 0.18f, 0.09f),
      paint("book blue", 0.06f, 0.10f, 0.26f),    paint("book ochre", 0.46f, 0.29f, 0.08f),
      paint("book ivory", 0.58f, 0.53f, 0.41f),   paint("book brown", 0.19f, 0.09f, 0.05f),
      paint("book black", 0.035f, 0.033f, 0.035f)};
  (void)model.surface(wood);
  for (const Material& m : covers) (void)model.surface(m);
  Mesh& frame = model.surface(wood);
  constexpr double kHalf = 0.55, kHigh = 2.1, kBoard = 0.022;
  add_rounded_box(frame, {-kHalf, 0.0, -0.16}, {-kHalf + 0.025, kHigh, 0.16}, 0.006, 12, 6);
  add_rounded_box(frame, {kHalf - 0.025, 0.0, -0.16}, {kHalf, kHigh, 0.16}, 0.006, 12, 6);
  add_rounded_box(frame, {-kHalf - 0.03, kHigh - 0.01, -0.16}, {kHalf + 0.03, kHigh + 0.04, 0.19}, 0.015, 16, 8);
  add_block(frame, {-kHalf + 0.01, 0.05, -0.158}, {kHalf - 0.01, kHigh - 0.005, -0.145});
  add_block(frame, {-kHalf + 0.02, 0.0, 0.10}, {kHalf - 0.02, 0.085, 0.12});
  Random random(seed, 0x626f6f6b);
  for (int row = 0; row < 7; ++row) {
    const double y = 0.08 + 0.288 * row;
    add_rounded_box(frame, {-kHalf + 0.02, y, -0.15}, {kHalf - 0.02, y + kBoard, 0.145}, 0.006, 8, 4);
    add_books(model, covers, -kHalf + 0.03, kHalf - 0.03, y + kBoard, random, kShelfTriangles);
  }
  fill_up(model, frame, kShelfTriangles);
  return model;
}

Model cupboard() {
  Model model{.name = "cupboard", .surfaces = {}};
  const Material wood = paint("cherry", 0.33f, 0.13f, 0.06f), brass = paint("brass", 0.52f, 0.38f, 0.13f);
  for (const Material& m : {wood, brass}) (void)model.surface(m);
  Mesh &body = model.surface(wood), &metal = model.surface(brass);
  add_rounded_box(body, {-0.60, 0.09, -0.25}, {0.60, 1.86, 0.22}, 0.012, 16, 8);
  add_rounded_box(body, {-0.65, 1.855, -0.26}, {0.65, 1.93, 0.28}, 0.03, 32, 8);
  add_rounded_box(body, {-0.62, 0.05, -0.25}, {0.62, 0.12, 0.25}, 0.02, 16, 8);
  const glm::dvec2 foot[] = {{.03, 0}, {.045, .012}, {.05, .03}, {.045, .05}, {.03, .06}};
  for (const double x : {-0.55, 0.55}) {
    for (const double z : {-0.2, 0.2}) add_turned(body, foot, 12, turned_frame({x, 0, z}, 0.0));
    const double x0 = std::min(0.0, x) + 0.006 + (x < 0 ? -0.035 : 0.0),
                 x1 = std::max(0.0, x) - 0.006 + (x > 0 ? 0.035 : 0);
    add_panelled_door(body, metal, x0, x1, 0.62, 1.82, 0.218, x < 0 ? -0.045 : 0.045);
    add_panelled_door(body, metal, x0, x1, 0.38, 0.60, 0.218, 0.5 * (x0 + x1));
    add_panelled_door(body, metal, x0, x1, 0.14, 0.36, 0.218, 0.5 * (x0 + x1));
  }
  fill_up(model, body, kShelfTriangles);
  return model;
}

Model potted_plant(std::uint64_t seed) {
  Model model{.name = "plant", .surfaces = {}};
  const Material clay = paint("terracotta", 0.45f, 0.17f, 0.08f), earth = paint("earth", 0.06f, 0.04f, 0.03f);
  Material green = two_sided(paint("fronds", 0.07f, 0.22f, 0.06f));
  green.alpha_mode = AlphaMode::mask;
  for (const Material& m : {clay, earth, green}) (void)model.surface(m);
  const glm::dvec2 pot[] = {{.15, 0},   {.165, .02}, {.19, .16},  {.21, .30}, {.235, .31},
                            {.24, .34}, {.235, .36}, {.21, .362}, {.205, .35}};
  add_turned(model.surface(clay), pot, 40, glm::dmat4(1.0));  // 720 triangles
  add_turned(model.surface(earth), std::vector<glm::dvec2>{{.204, .345}, {.18, .356}, {.08, .37}}, 40, glm::dmat4(1.0));
  Random random(seed, 0x706c616e);
  Mesh& fronds = model.surface(green);
  constexpr int kPieces = 16;
  for (int k = 0; n_triangles(model) + 2 * kPieces <= kPlantTriangles; ++k) {
    const double yaw = 2.399963229728653 * k + random.uniform(-0.25, 0.25);  // golden angle
    const double t = double(k) / 156.0, from = random.uniform(0.0, 0.05);
    const SinCos a = sin_cos(yaw);
    const double length = 0.30 + 0.38 * (1.0 - t) + random.uniform(0.0, 0.08),
                 rise = 0.5 + 1.9 * t + random.uniform(0.0, 0.4);
    add_frond(fronds, {from * a.sin, 0.36, from * a.cos}, yaw, length, rise, 0.075, kPieces);
  }
  fill_up(model, model.surface(clay), kPlantTriangles);
  return model;
}

Model standard_lamp() {
  Model model{.name = "lamp", .surfaces = {}};
  const Material brass = paint("brass", 0.52f, 0.38f, 0.13f), shade = paint("lampshade", 0.80f, 0.70f, 0.48f);
  for (const Material& m : {brass, shade}) (void)model.surface(m);
  const glm::dvec2 stand[] = {{.16, 0},     {.165, .01}, {.16, .025}, {.12, .035}, {.05, .05},
                              {.03, .07},   {.022, .12}, {.018, .3},  {.03, .34},  {.035, .37},
                              {.03, .40},   {.016, .44}, {.014, .7},  {.013, 1.0}, {.022, 1.03},
                              {.022, 1.07}, {.012, 1.1}, {.012, 1.3}, {.02, 1.33}, {.02, 1.4}};
  add_turned(model.surface(brass), stand, 40, glm::dmat4(1.0));  // 1600 triangles
  std::vector<std::vector<glm::dvec3>> shade_rings;              // pleated
  for (const glm::dvec2& p : {glm::dvec2(.24, 1.215), {.20, 1.38}, {.15, 1.58}}) {
    std::vector<glm::dvec3>& ring = shade_rings.emplace_back();
    for (int i = 0; i < 96; ++i) {
      const SinCos a = sin_cos(2.0 * kPi * (i + 0.5) / 96);
      const double r = p.x * (i % 2 == 0 ? 1.0 : 0.965);
      ring.emplace_back(r * a.sin, p.y, r * a.cos);
    }
  }
  add_loft(model.surface(shade), shade_rings, {0, 1.24, 0}, {0, 1.575, 0});                  // 576
  add_superellipsoid(model.surface(shade), {0, 1.215, 0}, {.05, .06, .05}, {4, 4}, 24, 12);  // 576, the bulb
  fill_up(model, model.surface(brass), kRoomLampTriangles);
  return model;
}

}  // namespace lode::geometry
