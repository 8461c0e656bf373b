import type { Shape } from "../../shape.ts";

/**
 * A program as its operations: the list, what can be done with each, and the dialogs that put one in or begin a
 * program.
 */
export const operations = {
  list: "Operations",
  none: "No operation yet.",
  insert: "Insert operation",
  insertBehind: (title: string) => `Insert an operation behind ${title}`,
  name: (number: number, title: string) => `Operation ${number}: ${title}`,
  withoutCycle: "Cut without a cycle",
  tool: (tool: string) => `T${tool}`,
  noTool: "no tool",
  inherits: "same tool as before",
  off: "switched off",
  blocks: (n: number) => (n === 1 ? "1 block" : `${n} blocks`),
  blocksOf: (title: string) => `Blocks of ${title}`,
  findings: (n: number) => (n === 1 ? "1 finding" : `${n} findings`),
  actions: (title: string) => `Change ${title}`,
  duplicate: "Duplicate",
  up: "Move up",
  down: "Move down",
  drag: "Drag to another place",
  switchOff: "Switch off",
  switchOn: "Switch on",
  retool: "Other tool",
  remove: "Delete",
  hint: "Alt+↑ ↓ moves the operation, Del deletes it.",
  ties: {
    label: "It stays as it is: a jump or a call leads into it.",
    frame: "It stays as it is: it shifts or turns the coordinates.",
    tool: "It stays as it is: no tool is called before it.",
  },
  refused: {
    label: (n: number) => `Not across operation ${n}: a jump or a call leads into it.`,
    frame: (n: number) => `Not across operation ${n}: it shifts or turns the coordinates.`,
    tool: (n: number) => `Not across operation ${n}: it has no tool of its own.`,
    parameter: (n: number, name: string) => `Not across operation ${n}: one sets ${name} and the other uses it.`,
  },
  toolTitle: (title: string) => `Tool for ${title}`,
  takeTool: (tool: string) => `Take tool ${tool}`,
  able: "Tools that make the contour",
  others: "Other tools",
  cancel: "Cancel",
  back: "Other cycle",
  choose: "choose",
  which: "Which cycle?",
  title: "Title",
  titleHint: "Stands as a structure comment in the program.",
  put: "Insert",
  spindle: "Spindle",
  start: "Start point",
  newProgram: "New program",
  programName: "Name",
  blank: "Blank",
  create: "Create and insert the first operation",
  unknownTool: (tool: string) => `Tool ${tool} is not in the tool table.`,
  chooseTool: "Choose the tool",
};

export type OperationsTexts = Shape<typeof operations>;
