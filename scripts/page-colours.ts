import { readFileSync } from "node:fs";
import { join } from "node:path";

/* Reads the style sheets of the page, so that a static drawing has its colours. Runs in the project folder. */
const sheet = (path: string) => readFileSync(join("src", "app", path), "utf8");

/** The declarations of all rules whose selector is at the beginning of a line, so without those in `@media`. */
const rulesOf = (css: string, selector: string): string =>
  css
    .split("\n")
    .flatMap((line, i, lines) => (line.startsWith(`${selector} {`) ? [lines.slice(i).join("\n")] : []))
    .map((rule) => rule.slice(rule.indexOf("{") + 1, rule.indexOf("}")))
    .join(";");

/** The colours by name, light, and dark where the system is. Only those that a text uses. */
function colours(used: string): string {
  const tokens = sheet("base/styles/tokens.css");
  const of = (selector: string) =>
    rulesOf(tokens, selector)
      .split(";")
      .map((d) => d.trim())
      .filter((d) => used.includes(`var(${d.split(":")[0]})`))
      .join(";");
  return `:root{color-scheme:light dark;${of(":root")}}@media (prefers-color-scheme: dark){:root{${of(':root[data-theme="dark"]')}}}`;
}

/** A style sheet with the colours that it uses, on few lines. */
export const styled = (css: string): string =>
  (colours(css) + css.replace(/\/\*.*?\*\//gs, "")).replace(/\s+/g, " ").trim();

/** The style of the help picture, for an `svg` of that class. */
export const helpRules = (): string =>
  [
    ...(sheet("pictures/help/help.css").split("@media")[0] ?? "").matchAll(
      /^\.help-picture (?:path|text|\.)[^{}]*\{[^{}]*\}/gm,
    ),
  ]
    .map(([rule]) => rule)
    .filter((rule) => !/^\.help-picture \.(?:help-note|dimmed)/.test(rule))
    .join("\n");
