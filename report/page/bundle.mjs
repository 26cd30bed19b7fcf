// Makes one page of page.html, style.css and src/, and writes it as C++.
//   node bundle.mjs FOLDER_OF_NODE_MODULES OUTPUT.cpp
// The page may load nothing: its policy allows this script and this style, by their hashes, alone.
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const source = dirname(fileURLToPath(import.meta.url));
const [packages, output] = process.argv.slice(2).map((path) => resolve(path));
const esbuild = createRequire(join(packages, 'package.json'))('esbuild');

const bundled = (entry, options) =>
  esbuild
    .buildSync({
      absWorkingDir: source,
      entryPoints: [entry],
      nodePaths: [join(packages, 'node_modules')],
      bundle: true,
      minify: true,
      write: false,
      charset: 'ascii',
      legalComments: 'none',
      target: ['chrome100', 'firefox100', 'safari15'],
      logLevel: 'warning',
      ...options,
    })
    .outputFiles[0].text.trim();

const script = bundled('src/main.ts', { format: 'iife', define: { 'process.env.NODE_ENV': '"production"' } });
const style = bundled('style.css', {});
if (/<\/script|<!--/i.test(script)) throw new Error('the script would end early inside a page');

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const licence = readFileSync(join(source, 'licences.txt'), 'utf8').trim();
const page = readFileSync(join(source, 'page.html'), 'utf8').replace(
  /@(POLICY|STYLE|SCRIPT|LICENCES)@/g,
  (_, part) =>
    ({
      POLICY: `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; base-uri 'none'; form-action 'none'`,
      STYLE: style,
      SCRIPT: script,
      LICENCES: licence,
    })[part],
);

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
