#include "geometry/procedural/building.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/procedural/parts.h"
#include "geometry/random.h"

namespace lode::geometry {
namespace {

constexpr double kPlinth = 0.45, kGroundFloor = 3.9, kFloor = 3.1, kParapet = 0.7;
constexpr std::size_t kTrianglesPerWindow = 18;

const Material kGlass = paint("window glass", 0.06f, 0.11f, 0.16f);
const Material kCurtain = paint("window curtain", 0.30f, 0.28f, 0.22f);
const Material kRoof = paint("roof felt", 0.14f, 0.13f, 0.13f);
const Material kDoor = paint("door", 0.16f, 0.06f, 0.04f);
const Material kMetal = paint("zinc", 0.40f, 0.42f, 0.44f);

double floor_level(const Wing& wing, int floor) {
  return wing.base_m + kPlinth + (floor == 0 ? 0.0 : kGroundFloor + (floor - 1) * kFloor);
}

/// A wall of a wing: u runs along it, out of it points `out`.
struct Wall {
  glm::dvec3 a, b, out;
  double length;
  int n_bays;

  /// Column k of the bays' grid; the ends are the corners, to the bit.
  [[nodiscard]] glm::dvec3 column(int k, double y) const {
    const glm::dvec3 p = k == n_bays ? b : a + (b - a) * (double(k) / n_bays);
    return {p.x, y, p.z};
  }
  [[nodiscard]] glm::dvec3 at(double u, double y, double out_by = 0.0) const {
    const glm::dvec3 p = a + (b - a) * (u / length) + out * out_by;
    return {p.x, y, p.z};
  }
};

std::vector<Wall> walls_of(const Wing& wing, double bay_m) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < wing.outline.size(); ++i) {
    const glm::dvec2 a = wing.outline[i], b = wing.outline[(i + 1) % wing.outline.size()];
    const glm::dvec2 along = glm::normalize(b - a);
    const double length = glm::distance(a, b);
    walls.push_back(
        {{a.x, 0.0, a.y}, {b.x, 0.0, b.y}, {-along.y, 0.0, along.x}, length, std::max(1, int(length / bay_m + 0.5))});
  }
  return walls;
}

/// A box in the world; ornaments are these.
struct Ornament {
  Bounds box;
  bool metal = false;
};

Ornament against(const Wall& wall, double u0, double u1, double y0, double y1, double from_out, double to_out) {
  Ornament ornament;
  for (const glm::dvec3& p : {wall.at(u0, y0, from_out), wall.at(u1, y1, to_out)}) ornament.box.add(p);
  return ornament;
}

/// Where the window of a bay is.
struct Opening {
  double u0, u1, y0, y1;
};
Opening opening(const Wing& wing, const Wall& wall, int bay, int floor) {
  const double width = wall.length / wall.n_bays, u = bay * width, y = floor_level(wing, floor);
  if (floor == 0) return {u + 0.12 * width, u + 0.88 * width, y + 0.35, y + 2.9};
  return {u + 0.27 * width, u + 0.73 * width, y + 0.75, y + 2.55};
}

class Builder {
 public:
  Builder(const BuildingPlan& plan, Model& model) : plan_(plan), model_(model) {
    for (const Material& m : {plan.wall, plan.trim, kGlass, kCurtain, kRoof, kDoor, kMetal}) (void)model.surface(m);
  }

  void add_shell() {
    for (const Wing& wing : plan_.wings) {
      const std::vector<Wall> walls = walls_of(wing, plan_.bay_m);
      for (const Wall& wall : walls) add_wall(wing, wall);
      add_caps(wing);
    }
  }

  /// By falling importance; within one kind from the ground up.
  [[nodiscard]] std::vector<Ornament> ornaments() const {
    std::vector<Ornament> all;
    for (const Wing& wing : plan_.wings) add_roof_ornaments(wing, all);
    for (int kind = 0; kind < kWindowKinds; ++kind) {
      for (const Wing& wing : plan_.wings) add_window_ornaments(wing, kind, all);
    }
    for (const Wing& wing : plan_.wings) add_dentils(wing, all);
    return all;
  }

  void add(const Ornament& ornament) {
    add_block(model_.surface(ornament.metal ? kMetal : plan_.trim), ornament.box.low, ornament.box.high);
  }

 private:
  static constexpr int kWindowKinds = 5;

