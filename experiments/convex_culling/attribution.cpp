#include "experiments/convex_culling/attribution.h"

#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include "experiments/convex_culling/names.h"
#include "experiments/harness/visible_samples.h"
#include "raster/render.h"

namespace lode::experiments {
namespace {

using techniques::ObjectId;

/// What is taken back, one after the other: an object that comes back with step k was lost by cause k.
constexpr std::array kSteps = {",depth_rule=on", ",depth_rule=on,slab_mode=conservative"};
static_assert(kSteps.size() + 1 == kCauses.size());

std::set<ObjectId> not_drawn(PreparedMethod& method, const techniques::View& view, raster::Image& image) {
  static_cast<void>(method.draw(view, image));
  std::set<ObjectId> ids;
  for (ObjectId id = 0; id < method.stage().world().objects().size(); ++id) {
    if (!method.stage().drawn(id)) ids.insert(id);
  }
  return ids;
}

/// The pixels that each object owns.
std::vector<std::uint32_t> owned_px(const techniques::World& world, const techniques::View& view,
                                    const raster::RenderOptions& options) {
  raster::Image image = raster::make_image(view.size_px, techniques::color_format(world.color_space()),
                                           {.color = false, .depth = false, .ids = true});
  const auto draws = world.draws().draws(view.camera, view.size_px);
  raster::render({.draws = draws, .clear = {}, .viewport = {}, .scissor = {}}, image, options);
  std::vector<std::uint32_t> owned(world.objects().size(), 0);
  add_owned_samples(image, world, owned);
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
    for (const char* settings : kSteps) {
      variants.push_back(std::make_unique<PreparedMethod>(make_method(name + settings), world, options));
    }
    std::array<std::int64_t, kCauses.size()> lost_px{};
    std::int64_t n_frames = 0;
    for (std::size_t i = 0; i < one.frames.size(); ++i) {
      const auto is_this = [&](const Row& row) {
        return row.text("method") == name && row.number("frame") == double(one.frames[i]) &&
               row.number("false_px") > 0.0;
      };
      if (std::none_of(result.results.begin(), result.results.end(), is_this)) continue;
      ++n_frames;
      const techniques::View view{.camera = one.cameras[i], .size_px = one.size_px};
      const std::vector<std::uint32_t> owned = owned_px(world, view, options);
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
    for (std::size_t cause = 0; cause < kCauses.size(); ++cause) row.add(kCauses[cause].column, lost_px[cause]);
  }
  return rows;
}

}  // namespace lode::experiments
