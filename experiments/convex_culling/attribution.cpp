#include "experiments/convex_culling/attribution.h"

#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include "raster/render.h"

namespace lode::experiments {
namespace {

using techniques::ObjectId;

/// What is taken back, one after the other, and what it says of an object that comes back.
struct Step {
  const char* settings;
  const char* cause;
};
constexpr std::array kSteps = {Step{",depth_rule=on", "depth_px"},
                               Step{",depth_rule=on,slab_mode=conservative", "snapping_px"}};
constexpr const char* kRest = "bulge_px";

std::set<ObjectId> not_drawn(PreparedMethod& method, const techniques::View& view, raster::Image& image) {
  static_cast<void>(method.draw(view, image));
  std::set<ObjectId> ids;
  for (ObjectId id = 0; id < method.stage().world().objects().size(); ++id) {
    if (!method.stage().drawn(id)) ids.insert(id);
  }
  return ids;
}

/// The pixels that each object owns.
std::vector<std::uint64_t> owned_px(const techniques::World& world, const techniques::View& view,
                                    const raster::RenderOptions& options) {
  raster::Image image = raster::make_image(view.size_px, techniques::color_format(world.color_space()),
                                           {.color = false, .depth = false, .ids = true});
  const auto draws = world.draws().draws(view.camera, view.size_px);
  raster::render({.draws = draws, .clear = {}, .viewport = {}, .scissor = {}}, image, options);
  std::vector<std::uint64_t> owned(world.objects().size(), 0);
  for (const raster::Ids& ids : image.ids) {
    if (ids.draw != raster::kNoId) ++owned[world.object_of(ids.draw)];
  }
  return owned;
}

}  // namespace

std::vector<Row> attributed_losses(const CullingCase& one, const CaseResult& result, const techniques::World& world,
                                   const std::vector<std::string>& methods, const raster::RenderOptions& options) {
  raster::Image image = raster::make_image(one.size_px, techniques::color_format(world.color_space()));
  std::vector<Row> rows;
  for (const std::string& name : methods) {
    PreparedMethod method(make_method(name), world, options);
    std::vector<std::unique_ptr<PreparedMethod>> variants;
    for (const Step& step : kSteps) {
      variants.push_back(std::make_unique<PreparedMethod>(make_method(name + step.settings), world, options));
    }
    std::array<std::int64_t, kSteps.size() + 1> lost_px{};
    std::int64_t n_frames = 0;
    for (std::size_t i = 0; i < one.frames.size(); ++i) {
      const auto is_this = [&](const Row& row) {
        return row.text("method") == name && row.number("frame") == double(one.frames[i]) &&
               row.number("false_px") > 0.0;
      };
      if (std::none_of(result.results.begin(), result.results.end(), is_this)) continue;
      ++n_frames;
      const techniques::View view{.camera = one.cameras[i], .size_px = one.size_px};
      const std::vector<std::uint64_t> owned = owned_px(world, view, options);
      std::set<ObjectId> left = not_drawn(method, view, image);
      for (std::size_t step = 0; step < kSteps.size(); ++step) {
        const std::set<ObjectId> still = not_drawn(*variants[step], view, image);
        std::erase_if(left, [&](ObjectId id) {
          if (still.contains(id)) return false;
          lost_px[step] += std::int64_t(owned[id]);
          return true;
        });
      }
      for (const ObjectId id : left) lost_px.back() += std::int64_t(owned[id]);
    }
    Row& row = rows.emplace_back();
    row.add("scene", one.scene).add("path", one.path).add("method", name).add("frames_with_losses", n_frames);
    for (std::size_t step = 0; step < kSteps.size(); ++step) row.add(kSteps[step].cause, lost_px[step]);
    row.add(kRest, lost_px.back());
  }
  return rows;
}

}  // namespace lode::experiments
