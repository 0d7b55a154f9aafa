#pragma once
/// Pieces of a page that stands alone: everything it shows is in it.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/harness/row.h"

namespace lode::experiments {

/// Text as HTML shows it.
[[nodiscard]] std::string escaped(std::string_view text);

/// So many digits after the point.
[[nodiscard]] std::string fixed_text(double value, int digits);

/// Of bytes (RFC 4648).
[[nodiscard]] std::string base64(std::string_view bytes);
/// And back; what is no digit ends it.
[[nodiscard]] std::string from_base64(std::string_view text);

/// A column of a table: which value of a row, under which heading, how many digits after the point (−1: as it is).
struct Column {
  std::string name, heading;
  int digits = -1;
};
/// A table of rows. Numbers stand to the right.
[[nodiscard]] std::string html_table(std::span<const Row> rows, std::span<const Column> columns);

/// An image file in the page. Empty if it cannot be read.
[[nodiscard]] std::string html_image(const std::string& file, std::string_view alt);

/// Two pictures of one size over each other, with a slider between them.
[[nodiscard]] std::string html_slider(const std::string& left_file, const std::string& right_file,
                                      std::string_view caption);

/// The whole page around its sections, light and dark, narrow and wide.
struct PageSection {
  std::string id, title, html;
};
/// `headlines`: HTML between the table of contents and the sections.
[[nodiscard]] std::string html_page(std::string_view title, std::string_view introduction, std::string_view headlines,
                                    std::span<const PageSection> sections);

}  // namespace lode::experiments
