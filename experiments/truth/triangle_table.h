#pragma once
/// The triangles of a list of draws by their ids.

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "experiments/truth/arbiter.h"
#include "raster/frame.h"
#include "raster/image.h"

namespace lode::experiments::truth {

class TriangleTable {
 public:
  /// Triangles of ObjectVertices, each draw with a draw_id of its own; borrowed.
  TriangleTable(std::span<const raster::Draw> draws, glm::ivec2 size_px);

  [[nodiscard]] std::size_t n_draws() const { return draws_.size(); }
  [[nodiscard]] std::size_t n_triangles(std::size_t draw) const;
  [[nodiscard]] raster::Ids ids(std::size_t draw, std::size_t triangle) const {
    return {*draws_[draw].draw_id, std::uint32_t(triangle)};
  }
  [[nodiscard]] SourceTriangle source(std::size_t draw, std::size_t triangle) const;
  /// Nothing where there is no such triangle.
  [[nodiscard]] std::optional<SourceTriangle> find(raster::Ids ids) const;

  [[nodiscard]] PreparedTriangle prepared(const SourceTriangle& triangle) const { return prepare(triangle, size_px_); }

 private:
  std::span<const raster::Draw> draws_;
  glm::ivec2 size_px_;
  std::map<std::uint32_t, std::size_t> draw_of_id_;
};

/// Prepared triangles that were asked for lately, for one thread: neighbouring pixels mostly show the same ones.
class PreparedCache {
 public:
  explicit PreparedCache(const TriangleTable& table) : table_(&table) {}
  /// Null where there is no such triangle; valid until the next call.
  [[nodiscard]] const PreparedTriangle* find(raster::Ids ids);

 private:
  struct Entry {
    raster::Ids ids{raster::kNoId, raster::kNoId};
    PreparedTriangle triangle;
  };
  const TriangleTable* table_;
  std::vector<Entry> entries_ = std::vector<Entry>(64);
};

}  // namespace lode::experiments::truth
