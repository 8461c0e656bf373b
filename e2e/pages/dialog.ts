import type { Locator } from "@playwright/test";
import { promptIds } from "./prompt-ids.ts";
import type { Context } from "./context.ts";

/** The prompts of a cycle: one open, all others one line each. */
export class Dialog {
  constructor(private readonly context: Context) {}

  get active(): Locator {
    return this.context.page.getByRole("region", { name: this.context.t.dialog.active, exact: true });
  }

  /** The heading of the open prompt: its question, or the text at the end of the dialog. */
  get question(): Locator {
    return this.active.getByRole("heading");
  }

  /** The number field of the open prompt. */
  get value(): Locator {
    return this.active.getByRole("textbox");
  }

  /** The group of numbers of the open prompt, where it is a choice. */
  get choices(): Locator {
    return this.active.getByRole("radiogroup");
  }

  choice(number: number): Locator {
    return this.choices.getByRole("radio").nth(number);
  }

  /** The error of the open prompt, as read out. */
  get messages(): Locator {
    return this.active.getByRole("status", { name: this.context.t.findings.title });
  }

  /** The line of a prompt in the list. */
  line(q: string): Locator {
    return this.list.getByRole("button", { name: new RegExp(`^${q} `) });
  }

  get list(): Locator {
    return this.context.page.getByRole("list", { name: this.context.t.dialog.list, exact: true });
  }

  get keypad(): Locator {
    return this.context.page.getByRole("group", { name: this.context.t.dialog.keypad, exact: true });
  }

  /** A key of the keypad: a digit, or a key by its name in the texts. */
  key(
    key:
      | "enterLong"
      | "noEnterLong"
      | "endLong"
      | "signLong"
      | "point"
      | "eraseLong"
      | "previous"
      | "next"
      | "cancel"
      | number,
  ): Locator {
    const name = typeof key === "number" ? String(key) : this.context.t.dialog.keys[key];
    return this.keypad.getByRole("button", { name, exact: true });
  }

  /** The question of a parameter as this language asks it. */
  promptOf(cycle: number, q: string): string {
    const id = promptIds[cycle]?.[q];
    return id ? this.context.t.params[id].prompt : "";
  }

  /** Opens a prompt from the list. */
  async open(q: string): Promise<void> {
    await this.line(q).click();
  }

  /** Types into the open prompt with the keyboard, replacing its value. It stays open. */
  async type(text: string): Promise<void> {
    const { keyboard } = this.context.page;
    if (await this.value.count()) {
      await this.value.press("ControlOrMeta+a");
      await this.value.press("Backspace");
    }
    await keyboard.type(text);
  }

  /** Opens a prompt, types and takes the value with ENT. */
  async set(q: string, text: string): Promise<void> {
    await this.open(q);
    await this.type(text);
    await this.context.page.keyboard.press("Enter");
  }
}
