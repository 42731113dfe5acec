// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes, JSON and HTML as text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "gudgeon/report/html/base64.h"
#include "gudgeon/report/html/block_store.h"
#include "gudgeon/report/html/html_text.h"
#include "gudgeon/report/html/json_text.h"
#include "gudgeon/report/svg_canvas.h"

namespace gudgeon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string encode(std::string_view text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  return encode_base64(bytes);
}

TEST(Base64, GivesTheExamplesOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(encode(""), "");
  EXPECT_EQ(encode("f"), "Zg==");
  EXPECT_EQ(encode("fo"), "Zm8=");
  EXPECT_EQ(encode("foo"), "Zm9v");
  EXPECT_EQ(encode("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encode("\xfb\xff\xfe"), "+//+");
}

TEST(JsonText, SeparatesAndEscapes) {
  JsonText json;
  json.begin_object();
  json.put("a", 1.5);
  json.key("b");
  json.begin_array();
  json.add("x\"\\\n");
  json.add(true);
  json.add(-3);
  json.end_array();
  json.put("c", std::nan(""));
  json.end_object();
  EXPECT_EQ(json.text(), R"({"a":1.5,"b":["x\"\\\u000a",true,-3],"c":null})");
}

TEST(JsonText, CannotEndItsScriptElement) {
  JsonText json;
  json.add("</script><script>alert(1)</script>");
  EXPECT_THAT(json.text(), Not(HasSubstr("<")));
}

TEST(HtmlText, EscapesWhatComesFromModelFiles) {
  EXPECT_EQ(escape_html("<b a=\"1\">&"), "&lt;b a=&quot;1&quot;&gt;&amp;");
  HtmlTable table("t", {"name", "value"});
  EXPECT_EQ(table.render(), "");
  table.add_row({"<x>", "-606.1 m/s^2"});
  EXPECT_THAT(table.render(), HasSubstr("&lt;x&gt;"));
  EXPECT_THAT(table.render(), HasSubstr("−606.1 m/s²"));
}

TEST(BlockStore, SharesBlocksByKey) {
  BlockStore blocks;
  const Numbers numbers = make_numbers({1.0, 2.0});
  int n_made = 0;
  const auto make = [&] {
    ++n_made;
    return blocks.add_signal(*numbers);
  };
  EXPECT_EQ(blocks.find({numbers.get(), 1}, make), blocks.find({numbers.get(), 1}, make));
  EXPECT_NE(blocks.find({numbers.get(), 1}, make), blocks.find({numbers.get(), 2}, make));
  EXPECT_EQ(n_made, 2);
  // 1.0f and 2.0f, little-endian: 00 00 80 3f 00 00 00 40.
  EXPECT_THAT(blocks.html(), HasSubstr("id=\"block-0\" data-type=\"f4\">AACAPwAAAEA=</script>"));
}

// Names of a strange run file may hold anything.
TEST(PageText, ShowsControlCharacters) {
  JsonText json;
  json.add("a\x1b[31m\u009b");
  EXPECT_EQ(json.text(), "\"a\\\\u001B[31m\\\\u009B\"");
  EXPECT_EQ(escape_html("a\x1b<\r"), "a\\u001B&lt;\\u000D");
  SvgCanvas canvas(100.0, 100.0, "a\x1b\u202e");
  EXPECT_THAT(canvas.render(), HasSubstr("a\\u001B\\u202E"));
}

// A word of five hundred letters in a picture of 800 pixels.
TEST(SvgCanvas, CutsATextThatIsWiderThanTheSheet) {
  SvgCanvas canvas(800.0, 400.0, "title");
  const std::string word(500, 'w');
  canvas.add_text({20.0, 30.0}, word, {.size = 16.0});
  canvas.add_text({700.0, 60.0}, word, {.size = 16.0, .anchor = TextAnchor::middle});
  canvas.add_text({20.0, 90.0}, "of ordinary length", {.size = 16.0});
  EXPECT_THAT(canvas.render(), HasSubstr(">" + std::string(82, 'w') + "…<"));
  EXPECT_THAT(canvas.render(), HasSubstr(">" + std::string(19, 'w') + "…<"));
  EXPECT_THAT(canvas.render(), HasSubstr(">of ordinary length<"));
}

}  // namespace
}  // namespace gudgeon
