import type { Statement } from "../statement.ts";
import type { AxisName, AxisWord, FeedWord, PathKind, Value, Words } from "../words.ts";
import { coordinatesOf, dimensionOf, type IsoCoordinate } from "./coordinates.ts";
import type { IsoProblem } from "./issue.ts";
import type { IsoModal, PathMeaning } from "./modal.ts";
import type { IsoToken } from "./tokens.ts";
import { isoMeaningOf, type IsoBlockName } from "./words.ts";

/** The result of reading a block: its Klartext blocks in order, the modal state, and problems. */
export interface ReadBlock {
  /** Null when the block is kept as text. */
  readonly statements: readonly Statement[] | null;
  readonly modal: IsoModal;
  readonly problems: readonly IsoProblem[];
}

type Building = { -readonly [K in keyof Words]: Words[K] };
/** Functions with a feed of their own, as in Klartext. */
const WITH_FEED: ReadonlySet<number> = new Set([128, 140]);
const CENTRE: Readonly<Record<string, AxisName>> = { I: "X", J: "Y", K: "Z" };

/** The words of one block, sorted by purpose. */
interface SortedWords {
  readonly explicit: PathMeaning | null;
  readonly special: IsoBlockName | null;
  readonly pole: boolean;
  readonly coordinates: readonly IsoCoordinate[];
  /** Compensation, feed, M functions. */
  readonly words: Words;
  readonly speed: Value | null;
  readonly incremental: boolean;
  readonly problems: readonly IsoProblem[];
}

const SPECIAL: ReadonlySet<IsoBlockName> = new Set(["chamfer", "rounding", "stop", "cycleCall"]);

function sortWords(tokens: readonly IsoToken[], modal: IsoModal): SortedWords {
  const problems: IsoProblem[] = [];
  const functions: number[] = [];
  const words: Building = { axes: [], functions };
  let explicit: PathMeaning | null = null;
  let special: IsoBlockName | null = null;
  let pole = false;
  let speed: Value | null = null;
  const unread = ({ raw: word, at }: IsoToken) =>
    problems.push({ code: "isoWordNotUnderstood", at, data: { word: word.slice(0, 40) } });
  const letter = (token: IsoToken) => {
    const { letter: address, value, special: word, text } = token;
    if (text !== null || (word !== null && address !== "F" && address !== "MB")) return unread(token);
    if (value === null && word === null) {
      if (/^[A-Z]+$/.test(address))
        return problems.push({ code: "isoValueMissing", at: token.at, data: { word: token.raw } });
      return unread(token);
    }
    if (/^[XYZABCUVWIJKRH]$/.test(address)) return undefined;
    if (/^F[UZ]?$/.test(address)) {
      const feed: FeedWord = word ?? { value: value ?? 0, unit: address as "F" | "FU" | "FZ" };
      words[functions.some((m) => WITH_FEED.has(m)) ? "functionFeed" : "feed"] = feed;
    } else if (address === "M" && typeof value === "number") functions.push(value);
    else if (address === "MB" && word !== "auto") words.retract = word ?? value ?? "max";
    else if (address === "S") speed = value;
    else unread(token);
    return undefined;
  };
  for (const token of tokens) {
    if (token.letter !== "G") {
      letter(token);
      continue;
    }
    const means = isoMeaningOf("G", token.number ?? -1);
    if (means?.kind === "path") explicit = means;
    else if (means?.kind === "compensation") words.compensation = means.value;
    else if (means?.kind === "plane")
      problems.push({ code: "isoPlaneLeftOut", at: token.at, data: { word: token.raw } });
    else if (means?.kind === "block" && means.block === "polePosition") pole = true;
    else if (means?.kind === "block" && SPECIAL.has(means.block) && special === null) special = means.block;
    else if (dimensionOf(token) === null) unread(token);
  }
  return { explicit, special, pole, words, speed, problems, ...coordinatesOf(tokens, modal.incremental) };
}

const axisWords = (coordinates: readonly IsoCoordinate[]): AxisWord[] =>
  coordinates.flatMap(({ name, ...w }) => (/^[XYZABCUVW]$/.test(name) ? [{ axis: name as AxisName, ...w }] : []));

/** The last of several coordinates with one name counts, as in Klartext. */
const single = (axes: readonly AxisWord[]): AxisWord[] =>
  axes.filter((w, i) => axes.findLastIndex((o) => o.axis === w.axis) === i);

