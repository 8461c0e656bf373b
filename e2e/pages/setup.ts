import type { Locator } from "@playwright/test";
import type { Context } from "./context.ts";

/** Tool, blank, start point, spindle, feed unit, rapid rate. Its section has to be shown first. */
export class Setup {
  constructor(private readonly context: Context) {}

  start(axis: "x" | "z"): Locator {
    return this.field(this.context.t.setup.start[axis]);
  }

  blank(size: "outside" | "bore" | "length" | "allowance"): Locator {
    return this.field(this.context.t.setup.blank[size]);
  }

  spindle(value: "speed" | "cuttingSpeed" | "limit"): Locator {
    return this.field(this.context.t.setup.spindle[value]);
  }

  spindleMode(mode: "constant" | "surface"): Locator {
    return this.context.page.getByRole("radio", { name: this.context.t.setup.spindle[mode], exact: true });
  }

  get perRevolution(): Locator {
    return this.context.page.getByRole("checkbox", { name: this.context.t.setup.feed.perRevolution, exact: true });
  }

  get rapid(): Locator {
    return this.field(this.context.t.setup.feed.rapid);
  }

  /** The value of a Q parameter that stands in a prompt. */
  parameter(name: string): Locator {
    return this.field(name);
  }

  get tools(): Locator {
    return this.context.page.getByRole("radiogroup", { name: this.context.t.setup.tool.list, exact: true });
  }

  /** A tool of the table by its number. */
  tool(number: number): Locator {
    return this.tools.getByRole("radio", {
      name: new RegExp(`^${this.context.t.setup.tool.name(number, "").trim()} `),
    });
  }

  private field(name: string): Locator {
    return this.context.page.getByRole("textbox", { name, exact: true });
  }
}
