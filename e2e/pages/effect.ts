import { expect, type Locator } from "@playwright/test";
import type { Context } from "./context.ts";

type EffectCell = "passes" | "infeed" | "time" | "chip" | "residual" | "proof";

/**
 * Any verdict that the path is verified, in one language. The grinding diameter of an axial blade is never stated, so
 * that doubt is allowed.
 */
export function provedIn({ findings: { verdict } }: Context["t"]): RegExp {
  const [proved = ""] = verdict.proved.split(/[\s:：]/);
  return new RegExp(`^(?:${proved}|${verdict.curvatureUnknown})`);
}

/** The effect of the values, updated while they are typed. */
export class Effect {
  constructor(private readonly context: Context) {}

  get strip(): Locator {
    return this.context.page.getByRole("region", { name: this.context.t.page.effect.title, exact: true });
  }

  /** The value of one cell, found by its name. */
  cell(cell: EffectCell): Locator {
    const { page, t } = this.context;
    const name = page
      .getByRole("term")
      .filter({ hasText: cell === "proof" ? t.findings.verdict.title : t.page.effect[cell] });
    return this.strip.locator("div").filter({ has: name }).getByRole("definition");
  }

  /** The words of the verdicts, for `toContainText` on `cell("proof")`. */
  get verdicts() {
    return this.context.t.findings.verdict;
  }

  /** Waits until the current program is verified. */
  async proved(): Promise<void> {
    // As long as the cell is missing, an assertion would describe the whole page each time it looks.
    await this.cell("proof").waitFor();
    await expect(this.cell("proof")).toHaveText(provedIn(this.context.t));
  }

  /** The button that leads to the list of findings; absent when there are none. */
  get findings(): Locator {
    return this.strip.getByRole("status").getByRole("button");
  }
}
