import { isoProgramText } from "../src/nc/iso/print-iso.ts";
import { isoSources, isoWords, isRecalledIsoWord, type IsoWord } from "../src/nc/iso/words.ts";
import { parse } from "../src/nc/parse.ts";

const cell = (text: string) => text.replaceAll("|", "\\|");
const code = (lines: readonly string[]) => lines.map((line) => `\`${cell(line)}\``).join("<br>");

/** The example of a word as a block of DIN/ISO, without its number if it has one. */
const isoExample = (klartext: string) =>
  isoProgramText(parse(`${klartext}\n`))
    .text.trimEnd()
    .replace(/^N\d{1,3} /, "");

function row(w: IsoWord): string {
  const klartext = w.klartext === "" ? "none" : code(w.klartext.replaceAll(" ~", "").split("\n"));
  const iso = w.klartext === "" ? "read only" : code([isoExample(w.klartext)]);
  const read = w.means.kind === "unread" ? "kept and reported" : iso;
  return `| \`${w.word}\` | ${klartext} | ${read} | ${w.evidence} | ${w.source} |\n`;
}

/** Words per line of the page. */
const IN_A_LINE = 16;
const recalled = isoWords
  .filter(isRecalledIsoWord)
  .map((w, i) => `${i > 0 && i % IN_A_LINE === 0 ? "\n" : ""}\`${w.word}\``)
  .join(", ")
  .replaceAll(" \n", "\n");

const HEAD = `# DIN/ISO programs

A Klartext program (\`.H\`) can be written as a DIN/ISO program (\`.I\`), and a DIN/ISO program can be opened. The editor itself works on
Klartext: a DIN/ISO file is translated when it is opened.

## What is written

- First line \`%NAME G71 *\` (G70 in inch), last line \`N99999999 %NAME G71 *\`.
- One block per line, with \` *\` at its end. A block has \`N\` and the number of its Klartext block: the blocks of both texts
  correspond.
- Each block is complete: path function, G90 or G91 and compensation do not depend on the block before. Where Klartext leaves the
  compensation as it is, the block has no G40, G41 or G42.
- A cycle with Q parameters is one line: \`G820 Q215=+0 Q460=+2 … *\`. The G number is the number of the cycle.
- A cycle of numbered lines (7.0, 7.1 …) becomes one block with the number of its first line.
- Axes carry a sign and a decimal point, as in Klartext. Line ends are those of the program.
- Formulas (\`Q1 = Q2 * 3\`), text formulas, comments and structure items are the same in both languages.

## What is kept as Klartext

A function without a DIN/ISO word is written as Klartext, as on the control. The export lists these blocks. They are:
APPR and DEP, UDC and GRV, FK contours, FUNCTION MODE, FUNCTION TURNDATA, BLK FORM CYLINDER, ROTATION and FILE, TRANS, PLANE and
FUNCTION TCPM, SEL CONTOUR, SEL PGM, CALL SELECTED PGM, CONTOUR DEF and contour formulas, CYCL CALL POS and PAT, jumps without FN
or with IS DEFINED, a tool axis other than X, Y and Z, a circle centre on other axes, arcs with LIN_, and every block with a word that
the Klartext reader does not know. Of the cycles of numbered lines only those in the table are translated, and only when their text
has the form shown.

G26 and G27 of older controls are not used for APPR CT and DEP CT: their path differs.

## What is lost

Names of cycles and the labels of their parameters. When the file is read again, they come from the catalogue. Titles of older cycles
come back in one language. Numbers are written in one form (\`70.0\` becomes \`70\`). A program whose numbers do not rise is counted from 0.

## How a file is read

- Path function, G90/G91 and the direction of arcs stay in force until they change, in the order of the file. A subprogram that relies on
  its caller is read with what is in force before it in the file.
- G00 and G10 become FMAX in each block. A compensation is written only where a block names it.
- One G90 or G91 in a block applies to the whole block; of several, each applies to the words after it.
- I, J, K with an end point become two blocks: CC and the arc.
- A feed in a block with G00 is written into the next block at feed. S without T becomes TOOL CALL S.
- Block numbers, \` *\`, spaces between words and capitals are optional; a decimal comma is read as a point.
- A cycle may be on several lines, with or without \` ~\` and labels.
- A block that is not understood stays in the program as text and is reported with block number, line and column. Nothing is dropped, except
  G17, G18 and G19 outside a tool call or blank, which is reported as well.

## Words

**Evidence**: A printed for TNC 640 or TNC7, B printed for another HEIDENHAIN control, K1 to K3 recalled, from sure to uncertain. The
recalled words are:
${recalled}.

The letter B applies to the word. The order of the words in a block, and what follows the G words of the older cycles, is recalled (K1);
that comments end with \` *\` is recalled (K3). Check the first file on your control.

| Word | Klartext | DIN/ISO | Evidence | Source |
|---|---|---|---|---|
`;

/** The page of DIN/ISO, with the table that printer and reader use. */
export function isoPage(): string {
  const sources = Object.entries(isoSources)
    .map(([key, what]) => `| ${key} | ${what} |\n`)
    .join("");
  return `${HEAD}${isoWords.map(row).join("")}
## Sources

| Key | Page |
|---|---|
${sources}`;
}
