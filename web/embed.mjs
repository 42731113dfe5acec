// SPDX-FileCopyrightText: gudgeon contributors
// SPDX-License-Identifier: Apache-2.0
//
// embed.mjs SCRIPT STYLE OUTPUT: writes both texts as a C++ source that defines page_script() and page_style().
import { readFileSync, writeFileSync } from 'node:fs';

const [script, style, output] = process.argv.slice(2);

/** A string literal; long ones in pieces that every compiler takes. */
function makeLiteral(text) {
  const pieces = [];
  for (let at = 0; at < text.length; at += 8000) pieces.push(`R"~page~(${text.slice(at, at + 8000)})~page~"`);
  return pieces.join('\n') || '""';
}

/** Nothing in the script may end the element it stands in. */
const safeScript = readFileSync(script, 'utf8').replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const source = `#include "gudgeon/report/html/page_assets.h"

namespace gudgeon {

std::string_view page_script() {
  static constexpr std::string_view kScript =
${makeLiteral(safeScript)};
  return kScript;
}

std::string_view page_style() {
  static constexpr std::string_view kStyle =
${makeLiteral(readFileSync(style, 'utf8'))};
  return kStyle;
}

}  // namespace gudgeon
`;
writeFileSync(output, source);
