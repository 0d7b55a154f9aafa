#include "techniques/picture_store.h"

#include <utility>

namespace lode::techniques {

void PictureStore::reset(std::size_t n_places) {
  kept_.assign(n_places, std::nullopt);
  frame_ = bytes_ = evicted_ = 0;
}

void PictureStore::begin_frame() {
  ++frame_;
  evicted_ = 0;
}

std::optional<PictureId> PictureStore::find(std::size_t place) const {
  if (!kept_[place]) return std::nullopt;
  return kept_[place]->picture;
}

bool PictureStore::make_room(std::uint64_t bytes, Stage& stage) {
  if (most_bytes_ == 0) return true;
  if (bytes > most_bytes_) return false;
  while (bytes_ + bytes > most_bytes_) {
    std::size_t oldest = kept_.size();
    for (std::size_t place = 0; place < kept_.size(); ++place) {
      if (!kept_[place] || kept_[place]->shown == frame_) continue;
      if (oldest == kept_.size() || kept_[place]->shown < kept_[oldest]->shown) oldest = place;
    }
    if (oldest == kept_.size()) return false;
    drop(oldest, stage);
    ++evicted_;
  }
  return true;
}

void PictureStore::keep(std::size_t place, PictureId picture, std::uint64_t bytes) {
  kept_[place] = {.picture = picture, .bytes = bytes, .shown = frame_};
  bytes_ += bytes;
}

void PictureStore::move(std::size_t from, std::size_t to) { kept_[to] = std::exchange(kept_[from], std::nullopt); }

void PictureStore::drop(std::size_t place, Stage& stage) {
  if (!kept_[place]) return;
  stage.release(kept_[place]->picture);
  bytes_ -= kept_[place]->bytes;
  kept_[place].reset();
}

void PictureStore::drop_all(Stage& stage) {
  for (std::size_t place = 0; place < kept_.size(); ++place) drop(place, stage);
}

}  // namespace lode::techniques
