#pragma once
/// Colour records: the colours of each visible triangle as planes, made once a tile, from which the kernels shade
/// bytes.

#include <array>
#include <cstdint>
#include <utility>

#include "raster/fast/tile.h"

namespace lode::raster::fast {

class Records {
 public:
  Records(const Scene& scene, Worker& worker, const PixelBox& box, glm::ivec2 sample_fx8)
      : scene_(scene), w_(worker), owners_(scene, worker, box), box_(box), sample_fx8_(sample_fx8) {}

  /// Of every visible triangle of the kernels, and perhaps of some that have lost their samples since: fills the
  /// worker's `records` and `record_of`. n_won: how often a sample of the tile was won
  void make(std::uint64_t n_won);
  /// Of a piece, kept while its neighbours ask for it; kNoRecord where it has none.
  [[nodiscard]] std::uint32_t of_piece(std::uint32_t index);

 private:
  void prefetch_colors(std::uint32_t slot) const;
  void make_those_of(std::uint32_t slot);
  void mark_owners();
  std::uint32_t add_constant(std::uint32_t bytes);
  std::uint32_t add_piece(const Piece& p);

  const Scene& scene_;
  Worker& w_;
  Owners owners_;
  PixelBox box_;
  glm::ivec2 sample_fx8_;
  std::uint32_t n_records_ = 0;
  std::uint8_t wanted_ = kWon;
  std::array<std::pair<std::uint32_t, std::uint32_t>, 8> recent_;  ///< piece and record
  std::size_t next_recent_ = 0;
};

}  // namespace lode::raster::fast
