// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Diagnostics as text: place, code, message, the source line with a caret below the value, notes.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "gudgeon/base/diagnostics.h"
#include "gudgeon/base/shown_text.h"

namespace gudgeon {

namespace {

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::remark:
      return "remark";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  return "error";
}

/// The line of that number, counted from 1, without its end; empty when there is none.
std::string_view find_line(std::string_view text, int number) {
  for (int i = 1; i < number; ++i) {
    const auto end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

/// Columns that a code point takes in a terminal: none for combining marks, two for East Asian letters and emoji.
std::size_t display_width(char32_t code) {
  if (code >= 0x300 && code <= 0x36F) return 0;
  const bool wide = (code >= 0x1100 && code <= 0x115F) || (code >= 0x2E80 && code <= 0xA4CF) ||
                    (code >= 0xAC00 && code <= 0xD7A3) || (code >= 0xF900 && code <= 0xFAFF) ||
                    (code >= 0xFE30 && code <= 0xFE6F) || (code >= 0xFF00 && code <= 0xFF60) || code >= 0x1F300;
  return wide ? 2 : 1;
}

// For what cannot be shown: one column wide, like what it stands for in the count of columns.
constexpr char32_t kReplacement = 0xFFFD;
constexpr std::string_view kReplacementText = "\uFFFD";

std::string replace_controls(std::string_view line) {
  std::string plain;
  while (!line.empty()) {
    const std::string_view from = line;
    const std::optional<char32_t> code = take_code_point(line);
    plain += code && !is_control(*code) ? from.substr(0, from.size() - line.size()) : kReplacementText;
  }
  return plain;
}

/// What of a line is shown, and where the span is in it.
struct Excerpt {
  std::string line;
  SourceSpan span;
};

/// The line whole, or of a long one, a table of thousand numbers, what is around the beginning of the span.
Excerpt make_excerpt(std::string_view line, SourceSpan span) {
  constexpr int kMostShown = 160;  // code points
  constexpr int kShownBefore = 60;
  const int before = std::max(span.column - 1 - kShownBefore, 0);
  std::string_view rest = line;
  std::string_view shown = line;
  for (int k = 0; k < before + kMostShown && !rest.empty(); ++k) {
    if (k == before) shown = rest;
    take_code_point(rest);
  }
  if (rest.empty() && before == 0) return {replace_controls(line), span};
  if (rest.empty() && shown.data() == line.data()) shown = {};
  Excerpt excerpt{before > 0 ? "…" : "", span};
  excerpt.line += replace_controls(shown.substr(0, shown.size() - rest.size()));
  if (!rest.empty()) excerpt.line += "…";
  excerpt.span.column += (before > 0 ? 1 : 0) - before;
  excerpt.span.length = std::min(span.length, before + kMostShown - span.column + 1);
  return excerpt;
}

/// Blanks up to the span, tabs kept as tabs, then a caret under each of its columns.
std::string make_caret(std::string_view line, const SourceSpan& span) {
  std::string caret;
  for (int column = 1; column < span.column; ++column) {
    if (line.empty()) {
      caret += ' ';
      continue;
    }
    const char32_t code = take_code_point(line).value_or(kReplacement);
    caret += code == U'\t' ? std::string{'\t'} : std::string(display_width(code), ' ');
  }
  std::size_t width = 0;
  for (int i = 0; i < span.length && !line.empty(); ++i) {
    width += display_width(take_code_point(line).value_or(kReplacement));
  }
  return caret + std::string(std::max<std::size_t>(width, 1), '^');
}

/// The place of the part of a text that is meant; the whole value's where the text is not a plain one of that line.
SourceSpan find_part(const Diagnostic& item, const SourceSpan& whole, std::string_view line) {
  for (int column = 1; column < whole.column && !line.empty(); ++column) take_code_point(line);
  const bool quoted =
      (line.starts_with('"') && !line.starts_with("\"\"\"")) || (line.starts_with('\'') && !line.starts_with("'''"));
  if (item.part < 0 || !quoted) return whole;
  line.remove_prefix(1);
  const std::string_view before = line.substr(0, static_cast<std::size_t>(item.part));
  if (before.find('\\') != std::string_view::npos) return whole;  // an escape is longer than what it stands for
  SourceSpan part{whole.line, whole.column + 1, 0};
  for (std::string_view rest = before; !rest.empty(); ++part.column) take_code_point(rest);
  std::string_view marked = line.substr(before.size(), static_cast<std::size_t>(std::max(item.part_length, 1)));
  for (; !marked.empty(); ++part.length) take_code_point(marked);
  return part;
}

// [characters] more than any message of ours without a value of the model in it.
constexpr std::size_t kLongestMessage = 600;
constexpr std::size_t kLongestNote = 2000;  // lists of names

/// On one line, whatever a name in it holds.
std::string render_line(std::string_view text, std::size_t most) {
  std::string line = shorten(show_controls(text), most);
  std::ranges::replace(line, '\n', ' ');
  return line;
}

void render_one(std::string& out, const Diagnostic& item, const SourceMap& source) {
  const auto write = std::back_inserter(out);
  const SourceSpan* span = source.find(item.path);
  const std::string* origin = source.find_origin(item.path);
  const bool placed = span != nullptr && span->line > 0;
  const std::string_view line = placed ? find_line(source.text, span->line) : std::string_view{};
  const SourceSpan place = placed ? find_part(item, *span, line) : SourceSpan{};
  if (placed) {
    fmt::format_to(write, "{}:{}:{}: ", show_controls(source.file), place.line, place.column);
  } else if (origin != nullptr) {
    fmt::format_to(write, "{}: ", render_line(*origin, kLongestMessage));
  }
  fmt::format_to(write, "{} {}: {}\n", severity_name(item.severity), item.code,
                 render_line(item.message, kLongestMessage));
  if (placed) {
    const Excerpt excerpt = make_excerpt(line, place);
    fmt::format_to(write, "{:>5} | {}\n      | {}\n", place.line, excerpt.line, make_caret(excerpt.line, excerpt.span));
    if (origin != nullptr) fmt::format_to(write, "   set by {}\n", render_line(*origin, kLongestMessage));
  }
  for (const std::string& note : item.notes) fmt::format_to(write, "   {}\n", render_line(note, kLongestNote));
}

/// Line and column; what has no place comes first.
std::pair<int, int> find_place(const Diagnostic& item, const SourceMap& source) {
  const SourceSpan* span = source.find(item.path);
  return span == nullptr ? std::pair{0, 0} : std::pair{span->line, span->column};
}

std::string count(std::size_t number, std::string_view what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

}  // namespace

std::string render(const Diagnostics& diagnostics, const SourceMap& source) {
  std::string out;
  std::string summary;
  for (const Severity severity : {Severity::error, Severity::warning, Severity::remark}) {
    std::vector<const Diagnostic*> items;
    for (const Diagnostic& item : diagnostics.items()) {
      if (item.severity == severity) items.push_back(&item);
    }
    if (items.empty()) continue;
    std::ranges::stable_sort(items, {}, [&source](const Diagnostic* item) { return find_place(*item, source); });
    for (const Diagnostic* item : items) render_one(out, *item, source);
    summary += (summary.empty() ? "" : ", ") + count(items.size(), severity_name(severity));
  }
  return summary.empty() ? out : out + summary + "\n";
}

}  // namespace gudgeon
