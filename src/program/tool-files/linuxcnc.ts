import { IN_MM, radiusOf } from "../../kernel/units.ts";
import type { Fact, Facts, FileTool } from "./facts.ts";
import { MOST_ITEMS, type ForeignContent, type ReadingContext } from "./foreign-file.ts";
import { kindOfWords } from "./tool-words.ts";

/*
 * Tool table of LinuxCNC (tool.tbl): words T P X Z D I J Q and a comment on each line. D is the diameter of a mill or a
 * drill, and twice the nose radius of a turning tool. Q is the orientation, I and J are the angles of front and back
 * edge, from +Z on, in the direction from +Z to +X. Sources: docs/decisions, tool files of other systems.
 */

const WORDS = /^\s*(?:[A-Z]\s*[+-]?(?:\d+(?:\.\d*)?|\.\d+)\s*)+$/i;
const WORD = /([A-Z])\s*([+-]?(?:\d+(?:\.\d*)?|\.\d+))/gi;

interface Line {
  readonly words: ReadonlyMap<string, number>;
  readonly comment: string;
}

function lineOf(text: string): Line | null {
  const at = text.indexOf(";");
  const [body, comment] = at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at + 1).trim()];
  if (body.length > 400 || !WORDS.test(body)) return null;
  const words = new Map([...body.matchAll(WORD)].map(([, letter = "", n]) => [letter.toUpperCase(), Number(n)]));
  return words.has("T") ? { words, comment: comment.slice(0, 200) } : null;
}

/** TO of the control by the orientation Q: the tip of Q 1 points to +Z −X, of 2 to −Z −X, of 3 to −Z +X and so on. */
const ORIENTATIONS: Readonly<Record<number, number>> = { 1: 3, 2: 1, 3: 7, 4: 5, 5: 4, 6: 2, 7: 8, 8: 6, 9: 9 };

const turn = (angle: number) => ((angle % 360) + 360) % 360;

/** Angle of an edge as the control measures it, from the feed direction away from the tip, by the angle from +Z. */
const FRAMES: Readonly<Record<number, (a: number) => number>> = {
  1: (a) => 180 - a,
  2: (a) => 180 - a,
  3: (a) => a,
  4: (a) => 270 - a,
  5: (a) => -a,
  6: (a) => 180 + a,
  7: (a) => 180 + a,
  8: (a) => a + 90,
};

/** Differences up to this are the same angle, degrees. */
const SAME_ANGLE = 1;
/** Angles of thread profiles. */
const PROFILES = [60, 55, 30];

function edgesOf(words: Line["words"], to: number): Facts {
  const [frame, front, back] = [FRAMES[to], words.get("I") ?? 0, words.get("J") ?? 0];
  if (!frame || (front === 0 && back === 0)) return {};
  const measured = [front, back].map((angle) => turn(frame(angle)));
  const inside = measured.map((angle) => (angle > 180 ? angle - 180 : angle));
  const [main, second] = [Math.min(...inside), Math.max(...inside)];
  const turned = measured.some((angle) => angle > 180);
  const [from, point] = [`I${front} J${back}`, second - main];
  const isWedge =
    [2, 4, 6, 8].includes(to) &&
    Math.abs(main + second - 180) <= SAME_ANGLE &&
    PROFILES.some((profile) => Math.abs(point - profile) <= SAME_ANGLE);
  if (isWedge) return { kind: { value: "threading", from, why: "wedgeFromAngles" }, profile: { value: point, from } };
  const why = turned ? ({ why: "edgeTurned" } as const) : {};
  return { setting: { value: main, from, ...why }, point: { value: point, from, ...why } };
}

const known = (value: number, from: string): Fact<number> => ({ value, from });

/** Columns that lengths of LinuxCNC have no place for here. */
const OTHERS = ["Y", "A", "B", "C", "U", "V", "W"];

function toolOf({ words, comment }: Line, isMill: boolean, scale: number): FileTool {
  const number = words.get("T") ?? 0;
  const size = (letter: string) => (words.get(letter) ?? 0) * scale;
  const unused = OTHERS.filter((letter) => (words.get(letter) ?? 0) !== 0).map(
    (letter) => `${letter}${words.get(letter)}`,
  );
  const numbered = { number: known(number, `T${number}`) };
  const texts = comment === "" ? [] : [comment];
  const label = comment === "" ? `T${number}` : comment;
  const [d, worded] = [size("D"), kindOfWords(comment)];
  const length = size("Z") === 0 ? {} : { lengthZ: known(size("Z"), `Z${words.get("Z")}`) };
  const across = d > 0 ? { cutter: known(d, `D${words.get("D")}`) } : {};
  const named =
    texts.length > 0 ? { name: { value: comment, from: `;${comment}` } } : { name: { value: "", from: "" } };
  const isDrill = worded === "drill" || worded === "center" || worded === "tap" || worded === "reamer";
  const to = ORIENTATIONS[words.get("Q") ?? 0];
  if (isDrill || (isMill && d > 0)) {
    const kind: Facts["kind"] = isDrill
      ? { value: worded, from: comment, why: "kindFromName" }
      : { value: "mill", from: "D, Q", why: "kindFromProperties" };
    return { label, texts, unused, facts: { ...numbered, ...named, kind, ...across, ...length } };
  }
  const xLength = size("X") === 0 ? {} : { lengthX: known(size("X"), `X${words.get("X")}`) };
  const facts: Facts = {
    ...numbered,
    ...named,
    ...length,
    ...xLength,
    ...(to && { orientation: known(to, `Q${words.get("Q")}`), ...edgesOf(words, to) }),
    ...(to === 9 && { shape: { value: "R", from: "Q9" } }),
    ...(worded && { kind: { value: worded, from: comment, why: "kindFromName" } as const }),
  };
  const groove = worded === "grooving" || worded === "parting";
  const sized = groove
    ? d > 0 && { width: { value: d, from: `D${words.get("D")}`, why: "widthFromDiameter" } as const }
    : { nose: known(radiusOf(d), `D${words.get("D") ?? 0}`) };
  return { label, texts, unused, facts: { kind: turning, ...facts, ...sized } };
}
const turning: NonNullable<Facts["kind"]> = { value: "turning", from: "Q", why: "kindFromProperties" };

/** Reads a tool table of LinuxCNC; null when the text is none. */
export function readLinuxCnc(text: string, { unit }: ReadingContext): ForeignContent | null {
  const written = text
    .replace(/^\uFEFF/, "")
    .split(/\r\n|\r|\n/)
    .filter((line) => !/^\s*(?:;.*)?$/.test(line));
  const read = written.slice(0, MOST_ITEMS + 1).map(lineOf);
  const lines = read.filter((line) => line !== null);
  if (lines.length === 0 || lines.length < read.length) return null;
  const isMill = lines.every(({ words }) => (words.get("Q") ?? 0) === 0);
  const isEmpty = ({ words }: Line) => isMill && (words.get("D") ?? 0) <= 0;
  return {
    tools: lines.filter((line) => !isEmpty(line)).map((line) => toolOf(line, isMill, IN_MM[unit])),
    refused: lines.filter(isEmpty).map(({ words, comment }) => ({
      label: `T${words.get("T")} ${comment}`.trim(),
      why: "nothingKnown",
      kind: "",
    })),
    unitAsked: true,
  };
}
