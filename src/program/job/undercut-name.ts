import { METRIC_SIZES } from "../../kernel/contour/metric-thread.ts";
import {
  GROOVE_FORMS,
  grooveNamed,
  groovesFor,
  groovesOf,
  isAssigned,
  nearestGroove,
  udcForm,
  type GrooveForm,
  type ReliefGroove,
} from "../../kernel/contour/relief-groove.ts";
import {
  neighboursOfPitch,
  RELIEF_FORMS,
  threadRelief,
  type ReliefForm,
  type ThreadRelief,
} from "../../kernel/contour/thread-relief.ts";
import { undercutOfPitch } from "../../kernel/contour/undercut-table.ts";
import { undercutShape, type RecessWord, type RecessWords, type UndercutForm } from "../../kernel/contour/undercut.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { diameter, radians, rounded, type Diameter } from "../../kernel/units.ts";

/** Where an undercut is: diameter of its cylinder, mm, and whether in a bore. */
export interface UndercutPlace {
  readonly diameter: Diameter;
  readonly isInside: boolean;
  /** Position of the face, mm. */
  readonly z?: number;
  /** Pitch of the thread that ends here, mm. */
  readonly pitch?: number;
}

/** A designation as a drawing has it; a part that is not typed is null. `allowance`: material for grinding, mm. */
export type UndercutName =
  | {
      readonly standard: "DIN 509" | "ISO 18388";
      readonly form: GrooveForm;
      readonly size: { readonly r: number; readonly t1: number } | null;
      readonly allowance: number;
    }
  | { readonly standard: "DIN 76"; readonly form: ReliefForm | null; readonly pitch: number | null };

const NUMBER = String.raw`(\d+(?:\.\d*)?|\.\d+)`;
const GROOVE = new RegExp(
  String.raw`^(?:(DIN509|ISO18388)-?)?(?:FORM)?([EFGH])(?:-?${NUMBER}[X*/]${NUMBER})?(?:Z=?${NUMBER})?$`,
);
const RELIEF = new RegExp(String.raw`^DIN76(?:-1)?(?:-?(?:FORM)?([ABCD])(?:[-XP]*=?${NUMBER})?|-?[XP]=?${NUMBER})?$`);
const BARE_RELIEF = new RegExp(String.raw`^(?:FORM)?([ABCD])(?:[-XP]*=?${NUMBER})?$`);
/** A trade name in front of the designation says nothing more. */
const TITLE = /^(?:GEWINDEFREISTICH|FREISTICH|UNDERCUT|RELIEFGROOVE|THREADUNDERCUT|D[ÉE]GAGEMENT|GORGE)[-:]?/;
/** No designation is longer. */
const LONGEST = 60;

/** Spaces, dashes, decimal comma and multiplication sign as one spelling. */
const plain = (typed: string) =>
  typed
    .slice(0, LONGEST)
    .toUpperCase()
    .replace(/\s+/g, "")
    .replace(/[‐-―−]/g, "-")
    .replace(/,/g, ".")
    .replace(/[×✕]/g, "X")
    .replace(TITLE, "");

const grooveForm = (letter: string | undefined) => GROOVE_FORMS.find((f) => f === letter);
const reliefForm = (letter: string | undefined) => RELIEF_FORMS.find((f) => f === letter);

/** Reads a designation such as "DIN 509-F 0,8×0,3", "E1x0.2" or "DIN 76-A 2,5"; null for anything else. */
export function readUndercutName(typed: string): UndercutName | null {
  const text = plain(typed);
  const groove = GROOVE.exec(text);
  const form = grooveForm(groove?.[2]);
  if (groove && form) {
    const [, standard, , r, t1, z] = groove;
    return {
      standard: standard === "ISO18388" ? "ISO 18388" : "DIN 509",
      form,
      size: r === undefined || t1 === undefined ? null : { r: Number(r), t1: Number(t1) },
      allowance: Number(z ?? 0),
    };
  }
  const relief = RELIEF.exec(text) ?? BARE_RELIEF.exec(text);
  const number = relief?.[2] ?? relief?.[3];
  return (
    relief && {
      standard: "DIN 76",
      form: reliefForm(relief[1]) ?? null,
      pitch: number === undefined ? null : Number(number),
    }
  );
}

const size = ({ r, t1 }: { readonly r: number; readonly t1: number }) => `${r}×${t1}`;
const grooveName = (standard: string, g: Pick<ReliefGroove, "form" | "r" | "t1">) => `${standard}-${g.form} ${size(g)}`;
const reliefName = (form: ReliefForm, pitch: number) => `DIN 76-${form} P${pitch}`;

