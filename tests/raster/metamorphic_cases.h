#pragma once
/// Metamorphic relations: what may be changed about a picture without a bit of it changing. Each function makes one
/// random case from a seed and returns the number of samples that differ.

#include <algorithm>
#include <cstring>

#include "frames.h"
#include "raster/reference/assemble.h"
#include "window_meshes.h"

namespace lode::raster::test {

/// A few draws of a few triangles each, with colours, in perspective: some cut by the near plane, some coplanar.
struct Picture {
  struct Triangles {
    std::vector<glm::dvec4> positions;
    std::vector<glm::vec4> colors;
    std::vector<std::uint32_t> indices;
  };
  glm::ivec2 size_px{0, 0};
  std::vector<Triangles> triangles;
  std::vector<Draw> draws;  ///< of the triangles, ids set, so that they may be reordered
};

[[nodiscard]] inline Picture random_picture(HashedNumbers& random, int most_px) {
  Picture picture;
  picture.size_px = {random.between(1, most_px), random.between(1, most_px)};
  picture.triangles.resize(std::size_t(random.between(1, 4)));
  for (Picture::Triangles& t : picture.triangles) {
    const int n = 3 * random.between(1, 5);
    const bool flat = random.below(3) == 0, behind = random.below(3) == 0;
    for (int i = 0; i < n; ++i) {
      const double w = flat ? 1.0 : 0.25 + 2.0 * random.unit() - (behind ? 0.75 : 0.0);
      const double x = (3.0 * random.unit() - 1.5) * std::abs(w), y = (3.0 * random.unit() - 1.5) * std::abs(w);
      t.positions.emplace_back(x, y, flat ? 0.5 : 0.25, w);
      const auto color = [&] { return float(random.unit()); };
      const float r = color(), g = color(), b = color();
      t.colors.emplace_back(r, g, b, color());
      t.indices.push_back(random.below(8) == 0 ? random.below(std::uint32_t(i) + 1) : std::uint32_t(i));
    }
  }
  for (std::size_t d = 0; d < picture.triangles.size(); ++d) {
    const Picture::Triangles& t = picture.triangles[d];
    Draw draw = triangles_of(ClipVertices{t.positions});
    draw.colors = t.colors;
    draw.indices = t.indices;
    draw.draw_id = std::uint32_t(d);
    draw.cull = random.below(4) == 0 ? Cull::back : Cull::none;
    picture.draws.push_back(draw);
  }
  return picture;
}

[[nodiscard]] inline Image rendered(const Frame& frame, glm::ivec2 size_px,
                                    const RenderOptions& options = workers_and_tiles(1, 64),
                                    ColorFormat format = ColorFormat::rgba32f) {
  const bool one_sample = frame.samples_fx8.size() == 1;
  Image image = make_image(size_px, format, {.color = true, .depth = one_sample, .ids = one_sample});
  render_by_both(frame, image, options);
  return image;
}

/// Whether pixel p of a and pixel q of b have the same bits in all planes.
[[nodiscard]] inline bool same_pixel(const Image& a, glm::ivec2 p, const Image& b, glm::ivec2 q) {
  const std::size_t i = std::size_t(p.y) * std::size_t(a.size_px.x) + std::size_t(p.x);
  const std::size_t k = std::size_t(q.y) * std::size_t(b.size_px.x) + std::size_t(q.x);
  const auto same = [&](const auto& x, const auto& y) {
    return x.empty() || std::memcmp(&x[i], &y[k], sizeof x[i]) == 0;
  };
  return same(a.rgba8, b.rgba8) && same(a.rgba32f, b.rgba32f) && same(a.depth, b.depth) && same(a.ids, b.ids);
}

/// Pixels of a's window [0, a.size) that differ from b's at the same place plus `offset`; where b has none, from
/// nothing.
[[nodiscard]] inline int differing_pixels(const Image& a, const Image& b, glm::ivec2 offset = {0, 0}) {
  int n = 0;
  for (int y = 0; y < a.size_px.y; ++y) {
    for (int x = 0; x < a.size_px.x; ++x) {
      const glm::ivec2 q = glm::ivec2(x, y) + offset;
      const bool inside = q.x >= 0 && q.y >= 0 && q.x < b.size_px.x && q.y < b.size_px.y;
      if (inside) n += !same_pixel(a, {x, y}, b, q);
    }
  }
  return n;
}

/// Each triangle's vertices rotated: coverage, depth, ids and colour stay.
[[nodiscard]] inline int wrong_after_rotation(std::uint64_t seed) {
  HashedNumbers random(seed);
  Picture picture = random_picture(random, 24);
  const Image before = rendered(frame_of(picture.draws), picture.size_px);
  for (Picture::Triangles& t : picture.triangles) {
    for (std::size_t i = 0; i < t.indices.size(); i += 3) {
      std::rotate(t.indices.begin() + std::ptrdiff_t(i), t.indices.begin() + std::ptrdiff_t(i + 1 + random.below(2)),
                  t.indices.begin() + std::ptrdiff_t(i + 3));
    }
  }
  return differing_pixels(before, rendered(frame_of(picture.draws), picture.size_px));
}

/// Winding turned by exchanging two vertices, culling off: coverage, depth, ids and colour stay.
[[nodiscard]] inline int wrong_after_turning(std::uint64_t seed) {
  HashedNumbers random(seed);
  Picture picture = random_picture(random, 24);
  for (Draw& draw : picture.draws) draw.cull = Cull::none;
  const Image before = rendered(frame_of(picture.draws), picture.size_px);
  for (Picture::Triangles& t : picture.triangles) {
    for (std::size_t i = 0; i < t.indices.size(); i += 3) std::swap(t.indices[i + random.below(2)], t.indices[i + 2]);
  }
  return differing_pixels(before, rendered(frame_of(picture.draws), picture.size_px));
}

[[nodiscard]] inline int wrong_in_tiles_and_threads(std::uint64_t seed) {
  HashedNumbers random(seed);
  Picture picture = random_picture(random, 40);
  const std::uint32_t blended = random.below(2);
  if (blended) picture.draws.back().blend = Blend::over;
  const Image before = rendered(frame_of(picture.draws), picture.size_px, workers_and_tiles(1, 256));
  const int threads = random.below(64) == 0 ? random.between(2, 5) : 1;
  const RenderOptions other = workers_and_tiles(threads, 8 << random.below(4));
  return differing_pixels(before, rendered(frame_of(picture.draws), picture.size_px, other));
}

/// A part of the picture, by a smaller target and a viewport that sticks out of it. Geometry beyond the guard band is
/// left out: that is cut elsewhere in the two, and its edges are then not the same lines.
[[nodiscard]] inline int wrong_in_crop(std::uint64_t seed) {
  HashedNumbers random(seed);
  const Picture picture = random_picture(random, 24);
  const glm::ivec2 size{random.between(1, 24), random.between(1, 24)},
      origin{random.between(-8, 24), random.between(-8, 24)};
  Frame whole = frame_of(picture.draws), part = whole;
  whole.viewport = Rect{{0, 0}, picture.size_px};
  part.viewport = Rect{-origin, picture.size_px};
  for (const Picture::Triangles& t : picture.triangles) {
    for (std::size_t i = 0; i < t.indices.size(); i += 3) {
      const reference::Viewport v = reference::make_viewport(*whole.viewport);
      const reference::ClipPolygon cut = reference::clip_triangle(
          v, {t.positions[t.indices[i]], t.positions[t.indices[i + 1]], t.positions[t.indices[i + 2]]});
      for (int k = 0; k < cut.n; ++k) {
        const glm::ivec2 p = reference::window_vertex(v, cut.vertices[std::size_t(k)].position).p_fx8;
        if (std::max(std::abs(p.x), std::abs(p.y)) > reference::kGuard_fx8 / 2) return 0;
      }
    }
  }
  // The part of the target that the whole picture's target has, too.
  return differing_pixels(rendered(part, size), rendered(whole, picture.size_px), origin);
}

/// Order-free draws in another order, and their triangles: the same bytes.
[[nodiscard]] inline int wrong_in_another_order(std::uint64_t seed) {
  HashedNumbers random(seed);
  Picture picture = random_picture(random, 24);
  const Image before = rendered(frame_of(picture.draws), picture.size_px);
  for (std::size_t i = picture.draws.size(); i > 1; --i) {
    std::swap(picture.draws[i - 1], picture.draws[random.below(std::uint32_t(i))]);
  }
  return differing_pixels(before, rendered(frame_of(picture.draws), picture.size_px));
}

/// Inside a scissor the picture, outside the clear colour; on the frame or on each draw.
[[nodiscard]] inline int wrong_in_scissor(std::uint64_t seed) {
  HashedNumbers random(seed);
  Picture picture = random_picture(random, 24);
  Frame frame = frame_of(picture.draws);
  frame.clear = {0.25f, 0.5f, 0.75f, 1.0f};
  const Image whole = rendered(frame, picture.size_px);
  Frame nothing = frame;
  nothing.draws = {};
  const Image clear = rendered(nothing, picture.size_px);
  const Rect scissor{{random.between(-4, 24), random.between(-4, 24)}, {random.between(0, 24), random.between(0, 24)}};
  if (random.below(2) == 0) {
    frame.scissor = scissor;
  } else {
    for (Draw& draw : picture.draws) draw.scissor = scissor;
  }
  const Image cut = rendered(frame, picture.size_px);
  int n = 0;
  for (int y = 0; y < picture.size_px.y; ++y) {
    for (int x = 0; x < picture.size_px.x; ++x) {
      const glm::ivec2 p{x, y}, d = p - scissor.origin_px;
      const bool inside = d.x >= 0 && d.y >= 0 && d.x < scissor.size_px.x && d.y < scissor.size_px.y;
      n += !same_pixel(cut, p, inside ? whole : clear, p);
    }
  }
  return n;
}

/// The same sample several times over, averaged, is that sample; and a sample elsewhere in the pixel sees what the
/// centre sees of a picture moved the other way.
[[nodiscard]] inline int wrong_in_samples(std::uint64_t seed) {
  HashedNumbers random(seed);
  Picture picture = random_picture(random, 16);
  const glm::ivec2 sample{random.between(0, 255), random.between(0, 255)};
  const std::vector<glm::ivec2> once(1, sample), often(std::size_t(random.between(2, 5)), sample);
  Frame frame = frame_of(picture.draws);
  for (Picture::Triangles& t : picture.triangles) {
    for (glm::vec4& color : t.colors) color *= 255.0f;
  }
  frame.samples_fx8 = once;
  const Image one = rendered(frame, picture.size_px, workers_and_tiles(1, 16), ColorFormat::rgba8);
  frame.samples_fx8 = often;
  const Image several = rendered(frame, picture.size_px, workers_and_tiles(1, 16), ColorFormat::rgba8);
  int n = 0;
  for (std::size_t i = 0; i < one.rgba8.size(); ++i) n += one.rgba8[i] != several.rgba8[i];

  const Corners t = {random_point_fx8(random, 8), random_point_fx8(random, 8), random_point_fx8(random, 8)};
  const std::optional<reference::Triangle> here = triangle_of(t);
  const glm::ivec2 by = kCentre_fx8 - sample;
  const std::optional<reference::Triangle> moved = triangle_of({t[0] + by, t[1] + by, t[2] + by});
  CoverageCount difference({{-1, -1}, {9, 9}});
  if (here && moved) {
    reference::for_each_covered(*here, difference.window(), sample, [&](glm::ivec2 px) { ++difference.at(px); });
    difference.add(*moved, -1);
  }
  difference.for_each([&](glm::ivec2, int d) { n += d != 0; });
  return n;
}

/// Window coordinates moved by whole pixels: the picture moves, all planes.
[[nodiscard]] inline int wrong_after_translation(std::uint64_t seed) {
  HashedNumbers random(seed);
  const glm::ivec2 size{random.between(1, 24), random.between(1, 24)};
  const int n = 3 * random.between(1, 6);
  const glm::ivec2 by{random.between(-20, 20), random.between(-20, 20)};
  std::vector<glm::dvec3> here, moved;
  std::vector<glm::vec4> colors;
  for (int i = 0; i < n; ++i) {
    const glm::ivec2 grid = 16 * random_point_fx8(random, 24);  // of 1/4096 px
    const glm::dvec2 p = glm::dvec2(grid + glm::ivec2(random.between(-8, 8))) / 4096.0;
    here.emplace_back(p, random.unit());
    moved.emplace_back(p + glm::dvec2(by), here.back().z);
    const float r = float(random.unit()), g = float(random.unit());
    colors.emplace_back(r, g, float(random.unit()), 1.0f);
  }
  Draw draw = triangles_of(WindowVertices{here});
  draw.colors = colors;
  const Image before = rendered(frame_of(draw), size);
  draw.vertices = WindowVertices{moved};
  const glm::ivec2 grown = size + glm::max(by, 0);
  return differing_pixels(before, rendered(frame_of(draw), grown), by);
}

/// Mirrored at a vertical line: the mirrored coverage, but for samples on edges, where the rule's "left" is now right:
/// exactly the coverage by a sample displaced to the left.
[[nodiscard]] inline int wrong_after_mirroring(std::uint64_t seed) {
  HashedNumbers random(seed);
  const int size = 1 << random.between(0, 4);
  const Corners t = {random_point_fx8(random, size), random_point_fx8(random, size), random_point_fx8(random, size)};
  Corners mirrored = t;
  for (glm::ivec2& p : mirrored) p.x = 256 * size - p.x;
  CoverageCount count({{0, 0}, glm::ivec2(size)});
  count.add(mirrored);
  constexpr Displacement kLeft{-(std::int64_t(1) << 26), 1};
  int n = 0;
  count.for_each([&](glm::ivec2 px, int c) {
    n += c != int(signed_cover(t, centre_of({size - 1 - px.x, px.y}), kLeft) != 0);
  });
  // Through projection: mirrored vertices land on mirrored sub-pixels.
  const reference::Viewport v = reference::make_viewport({{0, 0}, {size, size}});
  const glm::dvec4 p{3.0 * random.unit() - 1.5, 3.0 * random.unit() - 1.5, 0.5, 0.5 + random.unit()};
  const glm::ivec2 at = reference::window_vertex(v, p).p_fx8;
  const glm::ivec2 mirrored_x = reference::window_vertex(v, {-p.x, p.y, p.z, p.w}).p_fx8;
  const glm::ivec2 mirrored_y = reference::window_vertex(v, {p.x, -p.y, p.z, p.w}).p_fx8;
  return n + int(mirrored_x != glm::ivec2(256 * size - at.x, at.y)) +
         int(mirrored_y != glm::ivec2(at.x, 256 * size - at.y));
}

/// Split at a point of the grid, inside or on an edge: the parts cover what the whole covers, each sample once.
[[nodiscard]] inline int wrong_after_splitting(std::uint64_t seed) {
  HashedNumbers random(seed);
  const int size = 1 << random.between(0, 4);
  Corners t = {random_point_fx8(random, size), random_point_fx8(random, size), random_point_fx8(random, size)};
  if (doubled_area(t) < 0) std::swap(t[1], t[2]);
  if (random.below(2) == 0) t[1] = t[0] + 2 * ((t[1] - t[0]) / 2);  // the middle of the edge is on the grid
  glm::ivec2 p = (t[0] + t[1]) / 2;
  if ((t[0] + t[1]) % 2 != glm::ivec2(0) || random.below(2) == 0) p = (t[0] + t[1] + t[2]) / 3;
  for (std::size_t k = 0; k < 3; ++k) {
    if (doubled_area({t[k], t[(k + 1) % 3], p}) < 0) return 0;  // rounded out of the triangle
  }
  CoverageCount difference({{0, 0}, glm::ivec2(size)});
  difference.add(t, -1);
  for (std::size_t k = 0; k < 3; ++k) difference.add(Corners{t[k], t[(k + 1) % 3], p});
  int n = 0;
  difference.for_each([&](glm::ivec2, int d) { n += d != 0; });
  return n;
}

struct Relation {
  const char* name;
  int (*wrong)(std::uint64_t seed);
};
inline constexpr Relation kRelations[] = {
    {"rotating vertices", wrong_after_rotation},
    {"turning triangles over", wrong_after_turning},
    {"tile size and threads", wrong_in_tiles_and_threads},
    {"cropping", wrong_in_crop},
    {"order of order-free draws", wrong_in_another_order},
    {"scissor", wrong_in_scissor},
    {"sample positions", wrong_in_samples},
    {"translating by whole pixels", wrong_after_translation},
    {"mirroring", wrong_after_mirroring},
    {"splitting on the grid", wrong_after_splitting},
};

}  // namespace lode::raster::test
