import { readFileSync } from "node:fs";
import { join } from "node:path";
import { texts } from "../src/i18n/index.ts";
import { LANGUAGES, type Language } from "../src/i18n/languages.ts";

/** The value of a colour of the light page. */
const colour = (name: string): string =>
  new RegExp(`--${name}: (#[0-9a-f]{6});`).exec(
    readFileSync(join("src", "app", "base", "styles", "tokens.css"), "utf8"),
  )?.[1] ?? "";

const icon = (name: string, size: number, purpose: "any" | "maskable") => ({
  src: `icons/${name}-${size}.png`,
  sizes: `${size}x${size}`,
  type: "image/png",
  purpose,
});

/** The manifest for home screens; every address in it is relative, so that the site can be in any folder. */
export function webManifest(language: Language): object {
  const t = texts(language).page;
  const way = (name: string, address: string) => ({ name, url: `./#/${address}`, icons: [icon("icon", 192, "any")] });
  return {
    id: "./",
    start_url: "./",
    scope: "./",
    lang: language,
    dir: "ltr",
    name: t.product,
    short_name: t.product,
    description: t.promise,
    display: "standalone",
    theme_color: colour("page"),
    background_color: colour("page"),
    categories: ["productivity", "utilities", "education"],
    icons: [
      { src: "icon.svg", sizes: "any", type: "image/svg+xml", purpose: "any" },
      icon("icon", 192, "any"),
      icon("icon", 512, "any"),
      icon("maskable", 192, "maskable"),
      icon("maskable", 512, "maskable"),
    ],
    shortcuts: [way(t.newProgram, "new"), way(t.start.which, "which"), way(t.tools.title, "tools")],
  };
}

/** The manifest in each language as text, by the name of its file. */
export const manifests = (): Readonly<Record<string, string>> =>
  Object.fromEntries(
    LANGUAGES.map((language) => [`manifest.${language}.webmanifest`, JSON.stringify(webManifest(language), null, 1)]),
  );
