import { create } from "zustand";
import { isLanguage, type Language } from "../../../i18n/languages.ts";
import { isNcOutput, NC_OUTPUTS, type NcOutput } from "../../../program/machine/nc-output.ts";
import type { Control } from "../../../program/tools/plane-types.ts";
import { fetchAsked } from "./loaded-texts.ts";

/** Choices of this device, beside the work itself. Kept in the browser's local storage. */
export interface Settings {
  /** Language of the screen. */
  readonly language: Language;
  /** Light, dark, or as the system says. */
  readonly theme: "system" | "light" | "dark";
  /** Motion as the system says, or none. */
  readonly motion: "system" | "reduced";
  /** Large type and thick lines, for a class or from afar. */
  readonly presentation: boolean;
  /** How APPR and DEP move in the tool axis. */
  readonly control: Control;
  /** How new programs are written for the machine. */
  readonly output: NcOutput;
  /** What times are worked out with: a machine file as text, empty for none. */
  readonly machine: string;
  /** The program text takes part of the screen, or is folded away. */
  readonly programFolded: boolean;
  /** X grows downwards in the lathe view (tool behind the spindle axis seen from the operator). */
  readonly xDown: boolean;
  /** How the lathe view shows the work. */
  readonly section: SectionView;
  /** The turned body is shown in space in place of its section, and a quarter of it is cut away there. */
  readonly solid: boolean;
  readonly quarterCut: boolean;
  /** Which paths the lathe view shows. */
  readonly paths: ShownPaths;
  /** What the lathe view tells by colour along path or surface. */
  readonly colours: ShownColours;
  /** Paper of the setup sheet, and whether the program stands behind it. */
  readonly paper: Paper;
  readonly sheetProgram: boolean;
  /** The setup sheet shows what was measured. */
  readonly sheetMeasured: boolean;
  /** The steps of the manual stand as a list under the picture, or as one line. */
  readonly stepList: boolean;
  /** Values of the work are advised on. */
  readonly advice: boolean;
  /** Material of a work that names none, by its id; the shop's own cutting data as text, empty for those that ship. */
  readonly material: string;
  readonly cutting: string;
}

/** Longest cutting data, characters: more than the largest table that is taken has. */
const LONGEST_CUTTING = 200_000;

/** Cut above the axis and whole below it, cut on both sides, or whole. */
export const SECTION_VIEWS = ["half", "full", "outside"] as const;
export type SectionView = (typeof SECTION_VIEWS)[number];

/** All paths, or those of what runs now: its cycle call, its phase, its pass; or none. */
export const SHOWN_PATHS = ["all", "operation", "phase", "pass", "none"] as const;
export type ShownPaths = (typeof SHOWN_PATHS)[number];

/** Nothing, the roughness of the finished surface, or what the tool bears along its path. */
export const SHOWN_COLOURS = ["none", "roughness", "depth", "chip", "feed", "speed"] as const;
export type ShownColours = (typeof SHOWN_COLOURS)[number];

export const PAPERS = ["a4", "letter"] as const;
type Paper = (typeof PAPERS)[number];

const CONTROLS: readonly Control[] = ["TNC 640", "TNC7"];
const KEY = "turnwise/settings";

/** The first screen language that the browser asks for and that we have. */
function browserLanguage(): Language {
  const asked = typeof navigator === "undefined" ? [] : navigator.languages ?? [];
  for (const tag of asked) {
    const name = tag.slice(0, 2).toLowerCase();
    if (isLanguage(name)) return name;
  }
  return "en";
}

/** Letter where the browser's first language is that of a country that prints on it. */
const usualPaper = (): Paper => (typeof navigator !== "undefined" && /-(?:US|CA|MX)$/.test(navigator.language) ? "letter" : "a4");

function initial(): Settings {
  return {
    language: browserLanguage(),
    theme: "system",
    motion: "system",
    presentation: false,
    control: "TNC 640",
    output: NC_OUTPUTS.manual,
    machine: "",
    programFolded: false,
    xDown: false,
    section: "half",
    solid: false,
    quarterCut: true,
    paths: "all",
    colours: "none",
    paper: usualPaper(),
    sheetProgram: true,
    sheetMeasured: true,
    stepList: true,
    advice: true,
    material: "c45",
    cutting: "",
  };
}

/** Settings from untrusted text: what does not fit keeps its first value. */
export function readSettings(text: string | null): Settings {
  const first = initial();
  let raw: unknown;
  try {
    raw = JSON.parse(text ?? "");
  } catch {
    return first;
  }
  if (typeof raw !== "object" || raw === null) return first;
  const kept = raw as Readonly<Record<string, unknown>>;
  const oneOf = <T extends string>(value: unknown, allowed: readonly T[], otherwise: T): T =>
    allowed.find((each) => each === value) ?? otherwise;
  const flag = (value: unknown, otherwise: boolean) => (typeof value === "boolean" ? value : otherwise);
  const written = (value: unknown, otherwise: string) => (typeof value === "string" && value.length <= LONGEST_CUTTING ? value : otherwise);
  return {
    language: typeof kept["language"] === "string" && isLanguage(kept["language"]) ? kept["language"] : first.language,
    theme: oneOf(kept["theme"], ["system", "light", "dark"], first.theme),
    motion: oneOf(kept["motion"], ["system", "reduced"], first.motion),
    presentation: flag(kept["presentation"], first.presentation),
    control: oneOf(kept["control"], CONTROLS, first.control),
    output: isNcOutput(kept["output"]) ? kept["output"] : first.output,
    machine: written(kept["machine"], first.machine),
    programFolded: flag(kept["programFolded"], first.programFolded),
    xDown: flag(kept["xDown"], first.xDown),
    // Until the work could be seen from outside there was a switch.
    section: kept["fullSection"] === true ? "full" : oneOf(kept["section"], SECTION_VIEWS, first.section),
    solid: flag(kept["solid"], first.solid),
    quarterCut: flag(kept["quarterCut"], first.quarterCut),
    paths: oneOf(kept["paths"], SHOWN_PATHS, first.paths),
    colours: oneOf(kept["colours"], SHOWN_COLOURS, first.colours),
    paper: oneOf(kept["paper"], PAPERS, first.paper),
    sheetProgram: flag(kept["sheetProgram"], first.sheetProgram),
    sheetMeasured: flag(kept["sheetMeasured"], first.sheetMeasured),
    stepList: flag(kept["stepList"], first.stepList),
    advice: flag(kept["advice"], first.advice),
    material: written(kept["material"], first.material),
    cutting: written(kept["cutting"], first.cutting),
  };
}

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

export const useSettings = create<Settings>(() => readSettings(stored()));

/** Changes the screen language once its texts are here; where they cannot be fetched it stays as it is, and that is said. */
export async function changeLanguage(language: Language): Promise<void> {
  await fetchAsked(language);
  changeSettings({ language });
}

/** Changes settings and keeps them; a browser that refuses storage keeps them for this visit only. */
export function changeSettings(change: Partial<Settings>): void {
  useSettings.setState(change);
  try {
    localStorage.setItem(KEY, JSON.stringify(useSettings.getState()));
  } catch {
    return;
  }
}
