#pragma once
/// Pictures that a technique keeps, at most one in each place, and who must go when memory ends: what was not shown for
/// the longest time. An object's place has its number; a technique may have more places than objects.

#include <cstdint>
#include <optional>
#include <vector>

#include "techniques/stage.h"

namespace lode::techniques {

class PictureStore {
 public:
  /// most_bytes   of all pictures; 0: no limit
  explicit PictureStore(std::uint64_t most_bytes = 0) : most_bytes_(most_bytes) {}

  /// Forgets all. Pictures of an earlier stage are its own to release.
  void reset(std::size_t n_places);
  void begin_frame();

  /// Nothing if there is none.
  [[nodiscard]] std::optional<PictureId> find(std::size_t place) const;
  /// Marks the place's picture as shown in this frame.
  void show(std::size_t place) { kept_[place]->shown = frame_; }

  /// Lets pictures go until there is room for a new one; false, and nothing is kept for it, if there cannot be: those
  /// shown in this frame stay.
  [[nodiscard]] bool make_room(std::uint64_t bytes, Stage& stage);
  /// In a place that has none.
  void keep(std::size_t place, PictureId picture, std::uint64_t bytes);
  /// Of a place that has one, to one that has none.
  void move(std::size_t from, std::size_t to);
  /// Nothing if there is none.
  void drop(std::size_t place, Stage& stage);
  void drop_all(Stage& stage);

  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  [[nodiscard]] std::uint64_t evicted() const { return evicted_; }  ///< in this frame

 private:
  struct Kept {
    PictureId picture = 0;
    std::uint64_t bytes = 0;
    std::uint64_t shown = 0;  ///< in which frame, the last time
  };
  std::uint64_t most_bytes_;
  std::vector<std::optional<Kept>> kept_;  ///< [places]
  std::uint64_t frame_ = 0, bytes_ = 0, evicted_ = 0;
};

}  // namespace lode::techniques
