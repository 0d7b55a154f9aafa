#include "experiments/harness/visible_samples.h"

#include <charconv>

#include "geometry/random.h"
#include "raster/render.h"

namespace lode::experiments {
namespace {

/// Item buffers of one view, one after the other.
class ItemBuffers {
 public:
  ItemBuffers(const techniques::World& world, const techniques::View& view, const raster::RenderOptions& options)
      : world_(world), draws_(world.draws().draws(view.camera, view.size_px)), options_(options) {
    options_.memory = &memory_;
    options_.skips = {};
    image_ = raster::make_image(view.size_px, techniques::color_format(world.color_space()),
                                {.color = false, .depth = false, .ids = true});
  }

  /// Adds the samples that each object owns, at one place in every pixel.
  void add(glm::ivec2 sample_fx8, std::vector<std::uint32_t>& owned) {
    const glm::ivec2 samples[] = {sample_fx8};
    const raster::Frame frame{.draws = draws_, .clear = {}, .viewport = {}, .scissor = {}, .samples_fx8 = samples};
    static_cast<void>(raster::render(frame, image_, options_));
    add_owned_samples(image_, world_, owned);
  }

 private:
  const techniques::World& world_;
  std::vector<raster::Draw> draws_;
  raster::FrameMemory memory_;
  raster::RenderOptions options_;
  raster::Image image_;
};

/// The list, and where the next one begins.
bool read_list(std::string_view& text, std::size_t n, std::vector<std::uint32_t>& list) {
  list.clear();
  while (list.size() < n) {
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return false;
    list.push_back(value);
    text.remove_prefix(std::size_t(end - text.data()));
    if (text.empty() || text[0] != (list.size() == n ? '\n' : ' ')) return false;
    text.remove_prefix(1);
  }
  return true;
}

}  // namespace

void add_owned_samples(const raster::Image& image, const techniques::World& world, std::vector<std::uint32_t>& owned) {
  for (const raster::Ids& ids : image.ids) {
    if (ids.draw != raster::kNoId) ++owned[world.object_of(ids.draw)];
  }
}

VisibleSamples visible_samples(const techniques::World& world, const techniques::View& view, std::uint64_t seed,
                               std::uint64_t view_number, const raster::RenderOptions& options) {
  const std::size_t n = world.objects().size();
  VisibleSamples samples{std::vector<std::uint32_t>(n), std::vector<std::uint32_t>(n), std::vector<std::uint32_t>(n)};
  ItemBuffers buffers(world, view, options);
  buffers.add({128, 128}, samples.centre);
  for (int k = 0; k < 16; ++k) buffers.add({32 + 64 * (k % 4), 32 + 64 * (k / 4)}, samples.grid);
  geometry::Random random(seed, 0x5A3B, view_number);
  for (int k = 0; k < kRandomOffsets; ++k) {
    const auto x = int(random.below(256)), y = int(random.below(256));
    buffers.add({x, y}, samples.random);
  }
  return samples;
}

std::string text_of(const VisibleSamples& samples) {
  std::string text;
  for (const auto* list : {&samples.centre, &samples.grid, &samples.random}) {
    for (std::size_t i = 0; i < list->size(); ++i) text += (i > 0 ? " " : "") + std::to_string((*list)[i]);
    text += "\n";
  }
  return text;
}

bool read_visible_samples(std::string_view text, std::size_t n_objects, VisibleSamples& samples) {
  return read_list(text, n_objects, samples.centre) && read_list(text, n_objects, samples.grid) &&
         read_list(text, n_objects, samples.random) && text.empty();
}

}  // namespace lode::experiments
