#include "geometry/model_file/obj/obj_file.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/model_file/line_reader.h"
#include "geometry/model_file/obj/obj_corners.h"
#include "geometry/model_file/obj/obj_materials.h"
#include "geometry/model_file/obj/obj_mesh.h"
#include "geometry/polygon.h"
#include "geometry/shortened.h"

namespace lode::geometry {
namespace {

/// Statements that change nothing that is drawn here: smoothing, display, and what free-form surfaces are made of.
constexpr std::string_view kIgnored[] = {"s",          "mg",        "lod",   "bevel", "c_interp", "d_interp",
                                         "shadow_obj", "trace_obj", "ctech", "stech", "maplib",   "usemap",
                                         "vp",         "deg",       "bmat",  "step",  "cstype",   "parm",
                                         "trim",       "hole",      "scrv",  "sp",    "end",      "con"};

/// What a part takes beyond its corners: a mesh, an instance, and perhaps a node and a material of its own.
constexpr std::size_t kPartBytes = 2048;

class ObjReader {
 public:
  explicit ObjReader(ModelFiles& files)
      : files_(files),
        file_(files.read(files.model_path(), "")),
        lines_(file_.text(), files.model_path(), true),
        materials_(files, scene_) {
    scene_.name = files.model_path();
  }

  Scene read() {
    while (lines_.next_line()) read_statement(lines_.word());
    // A node's meshes are together, in the order of their first elements.
    std::stable_sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.node < b.node; });
    for (const Part& part : parts_) add_part(part);
    materials_.read_pictures();
    return std::move(scene_);
  }

 private:
  /// What becomes one mesh.
  struct Part {
    std::uint32_t node, material;
    MeshKind kind;
    std::vector<ObjCorner> corners;  ///< of triangles, lines or points
  };

  void read_statement(std::string_view key) {
    if (key.empty() || key.starts_with('#')) return;
    if (key == "v") return read_position();
    if (key == "vt") return read_uv();
    if (key == "vn") return read_normal();
    if (key == "f" || key == "fo") return read_face();
    if (key == "l") return read_line();
    if (key == "p") return read_points();
    if (key == "usemtl") {
      material_name_ = lines_.words.rest();
      material_line_ = lines_.line_number();
      part_of_kind_ = {};
    } else if (key == "o") {
      ++object_;
      group_name_ = lines_.words.rest();
      group_.reset();
      part_of_kind_ = {};
    } else if (key == "g") {
      group_name_ = lines_.words.rest();
      group_ = group_name_;
      part_of_kind_ = {};
    } else if (key == "mtllib") {
      read_library();
    } else if (std::find(std::begin(kIgnored), std::end(kIgnored), key) == std::end(kIgnored)) {
      lines_.fail("\"" + shortened(key, 40) + "\" is not read: expected v, vt, vn, f, l, p, o, g, usemtl or mtllib");
    }
  }

  void read_position() {
    constexpr const char* kExpected = "x y z";
    files_.budget.take(2 * sizeof(glm::vec3), files_.model_path());
    const float x = lines_.number(kExpected), y = lines_.number(kExpected), z = lines_.number(kExpected);
    data_.positions.emplace_back(x, y, z);
    float more[4];
    int n_more = 0;
    while (n_more < 4 && !lines_.words.rest().empty()) more[n_more++] = lines_.number("a weight, or a colour r g b");
    if (n_more < 3) return;  // a weight says nothing about polygons
    files_.budget.take(2 * sizeof(glm::vec4), files_.model_path());
    data_.colors.resize(data_.positions.size(), glm::vec4(1.0f));
    data_.colors.back() = {more[0], more[1], more[2], n_more == 4 ? more[3] : 1.0f};
  }

  void read_uv() {
    files_.budget.take(2 * sizeof(glm::vec2), files_.model_path());
    const float u = lines_.number("u [v]");
    data_.uvs.emplace_back(u, lines_.words.rest().empty() ? 0.0f : lines_.number("u v"));
  }

  void read_normal() {
    constexpr const char* kExpected = "a normal, x y z";
    files_.budget.take(2 * sizeof(glm::vec3), files_.model_path());
    const float x = lines_.number(kExpected), y = lines_.number(kExpected), z = lines_.number(kExpected);
    data_.normals.emplace_back(x, y, z);
  }

