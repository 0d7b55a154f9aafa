#include "geometry/procedural/house.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/procedural/parts.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr double kPlinth = 0.4, kFloor = 2.8, kEaves = 0.5;
constexpr std::size_t kBlock = 12;  ///< triangles

const Material kGlass = paint("house glass", 0.07f, 0.12f, 0.17f);
const Material kDoor = paint("house door", 0.20f, 0.07f, 0.05f);
const Material kBrick = paint("house brick", 0.30f, 0.12f, 0.08f);
const Material kStone = paint("house stone", 0.33f, 0.32f, 0.30f);
const Material kShutter = paint("house shutter", 0.08f, 0.17f, 0.13f);

/// A wall as its own frame: x along it, y up, z out of it, the origin at the middle of its foot.
struct Face {
  glm::dmat4 place;
  double length;
  bool front;
};

/// What is added to the model.
struct Block {
  const Material* material;
  glm::dvec3 low, high;
  glm::dmat4 place;
};
using Blocks = std::vector<Block>;

/// A window of a face: its pane, x and y in the face's frame.
struct Window {
  const Face* face;
  double x0, x1, y0, y1;
};

class House {
 public:
  explicit House(const HousePlan& plan) : plan_(plan), height_(kPlinth + kFloor * plan.n_floors) {
    const double w = plan.width_m, d = plan.depth_m;
    faces_ = {Face{turned_frame({0.0, 0.0, 0.5 * d}, 0.0), w, true},
              Face{turned_frame({0.5 * w, 0.0, 0.0}, 0.5 * kPi), d, false},
              Face{turned_frame({0.0, 0.0, -0.5 * d}, kPi), w, false},
              Face{turned_frame({-0.5 * w, 0.0, 0.0}, 1.5 * kPi), d, false}};
    for (const Face& face : faces_) add_windows(face);
  }

  [[nodiscard]] Blocks shell() const {
    const double w = 0.5 * plan_.width_m, d = 0.5 * plan_.depth_m;
    Blocks b = {{&kStone, {-w - 0.12, 0.0, -d - 0.12}, {w + 0.12, kPlinth, d + 0.12}, glm::dmat4(1.0)},
                {&plan_.wall, {-w, 0.1, -d}, {w, height_ + 0.05, d}, glm::dmat4(1.0)}};
    const double top = height_ + rise() + 0.9;
    b.push_back({&kBrick, {0.5 * w, height_ - 0.5, -0.35}, {0.5 * w + 0.8, top, 0.35}, glm::dmat4(1.0)});
    b.push_back({&kStone, {0.5 * w - 0.1, top - 0.15, -0.45}, {0.5 * w + 0.9, top + 0.05, 0.45}, glm::dmat4(1.0)});
    const Face& front = faces_[0];
    b.push_back({&kDoor, {-0.5, kPlinth, -0.1}, {0.5, kPlinth + 2.1, 0.06}, front.place});
    for (const double x : {-0.65, 0.5}) {
      b.push_back({&plan_.trim, {x, kPlinth, -0.1}, {x + 0.15, kPlinth + 2.1, 0.12}, front.place});
    }
    b.push_back({&plan_.trim, {-0.65, kPlinth + 2.1, -0.1}, {0.65, kPlinth + 2.3, 0.12}, front.place});
    for (const Window& v : windows_) {
      b.push_back({&kGlass, {v.x0, v.y0, -0.1}, {v.x1, v.y1, 0.02}, v.face->place});
    }
    if (plan_.porch) add_porch(b);
    return b;
  }

  /// By falling importance.
  [[nodiscard]] std::vector<Blocks> details() const {
    return {frames(), sills(), corner_boards(), bars(), shutters(), boards(), railings()};
  }

