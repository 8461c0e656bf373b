import type { Shape } from "../../shape.ts";

/**
 * A program as its operations: the list, what can be done with each, and the dialogs that put one in or begin a
 * program.
 */
export const operations = {
  list: "Operations",
  none: "No operation yet.",
  insert: "Insert operation",
  insertBehind: (title: string) => `Insert an operation after ${title}`,
  name: (number: number, title: string) => `Operation ${number}: ${title}`,
  withoutCycle: "Machining without a cycle",
  tool: (tool: string) => `T${tool}`,
  noTool: "no tool",
  inherits: "previous tool",
  off: "skipped",
  blocks: (n: number) => (n === 1 ? "1 block" : `${n} blocks`),
  blocksOf: (title: string) => `Blocks of ${title}`,
  findings: (n: number) => (n === 1 ? "1 finding" : `${n} findings`),
  actions: (title: string) => `Change ${title}`,
  duplicate: "Duplicate",
  up: "Move up",
  down: "Move down",
  drag: "Drag to move",
  switchOff: "Skip",
  switchOn: "Include",
  retool: "Change tool",
  remove: "Delete",
  hint: "Alt+↑ ↓ moves the operation, Del deletes it.",
  ties: {
    label: "Cannot be moved: a jump or call leads to it.",
    frame: "Cannot be moved: the operation shifts or rotates the coordinates.",
    tool: "Cannot be moved: no tool is called before it.",
  },
  refused: {
    label: (n: number) => `Cannot move past operation ${n}: a jump or call leads to it.`,
    frame: (n: number) => `Cannot move past operation ${n}: it shifts or rotates the coordinates.`,
    tool: (n: number) => `Cannot move past operation ${n}: it has no tool of its own.`,
    parameter: (n: number, name: string) => `Cannot move past operation ${n}: one sets ${name} and the other uses it.`,
  },
  toolTitle: (title: string) => `Tool for ${title}`,
  takeTool: (tool: string) => `Use tool ${tool}`,
  able: "Suitable tools",
  others: "Other tools",
  cancel: "Cancel",
  back: "Change cycle",
  choose: "choose",
  which: "Choose a cycle",
  title: "Title",
  titleHint: "Becomes a structure item (* -).",
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
