#include "experiments/harness/true_error.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "experiments/display_bytes.h"
#include "experiments/harness/sky.h"
#include "experiments/harness/true_picture.h"
#include "experiments/harness/visible_samples.h"
#include "experiments/metrics/flip/flip.h"
#include "experiments/metrics/pixel_difference.h"
#include "raster/render.h"
#include "techniques/objects_in_view.h"

namespace lode::experiments {
namespace {

using Bytes = std::vector<glm::u8vec4>;
using techniques::ObjectId;

struct PictureError {
  double flip = 0.0;
  std::optional<double> psnr_db;  ///< none of equal pictures
};

PictureError error_of(glm::ivec2 size_px, const Bytes& reference, const Bytes& picture, int threads) {
  if (reference == picture) return {};
  const PicturePair pair{size_px, reference, picture};
  return {mean_error(flip_map(pair, {.threads = threads}).errors), psnr(pixel_difference(pair))};
}

void add(const PictureError& error, const std::string& against, Row& row) {
  row.add("flip_" + against, error.flip);
  if (error.psnr_db) row.add("psnr_" + against + "_db", *error.psnr_db);
}

/// Most methods draw the same picture: each one that differs is measured once.
class ErrorsOfView {
 public:
  ErrorsOfView(glm::ivec2 size_px, Bytes truth, Bytes whole, int threads)
      : size_px_(size_px), truth_(std::move(truth)), whole_(std::move(whole)), threads_(threads) {}

  void add_to(Row& row, const Bytes& picture) {
    auto known = std::find_if(known_.begin(), known_.end(), [&](const Known& k) { return k.picture == picture; });
    if (known == known_.end()) {
      known = known_.insert(known, {picture, error_of(size_px_, truth_, picture, threads_),
                                    error_of(size_px_, whole_, picture, threads_)});
    }
    add(known->from_truth, "true", row);
    add(known->from_whole, "whole", row);
  }

 private:
  struct Known {
    Bytes picture;
    PictureError from_truth, from_whole;
  };
  glm::ivec2 size_px_;
  Bytes truth_, whole_;
  int threads_;
  std::vector<Known> known_;
};

/// What the oracle is told: objects in view that own a pixel.
std::vector<ObjectId> seen_objects(const techniques::World& world, const techniques::View& view,
                                   const raster::Image& whole) {
  std::vector<std::uint32_t> owned(world.objects().size(), 0);
  add_owned_samples(whole, world, owned);
  std::vector<ObjectId> seen = techniques::objects_in_view(world, view);
  std::erase_if(seen, [&](ObjectId id) { return owned[id] == 0; });
  return seen;
}

}  // namespace

void add_true_errors(const CullingCase& one, std::size_t i, const techniques::World& world, std::string_view look,
                     std::span<PreparedMethod* const> methods, const KeptResults& kept,
                     const raster::RenderOptions& options, CaseResult& result) {
  const techniques::View view{.camera = one.cameras[i], .size_px = one.size_px};
  TruePicture truth = true_picture(world, look, view, options, kept);
  for (glm::vec4& c : truth) c += (1.0f - c.a) * kSky;
  raster::Image image = raster::make_image(view.size_px, raster::ColorFormat::rgba32f);
  const auto draws = world.draws().draws(view.camera, view.size_px);
  raster::render({.draws = draws, .clear = kSky, .viewport = {}, .scissor = {}}, image, options);
  const std::vector<ObjectId> seen = seen_objects(world, view, image);
  ErrorsOfView errors(view.size_px, display_bytes(truth), display_bytes(image.rgba32f), options.threads);
  for (PreparedMethod* method : methods) {
    method->show(seen);
    static_cast<void>(method->draw(view, image, kSky));
    const auto row = std::find_if(result.results.begin(), result.results.end(), [&](const Row& r) {
      return r.number("frame") == double(one.frames[i]) && r.text("method") == method->method().name;
    });
    if (row != result.results.end()) errors.add_to(*row, display_bytes(image.rgba32f));
  }
}

}  // namespace lode::experiments