  void add_wall(const Wing& wing, const Wall& wall) {
    Mesh& mesh = model_.surface(plan_.wall);
    const double low = wing.base_m, high = wing.base_m + wing_height(wing);
    const double first = floor_level(wing, 0), last = floor_level(wing, wing.n_floors);
    // Plinth and parapet join the bays' columns to the wall's two corners, without a gap.
    Mesh& plinth = model_.surface(plan_.trim);
    for (int k = 0; k < wall.n_bays; ++k) {
      add_corner_triangle(plinth, wall.column(0, low), wall.column(k + 1, first), wall.column(k, first));
      add_corner_triangle(mesh, wall.column(k, last), wall.column(k + 1, last), wall.column(0, high));
    }
    add_corner_triangle(plinth, wall.column(0, low), wall.column(wall.n_bays, low), wall.column(wall.n_bays, first));
    add_corner_triangle(mesh, wall.column(wall.n_bays, last), wall.column(wall.n_bays, high), wall.column(0, high));
    for (int floor = 0; floor < wing.n_floors; ++floor) {
      for (int bay = 0; bay < wall.n_bays; ++bay) add_bay(wing, wall, bay, floor);
    }
  }

  static void add_corner_triangle(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const glm::dvec3& p : {a, b, c}) mesh.positions.emplace_back(p);
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }

  /// A window: the wall around it, its reveal, its pane.
  void add_bay(const Wing& wing, const Wall& wall, int bay, int floor) {
    constexpr double kInset = 0.24;
    const double y0 = floor_level(wing, floor), y1 = floor_level(wing, floor + 1);
    const Opening o = opening(wing, wall, bay, floor);
    const glm::dvec3 outer[] = {wall.column(bay, y0), wall.column(bay + 1, y0), wall.column(bay + 1, y1),
                                wall.column(bay, y1)};
    const glm::dvec3 inner[] = {wall.at(o.u0, o.y0), wall.at(o.u1, o.y0), wall.at(o.u1, o.y1), wall.at(o.u0, o.y1)};
    glm::dvec3 pane[4];
    for (int k = 0; k < 4; ++k) pane[k] = inner[k] - wall.out * kInset;
    for (int k = 0; k < 4; ++k) {
      const int next = (k + 1) % 4;
      add_quad(model_.surface(plan_.wall), outer[k], outer[next], inner[next], inner[k]);
      add_quad(model_.surface(plan_.trim), inner[k], inner[next], pane[next], pane[k]);
    }
    add_quad(model_.surface(pane_material(wing, wall, bay, floor)), pane[0], pane[1], pane[2], pane[3]);
  }

  [[nodiscard]] const Material& pane_material(const Wing& wing, const Wall& wall, int bay, int floor) const {
    if (wing.base_m == 0.0 && floor == 0 && bay == wall.n_bays / 2) return kDoor;
    const auto place = std::uint64_t(std::int64_t(wall.a.x * 64.0) * 7919 + std::int64_t(wall.a.z * 64.0));
    Random random(plan_.seed, 0x70616e65, place * 4096 + std::uint64_t(floor) * 64 + std::uint64_t(bay));
    return floor > 0 && random.below(5) == 0 ? kCurtain : kGlass;
  }

  void add_caps(const Wing& wing) {
    const double low = wing.base_m, high = wing.base_m + wing_height(wing);
    const auto at = [&](std::size_t i, double y) { return glm::dvec3(wing.outline[i].x, y, wing.outline[i].y); };
    for (std::size_t i = 1; i + 1 < wing.outline.size(); ++i) {
      add_corner_triangle(model_.surface(kRoof), at(0, high), at(i, high), at(i + 1, high));
      add_corner_triangle(model_.surface(plan_.trim), at(0, low), at(i + 1, low), at(i, low));
    }
  }

  void add_roof_ornaments(const Wing& wing, std::vector<Ornament>& all) const {
    const double top = wing.base_m + wing_height(wing), cornice = floor_level(wing, wing.n_floors);
    Bounds plan;
    for (const glm::dvec2& p : wing.outline) plan.add({p.x, top, p.y});
    for (const Wall& wall : walls_of(wing, plan_.bay_m)) {
      all.push_back(against(wall, -0.3, wall.length + 0.3, cornice + 0.15, cornice + 0.42, -0.2, 0.32));
      all.push_back(against(wall, -0.1, wall.length + 0.1, top - 0.12, top + 0.35, -0.28, 0.10));  // parapet
      const double string = floor_level(wing, 1) - 0.1;
      all.push_back(against(wall, -0.1, wall.length + 0.1, string - 0.18, string, -0.1, 0.12));
    }
    // Stair head and ventilation, near the corner that the roof's fan starts from: inside a rectangle and an L.
    const glm::dvec2 corner = wing.outline[0];
    const glm::dvec2 in(corner.x < plan.centre().x ? 1.0 : -1.0, corner.y < plan.centre().z ? 1.0 : -1.0);
    const auto on_roof = [&](double x, double z, double w, double d, double h, bool metal) {
      Ornament o{{}, metal};
      const glm::dvec2 low = corner + in * glm::dvec2(x, z), high = corner + in * glm::dvec2(x + w, z + d);
      o.box.add({low.x, top - 0.01, low.y});
      o.box.add({high.x, top + h, high.y});
      all.push_back(o);
    };
    on_roof(2.0, 2.0, 3.2, 2.6, 2.5, false);
    on_roof(6.4, 1.8, 1.4, 1.4, 1.1, true);
    on_roof(6.4, 4.2, 1.4, 1.4, 0.9, true);
    on_roof(2.2, 5.6, 0.7, 0.7, 1.9, false);
  }

  void add_window_ornaments(const Wing& wing, int kind, std::vector<Ornament>& all) const {
    for (int floor = kind == 4 ? 1 : 0; floor < wing.n_floors; ++floor) {
      for (const Wall& wall : walls_of(wing, plan_.bay_m)) {
        for (int bay = 0; bay < wall.n_bays; ++bay)
          add_window_ornament(wall, opening(wing, wall, bay, floor), kind, bay, all);
      }
    }
  }

  static void add_window_ornament(const Wall& wall, const Opening& o, int kind, int bay, std::vector<Ornament>& all) {
    const double middle = 0.5 * (o.u0 + o.u1);
    if (kind == 0) all.push_back(against(wall, o.u0 - 0.12, o.u1 + 0.12, o.y0 - 0.12, o.y0, -0.1, 0.14));
    if (kind == 1) all.push_back(against(wall, middle - 0.035, middle + 0.035, o.y0, o.y1, -0.27, -0.17));
    if (kind == 2) all.push_back(against(wall, o.u0 - 0.15, o.u1 + 0.15, o.y1, o.y1 + 0.2, -0.1, 0.09));
    if (kind == 3) {
      const double y = 0.32 * o.y0 + 0.68 * o.y1;
      all.push_back(against(wall, o.u0, o.u1, y - 0.03, y + 0.03, -0.27, -0.17));
    }
    if (kind == 4 && bay % 2 == 1) {  // a balcony: slab, rail, balusters
      const double u0 = o.u0 - 0.2, u1 = o.u1 + 0.2, y = o.y0 - 0.3;
      all.push_back(against(wall, u0, u1, y - 0.16, y, -0.1, 1.0));
      const auto metal = [&](Ornament ornament) {
        ornament.metal = true;
        all.push_back(ornament);
      };
      metal(against(wall, u0, u1, y + 0.95, y + 1.0, 0.92, 0.98));
      for (int k = 0; k <= 10; ++k) {
        const double u = u0 + 0.03 + (u1 - u0 - 0.06) * k / 10.0;
        metal(against(wall, u - 0.015, u + 0.015, y, y + 0.95, 0.935, 0.965));
      }
    }
  }

  void add_dentils(const Wing& wing, std::vector<Ornament>& all) const {
    const double y = floor_level(wing, wing.n_floors);
    for (const Wall& wall : walls_of(wing, plan_.bay_m)) {
      const int n = int(wall.length / 0.45);
      for (int k = 0; k < n; ++k) {
        const double u = wall.length * (k + 0.5) / n;
        all.push_back(against(wall, u - 0.1, u + 0.1, y - 0.05, y + 0.15, -0.1, 0.22));
      }
    }
  }

  const BuildingPlan& plan_;
  Model& model_;
};

}  // namespace

