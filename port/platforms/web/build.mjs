// SPDX-License-Identifier: MIT
// Puts the page's files together: node build.mjs SITE MODULES, where MODULES holds node_modules (toolchains/setup.sh web).
// The .wasm files are in SITE already.

import { createRequire } from "node:module";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [site, modules] = process.argv.slice(2).map((path) => resolve(path));
const page = join(dirname(fileURLToPath(import.meta.url)), "page");
const require = createRequire(join(modules, "package.json"));
const esbuild = require("esbuild");

mkdirSync(site, { recursive: true });
await esbuild.build({
  entryPoints: ["main.js", "worker.js", "lab.js"].map((name) => join(page, name)),
  outdir: site,
  bundle: true,
  minify: true,
  format: "esm",
  target: "es2022",
  nodePaths: [join(modules, "node_modules")],
  legalComments: "none",
  logLevel: "warning",
});
for (const name of ["index.html", "laboratory.html"]) copyFileSync(join(page, name), join(site, name));
const plots = readFileSync(require.resolve("uplot/dist/uPlot.min.css"), "utf8");
writeFileSync(join(site, "style.css"), plots + readFileSync(join(page, "style.css"), "utf8"));
// Both libraries are under the MIT licence, whose text goes with them.
const licences = ["three", "uplot"].map((name) => `${name}\n\n${readFileSync(join(modules, "node_modules", name, "LICENSE"), "utf8")}`);
writeFileSync(join(site, "licences.txt"), licences.join("\n\n"));
