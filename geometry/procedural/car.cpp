#include <algorithm>
#include <cmath>

#include "geometry/procedural/parts.h"
#include "geometry/procedural/town_models.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

/// A section of a car at x: half its width, the lowest and the highest point.
struct Section {
  double x, half_width, low, high;
};

/// Lengthwise loft of rounded sections: 2·points·sections triangles.
void add_body(Mesh& mesh, const std::vector<Section>& sections, int points) {
  std::vector<std::vector<glm::dvec3>> rings;
  const auto squared = [](double v) { return std::copysign(std::sqrt(std::sqrt(std::abs(v))), v); };
  for (const Section& s : sections) {
    std::vector<glm::dvec3>& ring = rings.emplace_back();
    for (int i = 0; i < points; ++i) {  // from y to z: counter-clockwise as seen from +x
      const SinCos a = sin_cos(2.0 * kPi * (i + 0.5) / points);
      ring.emplace_back(s.x, 0.5 * (s.low + s.high) + 0.5 * (s.high - s.low) * squared(a.cos),
                        s.half_width * squared(a.sin));
    }
  }
  const auto pole = [](const Section& s) { return glm::dvec3(s.x, 0.5 * (s.low + s.high), 0.0); };
  add_loft(mesh, rings, pole(sections.front()), pole(sections.back()));
}

/// Straight lines through the corners, n sections from end to end.
std::vector<Section> refined(const std::vector<Section>& corners, int n) {
  std::vector<Section> sections;
  for (int k = 0; k < n; ++k) {
    const double x = corners.front().x + (corners.back().x - corners.front().x) * k / (n - 1.0);
    std::size_t i = 0;
    while (i + 2 < corners.size() && corners[i + 1].x < x) ++i;
    const Section &a = corners[i], &b = corners[i + 1];
    const double t = (x - a.x) / (b.x - a.x);
    const auto mix = [t](double from, double to) { return from + (to - from) * t; };
    sections.push_back({x, mix(a.half_width, b.half_width), mix(a.low, b.low), mix(a.high, b.high)});
  }
  return sections;
}

struct CarShape {
  std::vector<Section> body, cabin, roof;
  double front_axle, rear_axle;
};

CarShape shape_of(CarBody body) {
  switch (body) {
    case CarBody::hatchback:
      return {{{-1.95, .70, .40, .78},
               {-1.88, .82, .28, .92},
               {-0.9, .86, .22, .95},
               {0.6, .86, .22, .93},
               {1.3, .85, .22, .86},
               {1.85, .80, .24, .74},
               {1.98, .68, .34, .62}},
              {{-1.80, .66, .85, .96},
               {-1.45, .68, .85, 1.38},
               {-0.9, .68, .85, 1.44},
               {-0.1, .68, .85, 1.45},
               {0.35, .67, .85, 1.36},
               {1.15, .64, .80, .90}},
              {{-1.48, .60, 1.36, 1.42}, {-0.9, .63, 1.38, 1.485}, {-0.1, .63, 1.38, 1.49}, {0.28, .60, 1.34, 1.42}},
              1.25,
              -1.25};
    case CarBody::saloon:
      return {{{-2.25, .70, .42, .80},
               {-2.15, .82, .28, .92},
               {-1.3, .87, .22, .96},
               {0.6, .88, .22, .94},
               {1.5, .86, .22, .86},
               {2.1, .81, .24, .74},
               {2.25, .68, .34, .62}},
              {{-1.60, .64, .85, .97},
               {-0.95, .67, .85, 1.36},
               {-0.5, .68, .85, 1.42},
               {0.05, .68, .85, 1.42},
               {0.45, .67, .85, 1.33},
               {1.20, .64, .80, .92}},
              {{-1.00, .60, 1.33, 1.40}, {-0.5, .63, 1.36, 1.465}, {0.05, .63, 1.36, 1.465}, {0.40, .60, 1.31, 1.39}},
              1.42,
              -1.38};
    case CarBody::van:
      break;
  }
  return {{{-2.35, .80, .40, 1.95},
           {-2.28, .94, .28, 2.05},
           {-1.2, .96, .24, 2.08},
           {0.95, .96, .24, 2.05},
           {1.05, .95, .24, 1.16},
           {1.9, .92, .24, 1.02},
           {2.30, .84, .28, .84},
           {2.38, .70, .38, .66}},
          {{0.80, .84, 1.10, 1.94}, {1.02, .84, 1.10, 1.92}, {1.25, .83, 1.08, 1.62}, {1.62, .80, 1.00, 1.12}},
          {{-2.2, .86, 2.02, 2.09}, {-1.2, .88, 2.02, 2.12}, {0.6, .88, 2.02, 2.10}, {0.92, .80, 1.98, 2.03}},
          1.45,
          -1.45};
}

