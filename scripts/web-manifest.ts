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

/** Pictures for the browser's install dialog, taken by `npm run pictures -- wide narrow`; no part of the page itself. */
export const SCREENSHOTS = {
  wide: { width: 1280, height: 800 },
  narrow: { width: 390, height: 844 },
} as const;
type Form = keyof typeof SCREENSHOTS;

/** The manifest for home screens; every address in it is relative, so that the site can be in any folder. */
export function webManifest(language: Language): object {
  const { page: t, helpMenu } = texts(language);
  const screenshot = (form: Form) => ({
    src: `screenshots/${form}.jpg`,
    sizes: `${SCREENSHOTS[form].width}x${SCREENSHOTS[form].height}`,
    type: "image/jpeg",
    form_factor: form,
    label: t.promise,
  });
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
    shortcuts: [
      way(t.newProgram, "new"),
      way(t.start.which, "which"),
      way(helpMenu.course, "course"),
      way(t.tools.title, "tools"),
    ],
    screenshots: [screenshot("wide"), screenshot("narrow")],
  };
}

/** The manifest in each language as text, by the name of its file. */
export const manifests = (): Readonly<Record<string, string>> =>
  Object.fromEntries(
    LANGUAGES.map((language) => [`manifest.${language}.webmanifest`, JSON.stringify(webManifest(language), null, 1)]),
  );
