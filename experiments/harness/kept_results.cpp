#include "experiments/harness/kept_results.h"

#include <filesystem>
#include <span>

#include "experiments/error.h"
#include "experiments/file_bytes.h"
#include "experiments/sha256.h"
#include "experiments/whole_file.h"

namespace lode::experiments {
namespace {

constexpr std::string_view kMagic = "lodestone kept result 1\n";
constexpr std::size_t kHashLength = 64;

std::string hash_of(std::string_view text) { return sha256_hex(std::as_bytes(std::span(text))); }

/// Magic, hash of what follows, key, NUL, value.
std::string entry_of(std::string_view key, std::string_view value) {
  std::string body(key);
  body += '\0';
  body += value;
  return std::string(kMagic) + hash_of(body) + body;
}

}  // namespace

std::string KeptResults::path_of(std::string_view key) const { return folder_ + "/" + hash_of(key).substr(0, 32); }

std::optional<std::string> KeptResults::find(std::string_view key) const {
  if (folder_.empty()) return std::nullopt;
  const std::string path = path_of(key);
  if (std::error_code error; !std::filesystem::is_regular_file(path, error)) return std::nullopt;
  const std::string all = file_bytes(path).value_or("");
  const std::size_t begin = kMagic.size() + kHashLength, value = begin + key.size() + 1;
  if (all.size() < value || !all.starts_with(kMagic)) return std::nullopt;
  const std::string_view body = std::string_view(all).substr(begin);
  const bool of_key = body.starts_with(key) && body[key.size()] == '\0';
  if (!of_key || std::string_view(all).substr(kMagic.size(), kHashLength) != hash_of(body)) return std::nullopt;
  return all.substr(value);
}

void KeptResults::keep(std::string_view key, std::string_view value) const {
  if (folder_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw Error(Status::bad_input, folder_ + ": cannot be made: " + error.message());
  write_whole_file(path_of(key), entry_of(key, value));
}

std::string KeptResults::get(std::string_view key, const std::function<std::string()>& make) const {
  if (std::optional<std::string> kept = find(key)) return *std::move(kept);
  std::string made = make();
  keep(key, made);
  return made;
}

}  // namespace lode::experiments