/** What to know before a size is taken: it was changed, is meant for other diameters, or is not all of the standard. */
export type UndercutNote =
  | { readonly code: "nearest"; readonly asked: string; readonly taken: string }
  | { readonly code: "diameter"; readonly over: number; readonly upTo: number }
  | { readonly code: "side"; readonly form: ReliefForm; readonly other: ReliefForm }
  | { readonly code: "pitch"; readonly below?: number; readonly above?: number; readonly pitch: number }
  | { readonly code: "formG" }
  | { readonly code: "faceOfH"; readonly t2: number }
  | { readonly code: "allowance"; readonly z: number };

/** A size of a standard for a place: its words of UDC, or none where UDC has no such form. */
export interface NamedUndercut {
  readonly name: string;
  readonly load: ReliefGroove["load"] | null;
  readonly udc: { readonly form: UndercutForm; readonly words: RecessWords } | null;
  readonly groove: ReliefGroove | null;
  readonly relief: ThreadRelief | null;
  readonly notes: readonly UndercutNote[];
}

/** Slopes of the standards, degrees: of the cylinder side, of the face (F), and of a thread relief (at least). */
const SLOPE = { cylinder: 15, face: 8, thread: 30 };

/**
 * Words of UDC for a groove. With an allowance the blank has more material by z on the cylinder, and with form F on the
 * face: the slope is lengthened by z / tan 15°, which the standard lists as e1.
 */
function grooveWords(g: ReliefGroove, z: number): RecessWords {
  const longer = z / Math.tan(radians(SLOPE.cylinder));
  if (g.form === "H") return { R: g.r, BREADTH: rounded(g.f + longer), ANGLE: SLOPE.cylinder };
  const ofFace = g.form === "F" ? z : 0;
  return {
    R: g.r,
    DEPTH: rounded(g.t1 + z),
    BREADTH: rounded(g.f + longer - ofFace),
    ANGLE: SLOPE.cylinder,
    ...(g.form === "F" && { FACEDEPTH: rounded(g.t2 + z), FACEANGLE: SLOPE.face }),
  };
}

function namedGroove(
  standard: "DIN 509" | "ISO 18388",
  g: ReliefGroove,
  place: UndercutPlace | null,
  { allowance, asked }: { readonly allowance: number; readonly asked: string | null },
): NamedUndercut {
  const form = udcForm(g.form);
  const name = grooveName(standard, g);
  const notes: UndercutNote[] = [];
  if (asked !== null) notes.push({ code: "nearest", asked, taken: name });
  if (place && !isAssigned(g, place.diameter)) notes.push({ code: "diameter", over: g.over, upTo: g.upTo });
  if (!form) notes.push({ code: "formG" });
  if (g.form === "H") notes.push({ code: "faceOfH", t2: g.t2 });
  if (allowance > 0) notes.push({ code: "allowance", z: allowance });
  return {
    name,
    load: g.load,
    udc: form && { form, words: grooveWords(g, allowance) },
    groove: g,
    relief: null,
    notes,
  };
}

const INSIDE: ReadonlySet<ReliefForm> = new Set(["C", "D"]);
/** The form of the other side with the same width. */
const OTHER_SIDE: Readonly<Record<ReliefForm, ReliefForm>> = { A: "C", B: "D", C: "A", D: "B" };

function namedRelief(asked: ReliefForm, pitch: number, place: UndercutPlace | null): NamedUndercut | null {
  const isInside = place?.isInside ?? INSIDE.has(asked);
  const form = INSIDE.has(asked) === isInside ? asked : OTHER_SIDE[asked];
  const relief = threadRelief(pitch, form);
  const cylinder = isInside && place ? { bore: place.diameter } : "shaft";
  const measures = undercutOfPitch(pitch, cylinder, form);
  if (!relief || !measures) return null;
  return {
    name: reliefName(form, relief.pitch),
    load: null,
    udc: {
      form: "THREAD",
      words: {
        PITCH: relief.pitch,
        R: relief.R,
        DEPTH: rounded(measures.DEPTH),
        BREADTH: relief.broad,
        ANGLE: SLOPE.thread,
      },
    },
    groove: null,
    relief,
    notes: form === asked ? [] : [{ code: "side", form: asked, other: form }],
  };
}

/** The pitch of the thread that ends here; else those of the metric sizes with this diameter or core, the coarse one first. */
export function pitchesFor({ diameter, isInside, pitch: known }: UndercutPlace): readonly number[] {
  if (known !== undefined) return [known];
  return METRIC_SIZES.flatMap(([nominal, coarse, ...fine]) =>
    [...(coarse === null ? [] : [coarse]), ...fine].filter((pitch) =>
      isInside
        ? Math.abs(nominal - diameter) <= SAME || Math.abs(nominal - 1.0826 * pitch - diameter) <= 0.25 * pitch
        : Math.abs(nominal - diameter) <= SAME,
    ),
  );
}

