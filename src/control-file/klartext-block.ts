import { takeFormula } from "./formula.ts";
import { isBlank, isDigit, type LineCursor } from "./line-cursor.ts";
import { takeAxisAlone, takeNamedWords, takePathWords } from "./path-words.ts";
import { refuse, type LineRefusal } from "./refusal.ts";
import {
  DELTA,
  ERROR_NUMBER,
  FEED,
  LABEL,
  LOOSE,
  type NumberFormat,
  parameterKind,
  POSITION,
  REPEAT,
  SPEED,
  takeNumberOrName,
  takeParameter,
  takeValue,
  TOOL,
  valueStarts,
} from "./values.ts";

type Check = (cursor: LineCursor) => LineRefusal | null;

const FN_LAST: NumberFormat = { least: 0, most: 99, before: 9, after: 0 };
/** Numbers of cycles, those of machine builders and of touch probes included. */
const CYCLE_NUMBER: NumberFormat = { least: 0, most: 9999, before: 9, after: 3 };
const APPROACH_FORMS = ["LT", "LN", "CT", "LCT", "PLT", "PLN", "PCT", "PLCT"];
const UNDERCUT_FORMS = ["TYPE_E", "TYPE_F", "TYPE_H", "TYPE_K", "TYPE_U", "THREAD"];
const CYLINDER_WORDS = { D: POSITION, R: POSITION, L: POSITION, DIST: POSITION, DI: POSITION, RI: POSITION };
const SPIN_WORDS = { VC: SPEED, S: SPEED, SMAX: SPEED, GEARRANGE: LOOSE };
const MODES = ["TURN", "MILL", "GRIND"];
const SELECTED = ["CONTOUR", "PGM", "TABLE", "PATTERN"];

const unknown = (cursor: LineCursor) => refuse(cursor.at, "unknownWord", { text: cursor.piece() });

/** Unchecked content: only its quoted texts must be closed. */
export const takeAnything: Check = (cursor) => {
  while (cursor.at < cursor.end) {
    if (cursor.char() !== '"') cursor.at += 1;
    else if (cursor.quoted() === null) return refuse(cursor.at, "stringOpen", {});
  }
  return null;
};

/** Text that a control prints or shows itself: quotation marks mean nothing in it. */
const takeText: Check = (cursor) => {
  cursor.at = cursor.end;
  return null;
};

const nothingMore: Check = (cursor) => (cursor.done ? null : unknown(cursor));

/** One of several words, each with its own continuation. */
function oneOf(cursor: LineCursor, words: Readonly<Record<string, Check>>): LineRefusal | null {
  cursor.blanks();
  const word = Object.keys(words).find((each) => cursor.takeWord(each));
  return word === undefined ? unknown(cursor) : (words[word]?.(cursor) ?? null);
}
const allOf = (words: readonly string[], behind: Check) => Object.fromEntries(words.map((word) => [word, behind]));

const blank: Check = (cursor) => {
  if (cursor.take("0.1") || cursor.take("0.2") || cursor.take("0,1") || cursor.take("0,2")) {
    takeAxisAlone(cursor);
    return takePathWords(cursor);
  }
  return oneOf(cursor, {
    CYLINDER: (c) => {
      takeAxisAlone(c);
      return takeNamedWords(c, CYLINDER_WORDS);
    },
    ROTATION: takeAnything,
    FILE: takeAnything,
  });
};

const TOOL_WORDS: Readonly<Record<string, NumberFormat>> = {
  S: SPEED,
  FU: FEED,
  FZ: FEED,
  DL: DELTA,
  DR: DELTA,
  DR2: DELTA,
};

/** TOOL CALL: the tool, its axis, speed, feed and deltas; each may be missing. */
const toolCall: Check = (cursor) => {
  cursor.blanks();
  const c = cursor.char();
  if (c === '"' || isDigit(c) || parameterKind(cursor) !== "" || c === "+") {
    const refused = takeNumberOrName(cursor, "TOOL CALL", TOOL);
    if (refused) return refused;
    if (cursor.char() === "." && isDigit(cursor.char(1))) {
      cursor.at += 1;
      cursor.digits();
    }
  }
  takeAxisAlone(cursor);
  while (!cursor.done) {
    const refused = toolWord(cursor);
    if (refused) return refused;
  }
  return null;
};