  /// The roof's solid: eight triangles.
  void add_roof(Mesh& mesh) const {
    const double length = 0.5 * roof_length(), span = 0.5 * roof_span(), y = height_, top = height_ + rise();
    const double ridge = plan_.roof == HouseRoof::hip ? length - span : length;
    const std::array<glm::dvec3, 6> p = {glm::dvec3{-length, y, span}, {length, y, span},  {length, y, -span},
                                         {-length, y, -span},          {-ridge, top, 0.0}, {ridge, top, 0.0}};
    const auto first = std::uint32_t(mesh.positions.size());
    for (const glm::dvec3& corner : p) mesh.positions.emplace_back(roof_place() * glm::dvec4(corner, 1.0));
    for (const std::uint32_t i : {0, 1, 5, 0, 5, 4, 2, 3, 4, 2, 4, 5, 1, 2, 5, 3, 0, 4, 0, 3, 2, 0, 2, 1}) {
      mesh.indices.push_back(first + i);
    }
  }

  /// Tiles of about that width and height.
  [[nodiscard]] Blocks tiles(const glm::dvec2& size_m) const {
    Blocks b;
    const double length = 0.5 * roof_length(), span = 0.5 * roof_span();
    const bool hip = plan_.roof == HouseRoof::hip;
    for (const double turn : {0.0, kPi}) {
      add_tiles(turned_frame({0.0, 0.0, 0.0}, turn), span, length, hip ? length - span : length, size_m, b);
      if (hip) {
        add_tiles(turned_frame({0.0, 0.0, 0.0}, turn + 0.5 * kPi), length, span, 0.0, size_m, b);
      }
    }
    return b;
  }

 private:
  [[nodiscard]] bool along_z() const { return plan_.roof == HouseRoof::front_gable; }
  [[nodiscard]] double roof_length() const { return (along_z() ? plan_.depth_m : plan_.width_m) + 2.0 * kEaves; }
  [[nodiscard]] double roof_span() const { return (along_z() ? plan_.width_m : plan_.depth_m) + 2.0 * kEaves; }
  [[nodiscard]] double rise() const { return 0.5 * roof_span() * plan_.pitch; }
  [[nodiscard]] glm::dmat4 roof_place() const { return turned_frame(glm::dvec3(0.0), along_z() ? 0.5 * kPi : 0.0); }

  void add_windows(const Face& face) {
    const int n = std::max(1, int(face.length / 2.6));
    for (int floor = 0; floor < plan_.n_floors; ++floor) {
      for (int k = 0; k < n; ++k) {
        const double x = face.length * ((k + 0.5) / n - 0.5), y = kPlinth + kFloor * floor + 0.9;
        if (face.front && floor == 0 && std::abs(x) < 1.6) continue;  // the door
        windows_.push_back({&face, x - 0.5, x + 0.5, y, y + 1.3});
      }
    }
  }

  void add_porch(Blocks& b) const {
    const glm::dmat4& front = faces_[0].place;
    const double y = kPlinth + 2.55;
    b.push_back({&kStone, {-2.0, 0.0, 0.05}, {2.0, kPlinth - 0.02, 1.9}, front});
    b.push_back({&kStone, {-0.8, 0.0, 1.8}, {0.8, 0.2, 2.3}, front});
    b.push_back({&plan_.tiles, {-2.2, y, -0.05}, {2.2, y + 0.18, 2.1}, front});
    for (const double x : {-1.9, -0.9, 0.78, 1.78}) {
      b.push_back({&plan_.trim, {x, kPlinth - 0.05, 1.65}, {x + 0.12, y + 0.05, 1.77}, front});
    }
  }

