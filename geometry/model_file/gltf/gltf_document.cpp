#include "geometry/model_file/gltf/gltf_document.h"

#include <algorithm>
#include <iterator>

#include "geometry/error.h"
#include "geometry/json/parse_json.h"
#include "geometry/model_file/gltf/glb_container.h"
#include "geometry/model_file/gltf/uri.h"
#include "geometry/shortened.h"

namespace lode::geometry {
namespace {

constexpr std::string_view kArrays[] = {"accessors", "buffers", "bufferViews", "cameras", "images",  "materials",
                                        "meshes",    "nodes",   "samplers",    "scenes",  "textures"};

/// Extensions that a file may require: those that we read, and those that only change how light is reflected.
constexpr std::string_view kKnownExtensions[] = {"KHR_lights_punctual",
                                                 "KHR_materials_anisotropy",
                                                 "KHR_materials_clearcoat",
                                                 "KHR_materials_diffuse_transmission",
                                                 "KHR_materials_dispersion",
                                                 "KHR_materials_emissive_strength",
                                                 "KHR_materials_ior",
                                                 "KHR_materials_iridescence",
                                                 "KHR_materials_pbrSpecularGlossiness",
                                                 "KHR_materials_sheen",
                                                 "KHR_materials_specular",
                                                 "KHR_materials_transmission",
                                                 "KHR_materials_unlit",
                                                 "KHR_materials_volume",
                                                 "KHR_mesh_quantization",
                                                 "KHR_texture_transform",
                                                 "KHR_xmp_json_ld"};

nlohmann::json parsed(const FileBytes& file, ModelFiles& files,
                      std::optional<std::span<const std::byte>>& binary_chunk) {
  if (!is_glb(file.span())) return parse_json(file.text(), files.model_path(), &files.budget);
  const GlbChunks chunks = glb_chunks(file.span(), files.model_path());
  binary_chunk = chunks.binary;
  return parse_json(chunks.json, files.model_path(), &files.budget);
}

}  // namespace

GltfDocument::GltfDocument(ModelFiles& files)
    : files_(files),
      file_(files.read(files.model_path(), "")),
      json_(parsed(file_, files, binary_chunk_)),
      root_(json_, files.model_path()) {
  check_version();
  check_extensions();
  for (const std::string_view key : kArrays) {
    const auto array = root_.find(key);
    if (!array) continue;
    (void)array->size("an array");
    arrays_.emplace(key, *array);
  }
}

void GltfDocument::check_version() const {
  const JsonView asset = root_.require("asset");
  const JsonView version = asset.require("version");
  if (!version.string().starts_with("2.")) version.fail_expected("\"2.0\", the version of glTF that is read");
  const auto min_version = asset.find("minVersion");
  if (min_version && min_version->string() != "2.0") min_version->fail_expected("\"2.0\"");
}

void GltfDocument::check_extensions() const {
  const auto required = root_.find("extensionsRequired");
  if (!required) return;
  for (std::size_t i = 0; i < required->size("an array of names"); ++i) {
    const JsonView name = required->at(i);
    if (std::find(std::begin(kKnownExtensions), std::end(kKnownExtensions), name.string()) !=
        std::end(kKnownExtensions))
      continue;
    name.fail("the file requires " + shortened(name.string(), 60) +
              ", which is not read: export it without that extension");
  }
}

std::size_t GltfDocument::count(std::string_view array) const {
  const auto found = arrays_.find(array);
  return found == arrays_.end() ? 0 : found->second.size("an array");
}

JsonView GltfDocument::element(std::string_view array, std::size_t index) const { return arrays_.at(array).at(index); }

JsonView GltfDocument::target(const JsonView& reference, std::string_view array) const {
  return element(array, reference.index(count(array), array));
}

void GltfDocument::read_uri(const JsonView& view, Buffer& buffer) {
  const std::string& uri = view.string();
  if (is_data_uri(uri)) {
    files_.budget.take(uri.size(), view.place());
    auto bytes = data_uri_bytes(uri);
    if (!bytes) view.fail("expected base64 after \"data:...;base64,\"");
    buffer.decoded = std::move(*bytes);
    buffer.bytes = buffer.decoded;
    return;
  }
  if (has_scheme(uri)) view.fail_expected("a file beside this one, or \"data:\"");
  buffer.file = files_.read(ModelFiles::resolved(files_.model_path(), percent_decoded(uri)), view.place());
  buffer.bytes = buffer.file.span();
}

const GltfDocument::Buffer& GltfDocument::buffer(const JsonView& reference) {
  const std::size_t index = reference.index(count("buffers"), "buffers");
  const auto [entry, is_new] = buffers_.try_emplace(index);
  Buffer& buffer = entry->second;
  if (!is_new) return buffer;

  const JsonView view = element("buffers", index);
  if (const auto uri = view.find("uri")) {
    read_uri(*uri, buffer);
  } else if (index == 0 && binary_chunk_) {
    buffer.bytes = *binary_chunk_;
  } else {
    view.fail("expected \"uri\": only the first buffer of a .glb file may lack it");
  }
  const JsonView length = view.require("byteLength");
  const auto n = std::size_t(length.integer(1, std::int64_t(1) << 40));
  if (n > buffer.bytes.size()) {
    length.fail("claims " + std::to_string(n) + " bytes, found " + std::to_string(buffer.bytes.size()));
  }
  buffer.bytes = buffer.bytes.first(n);
  return buffer;
}

BufferView GltfDocument::buffer_view(const JsonView& reference) {
  const JsonView view = target(reference, "bufferViews");
  const Buffer& of = buffer(view.require("buffer"));
  const std::int64_t size = std::int64_t(of.bytes.size());
  const auto offset_view = view.find("byteOffset");
  const std::int64_t offset = offset_view ? offset_view->integer(0, size) : 0;
  const JsonView length = view.require("byteLength");
  BufferView result;
  result.bytes = of.bytes.subspan(std::size_t(offset), std::size_t(length.integer(1, size - offset)));
  if (const auto stride = view.find("byteStride")) result.stride = std::size_t(stride->integer(4, 252));
  return result;
}

}  // namespace lode::geometry
