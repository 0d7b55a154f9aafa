#include "geometry/procedural/town_ground.h"

#include <algorithm>

#include "geometry/procedural/parts.h"
#include "geometry/procedural/town_plan.h"

namespace lode::geometry {
namespace {

const Material kAsphalt = paint("asphalt", 0.075f, 0.077f, 0.08f);
const Material kPaving = paint("paving", 0.30f, 0.285f, 0.26f);
const Material kLawn = paint("lawn", 0.10f, 0.21f, 0.055f);
const Material kMarking = paint("road marking", 0.72f, 0.72f, 0.68f);
constexpr double kMarkingHeight = 0.01;

/// A level rectangle seen from above.
void add_rectangle(Mesh& mesh, double x0, double z0, double x1, double z1, double y) {
  add_quad(mesh, {x0, y, z0}, {x0, y, z1}, {x1, y, z1}, {x1, y, z0});
}

/// Grid lines at the borders of blocks and streets, so that no edge meets another's middle.
std::vector<double> grid_lines(int n, double (*first_of)(int)) {
  std::vector<double> lines = {first_of(0) - kStreet};
  for (int k = 0; k < n; ++k) lines.push_back(first_of(k)), lines.push_back(first_of(k) + kBlock);
  lines.push_back(lines.back() + kStreet);
  return lines;
}

void add_asphalt(Mesh& mesh) {
  const auto x = grid_lines(kBlocksX, [](int i) { return block_square(i, 0).low.x; });
  const auto z = grid_lines(kBlocksZ, [](int j) { return block_square(0, j).low.y; });
  for (std::size_t j = 0; j + 1 < z.size(); ++j) {
    for (std::size_t i = 0; i + 1 < x.size(); ++i) add_rectangle(mesh, x[i], z[j], x[i + 1], z[j + 1], 0.0);
  }
}

void add_block_slabs(Model& model, const std::vector<int>& parks) {
  for (int k = 0; k < kBlocksX * kBlocksZ; ++k) {
    const Square s = block_square(k % kBlocksX, k / kBlocksX);
    add_block(model.surface(kPaving), {s.low.x, 0.0, s.low.y}, {s.high.x, kKerb, s.high.y});
    if (std::find(parks.begin(), parks.end(), k) == parks.end()) continue;
    const double edge = kPavement, path = 1.5, y = kKerb + 0.04;
    const glm::dvec2 c = 0.5 * (s.low + s.high);
    for (const double x : {-1.0, 1.0}) {  // four lawns with paths between them, around a place
      for (const double z : {-1.0, 1.0}) {
        const glm::dvec2 a = c + glm::dvec2(x, z) * path, b = c + glm::dvec2(x, z) * (0.5 * kBlock - edge);
        add_block(model.surface(kLawn), {std::min(a.x, b.x), kKerb - 0.02, std::min(a.y, b.y)},
                  {std::max(a.x, b.x), y, std::max(a.y, b.y)});
      }
    }
  }
}

/// The markings of one stretch of street along u, from u0 to u0 + kBlock, its middle at v.
class Stretch {
 public:
  Stretch(Mesh& mesh, double u0, double v, bool along_x) : mesh_(mesh), u0_(u0), v_(v), along_x_(along_x) {}

  void add_dashes() const {
    for (int k = 0; k < 7; ++k) rectangle(6.5 + 7.0 * k, 6.5 + 7.0 * k + 3.0, -0.07, 0.07);
  }
  void add_parking_lines() const {
    for (const double side : {-1.0, 1.0}) {
      for (int k = 0; k < 5; ++k) {
        rectangle(9.0 + 10.5 * k, 9.1 + 10.5 * k, side > 0 ? 3.7 : -5.9, side > 0 ? 5.9 : -3.7);
      }
    }
  }
  void add_crossing(double at) const {
    for (int k = 0; k < 8; ++k) rectangle(at, at + 2.6, -5.4 + 1.4 * k, -4.75 + 1.4 * k);
  }
  /// Three triangles, seen from above whichever way it lies.
  void add_arrow(double at, double v) const {
    rectangle(at, at + 2.0, v - 0.08, v + 0.08);
    const auto first = std::uint32_t(mesh_.positions.size());
    for (const glm::dvec2& p : {glm::dvec2(at + 2.0, v - 0.3), {at + 2.0, v + 0.3}, {at + 3.0, v}}) {
      mesh_.positions.emplace_back(place(p.x, p.y));
    }
    mesh_.indices.insert(mesh_.indices.end(), {first, first + (along_x_ ? 1 : 2), first + (along_x_ ? 2 : 1)});
  }

 private:
  [[nodiscard]] glm::dvec3 place(double u, double v) const {
    return along_x_ ? glm::dvec3(u0_ + u, kMarkingHeight, v_ + v) : glm::dvec3(v_ + v, kMarkingHeight, u0_ + u);
  }
  void rectangle(double u_low, double u_high, double v_low, double v_high) const {
    const glm::dvec3 a = place(u_low, v_low), b = place(u_high, v_high);
    add_rectangle(mesh_, std::min(a.x, b.x), std::min(a.z, b.z), std::max(a.x, b.x), std::max(a.z, b.z),
                  kMarkingHeight);
  }

  Mesh& mesh_;
  double u0_, v_;
  bool along_x_;
};

void add_markings(Mesh& mesh) {
  const auto add_stretch = [&](double u0, double v, bool along_x, bool inner) {
    const Stretch stretch(mesh, u0, v, along_x);
    stretch.add_dashes();
    stretch.add_parking_lines();
    if (!inner) return;
    stretch.add_crossing(1.0);
    stretch.add_crossing(kBlock - 3.6);
  };
  for (int j = 0; j <= kBlocksZ; ++j) {
    for (int i = 0; i < kBlocksX; ++i) {
      add_stretch(block_square(i, 0).low.x, street_z(j), true, j > 0 && j < kBlocksZ);
    }
  }
  for (int i = 0; i <= kBlocksX; ++i) {
    for (int j = 0; j < kBlocksZ; ++j) {
      add_stretch(block_square(0, j).low.y, street_x(i), false, false);
    }
  }
  for (int i = 0; i < 5; ++i) Stretch(mesh, block_square(i, 0).low.x, street_z(2), true).add_arrow(50.0, 1.9);
}

}  // namespace

Model town_ground(const std::vector<int>& parks) {
  Model model{.name = "ground", .surfaces = {}};
  for (const Material& m : {kAsphalt, kPaving, kLawn, kMarking}) (void)model.surface(m);
  add_asphalt(model.surface(kAsphalt));
  add_block_slabs(model, parks);
  add_markings(model.surface(kMarking));
  fill_up(model, model.surface(kAsphalt), kTownGroundTriangles);
  return model;
}

}  // namespace lode::geometry