/// Tyre (2·24·10 triangles) and rim (2·24·4).
void add_wheel(Mesh& rubber, Mesh& metal, double x, double side, double half_track) {
  constexpr double kRadius = 0.31;
  const glm::dvec3 inner(x, kRadius, side * (half_track - 0.20)), outer(x, kRadius, side * half_track);
  const glm::dvec2 tyre[] = {{.20, .0},  {.27, .0},   {.295, .012}, {.308, .04}, {.31, .07},
                             {.31, .13}, {.308, .16}, {.295, .19},  {.27, .202}, {.21, .20}};
  add_turned(rubber, tyre, 24, frame_along(inner, outer));
  const glm::dvec2 rim[] = {{.19, .19}, {.195, .206}, {.15, .207}, {.05, .222}};
  add_turned(metal, rim, 24, frame_along(inner, outer));
}

}  // namespace

Model car(CarBody body, const Material& paint_of_body) {
  Model model{.name = "car", .surfaces = {}};
  const Material glass = paint("car glass", 0.025f, 0.035f, 0.045f), rubber = paint("rubber", 0.018f, 0.018f, 0.02f),
                 metal = paint("chrome", 0.55f, 0.56f, 0.58f), red = paint("tail light", 0.55f, 0.02f, 0.02f),
                 white = paint("headlight", 0.85f, 0.85f, 0.78f);
  for (const Material& m : {paint_of_body, glass, rubber, metal, red, white}) (void)model.surface(m);
  const CarShape shape = shape_of(body);
  add_body(model.surface(paint_of_body), refined(shape.body, 28), 24);  // 1344 triangles
  add_body(model.surface(glass), shape.cabin, 24);
  add_body(model.surface(paint_of_body), refined(shape.roof, 8), 20);  // 320
  const double half = std::max(shape.body[2].half_width, shape.body[3].half_width);
  const Section front = shape.body.back(), rear = shape.body.front();
  for (const double side : {-1.0, 1.0}) {
    for (const double x : {shape.front_axle, shape.rear_axle}) {
      add_wheel(model.surface(rubber), model.surface(metal), x, side, half + 0.015);
    }
    const double z = side * 0.58 * half;
    add_superellipsoid(model.surface(white), {front.x - 0.06, front.high - 0.05, z}, {0.10, 0.065, 0.14}, {3, 3}, 8, 6);
    add_superellipsoid(model.surface(red), {rear.x + 0.05, rear.high - 0.09, z}, {0.07, 0.08, 0.12}, {2, 2}, 8, 6);
    add_superellipsoid(model.surface(paint_of_body), {0.72, 1.02, side * (half + 0.07)}, {0.06, 0.06, 0.10}, {3, 3}, 8,
                       6);
  }
  Mesh& trim = model.surface(rubber);
  add_rounded_box(trim, {front.x - 0.10, 0.26, -0.62}, {front.x + 0.05, 0.42, 0.62}, 0.05, 8, 6);  // 96
  add_rounded_box(trim, {rear.x - 0.05, 0.28, -0.62}, {rear.x + 0.10, 0.44, 0.62}, 0.05, 8, 6);
  add_block(model.surface(metal), {front.x + 0.045, 0.30, -0.26}, {front.x + 0.058, 0.41, 0.26});
  add_block(model.surface(metal), {rear.x - 0.058, 0.46, -0.26}, {rear.x + 0.06, 0.57, 0.26});
  fill_up(model, model.surface(glass), kCarTriangles);
  return model;
}

}  // namespace lode::geometry
