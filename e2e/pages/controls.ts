import type { Locator } from "@playwright/test";

/** Roles of controls that can be operated. */
const OPERABLE = new Set([
  "button",
  "checkbox",
  "combobox",
  "link",
  "listbox",
  "menuitem",
  "radio",
  "searchbox",
  "slider",
  "spinbutton",
  "switch",
  "tab",
  "textbox",
]);

/** A control as assistive technology knows it. */
export interface Control {
  readonly role: string;
  /** Empty if it has none. */
  readonly name: string;
}

/** A line of an accessibility snapshot: `- button "Copy" [disabled]: text`, in quotes where YAML wants them. */
function controlOf(line: string): Control | null {
  const text = line.trim().replace(/^- /, "");
  const quoted = /^'((?:[^']|'')*)'/.exec(text)?.[1];
  const entry = quoted === undefined ? text : quoted.replaceAll("''", "'");
  const [, role = "", name] = /^(\w+)(?: ("(?:[^"\\]|\\.)*"))?/.exec(entry) ?? [];
  return OPERABLE.has(role) ? { role, name: name === undefined ? "" : String(JSON.parse(name)) } : null;
}

/** All controls in a part of the page as it is now, in their order. */
export async function controls(part: Locator): Promise<readonly Control[]> {
  const snapshot = await part.ariaSnapshot();
  return snapshot.split("\n").flatMap((line) => controlOf(line) ?? []);
}

/** A name without the parts that depend on values: numbers, contents of numbered things, tool names, proposals. */
const nameWithoutValues = (name: string): string =>
  name
    .replaceAll(/[-−+]?\d+(?:[.,:]\d+)*/g, "#")
    .replace(/^(\w* ?#[^:,]*): .*$/, "$1: …")
    .replace(/\b([Tt]ool|Use:) # .*$/, "$1 # …");

/** Role and name of each kind of control, sorted; controls that differ in values alone are one kind. */
export function kinds(found: readonly Control[]): readonly string[] {
  return [
    ...new Set(
      found.map(
        ({ role, name }) =>
          `${role} ${
            role === "textbox"
              ? name.replace(/^Element \d+|\d+[.,]\d+/, (n) => n.replace(/[\d.,]+/, "#"))
              : nameWithoutValues(name)
          }`,
      ),
    ),
  ].sort();
}

/** Controls that share role and name with another one, or have no name. */
export function ambiguous(found: readonly Control[]): readonly string[] {
  const all = found.map(({ role, name }) => `${role} "${name}"`);
  return [...new Set(all.filter((one, i) => one.endsWith('""') || all.indexOf(one) !== i))].sort();
}
