// Makes one page of page.html, style.css and src/, and writes it as C++.
//   node bundle.mjs FOLDER_OF_NODE_MODULES OUTPUT.cpp
// The page may load nothing: its policy allows this script and this style, by their hashes, alone.
import { writeFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { onePage } from './one_page.mjs';

const source = dirname(fileURLToPath(import.meta.url));
const [packages, output] = process.argv.slice(2).map((path) => resolve(path));
const { page, script, style } = onePage(packages, source);

const bytes = Buffer.from(page);
const lines = [];
for (let at = 0; at < bytes.length; at += 32) lines.push([...bytes.subarray(at, at + 32)].join(','));
writeFileSync(
  output,
  `#include "report/report_template.h"

namespace raceway::report {
namespace {
constexpr unsigned char page[] = {
${lines.join(',\n')}};
}  // namespace

std::string_view report_template() {
  return {reinterpret_cast<const char*>(page), sizeof page};
}

}  // namespace raceway::report
`,
);
console.log(`report page: ${bytes.length} bytes, script ${script.length}, style ${style.length}`);
