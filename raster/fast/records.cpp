#include "raster/fast/records.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "raster/blend.h"

namespace lode::raster::fast {
namespace {

constexpr int kNarrow_fx8 = 64 * 256;  // corners of triangles whose records the kernels make

bool is_narrow(const WindowVertices128& v, const std::uint8_t* corners) {
  const auto [x0, x1] = std::minmax({v.x_fx8(corners[0]), v.x_fx8(corners[1]), v.x_fx8(corners[2])});
  const auto [y0, y1] = std::minmax({v.y_fx8(corners[0]), v.y_fx8(corners[1]), v.y_fx8(corners[2])});
  return x1 - x0 < kNarrow_fx8 && y1 - y0 < kNarrow_fx8;
}

}  // namespace

void Records::make() {
  n_records_ = 0;
  recent_.fill({kNoOwner, kNoRecord});
  for (const Resident& r : w_.residents) {
    std::memset(&w_.visible[std::size_t(&r - w_.residents.data()) * kSlotTriangles], 0, kSlotTriangles);
  }
  // Without branches: whose the next sample is, is hard to guess. Pieces and nothing mark a place of no slot.
  constexpr std::uint32_t kNowhere = kSlots * kSlotTriangles;
  for (std::size_t block = 0; block < kBlocks; ++block) {
    if ((w_.tile->written[block] & kTouched) == 0) continue;
    for (std::size_t i = 64 * block; i < 64 * block + 64; ++i) {
      const std::uint32_t owner = w_.tile->owner[i];
      w_.visible[owner & kPieceBit ? kNowhere : owner] = 1;
    }
  }
  for (std::uint32_t slot = 0; slot < w_.residents.size(); ++slot) {
    if (slot + 1 < w_.residents.size()) prefetch_colors(slot + 1);
    make_those_of(slot);
  }
}

/// Asks memory for the colours of the vertices of a slot that has anything visible.
void Records::prefetch_colors(std::uint32_t slot) const {
  std::array<std::uint64_t, kSlotTriangles / 8> visible;
  std::memcpy(visible.data(), &w_.visible[std::size_t(slot) * kSlotTriangles], kSlotTriangles);
  std::uint64_t any = 0;
  for (const std::uint64_t eight : visible) any |= eight;
  const Resident& r = w_.residents[slot];
  const FastDraw& fast = scene_.fast[r.fast_draw];
  if (any == 0 || !fast.flat || fast.constant) return;
  const std::uint32_t* vertices = &fast.clusters->vertices[r.first_vertex];
  const std::size_t n = fast.clusters->clusters[r.cluster].n_vertices;
  for (std::size_t i = 0; i < n; ++i) __builtin_prefetch(fast.flat_job.colors + 4 * std::size_t(vertices[i]));
}

void Records::make_those_of(std::uint32_t slot) {
  const std::uint8_t* visible = &w_.visible[std::size_t(slot) * kSlotTriangles];
  std::array<std::uint8_t, kSlotTriangles> narrow, wide;
  std::size_t n_narrow = 0, n_wide = 0;
  const Resident& r = w_.residents[slot];
  const FastDraw& fast = scene_.fast[r.fast_draw];
  std::uint32_t* record_of = &w_.record_of[std::size_t(slot) * kSlotTriangles];
  if (!fast.flat) {
    std::fill_n(record_of, kSlotTriangles, kNoRecord);
    return;
  }
  if (fast.constant) {
    std::uint32_t record = kNoRecord;
    for (std::size_t t = 0; t < kSlotTriangles; ++t) {
      if (!visible[t]) continue;
      if (record == kNoRecord) record = add_constant(fast.bytes);
      record_of[t] = record;
    }
    return;
  }
  const WindowVertices128& v = w_.vertices[slot];
  const std::uint8_t* corners = &fast.clusters->corners[3 * std::size_t(r.first_triangle)];
  for (std::size_t first = 0; first < kSlotTriangles; first += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, visible + first, 8);
    for (; eight != 0; eight &= eight - 1) {
      const std::size_t t = first + std::size_t(std::countr_zero(eight)) / 8;
      if (is_narrow(v, corners + 3 * t)) {
        record_of[t] = n_records_ + std::uint32_t(n_narrow);
        narrow[n_narrow++] = std::uint8_t(t);
      } else {
        wide[n_wide++] = std::uint8_t(t);
      }
    }
  }
  if (n_narrow > 0) {
    prepare_corners(v, corners, {narrow.data(), n_narrow}, fast.flat_job.colors,
                    &fast.clusters->vertices[r.first_vertex]);
    RecordJob job;
    job.corners = corners;
    job.vertices = w_.corners.get();
    job.scale = fast.scale;
    job.scaled = fast.flat_job.has_color;
    job.sample_x_fx8 = sample_fx8_.x, job.sample_y_fx8 = sample_fx8_.y;
    scene_.kernels->make_records(job, narrow.data(), int(n_narrow), &w_.records[n_records_]);
    n_records_ += std::uint32_t(n_narrow);
  }
  for (std::size_t i = 0; i < n_wide; ++i) {
    Piece p;
    owners_.make_piece(slot * kSlotTriangles + wide[i], p);
    record_of[wide[i]] = add_piece(p);
  }
}

