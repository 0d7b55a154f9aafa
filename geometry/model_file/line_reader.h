#pragma once
/// Text files of lines of words: OBJ, MTL, and the text forms of PLY and STL.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lode::geometry {

/// The words of one line, separated by blanks.
struct Words {
  std::string_view left;  ///< of the line

  /// Takes the next word; empty if there is none.
  std::string_view next();
  /// All that is left, without blanks around it.
  [[nodiscard]] std::string_view rest() const;
};

/// A number in decimal, correctly rounded (std::from_chars); false if the word is something else, not finite, or does
/// not fit.
[[nodiscard]] bool parse_number(std::string_view word, float& value);
[[nodiscard]] bool parse_number(std::string_view word, double& value);
[[nodiscard]] bool parse_number(std::string_view word, std::int64_t& value);

/// Goes through a text line by line. Lines end with \n or \r\n.
class LineReader {
 public:
  /// `name` is what errors call the text; both must outlive the reader. With `joins`, a backslash at the end of a line
  /// joins the next one to it.
  LineReader(std::string_view text, const std::string& name, bool joins) : text_(text), name_(name), joins_(joins) {}

  /// Moves on to the next line; false after the last one.
  [[nodiscard]] bool next_line();
  /// Of the current line, from 1; of joined lines, the first one's.
  [[nodiscard]] std::size_t line_number() const { return number_; }
  /// Where the next line begins, in bytes.
  [[nodiscard]] std::size_t offset() const { return at_; }

  [[nodiscard]] std::string_view word() { return words.next(); }
  /// The next word as a number. Throws Error (bad_input) saying what was expected.
  [[nodiscard]] float number(std::string_view expected);
  [[nodiscard]] std::int64_t integer(std::string_view expected);

  /// Throws Error (bad_input): name, line, and what is wrong.
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_expected(std::string_view expected, std::string_view found) const;

  Words words;  ///< of the current line

 private:
  std::string_view take_line();

  std::string_view text_;
  const std::string& name_;
  bool joins_;
  std::size_t at_ = 0, number_ = 0, n_joined_ = 0;
  std::string joined_;
};

}  // namespace lode::geometry