  [[nodiscard]] Blocks frames() const {
    Blocks b;
    for (const Window& v : windows_) {
      for (const double x : {v.x0 - 0.1, v.x1}) {
        b.push_back({&plan_.trim, {x, v.y0, -0.05}, {x + 0.1, v.y1, 0.08}, v.face->place});
      }
      b.push_back({&plan_.trim, {v.x0 - 0.1, v.y1, -0.05}, {v.x1 + 0.1, v.y1 + 0.12, 0.08}, v.face->place});
      b.push_back({&plan_.trim, {v.x0 - 0.1, v.y0 - 0.08, -0.05}, {v.x1 + 0.1, v.y0, 0.08}, v.face->place});
    }
    return b;
  }
  [[nodiscard]] Blocks sills() const {
    Blocks b;
    for (const Window& v : windows_) {
      b.push_back({&kStone, {v.x0 - 0.15, v.y0 - 0.16, -0.05}, {v.x1 + 0.15, v.y0 - 0.07, 0.16}, v.face->place});
    }
    return b;
  }
  [[nodiscard]] Blocks corner_boards() const {
    Blocks b;
    for (const double x : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        const glm::dvec3 corner(x * plan_.width_m, 0.0, z * plan_.depth_m);
        b.push_back({&plan_.trim, corner + glm::dvec3(-0.07, kPlinth, -0.07),
                     corner + glm::dvec3(0.07, height_ - 0.01, 0.07), glm::dmat4(1.0)});
      }
    }
    return b;
  }
  [[nodiscard]] Blocks bars() const {
    Blocks b;
    for (const Window& v : windows_) {
      const double x = 0.5 * (v.x0 + v.x1), y = 0.35 * v.y0 + 0.65 * v.y1;
      b.push_back({&plan_.trim, {x - 0.03, v.y0, -0.05}, {x + 0.03, v.y1, 0.05}, v.face->place});
      b.push_back({&plan_.trim, {v.x0, y - 0.03, -0.05}, {v.x1, y + 0.03, 0.045}, v.face->place});
    }
    return b;
  }
  [[nodiscard]] Blocks shutters() const {
    Blocks b;
    for (const Window& v : windows_) {
      for (const double x : {v.x0 - 0.55, v.x1 + 0.12}) {
        b.push_back({&kShutter, {x, v.y0, -0.05}, {x + 0.43, v.y1, 0.07}, v.face->place});
      }
    }
    return b;
  }
  /// Boards along the walls, above and below of every storey's windows.
  [[nodiscard]] Blocks boards() const {
    Blocks b;
    for (const Face& face : faces_) {
      for (int floor = 0; floor < plan_.n_floors; ++floor) {
        for (const double y : {0.12, 0.36, 0.6, 2.46, 2.62}) {
          const double low = kPlinth + kFloor * floor + y;
          if (face.front && floor == 0 && y < 2.4) continue;  // the door
          b.push_back(
              {&plan_.wall, {-0.5 * face.length, low, -0.05}, {0.5 * face.length, low + 0.1, 0.04}, face.place});
        }
      }
    }
    return b;
  }
  [[nodiscard]] Blocks railings() const {
    Blocks b;
    if (!plan_.porch) return b;
    const glm::dmat4& front = faces_[0].place;
    for (const double side : {-1.0, 1.0}) {
      const double x0 = side < 0.0 ? -1.8 : 0.9;
      b.push_back({&plan_.trim, {x0, kPlinth + 0.85, 1.66}, {x0 + 0.9, kPlinth + 0.93, 1.76}, front});
      for (int k = 1; k < 8; ++k) {
        const double x = x0 + 0.9 * k / 8.0;
        b.push_back({&plan_.trim, {x - 0.02, kPlinth - 0.05, 1.69}, {x + 0.02, kPlinth + 0.87, 1.73}, front});
      }
    }
    return b;
  }

  /// On the slope towards +z of `turn`, `run` wide in the plan, whose eaves are 2·eaves long and its ridge 2·ridge.
  void add_tiles(const glm::dmat4& turn, double run, double eaves, double ridge, const glm::dvec2& size_m,
                 Blocks& b) const {
    const double slope = run * std::sqrt(1.0 + rise() * rise() / (run * run));
    const int n_rows = std::max(1, int(slope / size_m.y));
    const glm::dvec3 down = glm::normalize(glm::dvec3(0.0, -rise(), run)), out(0.0, down.z, -down.y);
    for (int row = 0; row < n_rows; ++row) {
      const double high = double(row) / n_rows;  // of the row's upper edge, from the ridge
      const double half = ridge + (eaves - ridge) * high;
      const int n = std::max(0, int(2.0 * half / size_m.x));
      for (int k = 0; k < n; ++k) {
        const double x = half * (2.0 * (k + 0.5) / n - 1.0), width = 2.0 * half / n;
        // The lower edge lies on the next row.
        const glm::dvec3 z = glm::normalize(down + 0.12 * size_m.y * out), y = glm::normalize(glm::cross(z, {1, 0, 0}));
        glm::dmat4 place(1.0);
        place[0] = glm::dvec4(1.0, 0.0, 0.0, 0.0), place[1] = glm::dvec4(y, 0.0), place[2] = glm::dvec4(z, 0.0);
        place[3] = glm::dvec4(glm::dvec3(x, height_ + rise(), 0.0) + down * (slope * high), 1.0);
        b.push_back({&plan_.tiles,
                     {-0.48 * width, -0.02, 0.0},
                     {0.48 * width, 0.05, 1.04 * slope / n_rows},
                     roof_place() * turn * place});
      }
    }
  }

  const HousePlan& plan_;
  double height_;
  std::array<Face, 4> faces_;
  std::vector<Window> windows_;
};

