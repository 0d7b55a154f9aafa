#pragma once
/// A value in a JSON document that knows its place, so that whatever is wrong with it can be said in one line:
/// "picture.json: draws[2].triangles[1]: expected [x, y, z], found [1,2]". The path is put together only when
/// something is wrong. (nlohmann's type is in this header because a view is a view of it; no others have it.)

#include <cstdint>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace lode::geometry {

/// Views point to their parents: keep the parent alive while a child is used.
class JsonView {
 public:
  /// The whole document; `name` is what errors call it. Both must outlive the view.
  JsonView(const nlohmann::json& document, const std::string& name) : value_(document), name_(name) {}

  /// Throws Error (bad_input): name, path, what was expected, what is there.
  [[noreturn]] void fail_expected(std::string_view expected) const;
  /// Throws Error (bad_input): name, path, and what is wrong in other words.
  [[noreturn]] void fail(std::string_view what) const;
  /// "picture.json: draws[2].triangles[1]"
  [[nodiscard]] std::string place() const;

  /// Elements of an array; anything else fails, naming what was `expected`.
  [[nodiscard]] std::size_t size(std::string_view expected) const;
  [[nodiscard]] JsonView at(std::size_t index) const&;
  JsonView at(std::size_t index) const&& = delete;

  /// The member of an object, if it is there; not of anything else.
  [[nodiscard]] std::optional<JsonView> find(std::string_view key) const&;
  std::optional<JsonView> find(std::string_view key) const&& = delete;
  /// The same, and fails, naming the key, if it is not there.
  [[nodiscard]] JsonView require(std::string_view key) const&;
  JsonView require(std::string_view key) const&& = delete;
  /// Fails if this is no object, or has a member whose key is not among those allowed.
  void check_keys(std::span<const std::string_view> allowed) const;

  [[nodiscard]] bool boolean() const;
  /// A whole number in [low, high]; 3.0 is one too.
  [[nodiscard]] std::int64_t integer(std::int64_t low, std::int64_t high) const;
  /// A number in [low, high].
  [[nodiscard]] double number(double low, double high) const;
  /// A number that a float holds, rounded to it.
  [[nodiscard]] float float_number() const;
  /// An index into an array of n elements; `what` they are is said if it is none.
  [[nodiscard]] std::size_t index(std::size_t n, std::string_view what) const;
  [[nodiscard]] const std::string& string() const;
  /// Index of the string among the choices.
  [[nodiscard]] std::size_t choice(std::initializer_list<std::string_view> choices) const;
  /// [r, g, b, a], whole numbers 0…255.
  [[nodiscard]] glm::vec4 color() const;

 private:
  JsonView(const nlohmann::json& value, const JsonView& parent, std::string_view key, std::size_t index)
      : value_(value), name_(parent.name_), parent_(&parent), key_(key), index_(index) {}
  [[nodiscard]] std::string path() const;

  const nlohmann::json& value_;
  const std::string& name_;
  const JsonView* parent_ = nullptr;
  std::string_view key_;   ///< within the parent, if that is an object
  std::size_t index_ = 0;  ///< within the parent, if that is an array
};

}  // namespace lode::geometry
