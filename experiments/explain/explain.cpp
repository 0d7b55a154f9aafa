#include "experiments/explain/explain.h"

#include <ostream>

#include "experiments/error.h"
#include "experiments/explain/explained_scene.h"
#include "experiments/option_values.h"
#include "raster/error.h"

namespace lode::experiments {
namespace {

glm::ivec2 read_pixel_inside(const std::string& text, glm::ivec2 size_px) {
  const glm::ivec2 pixel = read_pixel("X,Y", text);
  if (pixel.x >= size_px.x || pixel.y >= size_px.y) {
    fail_value("X,Y", "a pixel inside " + std::to_string(size_px.x) + "x" + std::to_string(size_px.y), text);
  }
  return pixel;
}

std::size_t read_sample(const std::string& text, int n_samples) {
  const std::optional<std::int64_t> sample = whole_number_in(text);
  if (!sample || *sample >= n_samples) {
    fail_value("--sample", "a whole number below " + std::to_string(n_samples) + " (--samples)", text);
  }
  return std::size_t(*sample);
}

}  // namespace

void explain(const ExplainOptions& options, const CommonOptions& common, const Streams& streams) {
  const ViewRequest request = read_scene_options(options.render.scene);
  const Look look = read_look_options(options.render.look);
  const glm::ivec2 pixel = read_pixel_inside(options.pixel, request.size_px);
  const std::size_t sample = read_sample(options.sample, request.n_samples);

  const SceneView view = open_view(request);
  try {
    const techniques::SceneDraws scene_draws(view.scene, look.draws);
    const std::vector<raster::Draw> draws = scene_draws.draws(view.camera, view.size_px);
    const raster::Frame frame{
        .draws = draws, .clear = look.clear, .viewport = {}, .scissor = {}, .samples_fx8 = view.samples_fx8};
    const raster::PixelExplanation explanation = raster::explain_pixel(
        frame, view.size_px, techniques::color_format(look.draws.color_space), pixel, common.threads);
    const ExplainedScene explained{view, look.draws.color_space, explanation, sample};
    streams.out << (options.json ? explanation_json(explained) : explanation_text(explained)) << std::flush;
  } catch (const raster::Error& error) {
    const bool memory = error.kind() == raster::ErrorKind::out_of_memory;
    throw Error(memory ? Status::machine_failed : Status::bad_input, view.scene.name + ": " + error.what());
  }
  if (!streams.out) throw Error(Status::machine_failed, "standard output: cannot be written");
}

}  // namespace lode::experiments
