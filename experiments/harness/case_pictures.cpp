#include "experiments/harness/case_pictures.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <numeric>

#include "experiments/display_bytes.h"
#include "experiments/harness/png_file.h"
#include "experiments/harness/sky.h"
#include "experiments/harness/visible_samples.h"
#include "experiments/metrics/flip/flip.h"
#include "experiments/metrics/magma.h"
#include "experiments/whole_file.h"
#include "raster/render.h"
#include "techniques/objects_in_view.h"

namespace lode::experiments {
namespace {

using techniques::ObjectId;

/// What covers more than this of the scene is ground, which would hide all else from above.
constexpr double kGroundShare = 0.5;

constexpr glm::u8vec4 kFrameColor{255, 210, 60, 255};

/// Of top views, and of their keys in a page that holds one.
constexpr const char* kTopStyle = R"(<style>
.seen { --key: #2da44e; } .kept { --key: #e0a000; } .culled { --key: #54aeff; } .lost { --key: #e02030; }
.out { --key: #888a; }
.top { background: #8881; }
.top rect { fill: var(--key); stroke: var(--key); stroke-width: 1; fill-opacity: .55; vector-effect: non-scaling-stroke; }
.top .out { fill-opacity: .2; } .top .lost { fill-opacity: 1; stroke-width: 4; }
.top .view { fill: #8884; } .top .eye { fill: currentColor; stroke: #888; }
</style>
)";

std::string one_digit(double value) {
  std::array<char, 64> text;
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 1);
  return error == std::errc() ? std::string(text.data(), end) : "0";
}

/// What a top view says of an object, as a class of its style sheet.
const char* class_of(bool in_view, bool drawn, bool owns_samples) {
  if (!in_view) return "out";
  if (drawn) return owns_samples ? "seen" : "kept";
  return owns_samples ? "lost" : "culled";
}

std::string rectangle(const geometry::Bounds& box, const glm::dvec2& origin, double scale, const char* style) {
  const auto at = [&](double v, double from) { return one_digit((v - from) * scale); };
  return "<rect class=\"" + std::string(style) + "\" x=\"" + at(box.low.x, origin.x) + "\" y=\"" +
         at(box.low.z, origin.y) + "\" width=\"" + one_digit((box.high.x - box.low.x) * scale) + "\" height=\"" +
         one_digit((box.high.z - box.low.z) * scale) + "\"/>\n";
}

/// A frame around what may be a few pixels, this far from them.
constexpr int kFrameDistance_px = 6;
void draw_frame(glm::ivec2 size_px, const glm::ivec2& low, const glm::ivec2& high, std::vector<glm::u8vec4>& bytes) {
  const glm::ivec2 a = glm::max(low - kFrameDistance_px, 0), b = glm::min(high + kFrameDistance_px, size_px - 1);
  const auto set = [&](int x, int y) { bytes[std::size_t(y) * std::size_t(size_px.x) + std::size_t(x)] = kFrameColor; };
  for (int x = a.x; x <= b.x; ++x) set(x, a.y), set(x, b.y);
  for (int y = a.y; y <= b.y; ++y) set(a.x, y), set(b.x, y);
}

/// The whole picture, dark; samples of objects that are missing, bright red, and framed.
std::vector<glm::u8vec4> difference_of(const raster::Image& whole, const techniques::World& world,
                                       const PreparedMethod& method) {
  std::vector<glm::u8vec4> bytes = display_bytes(whole.rgba32f);
  glm::ivec2 low = whole.size_px, high(-1);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::uint32_t draw = whole.ids[i].draw;
    const bool lost = draw != raster::kNoId && !method.stage().drawn(world.object_of(draw));
    const int grey = (bytes[i].r + bytes[i].g + bytes[i].b) / 9;
    bytes[i] = lost ? glm::u8vec4(255, 40, 40, 255) : glm::u8vec4(grey, grey, grey, 255);
    if (!lost) continue;
    const glm::ivec2 p(int(i) % whole.size_px.x, int(i) / whole.size_px.x);
    low = glm::min(low, p), high = glm::max(high, p);
  }
  if (high.x >= 0) draw_frame(whole.size_px, low, high, bytes);
  return bytes;
}

}  // namespace

std::size_t telling_frame(const CullingCase& one, const CaseResult& result, const std::string& method) {
  std::size_t best = one.frames.size() / 2;
  double most = 0.0;
  for (const Row& row : result.results) {
    if (row.text("method") != method || row.number("false_px") <= most) continue;
    const auto at = std::find(one.frames.begin(), one.frames.end(), std::uint32_t(row.number("frame")));
    if (at == one.frames.end()) continue;
    best = std::size_t(at - one.frames.begin()), most = row.number("false_px");
  }
  return best;
}

std::string top_view(const techniques::World& world, const geometry::Camera& camera, glm::ivec2 size_px,
                     const PreparedMethod& method, const std::vector<std::uint32_t>& owned_samples) {
  const geometry::Bounds& all = world.bounds();
  const glm::dvec2 origin(all.low.x, all.low.z), size(all.high.x - all.low.x, all.high.z - all.low.z);
  const double scale = 600.0 / std::max({size.x, size.y, 1e-9});
  const std::vector<ObjectId> inside = techniques::objects_in_view(world, {.camera = camera, .size_px = size_px});
  std::vector<bool> in_view(world.objects().size(), false);
  for (const ObjectId id : inside) in_view[id] = true;

  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"top\" viewBox=\"0 0 " +
                    one_digit(size.x * scale) + " " + one_digit(size.y * scale) + "\">\n" + kTopStyle;
  // Large things lie below small ones, and what is lost above all.
  std::vector<ObjectId> order(world.objects().size());
  std::iota(order.begin(), order.end(), ObjectId{0});
  const auto area = [&](ObjectId id) {
    const glm::dvec3 side = world.objects()[id].bounds.high - world.objects()[id].bounds.low;
    return side.x * side.z;
  };
  const auto lost = [&](ObjectId id) { return !method.stage().drawn(id) && owned_samples[id] > 0; };
  std::stable_sort(order.begin(), order.end(),
                   [&](ObjectId a, ObjectId b) { return lost(a) != lost(b) ? lost(b) : area(a) > area(b); });
  for (const ObjectId id : order) {
    const techniques::WorldObject& object = world.objects()[id];
    if (object.bounds.empty() || area(id) > kGroundShare * size.x * size.y) continue;
    const char* style = class_of(in_view[id], method.stage().drawn(id), owned_samples[id] > 0);
    svg += rectangle(object.bounds, origin, scale, style);
  }
  // The eye, and the sides of the view.
  const glm::dvec2 half = geometry::half_extent(camera, size_px);
  const double reach = 2.0 * std::max(size.x, size.y);
  const auto corner = [&](double side) {
    const glm::dvec3 p = camera.eye + reach * (side * half.x * camera.right - camera.back);
    return one_digit((p.x - origin.x) * scale) + "," + one_digit((p.z - origin.y) * scale);
  };
  const std::string eye =
      one_digit((camera.eye.x - origin.x) * scale) + "," + one_digit((camera.eye.z - origin.y) * scale);
  return svg + "<polygon class=\"view\" points=\"" + eye + " " + corner(-1.0) + " " + corner(1.0) +
         "\"/>\n<circle class=\"eye\" r=\"5\" cx=\"" + eye.substr(0, eye.find(',')) + "\" cy=\"" +
         eye.substr(eye.find(',') + 1) + "\"/>\n</svg>\n";
}

std::vector<std::string> write_case_pictures(const CullingCase& one, std::size_t frame, const techniques::World& world,
                                             PreparedMethod& method, std::span<PreparedMethod* const> rivals,
                                             const raster::RenderOptions& options, const std::string& folder) {
  const techniques::View view{.camera = one.cameras[frame], .size_px = one.size_px};
  raster::Image whole = raster::make_image(one.size_px, raster::ColorFormat::rgba32f), drawn = whole;
  const auto draws = world.draws().draws(view.camera, view.size_px);
  raster::render({.draws = draws, .clear = kSky, .viewport = {}, .scissor = {}}, whole, options);
  static_cast<void>(method.draw(view, drawn, kSky));
  std::vector<std::uint32_t> owned(world.objects().size(), 0);
  add_owned_samples(whole, world, owned);
  const std::string name = one.scene + "." + one.path + "." + std::to_string(one.frames[frame]);
  std::vector<std::string> files;
  const auto write = [&](const char* kind, std::span<const glm::u8vec4> colors) {
    files.push_back(name + kind);
    write_png(folder + "/" + files.back(), one.size_px, colors);
  };
  const std::vector<glm::u8vec4> reference = display_bytes(whole.rgba32f), shown = display_bytes(drawn.rgba32f);
  write(".whole.png", reference);
  if (reference != shown) {
    write(".drawn.png", shown);
    write(".difference.png", difference_of(whole, world, method));
    const PicturePair pair{one.size_px, reference, shown};
    write(".flip.png", magma_picture(flip_map(pair, {.threads = options.threads}).errors));
  }
  const auto write_top = [&](const std::string& kind, const PreparedMethod& of) {
    files.push_back(name + kind + ".top.svg");
    write_whole_file(folder + "/" + files.back(), top_view(world, view.camera, view.size_px, of, owned));
  };
  write_top("", method);
  for (PreparedMethod* rival : rivals) {
    static_cast<void>(rival->draw(view, drawn, kSky));
    write_top("." + rival->method().name, *rival);
  }
  return files;
}

}  // namespace lode::experiments
