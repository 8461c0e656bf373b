/**
 * Every shortcut of the app by the place where it works, in the order of the sheet. Keys pressed together are joined by
 * a plus between two names; several entries are alternatives.
 */
export const KEY_LIST = {
  everywhere: { undo: ["Ctrl Z"], redo: ["Ctrl Y", "Ctrl Shift Z"], commands: ["Ctrl K"], keys: ["?"] },
  prompts: {
    accept: ["Enter"],
    move: ["↑", "↓"],
    parts: ["Tab"],
    leaveOut: ["Del"],
    finish: ["End"],
    cancel: ["Esc"],
    sign: ["−"],
  },
  cycles: { move: ["↑", "↓", "←", "→"], choose: ["Enter"] },
  text: {
    find: ["Ctrl F"],
    next: ["F3"],
    previous: ["Shift F3"],
    replace: ["Ctrl H"],
    goTo: ["Ctrl G"],
    fold: ["F9"],
    foldAll: ["Shift F9"],
    suggest: ["Ctrl Space"],
  },
  operations: { move: ["Alt ↑", "Alt ↓"], remove: ["Del"] },
  contourTable: {
    next: ["Enter"],
    row: ["↑", "↓"],
    move: ["Alt ↑", "Alt ↓"],
    insert: ["Insert"],
    duplicate: ["Ctrl D"],
    remove: ["Ctrl Del"],
    incremental: ["I"],
    tangential: ["T"],
    open: ["?"],
    corner: ["R", "C"],
  },
  contourDrawing: {
    choose: ["↑", "↓", "←", "→"],
    dimension: ["Tab"],
    open: ["Enter"],
    move: ["Alt ↑", "Alt ↓", "Alt ←", "Alt →"],
    insert: ["N", "Insert"],
    remove: ["Del"],
    corner: ["R", "C"],
    undercut: ["U"],
    zoom: ["+", "−"],
    fit: ["0"],
    pan: ["Shift ←", "Shift →"],
  },
  picture: {
    play: ["Space"],
    step: ["←", "→"],
    ends: ["Home", "End"],
    zoom: ["+", "−"],
    fit: ["0"],
    pan: ["Shift ←", "Shift →"],
  },
  solid: {
    rotate: ["↑", "↓", "←", "→"],
    pan: ["Shift ←", "Shift →"],
    zoom: ["+", "−"],
    fit: ["0"],
    views: ["1", "2", "3"],
  },
  measuring: { cross: ["↑", "↓", "←", "→"], edge: ["N", "P"], pick: ["Enter"], cancel: ["Esc"] },
} as const;

export type KeyPlace = keyof typeof KEY_LIST;
export const KEY_PLACES = Object.keys(KEY_LIST) as readonly KeyPlace[];
