import { readFileSync } from "node:fs";
import { join } from "node:path";
import { root } from "./packages.mjs";

/**
 * scripts/NAME.ts with all it imports as the text of one module, which plain Node runs without a checkout and without packages.
 *
 * @param {string} name the script
 * @param {{ minify?: boolean }} [how]
 * @returns {Promise<string>}
 */
export async function bundle(name, { minify = false } = {}) {
  const { build } = await import("vite");
  const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
  const made = await build({
    root,
    configFile: false,
    logLevel: "error",
    publicDir: false,
    define: { "import.meta.env.VITE_VERSION": JSON.stringify(version) },
    ssr: { noExternal: true, target: "node" },
    build: {
      ssr: join(root, "scripts", `${name}.ts`),
      write: false,
      target: "node20",
      minify,
      rolldownOptions: { output: { codeSplitting: false } },
    },
  });
  const chunks = made.output.filter((file) => file.type === "chunk");
  if (chunks.length !== 1) throw new Error(`${name} became ${chunks.length} files`);
  return chunks[0].code;
}