function toolWord(cursor: LineCursor): LineRefusal | null {
  const from = cursor.at;
  if (cursor.take("DR2")) {
    if (cursor.take(":")) return takeAnything(cursor);
    return takeValue(cursor, "DR2", DELTA);
  }
  if (cursor.take("S") && cursor.take("(")) return takeAnything(cursor);
  cursor.at = from;
  if (cursor.take("F") && (cursor.take("MAX") || cursor.take("AUTO"))) return null;
  cursor.at = from;
  const word = ["FU", "FZ", "DL", "DR", "S", "F", "M"].find((each) => {
    cursor.at = from;
    return cursor.take(each);
  });
  if (word === undefined) return unknown(cursor);
  const next = cursor.char();
  if (!valueStarts(cursor) && next !== "" && !isBlank(next)) {
    cursor.at = from;
    return unknown(cursor);
  }
  return takeValue(cursor, word, word === "M" ? LOOSE : (TOOL_WORDS[word] ?? FEED));
}

const toolDefinition: Check = (cursor) =>
  takeNumberOrName(cursor, "TOOL DEF", TOOL) ?? takeNamedWords(cursor, { L: POSITION, R: POSITION, R2: POSITION });

const spin: Check = (cursor) => {
  if (!cursor.takeWord("VCONST")) return takeAnything(cursor);
  cursor.take(":");
  return oneOf(
    cursor,
    allOf(["ON", "OFF"], (c) => takeNamedWords(c, SPIN_WORDS)),
  );
};

const functionBlock: Check = (cursor) => {
  if (cursor.takeWord("MODE")) return oneOf(cursor, allOf(MODES, takeAnything));
  if (!cursor.takeWord("TURNDATA"))
    return cursor.done ? refuse(cursor.at, "valueMissing", { word: "FUNCTION" }) : takeAnything(cursor);
  return cursor.takeWord("SPIN") ? spin(cursor) : takeAnything(cursor);
};

const chamfer: Check = (cursor) =>
  (valueStarts(cursor) ? takeValue(cursor, "CHF", POSITION) : null) ?? takePathWords(cursor);
const rounding: Check = (cursor) =>
  (valueStarts(cursor) ? takeValue(cursor, "RND", POSITION) : null) ?? takePathWords(cursor);
const approach: Check = (cursor) =>
  oneOf(
    cursor,
    allOf(APPROACH_FORMS, (c) => takePathWords(c)),
  );

const call: Check = (cursor) =>
  oneOf(cursor, {
    LBL: (c) => takeNumberOrName(c, "CALL LBL", LABEL) ?? repeats(c),
    PGM: (c) => (c.done ? refuse(c.at, "valueMissing", { word: "CALL PGM" }) : takeAnything(c)),
    SELECTED: takeAnything,
    TABLE: takeAnything,
  });

/** REP 8, REP 8/8 as the control shows it while it runs, or REP alone as older controls write it. */
const repeats: Check = (cursor) => {
  if (cursor.done) return null;
  if (!cursor.take("REP")) return unknown(cursor);
  if (cursor.done) return null;
  const refused = takeValue(cursor, "REP", REPEAT);
  if (refused) return refused;
  if (cursor.take("/")) cursor.digits();
  return nothingMore(cursor);
};

const label: Check = (cursor) => takeNumberOrName(cursor, "LBL", LABEL) ?? nothingMore(cursor);

const cycle: Check = (cursor) =>
  oneOf(cursor, {
    DEF: (c) => {
      c.blanks();
      if (!isDigit(c.char())) return c.done ? refuse(c.at, "valueMissing", { word: "CYCL DEF" }) : unknown(c);
      return takeValue(c, "CYCL DEF", CYCLE_NUMBER) ?? takeText(c);
    },
    CALL: (c) => {
      if (!c.takeWord("PAT")) c.takeWord("POS");
      return takePathWords(c);
    },
  });

const selection: Check = (cursor) => {
  cursor.blanks();
  const letters = cursor.letters();
  return SELECTED.includes(letters) || letters.startsWith("CORR") ? takeAnything(cursor) : unknown(cursor);
};

/** `LBL "END"` behind GOTO. */
const jump: Check = (cursor) => {
  const from = cursor.at;
  // The operands may be texts, so GOTO is looked for outside of quotation marks.
  while (cursor.at < cursor.end) {
    if (cursor.char() === '"') {
      if (cursor.quoted() === null) return refuse(cursor.at, "stringOpen", {});
    } else if (cursor.letters() === "GOTO") {
      cursor.takeWord("GOTO");
      if (!cursor.take("LBL")) return unknown(cursor);
      return takeNumberOrName(cursor, "GOTO LBL", LABEL) ?? nothingMore(cursor);
    } else cursor.at += Math.max(1, cursor.letters().length);
  }
  return refuse(from, "valueMissing", { word: "GOTO LBL" });
};

