import { expect, type Locator } from "@playwright/test";
import { Menus } from "./menus.ts";
import { Sharing } from "./sharing.ts";
import { settledBox } from "./picture.ts";
import type { Context } from "./context.ts";

type Example = keyof Context["t"]["page"]["examples"];
type Section = keyof Context["t"]["editor"]["sections"] | "findings";

/** Whole programs: opening, the text, the list of parts, the dialog of a block. */
export class ProgramEditor {
  constructor(private readonly context: Context) {}

  private get words() {
    return this.context.t.editor;
  }

  async openExample(id: Example): Promise<void> {
    await this.context.page
      .getByRole("button", {
        name: this.context.t.page.programs.example(this.context.t.page.examples[id]),
        exact: true,
      })
      .click();
    await expect(this.text).toBeVisible();
  }

  /** Opens bytes as a file of the device. */
  async openFile(name: string, bytes: Uint8Array): Promise<void> {
    await this.context.page.locator("input[type=file]:not([webkitdirectory])").setInputFiles({
      name,
      mimeType: "text/plain",
      buffer: Buffer.from(bytes),
    });
    await expect(this.text).toBeVisible();
  }

  /** Drops files on the page, as from a folder. */
  async drop(files: Readonly<Record<string, string>>): Promise<void> {
    const { page } = this.context;
    const data = await page.evaluateHandle((all) => {
      const made = new DataTransfer();
      for (const [name, text] of Object.entries(all)) made.items.add(new File([text], name, { type: "text/plain" }));
      return made;
    }, files);
    await page.getByRole("main").waitFor();
    await page.dispatchEvent("body", "drop", { dataTransfer: data });
  }

  /** The list of the files of the work. */
  get files(): Locator {
    return this.context.page.getByRole("region", { name: this.words.files.title, exact: true });
  }

  /** The button that shows a file of the work. */
  file(name: string): Locator {
    return this.files.getByRole("button", { name: this.words.files.show(name), exact: true });
  }

  /** The switch for blocks behind a skip mark. */
  get leaveOut(): Locator {
    return this.context.page.getByRole("checkbox", { name: this.words.leaveOut, exact: true });
  }

  async paste(text: string): Promise<void> {
    const { page } = this.context;
    await page.getByRole("button", { name: this.context.t.page.programs.paste, exact: true }).click();
    const dialog = page.getByRole("dialog", { name: this.context.t.page.programs.pasteTitle });
    await dialog.getByRole("textbox").fill(text);
    await dialog.getByRole("button", { name: this.context.t.page.programs.pasteOpen, exact: true }).click();
    await expect(this.text).toBeVisible();
  }

