#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/explain/explained_scene.h"
#include "experiments/render/look_options.h"
#include "raster/render.h"

namespace lode::experiments {
namespace {

using nlohmann::ordered_json;

template <class Vector>
ordered_json array_of(const Vector& v) {
  ordered_json array = ordered_json::array();
  for (glm::length_t i = 0; i < Vector::length(); ++i) array.push_back(v[i]);
  return array;
}

ordered_json ids_json(const raster::Ids& ids) { return {ids.draw, ids.primitive}; }

/// JSON has no infinity.
ordered_json number_json(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json lookup_json(const raster::TextureLookup& lookup) {
  ordered_json reads = ordered_json::array();
  for (const raster::TexelRead& read : lookup.reads) {
    reads.push_back({{"level", read.level}, {"texel", array_of(read.texel)}, {"weight", read.weight}});
  }
  ordered_json json = {{"uv", array_of(lookup.uv)},
                       {"duv_dx", array_of(lookup.duv_dx)},
                       {"duv_dy", array_of(lookup.duv_dy)},
                       {"probes", lookup.probes}};
  if (lookup.lambda_fx8) json["lambda"] = *lookup.lambda_fx8 / 256.0;
  json["texels"] = reads;
  return json;
}

ordered_json color_json(const raster::ExplainedColor& color) {
  return {{"color", array_of(color.color)},
          {"texel", array_of(color.texel)},
          {"material", array_of(color.material)},
          {"normal", array_of(color.normal)},
          {"shaded", array_of(color.shaded)}};
}

ordered_json piece_json(const ExplainedScene& explained, const raster::ExplainedPiece& piece) {
  ordered_json json = {{"fate", fate_name(piece.fate)},
                       {"draw", piece.draw},
                       {"name", draw_name(explained.view.scene, piece.draw)},
                       {"primitive", piece.primitive},
                       {"piece", piece.number},
                       {"key", {piece.ids.draw, piece.ids.primitive, piece.number}},
                       {"front_facing", piece.front_facing},
                       {"clipped", piece.clipped}};
  if (!piece.edges.empty()) {
    ordered_json edges = ordered_json::array();
    for (const raster::ExplainedEdge& edge : piece.edges) {
      edges.push_back({{"from_fx8", array_of(edge.a_fx8)},
                       {"to_fx8", array_of(edge.b_fx8)},
                       {"value", edge.value},
                       {"top_left", edge.top_left}});
    }
    json["edges"] = edges;
    json["other_piece_owns"] = piece.other_piece_owns;
  }
  if (piece.depth) {
    json["depth"] = *piece.depth;
    json["distance"] = number_json(view_distance(explained.view.camera, *piece.depth));
    json["vertices"] = piece.vertices;
    json["weights"] = std::vector<double>(piece.weights.begin(), piece.weights.begin() + piece.vertices.size());
  }
  if (piece.depth_before) json["depth_before"] = *piece.depth_before;
  if (piece.lookup) json["texture"] = lookup_json(*piece.lookup);
  if (piece.color) json["shading"] = color_json(*piece.color);
  if (piece.before) json["before"] = array_of(*piece.before);
  if (piece.after) json["after"] = array_of(*piece.after);
  return json;
}

}  // namespace

std::string explanation_json(const ExplainedScene& explained) {
  const raster::PixelExplanation& e = explained.explanation;
  ordered_json counters = ordered_json::object();
  for (const auto& [name, value] : {std::pair<const char*, std::uint64_t>{"in", e.discarded.primitives_in},
                                    {"not_finite", e.discarded.primitives_not_finite},
                                    {"outside", e.discarded.primitives_outside},
                                    {"facing", e.discarded.primitives_facing},
                                    {"empty", e.discarded.primitives_empty},
                                    {"clipped", e.discarded.primitives_clipped}}) {
    counters[name] = value;
  }
  ordered_json samples = ordered_json::array();
  for (const raster::ExplainedSample& sample : e.samples) {
    ordered_json pieces = ordered_json::array();
    for (const raster::ExplainedPiece& piece : sample.pieces) pieces.push_back(piece_json(explained, piece));
    samples.push_back({{"position_fx8", array_of(sample.p_fx8)},
                       {"color", array_of(sample.color)},
                       {"depth", sample.depth},
                       {"ids", ids_json(sample.ids)},
                       {"pieces", pieces}});
  }
  const ordered_json json = {{"scene", explained.view.scene.name},
                             {"size", array_of(explained.view.size_px)},
                             {"pixel", array_of(e.pixel)},
                             {"color_space", color_space_name(explained.color_space)},
                             {"pixel_contract", raster::kPixelContract},
                             {"color", array_of(e.color)},
                             {"primitives", counters},
                             {"samples", samples}};
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace lode::experiments
