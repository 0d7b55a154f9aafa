#include "geometry/model_file/model_files.h"

#include <filesystem>
#include <utility>

#include "geometry/error.h"

namespace lode::geometry {
namespace {

/// Calls `read`; its errors begin with the referrer.
template <class Read>
auto with_referrer(const std::string& referrer, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    throw Error(error.kind(), referrer.empty() ? error.what() : referrer + ": " + error.what());
  }
}

}  // namespace

ModelFiles::ModelFiles(std::string model_path) : model_path_(std::move(model_path)) {}

std::string ModelFiles::resolved(const std::string& from, std::string_view path) {
  return (std::filesystem::path(from).parent_path() / std::filesystem::path(path)).string();
}

FileBytes ModelFiles::read(const std::string& path, const std::string& referrer) {
  return with_referrer(referrer, [&] {
    FileBytes file = read_whole_file(path);
    if (seen_.insert(path).second) {
      budget.add_file(file.n);
    } else {
      budget.take(file.n, path);
    }
    return file;
  });
}

Picture ModelFiles::read_picture(const std::string& path, const std::string& referrer) {
  const FileBytes file = read(path, referrer);
  return with_referrer(referrer, [&] { return decode_picture(file.span(), path, budget); });
}

}  // namespace lode::geometry
