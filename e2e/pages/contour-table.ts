import type { Locator } from "@playwright/test";
import type { Context } from "./context.ts";

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

  /** The drawing on the large canvas. */
  get canvas(): Locator {
    return this.context.page.getByRole("group", { name: this.context.t.contour.canvas, exact: true });
  }

  get drawing(): Locator {
    return this.canvas.getByRole("img");
  }

  /** The choice of the picture in the middle. */
  view(view: "draw" | "lathe"): Locator {
    const { label, [view]: name } = this.context.t.contour.views;
    return this.context.page
      .getByRole("group", { name: label, exact: true })
      .getByRole("button", { name, exact: true });
  }

  /** A dimension on the drawing, by the name of its field: "Element 2, Z". */
  dimension(field: string): Locator {
    return this.canvas.getByRole("button", { name: this.context.t.contour.dimension(field, "") });
  }

  /** The field that a dimension becomes when it is clicked. */
  dimensionField(field: string): Locator {
    return this.canvas.getByRole("textbox", { name: this.context.t.contour.inDrawing(field), exact: true });
  }

  remove(element: number): Locator {
    return this.context.page.getByRole("button", { name: this.context.t.contour.remove(element), exact: true });
  }

  private field(name: string): Locator {
    return this.context.page.getByRole("textbox", { name, exact: true });
  }
}
