import AxeBuilder from "@axe-core/playwright";
import type { Page } from "@playwright/test";

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

/** The axe rules that the page breaks, out of all or some, with the elements that break them. */
export async function axeViolations(page: Page, rules?: string[]): Promise<readonly string[]> {
  await animationsFinished(page);
  // Injected once, and reporting violations only, axe takes a fifth of the time.
  const isThere = await page.evaluate(() => "axe" in window);
  const axe = new AxeBuilder(isThere ? { page, axeSource: "0;" } : { page })
    .setLegacyMode()
    .options({ resultTypes: ["violations"] });
  const { violations } = await (rules ? axe.withRules(rules) : axe).analyze();
  return violations.map(
    (v) =>
      `${v.id}: ${v.nodes
        .map((n) => n.target.join(" "))
        .slice(0, 4)
        .join(" | ")}`,
  );
}