void add(Model& model, const Blocks& blocks) {
  for (const Block& b : blocks) add_block(model.surface(*b.material), b.low, b.high, b.place);
}

/// The finest tiles of which there are at most so many: square ones, then as narrow as they may be.
Blocks tiles_of(const House& house, std::size_t most) {
  constexpr double kCoarsest_m = 1.2, kFinest_m = 0.08, kStep = 0.98;
  Blocks best;
  glm::dvec2 size_m(kCoarsest_m);
  for (const glm::dvec2 step : {glm::dvec2(kStep), glm::dvec2(kStep, 1.0)}) {
    for (glm::dvec2 finer_m = size_m; finer_m.x > kFinest_m; finer_m *= step) {
      Blocks finer = house.tiles(finer_m);
      if (finer.size() > most) break;
      best = std::move(finer);
      size_m = finer_m;
    }
  }
  return best;
}

}  // namespace

HousePlan house_plan(int k) {
  static const Material kWalls[] = {
      paint("house white", 0.66f, 0.65f, 0.61f), paint("house yellow", 0.60f, 0.47f, 0.22f),
      paint("house blue", 0.26f, 0.36f, 0.45f),  paint("house red", 0.42f, 0.13f, 0.09f),
      paint("house green", 0.25f, 0.36f, 0.23f), paint("house grey", 0.42f, 0.41f, 0.39f)};
  static const Material kTiles[] = {paint("roof red", 0.36f, 0.11f, 0.07f), paint("roof slate", 0.13f, 0.14f, 0.16f),
                                    paint("roof brown", 0.22f, 0.13f, 0.08f)};
  using enum HouseRoof;
  HousePlan plan;
  plan.wall = kWalls[k], plan.tiles = kTiles[k % 3], plan.trim = paint("house trim", 0.70f, 0.69f, 0.66f);
  const auto size = [&](double width_m, double depth_m, int n_floors, HouseRoof roof, double pitch, bool porch) {
    plan.width_m = width_m, plan.depth_m = depth_m, plan.n_floors = n_floors;
    plan.roof = roof, plan.pitch = pitch, plan.porch = porch;
  };
  if (k == 0) size(10.0, 8.0, 1, gable, 0.9, true);
  if (k == 1) size(8.5, 10.0, 2, front_gable, 0.8, true);
  if (k == 2) size(11.0, 9.0, 1, hip, 0.7, true);
  if (k == 3) size(9.0, 8.5, 2, hip, 0.6, true);
  if (k == 4) size(12.0, 7.5, 1, gable, 0.6, false);
  if (k == 5) size(9.5, 8.0, 2, gable, 1.0, false);
  return plan;
}

Model house(const HousePlan& plan, std::size_t n) {
  if (n < kFewestHouseTriangles || n % 2 != 0) {
    throw Error(ErrorKind::bad_input, "house: expected an even number of triangles, " +
                                          std::to_string(kFewestHouseTriangles) + " or more, found " +
                                          std::to_string(n));
  }
  Model model{.name = "house", .surfaces = {}};
  const House house(plan);
  add(model, house.shell());
  house.add_roof(model.surface(plan.tiles));
  std::size_t found = n_triangles(model);
  for (const Blocks& detail : house.details()) {
    if (found + kBlock * detail.size() > n) continue;
    add(model, detail);
    found += kBlock * detail.size();
  }
  add(model, tiles_of(house, (n - found) / kBlock));
  fill_up(model, model.surface(kStone), n);
  return model;
}

}  // namespace lode::geometry
