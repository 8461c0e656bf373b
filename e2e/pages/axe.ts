import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";

/**
 * Reads each colour once. Axe parses the colours of all elements again for each text, the same few dozen a thousand
 * times: a quarter of its time for contrast.
 */
const READ_COLOURS_ONCE = `(() => {
  const { prototype } = axe.commons.color.Color, read = prototype.parseString, known = new Map();
  prototype.parseString = function (text) {
    const same = known.get(text);
    if (same) return Object.assign(this, same);
    read.call(this, text);
    const { r, g, b, alpha } = this;
    known.set(text, { r, g, b, alpha });
    return this;
  };
})();`;

/** Axe as one short file: it is sent to every page. */
const SOURCE = `${readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8")}\n${READ_COLOURS_ONCE}`;

/** Rules about colours: only these differ between light and dark, and while something calculates. */
export const COLOUR_RULES = ["color-contrast", "link-in-text-block"];

/** Whether axe has looked at the page since it was loaded. */
export const hasAxe = (page: Page): Promise<boolean> => page.evaluate(() => "axe" in window);

/** Waits for finite animations and transitions: halfway through, colours are neither. */
const animationsFinished = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const ending = document
      .getAnimations()
      .filter(
        ({ effect, playState }) => playState === "running" && effect?.getComputedTiming().iterations !== Infinity,
      );
    await Promise.allSettled(ending.map(({ finished }) => finished));
  });

/** The axe rules that the page breaks, out of all, only some, or all but some, with the elements that break them. */
export async function axeViolations(
  page: Page,
  { only, but = [] }: { readonly only?: string[]; readonly but?: string[] } = {},
): Promise<readonly string[]> {
  await animationsFinished(page);
  // Injected once, and reporting violations only, axe takes a fifth of the time.
  const axe = new AxeBuilder({ page, axeSource: (await hasAxe(page)) ? "0;" : SOURCE })
    .setLegacyMode()
    .options({ resultTypes: ["violations"] });
  const { violations } = await (only ? axe.withRules(only) : axe.disableRules(but)).analyze();
  return violations.map(
    (v) =>
      `${v.id}: ${v.nodes
        .map((n) => n.target.join(" "))
        .slice(0, 4)
        .join(" | ")}`,
  );
}