/// What records need of the vertices of some triangles.
void Records::prepare_corners(const WindowVertices128& v, const std::uint8_t* corners,
                              std::span<const std::uint8_t> triangles, const float* colors,
                              const std::uint32_t* mesh_vertices) {
  std::array<std::uint64_t, 2> wanted{};
  for (const std::uint8_t t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint8_t corner = corners[3 * std::size_t(t) + k];
      wanted[corner / 64] |= std::uint64_t(1) << (corner % 64);
    }
  }
  for (std::size_t half = 0; half < 2; ++half) {
    for (std::uint64_t bits = wanted[half]; bits != 0; bits &= bits - 1) {
      const std::size_t i = 64 * half + std::size_t(std::countr_zero(bits));
      CornerRecord& out = w_.corners[i];
      std::memcpy(&out.x_fx8, &v.xy_fx8[i], 8);
      out.inverse_w = float(1.0 / v.w[i]);
      std::memcpy(out.rgba, colors + 4 * std::size_t(mesh_vertices[i]), 16);
    }
  }
}

std::uint32_t Records::add_constant(std::uint32_t bytes) {
  ColorRecord record{};
  for (std::size_t c = 0; c < 4; ++c) record.quads[1][c] = float(bytes >> (8 * c) & 255);
  w_.records[n_records_] = record;
  return n_records_++;
}

/// The planes of one triangle in double; of a clipped polygon, too.
std::uint32_t Records::add_piece(const Piece& p) {
  const auto& t = std::get<reference::Triangle>(p.shape);
  const Draw& draw = scene_.frame->draws[p.draw];
  const float full = 255.0f;
  const glm::vec4 color = draw.color.value_or(glm::vec4(full));
  if (draw.colors.empty()) {
    const glm::u8vec4 b = store_rgba8(color);
    return add_constant(b.r | b.g << 8 | b.b << 16 | std::uint32_t(b.a) << 24);
  }
  const auto edges = reference::edges_of(t);
  const PixelBox inside = intersect(intersect(reference::bounds_px(t, sample_fx8_), p.bounds_px), box_);
  const glm::ivec2 middle = (inside.begin_px + inside.end_px) / 2;
  const glm::dvec2 reach = glm::dvec2(glm::max(middle - inside.begin_px, inside.end_px - middle));
  const glm::ivec2 at_fx8 = reference::sample_position_fx8(middle, sample_fx8_);
  std::array<double, 3> at, right, down;
  double sum = 0.0, d_right = 0.0, d_down = 0.0, terms = 0.0, most = 255.0;
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = double(edges[k].at(at_fx8)) / t.v[k].w;
    right[k] = -256.0 * double(edges[k].dy) / t.v[k].w, down[k] = 256.0 * double(edges[k].dx) / t.v[k].w;
    sum += at[k], d_right += right[k], d_down += down[k];
    terms += std::abs(at[k]) + reach.x * std::abs(right[k]) + reach.y * std::abs(down[k]);
  }
  ColorRecord record{};
  for (int c = 0; c < 4; ++c) {
    double v = 0.0, v_right = 0.0, v_down = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      double corner = 0.0;
      if (t.polygon) {
        const auto& weights = t.polygon->weights[std::size_t(t.polygon_vertex[k])];
        for (std::size_t j = 0; j < 3; ++j) {
          const double own = double(draw.colors[p.vertices[j]][c]) * double(color[c]) / full;
          corner += weights[j] * own;
          most = std::max(most, std::abs(own));
        }
      } else {
        corner = double(draw.colors[p.vertices[k]][c]) * double(color[c]) / full;
        most = std::max(most, std::abs(corner));
      }
      v += at[k] * corner, v_right += right[k] * corner, v_down += down[k] * corner;
    }
    record.quads[1][c] = float(v / sum), record.quads[2][c] = float(v_right / sum),
    record.quads[3][c] = float(v_down / sum);
  }
  record.quads[0][0] = float(d_right / sum), record.quads[0][1] = float(d_down / sum);
  const glm::ivec2 in_tile = middle - box_.begin_px;
  const std::int32_t reference = in_tile.x | in_tile.y << 8;
  std::memcpy(&record.quads[0][2], &reference, 4);
  record.quads[0][3] = float(terms / std::abs(sum) * most * double(kRecordError));
  w_.records[n_records_] = record;
  return n_records_++;
}

std::uint32_t Records::of_piece(std::uint32_t index) {
  for (const auto& [piece, record] : recent_) {
    if (piece == index) return record;
  }
  const Piece& p = owners_.piece(index);
  const Draw& draw = scene_.frame->draws[p.draw];
  const bool flat = std::holds_alternative<reference::Triangle>(p.shape) && !draw.texture && !draw.shader.function;
  if (!flat || n_records_ + 1 >= kMostRecords) return kNoRecord;
  recent_[next_recent_++ % recent_.size()] = {index, add_piece(p)};
  return recent_[(next_recent_ - 1) % recent_.size()].second;
}

}  // namespace lode::raster::fast
