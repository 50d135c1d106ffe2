// Makes the source file with the text of the page:
//
//   node build.mjs NODE_MODULES OUTPUT
//
// All scripts become one, which goes into page.html together with page.css and the licence of
// three.js.

import { readFile, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";

const [node_modules, output] = process.argv.slice(2);
const folder = path.dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(path.join(path.resolve(node_modules), "x"))("esbuild");

const bundle = await esbuild.build({
  entryPoints: [path.join(folder, "main.js")],
  nodePaths: [path.resolve(node_modules)],
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2022",
  legalComments: "none",
  write: false,
});
const style = await esbuild.build({
  entryPoints: [path.join(folder, "page.css")],
  minify: true,
  write: false,
});

const pieces = {
  LICENSE: await readFile(path.join(node_modules, "three/LICENSE"), "utf8"),
  STYLE: style.outputFiles[0].text.trim(),
  SCRIPT: bundle.outputFiles[0].text.trim(),
};
const html = (await readFile(path.join(folder, "page.html"), "utf8")).replace(
  /\{\{(LICENSE|STYLE|SCRIPT)\}\}/g,
  (_, name) => pieces[name],
);
const [before_data, after_data] = html.split("{{DATA}}");

// String literals that compilers take: in plain characters, and not too long. A piece ends in no
// escape sequence, since each is encoded alone.
function literals(text) {
  const lines = [];
  for (let i = 0; i < text.length; i += 4000) {
    const bytes = Buffer.from(text.slice(i, i + 4000), "utf8");
    let literal = "";
    for (const byte of bytes) {
      const character = String.fromCharCode(byte);
      if (byte < 32 || byte > 126 || '"\\?'.includes(character))
        literal += "\\" + byte.toString(8).padStart(3, "0");
      else literal += character;
    }
    lines.push(`"${literal}"`);
  }
  return lines.join(",\n");
}

await writeFile(
  output,
  `// Made by build.mjs.

#include "Page_text.h"

const Page_text& page_text()
{
  static const Page_text text = {{${literals(before_data)}},
                                 {${literals(after_data)}}};
  return text;
}
`,
);
