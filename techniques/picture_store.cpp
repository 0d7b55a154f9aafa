#include "techniques/picture_store.h"

namespace lode::techniques {

void PictureStore::reset(std::size_t n_objects) {
  kept_.assign(n_objects, std::nullopt);
  frame_ = bytes_ = evicted_ = 0;
}

void PictureStore::begin_frame() {
  ++frame_;
  evicted_ = 0;
}

std::optional<PictureId> PictureStore::find(ObjectId id) const {
  if (!kept_[id]) return std::nullopt;
  return kept_[id]->picture;
}

bool PictureStore::make_room(std::uint64_t bytes, Stage& stage) {
  if (most_bytes_ == 0) return true;
  if (bytes > most_bytes_) return false;
  while (bytes_ + bytes > most_bytes_) {
    ObjectId oldest = ObjectId(kept_.size());
    for (ObjectId id = 0; id < kept_.size(); ++id) {
      if (!kept_[id] || kept_[id]->shown == frame_) continue;
      if (oldest == kept_.size() || kept_[id]->shown < kept_[oldest]->shown) oldest = id;
    }
    if (oldest == kept_.size()) return false;
    drop(oldest, stage);
    ++evicted_;
  }
  return true;
}

void PictureStore::keep(ObjectId id, PictureId picture, std::uint64_t bytes) {
  kept_[id] = {.picture = picture, .bytes = bytes, .shown = frame_};
  bytes_ += bytes;
}

void PictureStore::drop(ObjectId id, Stage& stage) {
  if (!kept_[id]) return;
  stage.release(kept_[id]->picture);
  bytes_ -= kept_[id]->bytes;
  kept_[id].reset();
}

void PictureStore::drop_all(Stage& stage) {
  for (ObjectId id = 0; id < kept_.size(); ++id) drop(id, stage);
}

}  // namespace lode::techniques
