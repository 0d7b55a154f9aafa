#include "experiments/technique_list.h"

#include "experiments/option_values.h"
#include "geometry/shortened.h"
#include "techniques/convex_culling/convex_culling.h"
#include "techniques/frustum_culling/frustum_culling.h"
#include "techniques/hierarchical_z/hierarchical_z.h"
#include "techniques/image_reuse/image_reuse.h"
#include "techniques/inner_boxes/inner_boxes.h"
#include "techniques/masked_occlusion/masked_occlusion.h"
#include "techniques/mesh_lod/mesh_lod.h"
#include "techniques/octahedral_impostors/octahedral_impostors.h"
#include "techniques/plain/plain.h"
#include "techniques/predicted_reuse/predicted_reuse.h"
#include "techniques/twelve_views/twelve_views.h"

namespace lode::experiments {
namespace {

/// Which objects are occluders: the same words for every culler.
std::vector<Parameter> with_occluder_parameters(std::vector<Parameter> parameters,
                                                const techniques::OccluderRule& rule = {}) {
  parameters.push_back({"occluders", "objects that hide others: at most", 0, 1e6, double(rule.most), true});
  parameters.push_back({"least_degree", "occluder degree of the last one", 0, 1, rule.least_degree});
  parameters.push_back(
      {"far", "distance at which the degree is 0; 0: the diagonal of scene and eye", 0, 1e9, rule.far});
  return parameters;
}

techniques::OccluderRule occluder_rule(const ParameterValues& v) {
  return {.least_degree = v.at("least_degree"), .most = int(v.at("occluders")), .far = v.at("far")};
}

AnyTechnique make_hierarchical_z(const ParameterValues& v) {
  return AnyTechnique(techniques::HierarchicalZ({.occluders = occluder_rule(v), .scale = 1 << int(v.at("scale"))}));
}

/// Of everything that tests boxes against convex parts on slabs.
std::vector<Parameter> with_slab_parameters(std::vector<Parameter> parameters,
                                            const techniques::SlabCullingParams& slabs) {
  parameters.push_back({"angle", "between eye, occluder and occludee at most, degrees", 0, 180, slabs.angle_limit_deg});
  parameters.push_back({"slabs", "of the virtual screen", 1, 65536, double(slabs.n_slabs), true});
  parameters.push_back(choice_parameter("fusion", "whose parts count together", {"per_occluder", "all"}, 1));
  parameters.push_back(choice_parameter("levels", "which levels decide", {"last", "any"}, 0));
  return with_occluder_parameters(std::move(parameters), slabs.occluders);
}

void set_slab_parameters(const ParameterValues& v, techniques::SlabCullingParams& slabs) {
  slabs.occluders = occluder_rule(v);
  slabs.angle_limit_deg = v.at("angle");
  slabs.n_slabs = int(v.at("slabs"));
  slabs.fusion = techniques::Fusion(int(v.at("fusion")));
  slabs.levels = techniques::LevelRule(int(v.at("levels")));
}

/// What each mode of convex culling has a value of its own for: kOfMode stands for that.
constexpr double kOfMode = -1.0;
Parameter of_mode(const char* name, const char* meaning, double high, bool whole = false) {
  return {name, std::string(meaning) + "; -1: as the mode has it", kOfMode, high, kOfMode, whole};
}

std::vector<Parameter> with_preselection_parameters(std::vector<Parameter> parameters) {
  parameters.push_back(of_mode("least_area", "quantile of A(S) from which on objects are occluders", 1));
  parameters.push_back(of_mode("error", "E/A(S) of an occluder at most", 1e9));
  parameters.push_back(of_mode("excess", "of its silhouette that an occluder hides too much at most", 1e9));
  parameters.push_back(of_mode("hull_excess", "likewise of one hull", 1e9));
  parameters.push_back(of_mode("occluder_excess", "likewise of a hull that hides occluders", 1e9));
  parameters.push_back(of_mode("hull_size", "of a model's silhouette that a hull has at least", 1));
  parameters = with_slab_parameters(std::move(parameters), {});
  for (Parameter& p : parameters) {
    if (p.name == "angle" || p.name == "occluders") p = of_mode(p.name.c_str(), p.meaning.c_str(), p.high, p.whole);
  }
  return parameters;
}

void set_preselection(const ParameterValues& v, techniques::ConvexCulling::Params& params) {
  const auto set = [&](const char* name, double& value) {
    if (v.at(name) != kOfMode) value = v.at(name);
  };
  set("least_area", params.least_area_quantile);
  set("error", params.largest_error);
  set("excess", params.largest_excess);
  set("hull_excess", params.largest_hull_excess);
  set("occluder_excess", params.largest_occluder_excess);
  set("hull_size", params.least_hull_size);
}

/// To see which rule of a mode does what: "of_mode", or another.
std::vector<Parameter> with_rule_parameters(std::vector<Parameter> parameters) {
  parameters.push_back(
      choice_parameter("depth_rule", "a hull hides only what is behind it", {"of_mode", "off", "on"}, 0));
  parameters.push_back(
      choice_parameter("test_occluders", "what others hide hides nothing", {"of_mode", "off", "on"}, 0));
  parameters.push_back(
      choice_parameter("slab_mode", "what a slab is", {"of_mode", "paper", "exact_x", "conservative"}, 0));
  return with_preselection_parameters(std::move(parameters));
}

AnyTechnique make_convex_culling(const ParameterValues& v) {
  auto params = techniques::ConvexCulling::params_for(techniques::ConvexCulling::Mode(int(v.at("mode"))));
  const techniques::SlabCullingParams of_mode = params.slabs;
  set_slab_parameters(v, params.slabs);
  if (v.at("angle") == kOfMode) params.slabs.angle_limit_deg = of_mode.angle_limit_deg;
  if (v.at("occluders") == kOfMode) params.slabs.occluders.most = of_mode.occluders.most;
  set_preselection(v, params);
  if (const int depth_rule = int(v.at("depth_rule")); depth_rule > 0) params.slabs.depth_rule = depth_rule == 2;
  if (const int test = int(v.at("test_occluders")); test > 0) params.slabs.test_occluders = test == 2;
  if (const int mode = int(v.at("slab_mode")); mode > 0) params.slabs.slabs = geometry::SlabMode(mode - 1);
  return AnyTechnique(techniques::ConvexCulling(params));
}

std::vector<Parameter> with_box_parameters(std::vector<Parameter> parameters) {
  const geometry::InnerBoxesParams boxes;
  parameters.push_back({"boxes", "in a shape at most", 0, 1000, double(boxes.n_most), true});
  parameters.push_back({"resolution", "cells on the longest side of a part", 1, 64, double(boxes.resolution), true});
  parameters.push_back({"least_share", "of a shape's volume that a box adds", 0.001, 1, boxes.least_share});
  return parameters;
}

geometry::InnerBoxesParams box_parameters(const ParameterValues& v) {
  return {.resolution = int(v.at("resolution")), .n_most = int(v.at("boxes")), .least_share = v.at("least_share")};
}

AnyTechnique make_inner_boxes(const ParameterValues& v) {
  techniques::InnerBoxes::Params params;
  params.boxes = box_parameters(v);
  set_slab_parameters(v, params.slabs);
  return AnyTechnique(techniques::InnerBoxes(params));
}

AnyTechnique make_masked_occlusion(const ParameterValues& v) {
  return AnyTechnique(techniques::MaskedOcclusion({.occluders = occluder_rule(v),
                                                   .shape = techniques::MaskedShape(int(v.at("shape"))),
                                                   .boxes = box_parameters(v)}));
}

std::vector<Parameter> image_reuse_parameters() {
  const techniques::ImageReuse::Params p;
  return {
      {"threshold", "turn of the viewing angle from which on a picture is taken anew, degrees", 0, 180,
       p.threshold_deg},
      choice_parameter("angle", "what of the viewing angle counts", {"full", "yaw"}, 0),
      choice_parameter("placement", "where plates go, and what is captured", {"corrected", "literal"}, 0),
      {"near_radii", "objects nearer than this many radii are drawn", 0, 1e6, p.far.radii},
      {"near", "objects nearer than this are drawn, world units", 0, 1e9, p.far.distance},
      {"magnification", "growth of a picture's pixels from which on it is taken anew; 0: off", 0, 1e6, p.magnification},
      {"captures", "in a frame at most; 0: no limit", 0, 1e6, double(p.most_captures), true},
      {"memory", "MiB of pictures at most; 0: no limit", 0, 1e6, 0}};
}

AnyTechnique make_image_reuse(const ParameterValues& v) {
  return AnyTechnique(techniques::ImageReuse({.threshold_deg = v.at("threshold"),
                                              .angle = techniques::AngleRule(int(v.at("angle"))),
                                              .placement = techniques::PlatePlacement(int(v.at("placement"))),
                                              .far = {.radii = v.at("near_radii"), .distance = v.at("near")},
                                              .magnification = v.at("magnification"),
                                              .most_captures = int(v.at("captures")),
                                              .most_bytes = std::uint64_t(v.at("memory") * 0x1p20)}));
}

std::vector<Parameter> predicted_reuse_parameters() {
  const techniques::PredictedReuse::Params p;
  return {{"error", "predicted of a picture from which on it is taken anew, px; 0: in every frame", 0, 1e6, p.error_px},
          {"captures", "in a frame at most, the worst first; 0: no limit", 0, 1e6, double(p.most_captures), true},
          {"cell", "side of a relief's cells, px of the picture; 0: plates", 0, 1024, double(p.cell_px), true},
          {"fade", "frames in which a new picture comes as the old one goes, dithered; 0: at once", 0, 1e4,
           double(p.fade_frames), true},
          {"near_radii", "objects nearer than this many radii are drawn", 0, 1e6, p.far.radii},
          {"near", "objects nearer than this are drawn, world units", 0, 1e9, p.far.distance},
          {"memory", "MiB of pictures at most; 0: no limit", 0, 1e6, 0}};
}

AnyTechnique make_predicted_reuse(const ParameterValues& v) {
  return AnyTechnique(techniques::PredictedReuse({.error_px = v.at("error"),
                                                  .most_captures = int(v.at("captures")),
                                                  .cell_px = int(v.at("cell")),
                                                  .fade_frames = int(v.at("fade")),
                                                  .far = {.radii = v.at("near_radii"), .distance = v.at("near")},
                                                  .most_bytes = std::uint64_t(v.at("memory") * 0x1p20)}));
}

std::vector<Parameter> mesh_lod_parameters() {
  const techniques::MeshLod::Params p;
  return {
      {"pixels", "error of a level on the screen, less than; 0: all at level 0", 0, 1e9, p.pixels},
      {"level", "1 to 3: that level everywhere; 0: by the error", 0, techniques::kMeshLevels, double(p.level), true},
      {"share1", "of a mesh's triangles that level 1 keeps", 0, 1, p.shares[0]},
      {"share2", "likewise level 2", 0, 1, p.shares[1]},
      {"share3", "likewise level 3", 0, 1, p.shares[2]}};
}

AnyTechnique make_mesh_lod(const ParameterValues& v) {
  return AnyTechnique(techniques::MeshLod({.shares = {v.at("share1"), v.at("share2"), v.at("share3")},
                                           .pixels = v.at("pixels"),
                                           .level = int(v.at("level"))}));
}

/// Which objects are drawn since they are near: the same words wherever pictures stand for the others.
std::vector<Parameter> with_near_parameters(std::vector<Parameter> parameters) {
  const techniques::FarRule far;
  parameters.push_back({"near_radii", "objects nearer than this many radii are drawn", 0, 1e6, far.radii});
  parameters.push_back({"near", "objects nearer than this are drawn, world units", 0, 1e9, far.distance});
  return parameters;
}

/// The memory of pictures that are taken beforehand.
Parameter baked_memory(std::uint64_t most_bytes) {
  return {"memory", "MiB of pictures at most, what finds no room is drawn; 0: no limit", 0, 1e6,
          double(most_bytes) * 0x1p-20};
}

techniques::FarRule far_rule(const ParameterValues& v) {
  return {.radii = v.at("near_radii"), .distance = v.at("near")};
}

std::vector<Parameter> twelve_views_parameters() {
  const techniques::TwelveViews::Params p;
  return with_near_parameters({{"elevation", "from which pictures look down, degrees", 0, 60, p.elevation_deg},
                               {"texels", "of a picture's longer side", 1, 1024, double(p.texels), true},
                               baked_memory(p.most_bytes)});
}

AnyTechnique make_twelve_views(const ParameterValues& v) {
  return AnyTechnique(techniques::TwelveViews({.elevation_deg = v.at("elevation"),
                                               .texels = int(v.at("texels")),
                                               .far = far_rule(v),
                                               .most_bytes = std::uint64_t(v.at("memory") * 0x1p20)}));
}

std::vector<Parameter> octahedral_impostors_parameters() {
  const techniques::OctahedralImpostors::Params p;
  return with_near_parameters({{"grid", "directions along a side of the grid", 2, 32, double(p.grid), true},
                               {"texels", "of a picture's longer side", 1, 1024, double(p.texels), true},
                               choice_parameter("blend", "which pictures are mixed", {"three", "nearest"}, 0),
                               choice_parameter("parallax", "read at the height that was captured", {"off", "on"}, 1),
                               baked_memory(p.most_bytes)});
}

AnyTechnique make_octahedral_impostors(const ParameterValues& v) {
  return AnyTechnique(techniques::OctahedralImpostors({.grid = int(v.at("grid")),
                                                       .texels = int(v.at("texels")),
                                                       .blend = techniques::ViewBlend(int(v.at("blend"))),
                                                       .parallax = v.at("parallax") == 1.0,
                                                       .far = far_rule(v),
                                                       .most_bytes = std::uint64_t(v.at("memory") * 0x1p20)}));
}

std::vector<TechniqueEntry> make_list() {
  return {
      {"plain",
       "The scene as it is: every object is drawn",
       {},
       [](const ParameterValues&) { return AnyTechnique(techniques::Plain{}); }},
      {"frustum_culling",
       "Objects whose box is outside the view are left out",
       {},
       [](const ParameterValues&) { return AnyTechnique(techniques::FrustumCulling{}); }},
      {"hierarchical_z", "Objects whose box is behind a pyramid of the occluders' depth are left out",
       with_occluder_parameters({choice_parameter("scale", "side of the finest texels looked at, px",
                                                  {"1", "2", "4", "8", "16", "32", "64"}, 0)}),
       make_hierarchical_z},
      {"masked_occlusion", "Objects whose box is behind a masked depth buffer of the occluders' triangles are left out",
       with_occluder_parameters(with_box_parameters({choice_parameter(
           "shape", "what stands for an occluder; hulls are approximate", {"meshes", "hulls", "inner_boxes"}, 0)})),
       make_masked_occlusion},
      {"convex_culling", "Objects whose box is covered by convex hulls of the occluders, on slabs, are left out",
       with_rule_parameters({choice_parameter("mode", "what is risked", {"literal", "safe", "conservative"}, 1)}),
       make_convex_culling},
      {"inner_boxes", "Objects whose box is covered by boxes inside the occluders, on slabs, are left out",
       with_slab_parameters(with_box_parameters({}), techniques::InnerBoxes::default_slabs()), make_inner_boxes},
      {"image_reuse", "Far objects are drawn as plates with the picture that they last had", image_reuse_parameters(),
       make_image_reuse},
      {"predicted_reuse", "Far objects are drawn as reliefs of pictures, taken anew by the error that is predicted",
       predicted_reuse_parameters(), make_predicted_reuse},
      {"mesh_lod", "Objects are drawn from simplified meshes, the coarser the smaller their error is on the screen",
       mesh_lod_parameters(), make_mesh_lod},
      {"twelve_views", "Far objects are drawn as upright plates with one of twelve pictures taken beforehand",
       twelve_views_parameters(), make_twelve_views},
      {"octahedral_impostors", "Far objects are drawn as plates mixed from pictures of a hemisphere, taken beforehand",
       octahedral_impostors_parameters(), make_octahedral_impostors},
  };
}

}  // namespace

std::span<const TechniqueEntry> technique_list() {
  static const std::vector<TechniqueEntry> list = make_list();
  return list;
}

TechniqueChoice read_technique(std::string_view option, std::string_view text) {
  const std::string_view name = text.substr(0, text.find(':'));
  std::vector<std::string_view> names;
  for (const TechniqueEntry& technique : technique_list()) names.push_back(technique.name);
  const TechniqueEntry& entry = technique_list()[read_choice(option, name, names)];
  const std::string where = "technique " + geometry::shortened(text, 80);
  const std::string_view parameters = name.size() < text.size() ? text.substr(name.size() + 1) : std::string_view();
  return {&entry, read_parameters(where, entry.parameters, parameters)};
}

}  // namespace lode::experiments
