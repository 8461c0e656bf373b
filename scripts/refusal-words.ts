import type { FileRefusal, LoadingControl, RefusalCode, RefusalData } from "../src/control-file/refusal.ts";

/** The controls of `--as`, as a sentence names them. */
export const LOADING_CONTROLS: Readonly<Record<LoadingControl, string>> = {
  tnc640: "a TNC 640",
  tnc7: "a TNC7",
  iso: "a control, as DIN/ISO,",
};

type Sentences = { readonly [C in RefusalCode]: (data: RefusalData[C]) => string };

const plural = (n: number, one: string, more: string) => `${n} ${n === 1 ? one : more}`;

/** One sentence for each code, to follow the place. */
const SENTENCES: Sentences = {
  beginMissing: ({ text }) =>
    `the program does not begin here with BEGIN PGM (%NAME in DIN/ISO)${text === "" ? "" : `, but with "${text}"`}`,
  endMissing: () => "the end of the program is missing: END PGM (%NAME in DIN/ISO) must be the last block",
  outsideProgram: ({ text }) => `"${text}" stands outside the program`,
  nameMissing: () => "the program has no name",
  nameCharacter: ({ name, character }) => `the program name "${name}" contains "${character}"`,
  nameDiffers: ({ begin, end }) => `the program ends as "${end}" and begins as "${begin}"`,
  unitMissing: ({ units }) => `the unit is missing behind the program name: ${units}`,
  blockNumber: ({ text }) => `"${text}" is not a block number`,
  listWithoutTilde: ({ list, lines }) =>
    `the list of ${list} has no " ~" at the end of the line before, so ${plural(lines, "line becomes a block", "lines become blocks")} of ` +
    `${lines === 1 ? "its" : "their"} own`,
  tildeAtEnd: () => 'the line ends in "~", but the block does not continue on the next line',
  equalsMissing: ({ word }) => `"=" is missing behind ${word}`,
  unknownWord: ({ text }) => `unknown word "${text}"`,
  formulaBroken: ({ text }) => `"${text}" cannot stand here in a formula`,
  valueMissing: ({ word }) => `${word} has no value`,
  badNumber: ({ word, text }) => `"${text}" behind ${word} is not a number`,
  outOfRange: ({ word, text, least, most }) => `${word} ${text} is out of range: ${least} to ${most}`,
  tooManyDigits: ({ word, text, before, after }) =>
    `${word} ${text} has too many digits: at most ${before} before the decimal point and ${after} after it`,
  tooManyFunctions: ({ text, most }) => `${text} is one M function too many: a block takes at most ${most}`,
  labelTwice: ({ label, line }) => `label ${label} is already set in line ${line}`,
  stringOpen: () => "the closing quotation mark is missing",
  bracketOpen: () => "the closing bracket is missing",
  starMissing: () => 'the block does not end in " *"',
};

/** The sentence of a refusal, without its place. */
export const refusalText = (refused: FileRefusal): string =>
  (SENTENCES[refused.code] as (data: FileRefusal["data"]) => string)(refused.data);

/** Most refusals of one file that the summary lists. */
const LISTED = 20;

/** Lines below the summary of a file, one for each refusal. */
export function refusalLines(file: string, control: LoadingControl, refused: readonly FileRefusal[]): string {
  const head = `${file}: ${LOADING_CONTROLS[control]} would not load it`;
  const lines = refused.slice(0, LISTED).map((each) => {
    const block = each.block === null ? "" : `block ${each.block}, `;
    return `${head}: ${block}column ${each.column} (line ${each.line}): ${refusalText(each)}\n`;
  });
  return lines.join("") + (refused.length > LISTED ? `${head}: and ${refused.length - LISTED} more\n` : "");
}

/** A refusal in the report of `--json`. */
export interface RefusedPlace {
  readonly block: number | null;
  readonly line: number;
  readonly column: number;
  readonly code: RefusalCode;
  readonly text: string;
}

export const refusedPlaces = (refused: readonly FileRefusal[]): readonly RefusedPlace[] =>
  refused.map((each) => ({
    block: each.block,
    line: each.line,
    column: each.column,
    code: each.code,
    text: refusalText(each),
  }));
