#include "experiments/truth/check_view.h"

#include <atomic>

#include "raster/render.h"

namespace lode::experiments::truth {
namespace {

/// A part of a view's work, which itself is done in parts: `pixels` is its share of all.
class Share {
 public:
  Share(const std::function<void(std::uint64_t)>& report, std::uint64_t pixels, std::size_t parts)
      : report_(report), pixels_(pixels), parts_(parts) {}
  ~Share() { advance(pixels_); }

  /// One more part of `parts` is done; from any thread.
  void part_done() {
    const std::uint64_t done = done_.fetch_add(1) + 1;
    if (parts_ > 0) advance(done * pixels_ / parts_);
  }

 private:
  void advance(std::uint64_t to) {
    if (to > pixels_) to = pixels_;
    std::uint64_t seen = reported_.load();
    while (seen < to && !reported_.compare_exchange_weak(seen, to)) {
    }
    if (seen < to && report_) report_(to - seen);
  }

  const std::function<void(std::uint64_t)>& report_;
  std::uint64_t pixels_;
  std::size_t parts_;
  std::atomic<std::uint64_t> done_{0}, reported_{0};
};

std::uint64_t area(glm::ivec2 size_px) { return std::uint64_t(size_px.x) * std::uint64_t(size_px.y); }

raster::Image rasterize(std::span<const raster::Draw> draws, glm::ivec2 size_px, raster::RenderOptions options,
                        const std::function<void(std::uint64_t)>& on_pixels) {
  raster::Image image =
      raster::make_image(size_px, raster::ColorFormat::rgba8, {.color = false, .depth = true, .ids = true});
  Share share(on_pixels, area(size_px) / 4, raster::n_tiles(size_px, options));
  options.on_tile = [&] { share.part_done(); };
  static_cast<void>(raster::render({.draws = draws, .viewport = {}, .scissor = {}}, image, options));
  return image;
}

}  // namespace

ViewCheck check_view(const techniques::SceneDraws& scene_draws, const geometry::Camera& camera,
                     const geometry::Bounds& bounds, glm::ivec2 size_px, const raster::RenderOptions& options,
                     const std::function<void(std::uint64_t)>& on_pixels) {
  const std::vector<raster::Draw> all = scene_draws.draws(camera, size_px);
  const SolidDraws solid = solid_draws(scene_draws.scene(), all);
  const raster::Image image = rasterize(solid.draws, size_px, options, on_pixels);

  const CameraRays rays(solid.traced(), camera, size_px, bounds);
  std::vector<raster::Ids> ray_ids;
  {
    Share share(on_pixels, area(size_px) / 4, std::size_t(size_px.y));
    ray_ids = trace_ids(rays, size_px, options.threads, [&] { share.part_done(); });
  }

  ViewCheck view;
  view.left_out = solid.left_out;
  const PicturePair pair{solid.draws, size_px, image.ids, image.depth, ray_ids};
  {
    Share share(on_pixels, area(size_px) - 2 * (area(size_px) / 4), check_steps(pair));
    view.picture = check_picture(pair, options.threads, [&] { share.part_done(); });
  }

  std::vector<glm::ivec2> at_edges;
  for (std::size_t i = 0; i < view.picture.verdicts.size(); ++i) {
    if (view.picture.verdicts[i] == Verdict::edge) at_edges.emplace_back(i % size_px.x, i / size_px.x);
  }
  const double enough_px = double(at_edges.size()) / kEdgeBand_px;  // from there on the bound holds
  view.edges = visible_edges(
      size_px, ray_ids, at_edges, enough_px, [&](glm::dvec2 p_px) { return rays.nearest(p_px); }, options.threads);
  return view;
}

}  // namespace lode::experiments::truth
