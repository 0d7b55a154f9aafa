#include "experiments/truth/check_report.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <ostream>

namespace lode::experiments::truth {
namespace {

using nlohmann::ordered_json;

/// Sums of one view or of several.
struct Sums {
  std::uint64_t pixels = 0;
  PictureCheck picture;
  double visible_edge_px = 0.0;
  bool every_bound_holds = true;

  void add(const ViewCheck& view) {
    pixels += view.picture.verdicts.size();
    for (std::size_t v = 0; v < kVerdicts; ++v) picture.pixels[v] += view.picture.pixels[v];
    picture.on_edge_line += view.picture.on_edge_line;
    visible_edge_px += view.edges.length_px;
    every_bound_holds = every_bound_holds && view.edge_bound_holds();
  }
};

void put(ordered_json& json, const Sums& sums, const LeftOut& left_out) {
  ordered_json explained;
  for (const Verdict v : {Verdict::edge, Verdict::depth_tie, Verdict::range, Verdict::embree}) {
    explained[verdict_name(v)] = sums.picture.of(v);
  }
  json["pixels"] = sums.pixels;
  json["different"] = sums.picture.different();
  json["explained"] = explained;
  json["unexplained"] = sums.picture.of(Verdict::unexplained);
  json["left_out"] = {{"blended", left_out.blended}, {"lines", left_out.lines}, {"points", left_out.points}};
  json["edge_on_line"] = sums.picture.on_edge_line;
  json["visible_edge_px"] = sums.visible_edge_px;
  json["edge_bound"] = kEdgeBand_px * sums.visible_edge_px;
  json["edge_bound_holds"] = sums.every_bound_holds;
}

/// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
  const char* const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./:=,+-";
  if (text.find_first_not_of(plain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string ids_text(raster::Ids ids) {
  if (ids.draw == raster::kNoId) return "nothing";
  return "(" + std::to_string(ids.draw) + ", " + std::to_string(ids.primitive) + ")";
}

}  // namespace

std::uint64_t CheckReport::unexplained() const {
  std::uint64_t n = 0;
  for (const CheckedView& view : views) n += view.check.picture.of(Verdict::unexplained);
  return n;
}

std::string check_json(const CheckReport& report) {
  Sums all;
  for (const CheckedView& view : report.views) all.add(view.check);
  ordered_json json = {{"scene", report.scene}, {"size", {report.size_px.x, report.size_px.y}}};
  put(json, all, report.views.front().check.left_out);
  if (report.views.size() > 1) {
    ordered_json cameras = ordered_json::array();
    for (const CheckedView& view : report.views) {
      Sums sums;
      sums.add(view.check);
      ordered_json one = {{"camera", view.camera}, {"options", view.options}};
      put(one, sums, view.check.left_out);
      one["visible_edge_grid"] = view.check.edges.grid;
      cameras.push_back(one);
    }
    json["cameras"] = cameras;
  } else {
    json["visible_edge_grid"] = report.views.front().check.edges.grid;
  }
  // A path need not be UTF-8; JSON must be.
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

Status conclude(const CheckReport& report, std::ostream& err) {
  if (report.unexplained() == 0) return Status::done;
  std::size_t n_listed = 0;
  for (const CheckedView& view : report.views) {
    for (const Unexplained& pixel : view.check.picture.examples) {
      if (++n_listed > kMaxExamples) return Status::check_failed;
      const std::string place = std::to_string(pixel.px.x) + "," + std::to_string(pixel.px.y);
      char depth[32];
      std::snprintf(depth, sizeof depth, "%.9g", double(pixel.depth));
      err << "lodestone: pixel " << place << ": raster " << ids_text(pixel.raster) << " at depth " << depth << ", rays "
          << ids_text(pixel.rays) << ": " << pixel.why << "\n  lodestone explain " << shell_word(report.scene) << " "
          << place << " --size " << report.size_px.x << "x" << report.size_px.y << view.options << "\n";
    }
  }
  return Status::check_failed;
}

}  // namespace lode::experiments::truth
