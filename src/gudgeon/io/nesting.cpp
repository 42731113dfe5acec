// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// One pass over the text, which knows keys, texts, comments and brackets.
#include "gudgeon/io/nesting.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace gudgeon {

namespace {

bool is_key_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         (static_cast<unsigned char>(c) & 0x80U) != 0;
}

class NestingScan {
 public:
  explicit NestingScan(std::string_view text) : text_(text) {}

  std::optional<NestingPlace> find() {
    while (at_ < text_.size()) {
      read_token();
      if (depth_ > kDeepestNesting) return find_place();
    }
    return std::nullopt;
  }

 private:
  // An array or inline table that is open, or the header of a table.
  struct Level {
    char bracket;
    int depth;  // around it
  };

  void read_token() {
    token_ = at_;
    const char c = text_[at_];
    if (c == '"' || c == '\'') {
      count_key_part();
      skip_text(c);
    } else if (c == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (in_key_ && is_key_letter(c)) {
      count_key_part();
      while (at_ < text_.size() && is_key_letter(text_[at_])) ++at_;
    } else {
      ++at_;
      read_symbol(c);
    }
  }

  void count_key_part() {
    if (in_key_) ++depth_;
  }

  void read_symbol(char c) {
    if (c == '=') {
      in_key_ = false;
    } else if (c == '[' || c == '{') {
      open(c);
    } else if (c == ']' || c == '}') {
      close();
    } else if (c == ',' && !levels_.empty()) {
      end_value();
    } else if (c == '\n' && levels_.empty()) {
      depth_ = header_depth_;
      in_key_ = true;
    }
  }

  void open(char bracket) {
    const bool header = levels_.empty() && in_key_;
    if (header) depth_ = 0;
    levels_.push_back({header ? 'h' : bracket, depth_});
    // The brackets of a header are no level: "[[a]]" is one of an array, and what is in it is a table.
    if (!header) ++depth_;
    in_key_ = header || bracket == '{' || (levels_.front().bracket == 'h');
  }

  void close() {
    if (levels_.empty()) return;
    if (levels_.front().bracket == 'h') {
      if (levels_.size() == 1) header_depth_ = depth_;
    } else {
      depth_ = levels_.back().depth;
    }
    levels_.pop_back();
    in_key_ = false;
  }

  // After a comma: another key in an inline table, another value in an array.
  void end_value() {
    depth_ = levels_.back().depth + 1;
    in_key_ = levels_.back().bracket == '{';
  }

  void skip_text(char quote) {
    const std::string_view triple = quote == '"' ? R"(""")" : "'''";
    const bool several_lines = text_.substr(at_).starts_with(triple);
    at_ += several_lines ? 3 : 1;
    while (at_ < text_.size()) {
      if (quote == '"' && text_[at_] == '\\') {
        at_ += 2;
      } else if (several_lines && text_.substr(at_).starts_with(triple)) {
        at_ += 3;
        while (at_ < text_.size() && text_[at_] == quote) ++at_;  // two quotes may stand before the last three
        return;
      } else if (!several_lines && (text_[at_] == quote || text_[at_] == '\n')) {
        if (text_[at_] == quote) ++at_;
        return;
      } else {
        ++at_;
      }
    }
  }

  [[nodiscard]] NestingPlace find_place() const {
    NestingPlace place;
    for (const char c : text_.substr(0, token_)) {
      if (c == '\n') {
        ++place.line;
        place.column = 1;
      } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {
        ++place.column;
      }
    }
    return place;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t token_ = 0;  // where the last token begins
  std::vector<Level> levels_;
  int depth_ = 0;         // of what is being read
  int header_depth_ = 0;  // of the table that keys are put in
  bool in_key_ = true;
};

}  // namespace

std::optional<NestingPlace> find_deep_nesting(std::string_view text) { return NestingScan{text}.find(); }

}  // namespace gudgeon
