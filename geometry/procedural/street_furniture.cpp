#include "geometry/procedural/parts.h"
#include "geometry/procedural/town_models.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

const Material kIron = paint("cast iron", 0.035f, 0.045f, 0.045f);
const Material kLampGlass = paint("lamp glass", 0.85f, 0.78f, 0.55f);
const Material kTimber = paint("timber", 0.33f, 0.19f, 0.09f);
const Material kStone = paint("stone", 0.46f, 0.43f, 0.37f);
const Material kWater = paint("water", 0.10f, 0.24f, 0.30f);
const Material kPoster = paint("poster", 0.62f, 0.16f, 0.10f);
const Material kShelterGlass = paint("shelter glass", 0.28f, 0.38f, 0.40f);

void add_lamp(Model& model) {
  Mesh& iron = model.surface(kIron);
  const glm::dvec2 post[] = {{.20, .0},   {.20, .08}, {.17, .10},  {.17, .45}, {.14, .50},  {.15, .54},  {.10, .60},
                             {.085, .9},  {.095, 1.}, {.08, 1.1},  {.07, 1.8}, {.065, 2.6}, {.08, 2.65}, {.065, 2.7},
                             {.055, 3.5}, {.05, 4.2}, {.07, 4.25}, {.05, 4.3}, {.045, 4.5}, {.09, 4.55}};
  add_turned(iron, post, 46, glm::dmat4(1.0));  // 1840 triangles
  for (const double side : {-1.0, 1.0}) {
    const glm::dvec3 from(0, 4.12, 0), to(side * 0.62, 4.28, 0);
    const glm::dvec2 arm[] = {{.03, .0}, {.022, .2}, {.03, .32}, {.022, .44}, {.025, .62}};
    add_turned(iron, arm, 16, frame_along(from, to));  // 160
    const glm::dvec2 cap[] = {{.05, 0}, {.20, .02}, {.20, .04}, {.12, .12}, {.03, .16}, {.02, .22}};
    add_turned(iron, cap, 24, turned_frame({to.x, 4.62, 0}, 0));                                      // 288
    add_superellipsoid(model.surface(kLampGlass), {to.x, 4.45, 0}, {.16, .19, .16}, {3, 4}, 24, 16);  // 768
  }
  const glm::dvec2 finial[] = {{.05, 4.56}, {.07, 4.62}, {.05, 4.70}, {.02, 4.85}};
  add_turned(iron, finial, 24, glm::dmat4(1.0));
}

void add_bench(Model& model) {
  Mesh& wood = model.surface(kTimber);
  for (int k = 0; k < 6; ++k) {
    const double z = -0.18 + 0.085 * k;
    add_rounded_box(wood, {-0.9, 0.42, z}, {0.9, 0.46, z + 0.065}, 0.015, 16, 8);  // 256 triangles
  }
  for (int k = 0; k < 5; ++k) {
    const double y = 0.52 + 0.085 * k, z = -0.22 - 0.025 * k;
    add_rounded_box(wood, {-0.9, y, z - 0.03}, {0.9, y + 0.065, z}, 0.013, 16, 8);
  }
  Mesh& iron = model.surface(kIron);
  for (const double x : {-0.72, 0.0, 0.72}) {
    add_rounded_box(iron, {x - 0.03, 0.0, 0.22}, {x + 0.03, 0.42, 0.28}, 0.02, 12, 8);  // 192
    add_rounded_box(iron, {x - 0.03, 0.36, -0.24}, {x + 0.03, 0.415, 0.30}, 0.02, 12, 8);
    add_turned(iron, std::vector<glm::dvec2>{{.03, 0}, {.03, .42}, {.028, .7}, {.022, .96}}, 20,
               frame_along({x, 0.0, -0.20}, {x, 0.93, -0.36}));
  }
}

void add_shelter(Model& model) {
  Mesh& iron = model.surface(kIron);
  for (const double x : {-1.9, -0.65, 0.65, 1.9}) {
    add_turned(iron, std::vector<glm::dvec2>{{.08, 0}, {.08, .05}, {.045, .07}, {.045, 2.3}, {.07, 2.36}}, 24,
               turned_frame({x, 0.0, -0.65}, 0.0));  // 240
  }
  add_rounded_box(iron, {-2.1, 2.34, -0.85}, {2.1, 2.48, 0.85}, 0.06, 40, 12);  // 960
  for (int k = 0; k < 3; ++k) {
    const double x = -1.9 + 1.265 * k;
    add_rounded_box(model.surface(kShelterGlass), {x + 0.06, 0.25, -0.665}, {x + 1.2, 2.2, -0.645}, 0.009, 16, 8);
  }
  add_rounded_box(model.surface(kPoster), {1.84, 0.25, -0.6}, {1.96, 2.1, 0.6}, 0.05, 24, 12);  // 576
  Mesh& wood = model.surface(kTimber);
  for (int k = 0; k < 3; ++k) {
    const double z = -0.5 + 0.11 * k;
    add_rounded_box(wood, {-1.6, 0.44, z}, {1.2, 0.49, z + 0.09}, 0.02, 16, 8);
  }
  for (const double x : {-1.3, 0.9}) add_rounded_box(iron, {x - .03, 0.0, -0.5}, {x + .03, 0.445, -0.2}, 0.02, 12, 8);
}

