import type { Shape } from "../../shape.ts";

/** Cycles of the operator's own: the list, the form of one, and the dialog that it gives. */
export const own = {
  back: "Back",
  backLong: "Back to the work",
  lead: "Cycles that this page does not know, described once: they get a dialog and clean text. They are not simulated.",
  count: (n: number) => (n === 1 ? "1 cycle" : `${n} cycles`),
  list: "Own cycles of this device",
  none: "No cycle is described yet. Begin one here, or open its block in a program and choose “Describe this cycle”.",
  unnamed: "without number",
  cycleName: (number: string, name: string) => `cycle ${number} ${name}`.trim(),
  select: (cycle: string) => `Edit ${cycle}`,
  parameterCount: (n: number) => (n === 1 ? "1 parameter" : `${n} parameters`),
  hasError: "not usable yet",
  add: "New cycle",
  duplicate: "Duplicate",
  duplicateLong: (cycle: string) => `Duplicate ${cycle}`,
  remove: "Delete",
  removeLong: (cycle: string) => `Delete ${cycle}`,
  removed: (cycle: string) => `Deleted: ${cycle}. Programs keep their text.`,
  undo: "Undo",

  form: (cycle: string) => `Description of ${cycle}`,
  number: "Number",
  name: "Name, as the text prints it",
  parameters: "Parameters, in the order of the prompts",
  parameter: (q: string) => `Parameter ${q}`.trim(),
  cells: {
    q: "Q number",
    prompt: "Prompt, behind ; in the text",
    min: "Smallest",
    max: "Largest",
    first: "First value",
    choices: "Values and their meanings",
  },
  choicesHint: "0 outside, 1 inside",
  kind: "Kind",
  kinds: { length: "Length (mm)", angle: "Angle (°)", feed: "Feed", choice: "Choice", number: "Number" },
  addParameter: "Add a parameter",
  removeParameter: (q: string) => `Delete parameter ${q}`.trim(),
  raise: (q: string) => `Parameter ${q} one up`,
  lower: (q: string) => `Parameter ${q} one down`,
  text: "In the program",
  oneText: "Name and prompts are one text, the same in every screen language.",

  problems: {
    missing: () => "This is needed.",
    noNumber: (text: string) => `${text} is no cycle number: a whole number from 1 to 9999.`,
    known: (text: string) => `Cycle ${text} is known to this page. Take another number.`,
    twice: (text: string) => `Cycle ${text} is described further up already. That description counts.`,
    characters: (text: string) => `These characters cannot stand here: ${text}, and none that cannot be printed.`,
    tooLong: (text: string) => `At most ${text} characters.`,
    noParameter: (text: string) => `${text} is no parameter: Q with a number up to 9999.`,
    qTwice: (text: string) => `${text} stands in this cycle twice.`,
    notANumber: (text: string) => `“${text}” is no number.`,
    order: (text: string) => `${text} is smaller than the smallest value.`,
    outside: (text: string) => `${text} is not among the values that are described here.`,
    choices: () => "Values with their meanings, separated by commas: 0 outside, 1 inside.",
    choiceTwice: (text: string) => `${text} stands there twice.`,
    tooMany: (text: string) => `At most ${text}.`,
  },

  files: {
    name: "Import and export",
    import: "Import",
    importLong: "Import own cycles from a JSON file",
    export: "JSON",
    exportLong: "Export as JSON: CYCLES.json",
    imported: (file: string, replaced: number, added: number) => `${file}: ${added} new, ${replaced} replaced.`,
    importedWrong: (n: number) => (n === 1 ? "1 description has an error." : `${n} descriptions have an error.`),
    leftOut: (names: string) => `Not taken over: ${names}.`,
    exported: (file: string, n: number) => (n === 1 ? `${file}: 1 cycle.` : `${file}: ${n} cycles.`),
    notALibrary: (file: string) => `${file} is no list of own cycles: JSON with "cycles".`,
    nothing: (file: string) => `${file} holds no cycles.`,
    tooMany: (file: string, most: number) =>
      `With ${file} there would be more than ${most} cycles. Nothing was taken over.`,
    wrongCycle: (file: string, at: number) =>
      `${file}: cycle ${at} of the list cannot be read. Nothing was taken over.`,
    unreadable: (file: string) => `${file} could not be read.`,
    tooLarge: (file: string) => `${file} is larger than 2 MB.`,
  },

  /** In a program. */
  describe: "Describe this cycle",
  describeAbout: "This page does not know the cycle. Describe it once, and its blocks get a dialog.",
  change: "Change the description",
  unprovedLong:
    "This page does not know what the cycle does to the path and the stock. Where it is called, nothing behind it is proved.",
  notDescribed: "not in the description",
  anyNumber: "any number",

  /** In the choice of a cycle. */
  mark: "own, not simulated",
  edit: "Edit the list",
};

export type OwnTexts = Shape<typeof own>;
