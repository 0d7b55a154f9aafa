#include "raster/fast/records.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "raster/blend.h"

namespace lode::raster::fast {

void Records::make(std::uint64_t n_won) {
  n_records_ = 0;
  recent_.fill({kNoOwner, kNoRecord});
  const auto& written = w_.tile->written;
  const auto n_touched =
      std::count_if(std::begin(written), std::end(written), [](std::uint8_t flags) { return (flags & kTouched) != 0; });
  // Where samples were won often over, finding out whose they are in the end costs less than records for nothing.
  wanted_ = 4 * n_won > 5 * 64 * std::uint64_t(n_touched) ? kOwns : kWon;
  if (wanted_ == kOwns) mark_owners();
  for (std::uint32_t slot = 0; slot < w_.residents.size(); ++slot) {
    if (slot + 1 < w_.residents.size()) prefetch_colors(slot + 1);
    make_those_of(slot);
  }
}

void Records::mark_owners() {
  // Without branches: whose the next sample is, is hard to guess. Pieces and nothing mark a place of no slot.
  constexpr std::uint32_t kNowhere = kSlots * kSlotTriangles;
  for (std::size_t block = 0; block < kBlocks; ++block) {
    if ((w_.tile->written[block] & kTouched) == 0) continue;
    for (std::size_t i = 64 * block; i < 64 * block + 64; ++i) {
      const std::uint32_t owner = w_.tile->owner[i];
      w_.marks[owner & kPieceBit ? kNowhere : owner] |= kOwns;
    }
  }
}

/// Asks memory for the colours of the vertices of a slot that has anything visible.
void Records::prefetch_colors(std::uint32_t slot) const {
  std::array<std::uint64_t, kSlotTriangles / 8> marks;
  std::memcpy(marks.data(), &w_.marks[std::size_t(slot) * kSlotTriangles], kSlotTriangles);
  std::uint64_t any = 0;
  for (const std::uint64_t eight : marks) any |= eight;
  const Resident& r = w_.residents[slot];
  const FastDraw& fast = scene_.fast[r.fast_draw];
  if ((any & 0x0101010101010101u * wanted_) == 0 || !fast.flat || fast.constant) return;
  const std::uint32_t* vertices = &fast.clusters->vertices[r.first_vertex];
  const std::size_t n = fast.clusters->clusters[r.cluster].n_vertices;
  for (std::size_t i = 0; i < n; ++i) __builtin_prefetch(fast.owners_job.colors + 4 * std::size_t(vertices[i]));
}

void Records::make_those_of(std::uint32_t slot) {
  const std::uint8_t* marks = &w_.marks[std::size_t(slot) * kSlotTriangles];
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
      if ((marks[t] & wanted_) == 0) continue;
      if (record == kNoRecord) record = add_constant(fast.bytes);
      record_of[t] = record;
    }
    return;
  }
  std::array<std::int32_t, kSlotTriangles + 16> wide;
  RecordJob job;
  job.corners = &fast.clusters->corners[3 * std::size_t(r.first_triangle)];
  job.vertices = &w_.vertices[slot];
  job.mesh_vertices = &fast.clusters->vertices[r.first_vertex];
  job.colors = fast.owners_job.colors;
  job.scale = fast.scale;
  job.scaled = scene_.frame->draws[fast.draw].color.has_value();
  job.sample_x_fx8 = sample_fx8_.x, job.sample_y_fx8 = sample_fx8_.y;
  job.marks = marks, job.wanted = wanted_;
  job.first_record = n_records_, job.record_of = record_of, job.records = &w_.records[n_records_];
  job.wide = wide.data();
  const RecordCounts n = scene_.kernels->make_records(job);
  n_records_ += std::uint32_t(n.made);
  for (std::size_t i = 0; i < std::size_t(n.wide); ++i) {
    Piece p;
    owners_.make_piece(slot * kSlotTriangles + std::uint32_t(wide[i]), p);
    record_of[wide[i]] = add_piece(p);
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
