#include "geometry/procedural/kit.h"

#include <vector>

#include "geometry/error.h"
#include "geometry/model_file.h"

namespace lode::geometry {
namespace {

glm::dmat4 scaled(double s) {
  glm::dmat4 m(s);
  m[3][3] = 1.0;
  return m;
}

glm::dmat4 moved(const glm::dvec3& by) {
  glm::dmat4 m(1.0);
  m[3] = glm::dvec4(by, 1.0);
  return m;
}

/// "car_sedan.gltf" is a "car_sedan".
std::string stem(const std::string& file) {
  return file.substr(file.rfind('/') + 1, file.find('.') - file.rfind('/') - 1);
}

}  // namespace

std::size_t Kit::model(const std::string& file) {
  const auto known = models_.find(file);
  if (known != models_.end()) return known->second;
  Scene read = read_model_file(folder_ + "/" + file);
  if (!left_out_.empty()) {
    std::erase_if(read.instances, [&](const Instance& i) { return read.nodes[i.node].name.ends_with(left_out_); });
  }
  const std::size_t model = scene_.add(read);
  if (scene_.bounds(model).empty()) {
    throw Error(ErrorKind::bad_input, folder_ + "/" + file + ": expected a model to place, found nothing to draw");
  }
  models_.emplace(file, model);
  return model;
}

Bounds Kit::bounds(const std::string& file) {
  const Bounds& b = scene_.bounds(model(file));
  return {units_ * b.low, units_ * b.high};
}

void Kit::place(const std::string& file, const glm::dmat4& at) {
  const std::size_t m = model(file);
  scene_.place(m, stem(file) + " " + std::to_string(scene_.scene().objects.size()), at * scaled(units_));
}

void Kit::stand_high(const std::string& file, const glm::dmat4& at, double height_m) {
  const Bounds& b = scene_.bounds(model(file));
  const double height = b.high.y - b.low.y;
  stand_scaled(file, at, height > 0.0 ? height_m / height : units_);
}

void Kit::stand_scaled(const std::string& file, const glm::dmat4& at, double scale) {
  const std::size_t m = model(file);
  const Bounds& b = scene_.bounds(m);
  const glm::dvec3 floor(b.centre().x, b.low.y, b.centre().z);
  scene_.place(m, stem(file) + " " + std::to_string(scene_.scene().objects.size()), at * scaled(scale) * moved(-floor));
}

}  // namespace lode::geometry