  /// The corners of this line's element, in element_.
  void read_corners(std::size_t n_min, const char* what) {
    const ObjCounts counts{data_.positions.size(), data_.uvs.size(), data_.normals.size()};
    element_.clear();
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word()) {
      element_.push_back(read_corner(lines_, word, counts));
    }
    if (element_.size() < n_min) {
      lines_.fail(std::string(what) + " of " + std::to_string(element_.size()) + " vertices: expected at least " +
                  std::to_string(n_min));
    }
  }

  void read_face() {
    read_corners(3, "a face");
    Part& to = part(MeshKind::triangles);
    face_.clear();
    triangles_.clear();
    for (const ObjCorner& corner : element_) face_.push_back(data_.positions[corner.position]);
    if (!triangulate(face_, triangles_, &n_ear_tests_)) {
      lines_.fail("a concave face of " + std::to_string(face_.size()) + " vertices: expected at most " +
                  std::to_string(kMaxConcaveCorners));
    }
    if (n_ear_tests_ > kMaxEarTests) lines_.fail("too many concave faces of many vertices: expected triangles");
    for (const std::uint32_t corner : triangles_) add_corner(to, element_[corner]);
  }

  void read_line() {
    read_corners(2, "a line");
    Part& to = part(MeshKind::lines);
    for (std::size_t i = 0; i + 1 < element_.size(); ++i) {
      add_corner(to, element_[i]);
      add_corner(to, element_[i + 1]);
    }
  }

  void read_points() {
    read_corners(1, "points");
    Part& to = part(MeshKind::points);
    for (const ObjCorner& corner : element_) add_corner(to, corner);
  }

  void add_corner(Part& to, const ObjCorner& corner) {
    files_.budget.take(2 * sizeof(ObjCorner), files_.model_path());
    to.corners.push_back(corner);
  }

  /// Where elements of this kind go now.
  Part& part(MeshKind kind) {
    std::uint32_t& known = part_of_kind_.index[std::size_t(kind)];
    if (known != ObjCorner::kNone) return parts_[known];
    const std::string place = files_.model_path() + ": line " + std::to_string(material_line_);
    const std::uint32_t in_node = node(), with = materials_.use(material_name_, place);
    const auto [entry, is_new] = part_index_.try_emplace(std::tuple(in_node, with, kind), std::uint32_t(parts_.size()));
    if (is_new) {
      files_.budget.take(kPartBytes, place);
      parts_.push_back({in_node, with, kind, {}});
    }
    known = entry->second;
    return parts_[known];
  }

  /// The node of the current object and group.
  std::uint32_t node() {
    const auto [entry, is_new] =
        node_index_.try_emplace(std::pair(object_, group_), std::uint32_t(scene_.nodes.size()));
    if (is_new) scene_.nodes.emplace_back().name = group_name_;
    return entry->second;
  }

  void read_library() {
    const std::string place = files_.model_path() + ": line " + std::to_string(lines_.line_number());
    std::string all(lines_.words.rest());
    std::replace(all.begin(), all.end(), '\\', '/');
    if (all.empty()) lines_.fail_expected("the name of a material library", "");
    // Several names are separated by spaces, but one name may have spaces in it, too.
    std::error_code ignored;
    if (std::filesystem::exists(ModelFiles::resolved(files_.model_path(), all), ignored)) {
      return materials_.add_library(ModelFiles::resolved(files_.model_path(), all), place);
    }
    Words names{all};
    for (std::string_view name = names.next(); !name.empty(); name = names.next()) {
      materials_.add_library(ModelFiles::resolved(files_.model_path(), name), place);
    }
  }

  void add_part(const Part& part) {
    const auto mesh = std::uint32_t(scene_.meshes.size());
    scene_.meshes.push_back(obj_mesh(data_, part.corners, part.kind, materials_.uvs(part.material), files_));
    scene_.meshes.back().material = part.material;
    scene_.instances.push_back({mesh, part.node, glm::dmat4(1.0)});
  }

  ModelFiles& files_;
  FileBytes file_;
  LineReader lines_;
  Scene scene_;
  ObjMaterials materials_;
  ObjData data_;

  // What statements after these belong to.
  std::size_t object_ = 0;
  std::optional<std::string> group_;
  std::string group_name_, material_name_;
  std::size_t material_line_ = 0;

  struct PartOfKind {
    std::uint32_t index[3] = {ObjCorner::kNone, ObjCorner::kNone, ObjCorner::kNone};
  } part_of_kind_;  ///< of triangles, lines and points, in parts_
  std::vector<Part> parts_;
  std::map<std::tuple<std::uint32_t, std::uint32_t, MeshKind>, std::uint32_t> part_index_;
  std::map<std::pair<std::size_t, std::optional<std::string>>, std::uint32_t> node_index_;

  // The current element; kept to keep their memory.
  std::vector<ObjCorner> element_;
  std::vector<glm::vec3> face_;
  std::vector<std::uint32_t> triangles_;
  std::uint64_t n_ear_tests_ = 0;
};

}  // namespace

Scene read_obj(const std::string& path) {
  ModelFiles files(path);
  Scene scene = ObjReader(files).read();
  scene.files = files.paths();
  return scene;
}

}  // namespace lode::geometry
