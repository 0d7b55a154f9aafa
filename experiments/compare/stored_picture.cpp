#include "experiments/compare/stored_picture.h"

#include <cstring>

#include "experiments/display_bytes.h"
#include "experiments/error.h"
#include "geometry/image_file.h"
#include "geometry/image_file/read_picture.h"
#include "geometry/npy_file.h"
#include "raster/image.h"

namespace lode::experiments {
namespace {

template <class Element>
std::vector<Element> elements_of(const geometry::NpyArray& array) {
  std::vector<Element> elements(array.bytes.size() / sizeof(Element));
  if (!elements.empty()) std::memcpy(elements.data(), array.bytes.data(), elements.size() * sizeof(Element));
  return elements;
}

std::string shape_text(const geometry::NpyArray& array) {
  std::string text = array.descr;
  for (std::size_t i = 0; i < array.shape.size(); ++i) text += (i == 0 ? " " : " x ") + std::to_string(array.shape[i]);
  return text;
}

StoredPicture read_array(const std::string& path) {
  const geometry::NpyArray array = geometry::read_npy(path);
  const auto& shape = array.shape;
  const auto is = [&](const char* descr, std::size_t n_dimensions, std::size_t last) {
    return array.descr == descr && shape.size() == n_dimensions && (n_dimensions == 2 || shape[2] == last);
  };
  const bool sized =
      shape.size() >= 2 && shape[0] <= raster::kMaxTargetSize_px && shape[1] <= raster::kMaxTargetSize_px;
  StoredPicture picture{.path = path, .plane = {}, .linear = {}};
  if (sized) picture.size_px = {int(shape[1]), int(shape[0])};
  if (sized && is("|u1", 3, 4)) {
    picture.plane = elements_of<glm::u8vec4>(array);
  } else if (sized && is("<f4", 3, 4)) {
    picture.is_linear = true;
    picture.linear = elements_of<glm::vec4>(array);
    picture.plane = display_bytes(picture.linear);
  } else if (sized && is("<f4", 2, 0)) {
    picture.plane = elements_of<float>(array);
  } else if (sized && is("<u4", 3, 2)) {
    picture.plane = elements_of<glm::vec<2, std::uint32_t>>(array);
  } else {
    throw Error(
        Status::bad_input,
        path + ": expected h x w x 4 bytes or floats, h x w floats or h x w x 2 ids, found " + shape_text(array));
  }
  return picture;
}

}  // namespace

const char* kind_of(const StoredPicture& picture) {
  constexpr const char* kNames[] = {"colour", "depth", "ids"};
  return kNames[picture.plane.index()];
}

StoredPicture read_stored_picture(const std::string& path) {
  const auto format = geometry::image_format(path);
  if (format == geometry::ImageFormat::npy) return read_array(path);
  if (format == geometry::ImageFormat::exr) {
    throw Error(Status::bad_input, path + ": expected a PNG, JPEG or .npy file to compare");
  }
  geometry::Picture picture = geometry::read_picture(path);
  return {.path = path, .size_px = picture.size_px, .plane = std::move(picture.texels), .linear = {}};
}

}  // namespace lode::experiments
