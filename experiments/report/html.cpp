#include "experiments/report/html.h"

#include <array>
#include <charconv>

#include "experiments/error.h"
#include "experiments/file_bytes.h"

namespace lode::experiments {
namespace {

constexpr const char* kStyle = R"(
  :root { color-scheme: light dark; --line: #8884; --soft: #8881; --good: #1a7f37; --bad: #cf222e; }
  @media (prefers-color-scheme: dark) { :root { --good: #4ac26b; --bad: #ff7b72; } }
  body { font: 16px/1.5 system-ui, sans-serif; max-width: 76rem; margin: 2rem auto; padding: 0 1rem; }
  h1 { font-size: 1.8rem; margin-bottom: 0; }
  h2 { font-size: 1.35rem; margin: 0 0 .5rem; }
  h3 { font-size: 1.05rem; margin: 1.5rem 0 .4rem; }
  section { border-top: 1px solid var(--line); padding: 1.5rem 0; }
  nav a { margin-right: 1rem; white-space: nowrap; }
  .wide { overflow-x: auto; }
  table { border-collapse: separate; border-spacing: 0; font-size: .85rem; font-variant-numeric: tabular-nums; }
  th, td { padding: .2rem .6rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
  td { white-space: nowrap; }
  th:first-child, td:first-child { position: sticky; left: 0; background: Canvas; }
  th { font-weight: 600; }
  td.n, th.n { text-align: right; }
  th { vertical-align: bottom; }
  figure { margin: 1rem 0; }
  figcaption { font-size: .85rem; opacity: .8; }
  img { max-width: 100%; height: auto; }
  .pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); gap: 1rem; }
  .slider { position: relative; line-height: 0; }
  .slider img { width: 100%; display: block; }
  .slider .over { position: absolute; inset: 0; overflow: hidden; clip-path: inset(0 50% 0 0); }
  .slider input { position: absolute; inset: auto 0 0 0; width: 100%; margin: 0; }
  pre { font: 13px/1.45 ui-monospace, monospace; background: var(--soft); padding: .75rem; overflow-x: auto; }
  .plot svg { width: 100%; min-width: 34rem; max-width: 52rem; }
  .top { width: 100%; max-height: 30rem; }
  .keys i { display: inline-block; width: .8em; height: .8em; background: var(--key); margin-right: .3em; }
  .keys { margin: .3rem 0; }
  .keys span { margin-right: .8em; white-space: nowrap; }
  .again { font-size: .8rem; opacity: .8; overflow-wrap: anywhere; }
  section > h2:not(:first-child) { margin-top: 2.5rem; }
  .bad { color: var(--bad); } .good { color: var(--good); }
  .two { display: grid; grid-template-columns: minmax(0, 30rem) minmax(0, 1fr); gap: 1.5rem; align-items: start; }
  .three { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 1rem; }
  .three figure { margin: 0; }
  .two img, .three img { width: 100%; background: repeating-conic-gradient(#ccc 0 25%, #fff 0 50%) 0 0 / 16px 16px; }
  .pixels img { image-rendering: pixelated; }
  .part { padding: 1rem 0; }
  pre { white-space: pre-wrap; overflow-wrap: anywhere; max-height: 26rem; overflow: auto; }
  summary { cursor: pointer; margin: .75rem 0 .5rem; }
  @media (max-width: 50rem) { .two, .three { grid-template-columns: minmax(0, 1fr); } }
)";

constexpr std::string_view kBase64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr const char* kScript = R"(
  for (const slider of document.querySelectorAll('.slider')) {
    const over = slider.querySelector('.over');
    slider.querySelector('input').addEventListener('input', e => {
      over.style.clipPath = `inset(0 ${100 - e.target.value}% 0 0)`;
    });
  }
)";

/// Whether all of a PNG file is there, from its signature to its last chunk (PNG specification, 5.2 and 11.2.5).
bool is_whole_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1A\n") && bytes.ends_with("IEND\xAE\x42\x60\x82");
}

/// Nothing if there is no such file. Throws Error (bad_input) if it is no picture.
std::string source_of(const std::string& file) {
  const std::string bytes = file_bytes(file).value_or("");
  if (!bytes.empty() && !is_whole_png(bytes)) throw Error(Status::bad_input, file + ": expected a whole PNG file");
  return bytes.empty() ? std::string() : "data:image/png;base64," + base64(bytes);
}

std::string cell_text(const Row& row, const Column& column) {
  const Row::Value* value = row.find(column.name);
  if (value == nullptr) return "–";
  if (column.digits < 0 || std::holds_alternative<std::string>(*value)) return escaped(row.text(column.name));
  return fixed_text(row.number(column.name), column.digits);
}

bool is_number(std::span<const Row> rows, const Column& column) {
  for (const Row& row : rows) {
    if (const Row::Value* value = row.find(column.name)) return !std::holds_alternative<std::string>(*value);
  }
  return false;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string fixed_text(double value, int digits) {
  std::array<char, 400> text;  // the largest double has 309 digits before the point
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits);
  return error == std::errc() ? std::string(text.data(), end) : std::string("?");
}

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < n ? std::uint8_t(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= n ? kBase64[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string from_base64(std::string_view text) {
  std::string bytes;
  std::uint32_t group = 0;
  int n_bits = 0;
  for (const char c : text) {
    const std::size_t digit = kBase64.find(c);
    if (digit == std::string_view::npos) break;
    group = group << 6 | std::uint32_t(digit), n_bits += 6;
    if (n_bits < 8) continue;
    n_bits -= 8;
    bytes += char(group >> n_bits & 0xFF);
  }
  return bytes;
}

std::string html_table(std::span<const Row> rows, std::span<const Column> columns) {
  std::string html = "<div class=\"wide\"><table><thead><tr>";
  for (const Column& c : columns) {
    html += std::string(is_number(rows, c) ? "<th class=\"n\">" : "<th>") + escaped(c.heading) + "</th>";
  }
  html += "</tr></thead><tbody>\n";
  for (const Row& row : rows) {
    html += "<tr>";
    for (const Column& c : columns) {
      html += std::string(is_number(rows, c) ? "<td class=\"n\">" : "<td>") + cell_text(row, c) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string html_image(const std::string& file, std::string_view alt) {
  const std::string source = source_of(file);
  if (source.empty()) return {};
  return "<img alt=\"" + escaped(alt) + "\" src=\"" + source + "\">";
}

std::string html_slider(const std::string& left_file, const std::string& right_file, std::string_view caption) {
  const std::string left = source_of(left_file), right = source_of(right_file);
  if (left.empty() || right.empty()) return {};
  return "<figure><div class=\"slider\"><img alt=\"\" src=\"" + right + "\"><div class=\"over\"><img alt=\"\" src=\"" +
         left + "\"></div><input type=\"range\" min=\"0\" max=\"100\" value=\"50\" aria-label=\"compare\"></div>" +
         "<figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string html_page(std::string_view title, std::string_view introduction, std::string_view headlines,
                      std::span<const PageSection> sections) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n";
  html += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" + escaped(title) +
          "</title>\n<style>" + kStyle + "</style>\n<h1>" + escaped(title) + "</h1>\n<p>" + std::string(introduction) +
          "</p>\n<nav>";
  for (const PageSection& s : sections) html += "<a href=\"#" + escaped(s.id) + "\">" + escaped(s.title) + "</a>\n";
  html += "</nav>\n" + std::string(headlines);
  for (const PageSection& s : sections) {
    html += "<section id=\"" + escaped(s.id) + "\"><h2>" + escaped(s.title) + "</h2>\n" + s.html + "</section>\n";
  }
  return html + "<script>" + kScript + "</script>\n</html>\n";
}

}  // namespace lode::experiments
