#include "experiments/convex_approximation/model_pictures.h"

#include <algorithm>

#include "experiments/display_bytes.h"
#include "experiments/sample_positions.h"
#include "experiments/whole_file.h"
#include "geometry/hull.h"
#include "geometry/image_file.h"
#include "geometry/inner_boxes.h"
#include "geometry/procedural.h"
#include "techniques/scene_draws.h"

namespace lode::experiments {
namespace {

/// Meshes in one place: a model, or what stands for it.
using Panel = std::vector<geometry::Mesh>;

constexpr int kPanelWidth_px = 260;
constexpr double kGap = 0.08;  // of a panel's width, on either side
constexpr glm::vec4 kModelColor{0.45f, 0.45f, 0.45f, 1.0f};
constexpr glm::vec4 kColors[] = {{0.05f, 0.22f, 0.60f, 1}, {0.75f, 0.24f, 0.02f, 1}, {0.06f, 0.42f, 0.12f, 1},
                                 {0.60f, 0.05f, 0.08f, 1}, {0.33f, 0.16f, 0.55f, 1}, {0.70f, 0.50f, 0.05f, 1},
                                 {0.05f, 0.45f, 0.50f, 1}, {0.60f, 0.20f, 0.42f, 1}, {0.25f, 0.13f, 0.06f, 1}};

/// Extents along the camera's axes.
struct Extent {
  glm::dvec3 low{1e300}, high{-1e300};
};
Extent extent_of(const std::vector<Panel>& panels, const geometry::Camera& camera) {
  Extent e;
  for (const Panel& panel : panels) {
    for (const geometry::Mesh& mesh : panel) {
      for (const glm::dvec3 p : mesh.positions) {
        const glm::dvec3 seen(glm::dot(p, camera.right), glm::dot(p, camera.up), glm::dot(p, camera.back));
        e.low = glm::min(e.low, seen), e.high = glm::max(e.high, seen);
      }
    }
  }
  return e;
}

/// Panels side by side along the camera's right, under an orthographic camera: all are seen from the same side.
void write_panels(const std::string& file, const std::vector<Panel>& panels, const raster::RenderOptions& options) {
  geometry::Camera camera;
  geometry::look_at(camera, {0.55, 0.6, 1.0}, glm::dvec3(0.0));
  const Extent e = extent_of(panels, camera);
  const glm::dvec3 size = e.high - e.low;
  const double step = size.x * (1.0 + 2.0 * kGap), height = size.y + 2.0 * kGap * size.x;
  if (!(size.x > 0.0)) return;

  geometry::Scene scene;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    glm::dmat4 place(1.0);
    place[3] = glm::dvec4((double(k) - 0.5 * double(panels.size() - 1)) * step * camera.right, 1.0);
    for (std::size_t i = 0; i < panels[k].size(); ++i) {
      geometry::Material material;
      material.color = k == 0 ? kModelColor : kColors[i % std::size(kColors)];
      material.double_sided = k == 0;
      geometry::add_instance(scene, panels[k][i], material, place);
    }
  }
  const glm::dvec3 middle = 0.5 * (e.low + e.high);
  camera.eye = middle.x * camera.right + middle.y * camera.up + (e.high.z + size.z) * camera.back;
  camera.projection = geometry::Projection::orthographic;
  camera.height = height, camera.near = 0.0, camera.far = 3.0 * size.z;

  const int n = int(panels.size());
  const glm::ivec2 size_px(kPanelWidth_px * n, std::max(1, int(kPanelWidth_px * height / step)));
  const techniques::SceneDraws draws(scene, {});
  const std::vector<glm::ivec2> samples_fx8 = sample_positions_fx8(16);
  raster::Image image =
      raster::make_image(size_px, raster::ColorFormat::rgba32f, {.color = true, .depth = false, .ids = false});
  const std::vector<raster::Draw> list = draws.draws(camera, size_px);
  static_cast<void>(raster::render(
      {.draws = list, .clear = glm::vec4(0.0f), .viewport = {}, .scissor = {}, .samples_fx8 = samples_fx8}, image,
      options));
  WholeFile out(file);
  geometry::write_color(out.file(), geometry::ImageFormat::png, size_px, display_bytes(image.rgba32f));
  publish({&out});
}

Panel model_panel(const techniques::Shape& model) {
  geometry::Mesh mesh;
  mesh.positions = model.positions, mesh.indices = model.indices;
  return {geometry::with_flat_normals(mesh)};
}

/// What has no volume is not shown.
Panel hulls_panel(const std::vector<std::vector<glm::vec3>>& hulls) {
  Panel panel;
  for (const std::vector<glm::vec3>& vertices : hulls) {
    const geometry::Hull hull = geometry::convex_hull(std::vector<glm::dvec3>(vertices.begin(), vertices.end()));
    geometry::Mesh mesh;
    mesh.positions = vertices;
    for (const auto& triangle : hull.triangles)
      mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
    if (!mesh.indices.empty()) panel.push_back(geometry::with_flat_normals(mesh));
  }
  return panel;
}

}  // namespace

void write_hulls_picture(const std::string& file, const techniques::Shape& model,
                         const techniques::convex_culling::ConvexApproximation& approximation,
                         const raster::RenderOptions& options) {
  std::vector<Panel> panels = {model_panel(model)};
  for (const auto& level : approximation.levels) panels.push_back(hulls_panel(level.hulls));
  write_panels(file, panels, options);
}

void write_boxes_picture(const std::string& file, const techniques::Shape& model,
                         const raster::RenderOptions& options) {
  Panel boxes;
  for (const geometry::Bounds& box : geometry::inner_boxes({model.positions, model.indices})) {
    boxes.push_back(geometry::box(box.low, box.high));
  }
  write_panels(file, {model_panel(model), std::move(boxes)}, options);
}

}  // namespace lode::experiments
