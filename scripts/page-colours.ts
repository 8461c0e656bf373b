import { readFileSync } from "node:fs";
import { join } from "node:path";

/* Reads the style sheets of the page, so that a static drawing has its colours. Runs in the project folder. */
const sheet = (path: string) => readFileSync(join("src", "app", path), "utf8");

/** The declarations of the first rule with a selector. */
function ruleOf(css: string, selector: string): string {
  const from = css.indexOf(`${selector} {`);
  return from < 0 ? "" : css.slice(css.indexOf("{", from) + 1, css.indexOf("}", from));
}

/** The colours by name, light, and dark where the system is. Only those that a text uses. */
function colours(used: string): string {
  const tokens = sheet("styles/tokens.css");
  const of = (selector: string) =>
    ruleOf(tokens, selector).split(";").map((d) => d.trim()).filter((d) => used.includes(`var(${d.split(":")[0]})`)).join(";");
  return `:root{color-scheme:light dark;${of(":root")}}@media (prefers-color-scheme: dark){:root{${of(':root[data-theme="dark"]')}}}`;
}

/** A sheet with the colours that it names, on few lines. */
export const styled = (css: string): string => (colours(css) + css.replace(/\/\*.*?\*\//gs, "")).replace(/\s+/g, " ").trim();

/** How the help picture is drawn, for an `svg` of that class. */
export const helpRules = (): string =>
  [...(sheet("help/help.css").split("@media")[0] ?? "").matchAll(/^\.help-picture (?:path|text|\.)[^{}]*\{[^{}]*\}/gm)].map(([rule]) =>
    rule
  ).filter((rule) => !/^\.help-picture \.(?:help-note|dimmed)/.test(rule)).join("\n");
