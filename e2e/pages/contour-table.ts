import type { Locator } from "@playwright/test";
import type { Context } from "./turnwise.ts";

/** The table of a contour subprogram. Its section has to be shown first; elements count from 1. */
export class ContourTable {
  constructor(private readonly context: Context) {}

  get table(): Locator {
    return this.context.page.getByRole("table", { name: this.context.t.contour.table, exact: true });
  }

  get add(): Locator {
    return this.context.page.getByRole("button", { name: this.context.t.contour.add, exact: true });
  }

  kind(element: number): Locator {
    return this.context.page.getByRole("combobox", { name: this.context.t.contour.kindOf(element), exact: true });
  }

  x(element: number): Locator {
    return this.field(this.context.t.contour.xOf(element));
  }

  z(element: number): Locator {
    return this.field(this.context.t.contour.zOf(element));
  }

  radius(element: number): Locator {
    return this.field(this.context.t.contour.radiusOf(element));
  }

  chamfer(element: number): Locator {
    return this.field(this.context.t.contour.chamferOf(element));
  }

  angle(element: number): Locator {
    return this.field(this.context.t.contour.angleOf(element));
  }

  length(element: number): Locator {
    return this.field(this.context.t.contour.lengthOf(element));
  }

  /** Shows the fields for angle, length and tangency. */
  get details(): Locator {
    return this.context.page.getByRole("button", { name: this.context.t.contour.details, exact: true });
  }

  /** What the pointer does in the drawing. */
  drawingMode(mode: "move" | "draw" | "round" | "chamfer"): Locator {
    return this.context.page.getByRole("button", { name: this.context.t.contour.modes[mode], exact: true });
  }

  remove(element: number): Locator {
    return this.context.page.getByRole("button", { name: this.context.t.contour.remove(element), exact: true });
  }

  private field(name: string): Locator {
    return this.context.page.getByRole("textbox", { name, exact: true });
  }
}