double wing_height(const Wing& wing) { return kPlinth + kGroundFloor + (wing.n_floors - 1) * kFloor + kParapet; }

std::size_t n_windows(const BuildingPlan& plan) {
  std::size_t n = 0;
  for (const Wing& wing : plan.wings) {
    for (const Wall& wall : walls_of(wing, plan.bay_m)) n += std::size_t(wall.n_bays) * std::size_t(wing.n_floors);
  }
  return n;
}

std::size_t n_plain_triangles(const BuildingPlan& plan) {
  std::size_t n = kTrianglesPerWindow * n_windows(plan);
  for (const Wing& wing : plan.wings) {
    n += 2 * (wing.outline.size() - 2);
    for (const Wall& wall : walls_of(wing, plan.bay_m)) n += 2 * std::size_t(wall.n_bays) + 2;
  }
  return n;
}

Model building(const BuildingPlan& plan, std::size_t n) {
  Model model{.name = "building", .surfaces = {}};
  Builder builder(plan, model);
  builder.add_shell();
  constexpr std::size_t kBox = 12;
  std::size_t found = n_triangles(model);
  for (const Ornament& ornament : builder.ornaments()) {
    if (found + kBox > n) break;
    builder.add(ornament);
    found += kBox;
  }
  fill_up(model, model.surface(kRoof), n);
  return model;
}

}  // namespace lode::geometry
