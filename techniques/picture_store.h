#pragma once
/// Pictures that a technique keeps of objects, at most one each, and who must go when memory ends: what was not shown for
/// the longest time.

#include <cstdint>
#include <optional>
#include <vector>

#include "techniques/stage.h"

namespace lode::techniques {

class PictureStore {
 public:
  /// most_bytes   of all pictures; 0: no limit
  explicit PictureStore(std::uint64_t most_bytes = 0) : most_bytes_(most_bytes) {}

  /// Forgets all, of a world of so many objects. Pictures of an earlier stage are its own to release.
  void reset(std::size_t n_objects);
  void begin_frame();

  /// Nothing if there is none.
  [[nodiscard]] std::optional<PictureId> find(ObjectId id) const;
  /// Marks the object's picture as shown in this frame.
  void show(ObjectId id) { kept_[id]->shown = frame_; }

  /// Lets pictures go until there is room for a new one; false, and nothing is kept for it, if there cannot be: those
  /// shown in this frame stay.
  [[nodiscard]] bool make_room(std::uint64_t bytes, Stage& stage);
  /// Of an object that has none.
  void keep(ObjectId id, PictureId picture, std::uint64_t bytes);
  /// Nothing if there is none.
  void drop(ObjectId id, Stage& stage);
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
  std::vector<std::optional<Kept>> kept_;  ///< [objects]
  std::uint64_t frame_ = 0, bytes_ = 0, evicted_ = 0;
};

}  // namespace lode::techniques
