import type { Locator } from "@playwright/test";
import type { Context } from "./context.ts";

/** The verdict and the list of all findings, the same for prompts and whole programs. */
export class Findings {
  constructor(private readonly context: Context) {}

  private get words() {
    return this.context.t.findings;
  }

  get tab(): Locator {
    return this.context.page.getByRole("tab", { name: new RegExp(`^${this.words.title}`) });
  }

  get panel(): Locator {
    return this.context.page.getByRole("tabpanel", { name: new RegExp(`^${this.words.title}`) });
  }

  get items(): Locator {
    return this.panel.getByRole("list", { name: this.words.list, exact: true }).getByRole("listitem");
  }

  /** The mark of a finding with a place in the picture, in the list. */
  mark(mark: string): Locator {
    return this.panel.getByRole("button", { name: this.words.show(mark), exact: true });
  }

  /** A button of the list: goes to a place, or fixes a finding. */
  button(name: string): Locator {
    return this.panel.getByRole("button", { name, exact: true }).first();
  }

  /** The question before a program with faults leaves the page. */
  get question(): Locator {
    return this.context.page.getByRole("alertdialog");
  }

  /** Answers the question. */
  answer(name: "look" | "cancel" | "copy" | "save" | "download" | "share"): Locator {
    const { leaving } = this.words;
    return this.question.getByRole("button", {
      name: name === "look" || name === "cancel" ? leaving[name] : leaving.go[name],
      exact: true,
    });
  }
}
