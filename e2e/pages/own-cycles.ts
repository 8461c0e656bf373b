import type { Locator } from "@playwright/test";
import type { OwnTexts } from "../../src/i18n/en/tables/own.ts";
import type { Context } from "./context.ts";

type OwnCell = keyof OwnTexts["cells"];

/** The operator's own cycles: their list, the form of one, and the buttons that lead there. */
export class OwnCycles {
  constructor(private readonly context: Context) {}

  private get words() {
    return this.context.t.own;
  }

  /** From the block of an unknown cycle. */
  get describe(): Locator {
    return this.button(this.words.describe);
  }

  /** From the dialog of a described cycle. */
  get change(): Locator {
    return this.button(this.words.change);
  }

  get back(): Locator {
    return this.button(this.words.backLong);
  }

  get add(): Locator {
    return this.button(this.words.add);
  }

  get status(): Locator {
    return this.context.page.locator(".tool-status");
  }

  get takeBack(): Locator {
    return this.status.getByRole("button", { name: `${this.words.undo} – ` });
  }

  row(number: number, name: string): Locator {
    return this.context.page.getByRole("list", { name: this.words.list }).getByRole("button", {
      name: new RegExp(this.words.select(this.words.cycleName(String(number), name))),
    });
  }

  remove(number: number, name: string): Locator {
    return this.button(this.words.removeLong(this.words.cycleName(String(number), name)));
  }

  get number(): Locator {
    return this.context.page.getByRole("textbox", { name: this.words.number, exact: true });
  }

  get name(): Locator {
    return this.context.page.getByRole("textbox", { name: this.words.name, exact: true });
  }

  cell(q: string, cell: OwnCell): Locator {
    return this.context.page.getByRole("textbox", { name: `${q}: ${this.words.cells[cell]}`, exact: true });
  }

  kind(q: string): Locator {
    return this.context.page.getByRole("combobox", { name: `${q}: ${this.words.kind}`, exact: true });
  }

  /** The block as it will be written to a program. */
  get text(): Locator {
    return this.context.page.getByRole("figure", { name: this.words.text });
  }

  /** The group of own cycles in the cycle chooser. */
  get group(): Locator {
    return this.context.page.getByRole("region", { name: this.context.t.page.own.title, exact: true });
  }

  private button(name: string): Locator {
    return this.context.page.getByRole("button", { name, exact: true });
  }
}
