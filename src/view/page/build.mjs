// Bundles the page into one file: dist/index.html. The same sources give the same bytes.
import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";

/** Maximum size (bytes) of the built page. */
const SIZE = 1_200_000;

const read = name => readFile(new URL(name, import.meta.url), "utf8");
const lock = JSON.parse(await read("package-lock.json")).packages;
const version = name => lock[`node_modules/${name}`].version;
const common = { bundle: true, minify: true, write: false, charset: "utf8", legalComments: "none", target: "es2022" };
const bundle = async (entry, more) =>
  (await build({ ...common, entryPoints: [new URL(entry, import.meta.url).pathname], ...more })).outputFiles[0].text;

const script = await bundle("src/main.ts", {
  format: "iife",
  define: {
    VERSION_THREE: JSON.stringify(version("three")),
    VERSION_UPLOT: JSON.stringify(version("uplot")),
    LICENCES: JSON.stringify(await read("LICENSES.txt")),
  },
});
const style = await bundle("src/style.css", { loader: { ".css": "css" } });
// a closing tag inside the script would end it
const safe = script.replaceAll("</script", "<\\/script").replaceAll("<!--", "<\\!--");
const template = await read("src/index.html");
const fill = { STYLE: style.trim(), SCRIPT: safe.trim() };
const page = template.replace(/\/\*(STYLE|SCRIPT)\*\//g, (_, name) => fill[name]);

const bytes = Buffer.byteLength(page);
if (bytes > SIZE) throw new Error(`the page has ${bytes} bytes; at most ${SIZE} are allowed`);
if (/\beval\(|new Function\(/.test(script)) throw new Error("the script evaluates text");
await mkdir(new URL("dist", import.meta.url), { recursive: true });
await writeFile(new URL("dist/index.html", import.meta.url), page);
console.log(`dist/index.html: ${bytes} bytes`);
