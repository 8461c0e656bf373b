import type { Locator } from "@playwright/test";
import type { Context } from "./context.ts";

/**
 * The view of the machine, the lathe or the plane of a milled program: picture, playback, timeline, findings and moves.
 */
export class Lathe {
  constructor(private readonly context: Context) {}

  get view(): Locator {
    const { page, t } = this.context,
      named = (name: string) => page.getByRole("region", { name, exact: true });
    return named(t.lathe.title).or(named(t.approach.view));
  }

  /** The picture; its name says in words what it shows. */
  get picture(): Locator {
    return this.view.getByRole("img").first();
  }

  button(
    name: "play" | "pause" | "forward" | "back" | "first" | "last" | "xDown" | "ruler" | "zoomIn" | "zoomOut" | "fit",
  ): Locator {
    return this.view.getByRole("button", { name: this.context.t.lathe[name], exact: true });
  }

  /** How the work is shown: section or from outside. */
  get section(): Locator {
    return this.view.getByRole("combobox", { name: this.context.t.lathe.sections.title, exact: true });
  }

  /** Selects section, outside or 3D view; on narrow screens it unfolds the choice first and folds it again. */
  async shows(view: string): Promise<void> {
    const fold = this.view.getByRole("button", { name: this.context.t.lathe.viewTools, exact: true }),
      folded = !(await this.section.isVisible());
    if (folded) await fold.click();
    await this.section.selectOption(view);
    if (folded && (await this.section.isVisible())) await fold.click();
  }

  /** The choice of the colour map of path or surface. */
  get colours(): Locator {
    return this.view.getByRole("combobox", { name: this.context.t.lathe.colours.title, exact: true });
  }

  get timeline(): Locator {
    return this.view.getByRole("slider", { name: this.context.t.lathe.timeline, exact: true });
  }

  get speed(): Locator {
    return this.view.getByRole("combobox", { name: this.context.t.lathe.speed, exact: true });
  }

  /** Position, feed, phase and the current step of the manual. */
  get running(): Locator {
    return this.view.getByRole("group", { name: this.context.t.lathe.now, exact: true });
  }

  /** The mark of a finding in the picture: a number, or a letter for residual material. */
  mark(mark: string): Locator {
    return this.view.getByRole("button", { name: new RegExp(`^${mark}: `) });
  }

  /** Advances the manual clock; the page has to be opened with `heldClock`. */
  async advance(milliseconds: number): Promise<void> {
    await this.context.page.evaluate((ms) => window.__turnwiseClock?.advance(ms), milliseconds);
  }
}
