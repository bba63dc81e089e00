// Builds dist/ from src/: unminified, without anything that differs from run to run.
// usage: node build.mjs [OUTPUT_FOLDER]
import { build } from "esbuild";
import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2] ?? join(here, "dist");

await mkdir(output, { recursive: true });
await build({
  absWorkingDir: here,
  entryPoints: ["src/main.ts"],
  bundle: true,
  format: "esm",
  target: "es2022",
  charset: "utf8",
  legalComments: "inline",
  outfile: join(output, "page.js"),
});
for (const file of ["index.html", "page.css", "icon.svg"]) {
  await copyFile(join(here, "src", file), join(output, file));
}
const three = JSON.parse(await readFile(join(here, "node_modules/three/package.json"), "utf8"));
const license = await readFile(join(here, "node_modules/three/LICENSE"), "utf8");
await writeFile(join(output, "licenses.txt"), `page.js holds parts of three.js ${three.version}:\n\n${license}`);