/** A designation for a place, and the ones to choose from where it is not complete. */
export type UndercutFound = { readonly notes: readonly UndercutNote[]; readonly sizes: readonly NamedUndercut[] };

const NONE: UndercutFound = { notes: [], sizes: [] };

/** Most sizes listed. */
const LISTED = 8;

function listed(place: UndercutPlace | null): UndercutFound {
  if (!place) return NONE;
  const of = (form: GrooveForm) =>
    groovesFor(form, place.diameter).map((g) => namedGroove("DIN 509", g, place, { allowance: 0, asked: null }));
  const reliefs = pitchesFor(place)
    .slice(0, 2)
    .flatMap((pitch) => namedRelief(place.isInside ? "C" : "A", pitch, place) ?? []);
  return { notes: [], sizes: [...of("E"), ...of("F"), ...of("H"), ...reliefs] };
}

function foundGroove(name: Exclude<UndercutName, { standard: "DIN 76" }>, place: UndercutPlace | null): UndercutFound {
  const { standard, form, allowance } = name;
  if (!name.size) {
    const among = place ? groovesFor(form, place.diameter) : groovesOf(form);
    const own = among.length > 0 ? among : groovesOf(form);
    return { notes: [], sizes: own.map((g) => namedGroove(standard, g, place, { allowance, asked: null })) };
  }
  const { r, t1 } = name.size;
  const exact = grooveNamed(form, r, t1);
  const g = exact ?? nearestGroove(form, r, t1);
  if (!g) return NONE;
  const asked = exact ? null : grooveName(standard, { form, r, t1 });
  return { notes: [], sizes: [namedGroove(standard, g, place, { allowance, asked })] };
}

/** The sizes that a typed designation names for a place; nothing typed lists those of its diameter. */
export function undercutsNamed(typed: string, place: UndercutPlace | null): UndercutFound {
  if (typed.trim() === "") return listed(place);
  const name = readUndercutName(typed);
  if (!name) return NONE;
  if (name.standard !== "DIN 76") return foundGroove(name, place);
  const usual = place?.isInside ? (["C", "D"] as const) : (["A", "B"] as const);
  const forms = name.form === null ? usual : [name.form];
  const named = (p: number) => forms.flatMap((form) => namedRelief(form, p, place) ?? []);
  const pitch = name.pitch ?? place?.pitch ?? null;
  if (pitch === null) {
    const pitches = place ? pitchesFor(place) : [];
    return { notes: [], sizes: pitches.slice(0, LISTED).flatMap(named) };
  }
  const found = named(pitch);
  if (found.length > 0) return { notes: [], sizes: found };
  const near = neighboursOfPitch(pitch);
  const sizes = [near.below, near.above].flatMap((p) => (p === undefined ? [] : named(p)));
  return { notes: [{ code: "pitch", pitch, ...near }], sizes };
}

/** Breadth of the recess in the face above the floor (g) of form F, mm; null for the other forms. */
export function breadthOnFace(g: ReliefGroove): number | null {
  if (g.form !== "F") return null;
  const shape = undercutShape({ kind: "undercut", form: "F", words: grooveWords(g, 0) }, diameter(2 * g.f), false);
  const top = "vertices" in shape ? shape.vertices.at(-1) : undefined;
  return top ? Number((top.v + g.t1).toFixed(1)) : null;
}

const agrees = (words: RecessWords, own: RecessWords): boolean =>
  (Object.keys(own) as RecessWord[]).every((w) => {
    const [a, b] = [own[w], words[w]];
    return a !== undefined && b !== undefined && Math.abs(a - b) <= 0.0011;
  });

/** The designation of an undercut whose words are those of a standard size; null for any other. */
export function nameOfUndercut(
  form: UndercutForm,
  words: RecessWords,
  place: UndercutPlace | null,
): NamedUndercut | null {
  const own = GROOVE_FORMS.find((f) => f === form);
  const made: readonly NamedUndercut[] = own
    ? groovesOf(own).map((g) => namedGroove("DIN 509", g, place, { allowance: 0, asked: null }))
    : form === "THREAD" && words.PITCH !== undefined
      ? (place?.isInside ? (["C", "D"] as const) : (["A", "B"] as const)).flatMap(
          (f) => namedRelief(f, words.PITCH ?? 0, place) ?? [],
        )
      : [];
  return made.find(({ udc }) => udc && agrees(words, udc.words)) ?? null;
}
