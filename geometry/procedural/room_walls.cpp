#include "geometry/procedural/room_walls.h"

#include <algorithm>
#include <string>

#include "geometry/procedural/parts.h"

namespace lode::geometry {
namespace {

const Material kPlaster = paint("plaster", 0.70f, 0.66f, 0.57f);
const Material kPanel = paint("panelling", 0.52f, 0.53f, 0.47f);
const Material kJoinery = paint("white joinery", 0.74f, 0.73f, 0.70f);
const Material kBoards = paint("floor boards", 0.36f, 0.21f, 0.10f);
const Material kDarkBoards = paint("dark floor boards", 0.29f, 0.165f, 0.08f);
const Material kCeiling = paint("ceiling", 0.76f, 0.75f, 0.72f);
const Material kSky = paint("daylight", 0.60f, 0.74f, 0.88f);

/// A wall's own frame: u along it, y up, w across it. Along x, w is z; along z, w is −x, which keeps boxes boxes.
struct WallFrame {
  bool along_x;
  double at;  ///< its middle's z, or x

  [[nodiscard]] Bounds box(double u0, double u1, double y0, double y1, double w0, double w1) const {
    Bounds b;
    b.add(along_x ? glm::dvec3(u0, y0, at + w0) : glm::dvec3(at - w0, y0, u0));
    b.add(along_x ? glm::dvec3(u1, y1, at + w1) : glm::dvec3(at - w1, y1, u1));
    return b;
  }
};

void add(Mesh& mesh, const Bounds& b) { add_block(mesh, b.low, b.high); }
/// 64 triangles; a moulding, which is only bevelled, 32.
void add_rounded(Mesh& mesh, const Bounds& b, double radius) { add_rounded_box(mesh, b.low, b.high, radius, 8, 4); }
void add_moulding(Mesh& mesh, const Bounds& b, double radius) { add_rounded_box(mesh, b.low, b.high, radius, 8, 2); }

/// Where wall and ceiling meet.
void add_cornice(Model& model, const WallFrame& frame, double u0, double u1, double side) {
  const double face = side * 0.5 * kWallThickness;
  add_moulding(model.surface(kJoinery),
               frame.box(u0, u1, kRoomHeight - 0.10, kRoomHeight + 0.01, face - side * 0.01, face + side * 0.07),
               0.012);
}

/// Skirting, dado, panels and cornice on one side of the wall from u0 to u1; side is 1 or −1.
void add_panelling(Model& model, const WallFrame& frame, double u0, double u1, double side) {
  const double face = side * 0.5 * kWallThickness;
  const auto on_face = [&](double a, double b, double y0, double y1, double depth) {
    return frame.box(a, b, y0, y1, face - side * 0.01, face + side * depth);
  };
  Mesh &joinery = model.surface(kJoinery), &panel = model.surface(kPanel);
  add_moulding(joinery, on_face(u0, u1, 0.0, 0.14, 0.022), 0.008);
  add_moulding(joinery, on_face(u0, u1, 0.90, 0.96, 0.03), 0.010);
  add_cornice(model, frame, u0, u1, side);
  add(panel, on_face(u0, u1, 0.13, 0.91, 0.008));
  constexpr double kPanelWidth = 0.95;
  const int n = std::max(1, int((u1 - u0) / kPanelWidth + 0.5));
  for (int k = 0; k < n; ++k) {
    const double a = u0 + (u1 - u0) * k / n + 0.09, b = u0 + (u1 - u0) * (k + 1) / n - 0.09;
    if (b - a > 0.1) add_rounded(panel, on_face(a, b, 0.24, 0.81, 0.028), 0.008);
  }
}

/// Jambs and head around a door, on both sides of the wall.
void add_door_case(Mesh& joinery, const WallFrame& frame, double u) {
  constexpr double kCase = 0.11;
  const double half = 0.5 * kDoorWidth, w = 0.5 * kWallThickness + 0.03;
  for (const double side : {-1.0, 1.0}) {
    const double inner = u + side * (half - 0.012), outer = u + side * (half + kCase);
    add_rounded(joinery, frame.box(std::min(inner, outer), std::max(inner, outer), 0.0, kDoorHeight + 0.02, -w, w),
                0.01);
  }
  add_rounded(joinery, frame.box(u - half - kCase, u + half + kCase, kDoorHeight - 0.012, kDoorHeight + kCase, -w, w),
              0.01);
}

/// A wall from −span/2 to span/2 of n rooms with a door in each, in closed parts.
Model partition(const WallFrame& frame, int n, double room, const std::string& name, std::size_t triangles) {
  Model model{.name = name, .surfaces = {}};
  for (const Material& m : {kPlaster, kPanel, kJoinery}) (void)model.surface(m);
  Mesh& plaster = model.surface(kPlaster);
  const double half = 0.5 * kWallThickness, half_door = 0.5 * kDoorWidth, span = n * room;
  double from = -0.5 * span;
  for (int k = 0; k <= n; ++k) {
    const bool last = k == n;
    const double door = -0.5 * span + (k + 0.5) * room + kDoorOffset;
    const double to = last ? 0.5 * span : door - half_door;
    add(plaster, frame.box(from, to, 0.0, kRoomHeight, -half, half));
    for (const double side : {-1.0, 1.0}) {
      // Panels stop at the walls across, half a thickness from a room's border.
      const double border = last || k == 0 ? 0.0 : -0.5 * span + k * room;
      if (last || k == 0) {
        add_panelling(model, frame, k == 0 ? from + half : from + 0.11, last ? to - half : to - 0.11, side);
      } else {
        add_panelling(model, frame, from + 0.11, border - half, side);
        add_panelling(model, frame, border + half, to - 0.11, side);
      }
    }
    if (last) break;
    add(plaster, frame.box(door - half_door, door + half_door, kDoorHeight, kRoomHeight, -half, half));
    add_door_case(model.surface(kJoinery), frame, door);
    for (const double side : {-1.0, 1.0})
      add_cornice(model, frame, door - half_door - 0.11, door + half_door + 0.11, side);
    from = door + half_door;
  }
  fill_up(model, plaster, triangles);
  return model;
}

/// An outer wall as a sheet of quads around windows, seen from its side w > 0 (side 1) or w < 0 (side −1): the corners
/// come counter-clockwise as seen from w > 0.
void add_outer_wall(Model& model, const WallFrame& frame, int n, double room, double side) {
  constexpr double kLow = 1.0, kHigh = 2.4, kHalf = 0.8, kReveal = 0.18;
  const double span = n * room, face = 0.0;
  Mesh& plaster = model.surface(kPlaster);
  const auto at = [&](double u, double y, double w) {
    return frame.along_x ? glm::dvec3(u, y, frame.at + w) : glm::dvec3(frame.at - w, y, u);
  };
  const auto quad = [&](Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                        const glm::dvec3& d) { side > 0.0 ? add_quad(mesh, a, b, c, d) : add_quad(mesh, d, c, b, a); };
  for (int k = 0; k < n; ++k) {
    const double u0 = -0.5 * span + k * room, u1 = u0 + room, m = 0.5 * (u0 + u1);
    const glm::dvec2 outer[] = {{u0, 0.0}, {u1, 0.0}, {u1, kRoomHeight}, {u0, kRoomHeight}};
    const glm::dvec2 inner[] = {{m - kHalf, kLow}, {m + kHalf, kLow}, {m + kHalf, kHigh}, {m - kHalf, kHigh}};
    const double deep = -side * kReveal;
    for (int e = 0; e < 4; ++e) {
      const int f = (e + 1) % 4;
      quad(plaster, at(outer[e].x, outer[e].y, face), at(outer[f].x, outer[f].y, face),
           at(inner[f].x, inner[f].y, face), at(inner[e].x, inner[e].y, face));
      quad(model.surface(kJoinery), at(inner[e].x, inner[e].y, face), at(inner[f].x, inner[f].y, face),
           at(inner[f].x, inner[f].y, deep), at(inner[e].x, inner[e].y, deep));
    }
    quad(model.surface(kSky), at(inner[0].x, inner[0].y, deep), at(inner[1].x, inner[1].y, deep),
         at(inner[2].x, inner[2].y, deep), at(inner[3].x, inner[3].y, deep));
    Mesh& joinery = model.surface(kJoinery);
    add(joinery, frame.box(m - 0.025, m + 0.025, kLow, kHigh, 0.8 * deep, 0.5 * deep));
    for (const double y : {kLow + 0.03, 1.9, kHigh - 0.03}) {
      add_moulding(joinery, frame.box(m - kHalf, m + kHalf, y - 0.025, y + 0.025, 0.8 * deep, 0.5 * deep), 0.008);
    }
    add_rounded(joinery, frame.box(m - kHalf - 0.1, m + kHalf + 0.1, kLow - 0.05, kLow, 0.9 * deep, side * 0.10),
                0.012);
    add_rounded(joinery, frame.box(u0 + 0.08, u1 - 0.08, 0.0, 0.14, -0.01 * side, 0.02 * side), 0.008);
  }
}

void add_floor(Model& model) {
  const double x1 = 0.5 * kRoomsX * kRoomX, z1 = 0.5 * kRoomsZ * kRoomZ;
  constexpr int kRows = 120,
                kPieces = 5;  // boards of 20 cm along x, in two shades, broken at a third or two of their length
  for (int k = 0; k < kRows; ++k) {
    const double a = -z1 + 2.0 * z1 * k / kRows, b = -z1 + 2.0 * z1 * (k + 1) / kRows;
    double from = -x1;
    for (int piece = 0; piece < kPieces; ++piece) {
      const double to =
          piece + 1 == kPieces ? x1 : -x1 + 2.0 * x1 * (piece + 0.3 + 0.37 * (k * 5 % 7) / 7.0 + 0.2) / kPieces;
      Mesh& mesh = model.surface((k * 7 + piece * 3) % 5 < 2 ? kDarkBoards : kBoards);
      add_quad(mesh, {from, 0.0, a}, {from, 0.0, b}, {to, 0.0, b}, {to, 0.0, a});
      from = to;
    }
  }
  add_quad(model.surface(kCeiling), {-x1, kRoomHeight, -z1}, {x1, kRoomHeight, -z1}, {x1, kRoomHeight, z1},
           {-x1, kRoomHeight, z1});
}

}  // namespace

Model partition_east_of(int column) {
  const double x = (column + 1 - 0.5 * kRoomsX) * kRoomX;
  return partition({false, x}, kRoomsZ, kRoomZ, "partition east of " + std::to_string(column), kEastPartitionTriangles);
}

Model partition_south_of(int row) {
  const double z = (row + 1 - 0.5 * kRoomsZ) * kRoomZ;
  return partition({true, z}, kRoomsX, kRoomX, "partition south of " + std::to_string(row), kSouthPartitionTriangles);
}

Model room_shell() {
  Model model{.name = "shell", .surfaces = {}};
  for (const Material& m : {kPlaster, kJoinery, kBoards, kDarkBoards, kCeiling, kSky}) (void)model.surface(m);
  const double x = 0.5 * kRoomsX * kRoomX, z = 0.5 * kRoomsZ * kRoomZ;
  add_outer_wall(model, {true, -z}, kRoomsX, kRoomX, 1.0);
  add_outer_wall(model, {true, z}, kRoomsX, kRoomX, -1.0);
  add_outer_wall(model, {false, x}, kRoomsZ, kRoomZ, 1.0);
  add_outer_wall(model, {false, -x}, kRoomsZ, kRoomZ, -1.0);
  add_floor(model);
  fill_up(model, model.surface(kCeiling), kShellTriangles);
  return model;
}

}  // namespace lode::geometry