/** A block with its own word: rounding, chamfer, stop, cycle call. Null where its words do not fit. */
function specialBlock(
  kind: IsoBlockName,
  { coordinates, words, explicit, pole, speed }: SortedWords,
): Statement | null {
  if (explicit || pole || speed !== null) return null;
  if (kind === "rounding" || kind === "chamfer") {
    const [r, ...more] = coordinates;
    if (r?.name !== "R" || more.length > 0) return null;
    return kind === "chamfer"
      ? { kind: "chamfer", length: r.value, words }
      : { kind: "path", path: "RND", words: { ...words, radius: r.value } };
  }
  if (coordinates.length > 0) return null;
  return kind === "stop" ? { kind: "stop", words } : { kind: "cycleCall", how: "", words };
}

/** A path block from its words; null where they do not fit together. */
function pathBlock(means: PathMeaning, read: SortedWords, turn: "cw" | "ccw" | null): Statement | null {
  const { coordinates, words } = read;
  const named = (name: string) => {
    const found = coordinates.findLast((c) => c.name === name);
    return found && { value: found.value, incremental: found.incremental };
  };
  const [radius, angle] = [named("R"), named("H")];
  const { path } = means;
  const polar = path === "LP" || path === "CP" || path === "CTP";
  if (!polar && (angle || (radius && path !== "C"))) return null;
  const direction = path === "C" || path === "CP" ? turn : null;
  const kind: PathKind = path === "C" && radius ? "CR" : path;
  return {
    kind: "path",
    path: kind,
    words: {
      ...words,
      axes: single(axisWords(coordinates)),
      ...(polar && radius && { polarRadius: radius }),
      ...(polar && angle && { polarAngle: angle }),
      ...(kind === "CR" && radius && { radius: radius.value }),
      ...(direction && { turn: direction }),
      ...(means.rapid && { feed: "max" }),
    },
  };
}

const speedCall = (speed: Value): Statement => ({
  kind: "toolCall",
  tool: null,
  axis: null,
  speed,
  feed: null,
  deltaLength: null,
  deltaRadius: null,
  extra: [],
});

const notUnderstood = (raw: string): IsoProblem => ({
  code: "isoBlockNotUnderstood",
  at: 0,
  data: { text: raw.slice(0, 60) },
});

/** Reads a block of path words with the modal state before it. */
export function readPathBlock(raw: string, tokens: readonly IsoToken[], before: IsoModal): ReadBlock {
  const read = sortWords(tokens, before);
  const { explicit, special, words, coordinates, speed } = read;
  const path = explicit ?? before.path;
  const turn = explicit?.turn && explicit.turn !== "last" ? explicit.turn : before.turn;
  const modal: IsoModal = { ...before, path, turn, incremental: read.incremental };
  const problems = [...read.problems];
  const kept = (...more: IsoProblem[]): ReadBlock => ({ statements: null, modal, problems: [...problems, ...more] });
  if (tokens.some((t) => t.letter === "")) return { statements: null, modal, problems: [notUnderstood(raw)] };
  if (problems.some((p) => p.code !== "isoPlaneLeftOut")) return kept();
  if (special) {
    const statement = specialBlock(special, read);
    return statement ? { statements: [statement], modal, problems } : kept(notUnderstood(raw));
  }
  const statements: Statement[] = speed === null ? [] : [speedCall(speed)];
  const centre = coordinates.flatMap(({ name, ...w }) =>
    CENTRE[name] === undefined ? [] : [{ axis: CENTRE[name], ...w }],
  );
  const ends = coordinates.length > centre.length;
  const moves = explicit !== null || ends;
  const none: Words = { axes: [], functions: [] };
  if (centre.length > 0 || read.pole)
    statements.push({ kind: "path", path: "CC", words: { ...(moves ? none : words), axes: single(centre) } });
  else if (!moves && (words.feed !== undefined || words.compensation !== undefined))
    statements.push({ kind: "path", path: "L", words });
  else if (!moves && words.functions.length > 0) statements.push({ kind: "functions", words });
  if (!moves) return { statements, modal, problems };
  if (!path) return kept({ code: "isoPathMissing", at: 0, data: {} });
  if (path.turn === "last" && turn === null) {
    return kept({
      code: "isoDirectionMissing",
      at: 0,
      data: { word: tokens.find((t) => t.letter === "G")?.raw ?? "" },
    });
  }
  const fed = withFeed(path, words, before.feed);
  const statement = pathBlock(path, { ...read, words: fed.words }, turn);
  return statement
    ? { statements: [...statements, statement], modal: { ...modal, feed: fed.left }, problems }
    : kept(notUnderstood(raw));
}

/** Moves the feed of a rapid block to the next feed block. */
function withFeed(
  { rapid }: PathMeaning,
  words: Words,
  left: FeedWord | null,
): { readonly words: Words; readonly left: FeedWord | null } {
  if (rapid) return { words, left: words.feed !== undefined && words.feed !== "max" ? words.feed : left };
  return { words: words.feed === undefined && left !== null ? { ...words, feed: left } : words, left: null };
}