void add_column(Model& model) {
  const glm::dvec2 base[] = {{.72, 0}, {.72, .10}, {.66, .14}, {.66, .34}, {.60, .40}};
  add_turned(model.surface(kIron), base, 48, glm::dmat4(1.0));  // 480 triangles
  const glm::dvec2 drum[] = {{.56, .40}, {.56, .9}, {.56, 1.4}, {.56, 1.9}, {.56, 2.4}, {.56, 2.8}};
  add_turned(model.surface(kPoster), drum, 48, glm::dmat4(1.0));  // 576
  std::vector<glm::dvec2> dome = {{.68, 2.80}, {.74, 2.86}, {.74, 2.92}, {.66, 2.98}};
  for (int k = 0; k < 14; ++k) {
    const SinCos a = sin_cos(0.5 * kPi * k / 14.5);
    dome.emplace_back(.60 * a.cos, 3.0 + .52 * a.sin);
  }
  dome.insert(dome.end(), {{.05, 3.56}, {.08, 3.64}, {.05, 3.72}, {.012, 3.95}});
  add_turned(model.surface(kIron), dome, 48, glm::dmat4(1.0));  // 22 rings: 2112
  for (int k = 0; k < 10; ++k) {
    const SinCos a = sin_cos(2.0 * kPi * k / 10);
    add_turned(model.surface(kIron), std::vector<glm::dvec2>{{.045, .40}, {.03, .46}, {.03, 2.7}, {.05, 2.8}}, 16,
               turned_frame({.60 * a.sin, 0.0, .60 * a.cos}, 0.0));  // 128
  }
}

void add_fountain(Model& model) {
  Mesh& stone = model.surface(kStone);
  const glm::dvec2 basin[] = {{3.2, 0},    {3.2, .10},  {3.0, .14}, {3.0, .42},
                              {3.15, .48}, {3.15, .56}, {2.8, .56}, {2.75, .50}};
  add_turned(stone, basin, 64, glm::dmat4(1.0));  // 1024 triangles
  add_turned(model.surface(kWater), std::vector<glm::dvec2>{{2.74, .505}, {2.7, .515}}, 64, glm::dmat4(1.0));
  const glm::dvec2 stem[] = {{.55, .5},  {.55, .62},  {.40, .70},   {.30, .95},   {.34, 1.1},  {.22, 1.3}, {.25, 1.5},
                             {.6, 1.62}, {1.1, 1.74}, {1.25, 1.86}, {1.25, 1.94}, {1.1, 1.94}, {.3, 1.9},  {.2, 2.0},
                             {.16, 2.3}, {.2, 2.5},   {.5, 2.6},    {.62, 2.7},   {.62, 2.76}, {.5, 2.76}, {.14, 2.72},
                             {.1, 2.9},  {.16, 3.05}, {.12, 3.2},   {.03, 3.35}};
  add_turned(stone, stem, 64, glm::dmat4(1.0));  // 3200
}

}  // namespace

Model street_furniture(StreetFurniture kind) {
  Model model{.name = {}, .surfaces = {}};
  const std::vector<Material> used = {kIron, kLampGlass, kTimber, kStone, kWater, kPoster, kShelterGlass};
  for (const Material& m : used) (void)model.surface(m);
  switch (kind) {
    case StreetFurniture::lamp:
      model.name = "lamp", add_lamp(model);
      break;
    case StreetFurniture::bench:
      model.name = "bench", add_bench(model);
      break;
    case StreetFurniture::shelter:
      model.name = "shelter", add_shelter(model);
      break;
    case StreetFurniture::column:
      model.name = "column", add_column(model);
      break;
    case StreetFurniture::fountain:
      model.name = "fountain", add_fountain(model);
      break;
  }
  fill_up(model, model.surface(kind == StreetFurniture::fountain ? kStone : kIron), kStreetFurnitureTriangles);
  return model;
}

}  // namespace lode::geometry
