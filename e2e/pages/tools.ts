import type { Locator } from "@playwright/test";
import type { CellName, HolderCell, ToolColumn } from "../../src/program/tools/tool-columns.ts";
import { plainText } from "./pattern.ts";
import { words } from "./words.ts";
import { Menus } from "./menus.ts";
import type { Context } from "./context.ts";

/** The tool table: the tools of the device on one side, the columns of the open tool on the other. */
export class ToolTable {
  constructor(private readonly context: Context) {}

  /** Opens the table from anywhere. */
  async open(): Promise<void> {
    await new Menus(this.context).header(this.context.t.page.tools.openLong);
    await this.table.or(this.context.page.getByText(this.context.t.tools.none)).waitFor();
  }

  /** Goes back to the work. */
  async close(): Promise<void> {
    await this.button(this.context.t.tools.backLong).click();
  }

  get table(): Locator {
    const { table, millTable } = this.context.t.tools;
    return this.context.page
      .getByRole("table", { name: table, exact: true })
      .or(this.context.page.getByRole("table", { name: millTable, exact: true }));
  }

  /** Shows the tools of a kind. */
  async show(kind: "turning" | "milling"): Promise<void> {
    const { kinds } = this.context.t.tools;
    await this.context.page
      .getByRole("group", { name: kinds.name, exact: true })
      .getByRole("button", { name: kinds[kind], exact: true })
      .click();
  }

  /** The row of a tool by its number. */
  row(number: number | string): Locator {
    return this.table
      .getByRole("row")
      .filter({ has: this.context.page.getByRole("button", { name: this.rowName(number) }) });
  }

  /** The button that opens a row. */
  rowButton(number: number | string): Locator {
    return this.table.getByRole("button", { name: this.rowName(number) });
  }

  /** The columns of the open row. */
  get form(): Locator {
    return this.context.page.getByRole("region", { name: new RegExp(plainText(this.context.t.tools.form("").trim())) });
  }

  /** A text field of the open row. */
  cell(name: Exclude<CellName, "TYPE" | "TO">): Locator {
    const { columns, holder, field } = this.context.t.tools;
    const label = name in holder ? holder[name as HolderCell] : field(name, columns[name as ToolColumn]);
    return this.form.getByRole("textbox", { name: label, exact: true });
  }

  get type(): Locator {
    return this.form.getByRole("combobox", {
      name: this.context.t.tools.field("TYPE", this.context.t.tools.columns.TYPE),
      exact: true,
    });
  }

  /** One of the nine directions of TO. */
  direction(to: number): Locator {
    const { orientation, orientationOf, directions } = this.context.t.tools;
    return this.form.getByRole("radiogroup", { name: orientation, exact: true }).getByRole("radio", {
      name: orientationOf(to, directions[to - 1] ?? ""),
      exact: true,
    });
  }

  get drawing(): Locator {
    const { drawing, millDrawing } = this.context.t.tools;
    return this.form
      .getByRole("figure", { name: drawing, exact: true })
      .or(this.form.getByRole("figure", { name: millDrawing, exact: true }));
  }

  /** The status after an import, a deletion, or restoring the default tools. */
  get status(): Locator {
    return this.context.page.locator(".tool-status");
  }

  get add(): Locator {
    return this.button(this.context.t.tools.add);
  }

  get duplicate(): Locator {
    return this.form.getByRole("button", { name: this.named(this.context.t.tools.duplicateLong) });
  }

  get remove(): Locator {
    return this.form.getByRole("button", { name: this.named(this.context.t.tools.removeLong) });
  }

  /** Restores the default tools, and confirms it. */
  async restore(): Promise<void> {
    await this.button(this.context.t.tools.restore).click();
    await this.context.page
      .getByRole("alertdialog")
      .getByRole("button", { name: this.context.t.tools.restoreNow, exact: true })
      .click();
  }

  /** The undo button in the status of the last action. */
  get takeBack(): Locator {
    return this.status.getByRole("button", { name: `${this.context.t.tools.undo} – ` });
  }

  /** Chooses a file to import; text is encoded as UTF-8. `incoming` then shows its contents. */
  async choose(...files: readonly { readonly name: string; readonly content: string | Buffer }[]): Promise<void> {
    const choosing = this.context.page.waitForEvent("filechooser");
    await this.button(this.words.files.importLong).click();
    await (
      await choosing
    ).setFiles(
      files.map(({ name, content }) => ({ name, mimeType: "text/plain", buffer: Buffer.from(content as string) })),
    );
  }

  /** The import dialog: changes that the chosen files would make to the table. */
  get incoming(): Locator {
    return this.context.page.getByRole("dialog", {
      name: new RegExp(plainText(this.words.files.title("§")).replace("§", ".*")),
    });
  }

  /** The dialog that assigns the columns of a sheet. */
  get sheet(): Locator {
    const { title } = words(this.context.language, "tool-sheets");
    return this.context.page.getByRole("dialog", { name: new RegExp(plainText(title("§")).replace("§", ".*")) });
  }

  /** Imports the files: all tools, or those with new numbers only. */
  async take(choice: "all" | "new" = "all"): Promise<void> {
    const { takeAll, takeNew } = this.words.files;
    const [before = "", behind = ""] = (choice === "all" ? takeAll : takeNew)(0).split("0");
    await this.incoming
      .getByRole("button", { name: new RegExp(`^${plainText(before)}\\d+${plainText(behind)}$`) })
      .click();
    await this.incoming.waitFor({ state: "hidden" });
  }

  /** Chooses a file and imports all of it. */
  async import(name: string, text: string): Promise<void> {
    await this.choose({ name, content: text });
    await this.take();
  }

  /** Downloads the table and returns the file; `again` is the file the tools came from, with the changes. */
  async export(
    kind: "json" | "csv" | "text" | "millText" | "again",
  ): Promise<{ name: string; text: string; bytes: Buffer }> {
    const { exportLong, exportTitle, json, sheet, turning, milling, again } = this.words.files;
    const downloading = this.context.page.waitForEvent("download");
    await this.button(exportLong).click();
    const names = { json, csv: sheet, text: turning, millText: milling, again: again("§") };
    const name = new RegExp(`^${plainText(names[kind]).replace("§", ".*")}$`);
    await this.context.page
      .getByRole("dialog", { name: exportTitle, exact: true })
      .getByRole("button", { name })
      .first()
      .click();
    const download = await downloading;
    const stream = await download.createReadStream();
    const parts: Buffer[] = [];
    for await (const part of stream) parts.push(Buffer.from(part as Uint8Array));
    const bytes = Buffer.concat(parts);
    return { name: download.suggestedFilename(), text: bytes.toString("utf8"), bytes };
  }

  /** The field for the code of an insert or a holder; Enter applies it. */
  get code(): Locator {
    return this.form.getByRole("textbox", { name: this.words.codes.label, exact: true });
  }

  private get words() {
    const { language } = this.context;
    return { codes: words(language, "tool-codes"), files: words(language, "tool-files") };
  }

  private button(name: string): Locator {
    return this.context.page.getByRole("button", { name, exact: true });
  }

  private rowName(number: number | string): RegExp {
    const { select, toolName } = this.context.t.tools;
    return this.named(select, `${plainText(toolName(String(number), ""))}(?![\\d.]).*`);
  }

  /** Matches a name that contains the tool. */
  private named(long: (tool: string) => string, tool = ".*"): RegExp {
    const [before = "", behind = ""] = long("§").split("§");
    return new RegExp(`^${plainText(before)}${tool}${plainText(behind)}(,|$)`);
  }
}