  /** Pastes a program on the start page, outside of any field. */
  async pasteOnPage(text: string): Promise<void> {
    await this.context.page.evaluate((pasted) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData("text/plain", pasted);
      document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
    }, text);
    await expect(this.text).toBeVisible();
  }

  /** The text editor. */
  get text(): Locator {
    return this.context.page.getByRole("textbox", { name: this.context.t.page.text.title, exact: true });
  }

  /** A line of the text that holds these characters. */
  line(characters: string): Locator {
    return this.text.locator(".cm-line", { hasText: characters }).first();
  }

  async show(section: Section): Promise<void> {
    const tab = this.context.page.getByRole("tab", {
      name: new RegExp(`^${section === "findings" ? this.context.t.findings.title : this.words.sections[section]}`),
    });
    await this.context.page.getByRole("tablist").first().waitFor();
    if (await tab.count()) await tab.click();
  }

  /** Heading of the dialog: number and kind of the open block. */
  get heading(): Locator {
    return this.context.page
      .getByRole("heading", { level: 2 })
      .filter({ hasText: this.words.heading("", "").split(" ")[0] ?? "" });
  }

  field(name: keyof Context["t"]["editor"]["fields"]): Locator {
    const words = this.words.fields[name];
    return this.context.page
      .getByRole("form")
      .getByLabel(typeof words === "string" ? words : words(""), { exact: true });
  }

  /** Entry of the list of parts that holds these characters. */
  part(characters: string): Locator {
    return this.context.page
      .getByRole("list", { name: this.words.list, exact: true })
      .getByRole("button")
      .filter({ hasText: characters })
      .first();
  }

  /** The filter of the list of parts. */
  async filter(kind: keyof Context["t"]["editor"]["filters"]): Promise<void> {
    await this.context.page.getByRole("combobox", { name: this.words.filter, exact: true }).selectOption(kind);
  }

  /** An operation of the program by its number. */
  operation(number: number): Locator {
    return this.context.page
      .getByRole("list", { name: this.context.t.operations.list, exact: true })
      .getByRole("button", {
        name: new RegExp(`^${this.context.t.operations.name(number, "")}`),
      });
  }

  /** Drags an operation by its grip to the place of another one; both are counted from 1. */
  async dragOperation(number: number, to: number): Promise<void> {
    const {
      page: { mouse },
      t,
    } = this.context;
    const row = (each: number) => this.operation(each).locator("xpath=ancestor::li[1]");
    const grip = row(number).getByTitle(t.operations.drag);
    await grip.scrollIntoViewIfNeeded();
    const target = await settledBox(row(to)),
      from = await settledBox(grip);
    const x = from.x + from.width / 2;
    await mouse.move(x, from.y + from.height / 2);
    await mouse.down();
    await mouse.move(x, target.y + 12, { steps: 4 });
    await mouse.up();
  }

  /** The actions of the open operation. */
  operationTool(name: "duplicate" | "up" | "down" | "switchOff" | "switchOn" | "retool" | "remove"): Locator {
    return this.context.page.getByRole("button", { name: this.context.t.operations[name], exact: true });
  }

  /** The dialog of a new operation. */
  get inserting(): Locator {
    return this.context.page.getByRole("dialog", { name: this.context.t.operations.insert, exact: true });
  }

  /** Creates a program with its blank, from the start page or the top line, and skips its first operation. */
  async create(from: "start" | "top" = "start"): Promise<void> {
    const { page, t } = this.context;
    if (from === "top") await new Menus(this.context).header(t.page.newProgram);
    else await page.getByRole("button", { name: t.page.programs.create, exact: true }).click();
    const dialog = page.getByRole("dialog", { name: t.operations.newProgram, exact: true });
    await dialog.getByRole("button", { name: t.operations.create, exact: true }).click();
    await this.inserting.getByRole("button", { name: t.page.close, exact: true }).click();
    await expect(this.text).toBeVisible();
  }

  tool(name: "insertLong" | "duplicate" | "remove" | "up" | "down"): Locator {
    return this.context.page
      .getByRole("group", { name: this.words.tools })
      .getByRole("button", { name: this.words[name], exact: true });
  }

  /** Inserts a block of this kind after the open one. */
  async insert(kind: keyof Context["t"]["editor"]["kinds"]): Promise<void> {
    await this.tool("insertLong").click();
    await this.context.page
      .getByRole("group", { name: this.words.palette })
      .getByRole("button", { name: this.words.kinds[kind] })
      .first()
      .click();
  }

  /** Totals of the whole program, by their name. */
  total(name: string): Locator {
    return this.context.page
      .getByRole("region", { name: this.words.total, exact: true })
      .locator(".effect-cell")
      .filter({ has: this.context.page.locator("dt", { hasText: name }) })
      .locator("dd");
  }

  /** The downloaded bytes of the program. */
  async downloaded(): Promise<Buffer> {
    const { page, t } = this.context;
    const waiting = page.waitForEvent("download");
    await new Menus(this.context).choose("export", new RegExp(t.page.text.download("").trim()));
    const { readFile } = await import("node:fs/promises");
    return readFile(await (await waiting).path());
  }

  /** The address that carries the program. */
  async sharedLink(): Promise<string> {
    const handing = new Sharing(this.context);
    await handing.openDialog();
    const link = await handing.link();
    await this.context.page.keyboard.press("Escape");
    return link;
  }
}