/** An assignment to the parameter that stands here. */
export const assignment: Check = (cursor) => {
  cursor.blanks();
  const from = cursor.at;
  const kind = parameterKind(cursor);
  const refused = kind === "" ? takeValue(cursor, "Q", LOOSE) : takeParameter(cursor);
  if (refused) return refused;
  const word = cursor.text.slice(from, cursor.at).toUpperCase();
  cursor.blanks();
  if (!cursor.take("=")) return refuse(cursor.at, "equalsMissing", { word });
  return takeFormula(cursor, word);
};

const fnBlock: Check = (cursor) => {
  cursor.blanks();
  const from = cursor.at;
  const refused = takeValue(cursor, "FN", FN_LAST);
  if (refused) return refused;
  const number = Number(cursor.text.slice(from, cursor.at));
  cursor.take(":");
  if (number <= 8 || number === 13) return assignment(cursor);
  if (number <= 12) return cursor.takeWord("IF") ? jump(cursor) : unknown(cursor);
  if (number !== 14) return takeAnything(cursor);
  if (!cursor.takeWord("ERROR")) return unknown(cursor);
  cursor.take("=");
  return takeValue(cursor, "ERROR", ERROR_NUMBER) ?? nothingMore(cursor);
};

const declaration: Check = (cursor) => {
  if (!cursor.takeWord("STRING")) return takeAnything(cursor);
  return assignment(cursor);
};

const words: Check = (cursor) => takePathWords(cursor);
const free: Check = (cursor) => takePathWords(cursor, "free");
const vectors: Check = (cursor) => takePathWords(cursor, "vectors");
const definition: Check = (cursor) => oneOf(cursor, { DEF: takeAnything });

/** Every word that opens a block, with the check of the text after it. */
const OPENERS: Readonly<Record<string, Check>> = {
  ...allOf(["L", "C", "CR", "CT", "CTP", "LP", "CP", "CC", "STOP"], words),
  ...allOf(["FL", "FLT", "FC", "FCT", "FPOL"], free),
  ...allOf(["SPL", "LN"], vectors),
  ...allOf(["PLANE", "TRANS", "POLARKIN", "TABDATA", "MONITORING", "SECTION", "FSELECT"], takeAnything),
  SQL: takeText,
  RND: rounding,
  CHF: chamfer,
  APPR: approach,
  DEP: approach,
  BLK: (cursor) => oneOf(cursor, { FORM: blank }),
  TOOL: (cursor) => oneOf(cursor, { CALL: toolCall, DEF: toolDefinition }),
  TCH: (cursor) => oneOf(cursor, { PROBE: takeText }),
  GLOBAL: definition,
  PATTERN: definition,
  CONTOUR: definition,
  FUNCTION: functionBlock,
  CALL: call,
  LBL: label,
  CYCL: cycle,
  SEL: selection,
  DECLARE: declaration,
  FN: fnBlock,
  IF: jump,
  UDC: (cursor) => oneOf(cursor, allOf(UNDERCUT_FORMS, takeAnything)),
  GRV: (cursor) => oneOf(cursor, allOf(["RADIAL", "AXIAL"], takeAnything)),
};

export const isOpener = (letters: string) => Object.hasOwn(OPENERS, letters);

/** Checks the block that starts here, without number, comment and end. */
export function checkKlartextBlock(cursor: LineCursor): LineRefusal | null {
  cursor.blanks();
  const start = cursor.at;
  if (parameterKind(cursor) !== "" || cursor.char() === "{") return assignment(cursor);
  const letters = cursor.letters();
  const opener = isOpener(letters) ? OPENERS[letters] : undefined;
  // `C+90` alone moves the axis C; `LX+5` is an L without its blank.
  const isAxis = letters.length === 1 && letters === "C" && /[+\-\d.]/.test(cursor.char(1));
  if (opener && !isAxis) {
    cursor.at += letters.length;
    return opener(cursor);
  }
  if (/^L(?:I?[XYZABCUVW])$/.test(letters)) cursor.at += 1;
  const refused = takePathWords(cursor);
  return refused?.code === "unknownWord" && refused.at === start
    ? refuse(start, "unknownWord", { text: cursor.piece() })
    : refused;
}
