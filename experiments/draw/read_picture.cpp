#include "experiments/draw/read_picture.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <istream>
#include <memory>
#include <nlohmann/json.hpp>

#include "experiments/draw/read_draw.h"
#include "experiments/error.h"
#include "experiments/sample_positions.h"
#include "geometry/json/json_view.h"
#include "geometry/json/parse_json.h"
#include "raster/image.h"

namespace lode::experiments {
namespace {

using geometry::JsonView;

/// A picture is a handful of primitives: what is longer was meant for something else.
constexpr std::size_t kMaxText = std::size_t(256) << 20;

glm::ivec2 read_size(const JsonView& view) {
  if (view.size("[width, height]") != 2) view.fail_expected("[width, height]");
  return {int(view.at(0).integer(0, raster::kMaxTargetSize_px)), int(view.at(1).integer(0, raster::kMaxTargetSize_px))};
}

int read_sample_count(const JsonView& view) {
  const std::int64_t n = view.integer(1, 128);
  if ((n & (n - 1)) != 0) view.fail_expected("a power of two up to 128");
  return int(n);
}

}  // namespace

std::string read_text(const std::string& path, std::istream& standard_input) {
  const bool from_file = path != "-";
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(from_file ? std::fopen(path.c_str(), "rb") : nullptr);
  if (from_file && !file) throw Error(Status::bad_input, path + ": cannot be read: " + std::strerror(errno));

  std::string text;
  char block[1 << 16];
  for (;;) {
    std::size_t n = 0;
    if (from_file) {
      n = std::fread(block, 1, sizeof block, file.get());
      if (n == 0 && std::ferror(file.get())) {
        throw Error(Status::bad_input, path + ": cannot be read: " + std::strerror(errno));
      }
    } else {
      standard_input.read(block, sizeof block);
      n = std::size_t(standard_input.gcount());
    }
    if (n == 0) return text;
    text.append(block, n);
    if (text.size() > kMaxText)
      throw Error(Status::bad_input, path + ": longer than 256 MiB: expected a small picture");
  }
}

Picture read_picture(std::string_view json_text, const std::string& name) {
  const nlohmann::json document = geometry::parse_json(json_text, name);
  const JsonView view(document, name);
  constexpr std::string_view kKeys[] = {"size", "unit", "clear", "samples", "clip_from_world", "scissor", "draws"};
  view.check_keys(kKeys);

  Picture picture;
  const auto size = view.find("size");
  if (!size) view.fail("expected \"size\": [width, height]");
  picture.size_px = read_size(*size);

  DrawContext context;
  if (const auto unit = view.find("unit")) context.in_fx8 = unit->choice({"px", "1/256"}) == 1;
  if (const auto matrix = view.find("clip_from_world")) context.clip_from_world = read_matrix(*matrix);
  if (const auto clear = view.find("clear")) picture.clear = clear->color();
  if (const auto scissor = view.find("scissor")) picture.scissor = read_rect(*scissor);
  const auto samples = view.find("samples");
  picture.samples_fx8 = sample_positions_fx8(samples ? read_sample_count(*samples) : 1);

  const auto draws = view.find("draws");
  if (!draws) view.fail("expected \"draws\": [...]");
  const std::size_t n_draws = draws->size("an array of draws");
  picture.draws.reserve(n_draws);
  for (std::size_t i = 0; i < n_draws; ++i) picture.draws.push_back(read_draw(draws->at(i), context));
  return picture;
}

}  // namespace lode::experiments
