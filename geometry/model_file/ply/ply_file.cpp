#include "geometry/model_file/ply/ply_file.h"

#include <cfloat>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/error.h"
#include "geometry/model_file/model_files.h"
#include "geometry/model_file/ply/ply_rows.h"
#include "geometry/polygon.h"
#include "geometry/procedural.h"

namespace lode::geometry {
namespace {

/// A float of any number; what does not fit becomes infinite, defined so.
float narrowed(double x) {
  return std::fabs(x) > double(FLT_MAX) ? std::copysign(INFINITY, float(x > 0.0) - 0.5f) : float(x);
}

class PlyReader {
 public:
  explicit PlyReader(ModelFiles& files)
      : files_(files),
        file_(files.read(files.model_path(), "")),
        header_(read_ply_header(file_.text(), files.model_path())),
        rows_(ply_rows(header_, file_.text(), files.model_path())) {}

  Mesh read() {
    for (const PlyElement& element : header_.elements) {
      row_.values.assign(element.properties.size(), 0.0);
      row_.lists.assign(element.properties.size(), {});
      if (element.properties.empty()) continue;  // no bytes, however many there are
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        for (std::uint64_t i = 0; i < element.count; ++i) rows_->read(element, row_);
      }
    }
    if (!has_vertices_) throw Error(ErrorKind::bad_input, files_.model_path() + ": expected an element \"vertex\"");
    if (!has_faces_) make_points();
    if (has_faces_ && mesh_.normals.empty()) {
      files_.budget.take(32 * mesh_.positions.size() + 96 * mesh_.indices.size(), files_.model_path());
      return with_smooth_normals(mesh_);
    }
    return std::move(mesh_);
  }

 private:
  using Index = std::optional<std::size_t>;  ///< of a property

  /// Room for a value of each vertex.
  template <class Value>
  void reserve(std::vector<Value>& values, std::uint64_t n) {
    files_.budget.take(n * sizeof(Value), files_.model_path());
    values.reserve(n);
  }

  /// A colour's channel: whole numbers are fractions of their type's greatest.
  float channel(const PlyElement& element, std::size_t i) const {
    switch (element.properties[i].type) {
      case PlyType::uint8:
        return float(row_.values[i]) / 255.0f;
      case PlyType::uint16:
        return float(row_.values[i]) / 65535.0f;
      default:
        return narrowed(row_.values[i]);
    }
  }

  void read_vertices(const PlyElement& element) {
    if (has_vertices_) throw Error(ErrorKind::bad_input, files_.model_path() + ": a second element \"vertex\"");
    has_vertices_ = true;
    const Index x = element.find("x"), y = element.find("y"), z = element.find("z");
    if (!x || !y || !z) {
      throw Error(ErrorKind::bad_input, files_.model_path() + ": expected the properties x, y and z of \"vertex\"");
    }
    if (element.count > 0xFFFFFFFFu) throw Error(ErrorKind::bad_input, files_.model_path() + ": too many vertices");
    const Index nx = element.find("nx"), ny = element.find("ny"), nz = element.find("nz");
    const Index u = first_of(element, {"s", "u", "texture_u"}), v = first_of(element, {"t", "v", "texture_v"});
    const Index r = element.find("red", "r"), g = element.find("green", "g"), b = element.find("blue", "b");
    const Index a = element.find("alpha", "a");
    const bool has_normals = nx && ny && nz, has_uvs = u && v, has_colors = r && g && b;
    reserve(mesh_.positions, element.count);
    if (has_normals) reserve(mesh_.normals, element.count);
    if (has_uvs) reserve(mesh_.uvs, element.count);
    if (has_colors) reserve(mesh_.colors, element.count);
    const auto value = [&](Index i) { return narrowed(row_.values[*i]); };
    for (std::uint64_t i = 0; i < element.count; ++i) {
      rows_->read(element, row_);
      const glm::vec3 p(value(x), value(y), value(z));
      if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) {
        rows_->fail("vertex " + std::to_string(i) + ": a position that is not finite");
      }
      mesh_.positions.push_back(p);
      if (has_normals) mesh_.normals.emplace_back(value(nx), value(ny), value(nz));
      if (has_uvs) mesh_.uvs.emplace_back(value(u), 1.0f - value(v));
      if (has_colors) {
        mesh_.colors.emplace_back(channel(element, *r), channel(element, *g), channel(element, *b),
                                  a ? channel(element, *a) : 1.0f);
      }
    }
  }

