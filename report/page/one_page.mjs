// Makes one file of a page: script and style inside it, allowed by their hashes alone.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));

/// Bundles an entry of `source` with the esbuild and the libraries of `packages`, the folder of node_modules.
function bundled(packages, source, entry, options) {
  const esbuild = createRequire(join(packages, 'package.json'))('esbuild');
  return esbuild
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
}

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;

/// The page of `source`: page.html with src/main.ts and style.css. `policy` has further sources by
/// directive of its policy, which allows nothing else; `options` are those of esbuild for the script.
export function onePage(packages, source, { policy = {}, options = {} } = {}) {
  const script = bundled(packages, source, 'src/main.ts', { format: 'iife', define: { 'process.env.NODE_ENV': '"production"' }, ...options });
  const style = bundled(packages, source, 'style.css', {});
  if (/<\/script|<!--/i.test(script)) throw new Error('the script would end early inside a page');
  const { 'script-src': alsoScript = '', ...others } = policy;
  const directives = ["default-src 'none'", `script-src ${hash(script)}${alsoScript && ` ${alsoScript}`}`, `style-src ${hash(style)}`, ...Object.entries(others).map(([name, from]) => `${name} ${from}`), "base-uri 'none'", "form-action 'none'"];
  const parts = { POLICY: directives.join('; '), STYLE: style, SCRIPT: script, LICENCES: readFileSync(join(here, 'licences.txt'), 'utf8').trim() };
  const page = readFileSync(join(source, 'page.html'), 'utf8').replace(/@(POLICY|STYLE|SCRIPT|LICENCES)@/g, (_, part) => parts[part]);
  return { page, script, style };
}