  static Index first_of(const PlyElement& element, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
      if (const Index i = element.find(name)) return i;
    }
    return std::nullopt;
  }

  /// The vertex that a number of this row stands for.
  std::uint32_t checked_index(double index, std::uint64_t i, const PlyElement& element) {
    if (index >= 0.0 && index < double(mesh_.positions.size()) && index == std::floor(index)) {
      return std::uint32_t(index);
    }
    const double shown = std::fmax(std::fmin(index, 1e18), -1e18);
    rows_->fail(element.name + " " + std::to_string(i) + ": vertex " + std::to_string(std::int64_t(shown)) +
                ": expected a whole number below " + std::to_string(mesh_.positions.size()));
  }

  std::size_t index_list(const PlyElement& element) {
    const Index list = element.find("vertex_indices", "vertex_index");
    if (list && element.properties[*list].list_count) return *list;
    throw Error(ErrorKind::bad_input,
                files_.model_path() + ": expected a list vertex_indices in the element \"" + element.name + "\"");
  }

  void take_triangles(std::size_t n) { files_.budget.take(2 * 3 * sizeof(std::uint32_t) * n, files_.model_path()); }

  void read_faces(const PlyElement& element) {
    check_order(element);
    const std::size_t list = index_list(element);
    has_faces_ = has_faces_ || element.count > 0;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      rows_->read(element, row_);
      const std::vector<double>& indices = row_.lists[list];
      if (indices.size() < 3) {
        rows_->fail("face " + std::to_string(i) + " of " + std::to_string(indices.size()) +
                    " vertices: expected at least 3");
      }
      take_triangles(indices.size() - 2);
      if (indices.size() > longest_face_) {  // what triangulating it takes is kept for the next ones
        files_.budget.take(96 * (indices.size() - longest_face_), files_.model_path());
        longest_face_ = indices.size();
      }
      add_face(indices, i, element);
    }
  }

  void add_face(const std::vector<double>& indices, std::uint64_t i, const PlyElement& element) {
    corners_.clear();
    face_.clear();
    triangles_.clear();
    for (const double index : indices) {
      corners_.push_back(checked_index(index, i, element));
      face_.push_back(mesh_.positions[corners_.back()]);
    }
    if (!triangulate(face_, triangles_, &n_ear_tests_)) {
      rows_->fail("face " + std::to_string(i) + ": concave, of " + std::to_string(face_.size()) +
                  " vertices: expected at most " + std::to_string(kMaxConcaveCorners));
    }
    if (n_ear_tests_ > kMaxEarTests) {
      rows_->fail("face " + std::to_string(i) + ": too many concave faces of many vertices: expected triangles");
    }
    for (const std::uint32_t corner : triangles_) mesh_.indices.push_back(corners_[corner]);
  }

  /// Strips, one after another with −1 between them; every other triangle is turned round.
  void read_strips(const PlyElement& element) {
    check_order(element);
    const std::size_t list = index_list(element);
    has_faces_ = has_faces_ || element.count > 0;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      rows_->read(element, row_);
      take_triangles(row_.lists[list].size());
      corners_.clear();
      for (const double index : row_.lists[list]) {
        if (index == -1.0) {
          corners_.clear();
          continue;
        }
        corners_.push_back(checked_index(index, i, element));
        const std::size_t n = corners_.size();
        if (n < 3) continue;
        const std::size_t odd = (n - 1) % 2;
        mesh_.indices.insert(mesh_.indices.end(), {corners_[n - 3], corners_[n - 2 + odd], corners_[n - 1 - odd]});
      }
    }
  }

  void check_order(const PlyElement& element) const {
    if (has_vertices_) return;
    throw Error(ErrorKind::bad_input, files_.model_path() + ": \"" + element.name + "\" before \"vertex\"");
  }

  void make_points() {
    mesh_.kind = MeshKind::points;
    files_.budget.take(4 * mesh_.positions.size(), files_.model_path());
    mesh_.indices.resize(mesh_.positions.size());
    std::iota(mesh_.indices.begin(), mesh_.indices.end(), 0u);
  }

  ModelFiles& files_;
  FileBytes file_;
  PlyHeader header_;
  std::unique_ptr<PlyRows> rows_;
  Mesh mesh_;
  bool has_vertices_ = false, has_faces_ = false;
  PlyRow row_;
  std::size_t longest_face_ = 16;
  std::vector<std::uint32_t> corners_, triangles_;
  std::vector<glm::vec3> face_;
  std::uint64_t n_ear_tests_ = 0;
};

}  // namespace

Scene read_ply(const std::string& path) {
  ModelFiles files(path);
  Material material;
  material.double_sided = true;
  Scene scene = scene_of(PlyReader(files).read(), material);
  scene.name = path;
  scene.files = files.paths();
  return scene;
}

}  // namespace lode::geometry
