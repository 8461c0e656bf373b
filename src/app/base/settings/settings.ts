import { create } from "zustand";
import { z } from "zod/mini";
import { isLanguage, LANGUAGES, type Language } from "../../../i18n/languages.ts";
import { isNcOutput, NC_OUTPUTS, type NcOutput } from "../../../program/machine/nc-output.ts";
import type { Control } from "../../../program/tools/plane-types.ts";
import { keptData } from "../kept.ts";
import { fetchAsked } from "./loaded-texts.ts";

/** Longest cutting data, characters: more than the largest table that is taken has. */
const LONGEST_CUTTING = 200_000;

/** Cut above the axis and whole below it, cut on both sides, or whole. */
export const SECTION_VIEWS = ["half", "full", "outside"] as const;
export type SectionView = (typeof SECTION_VIEWS)[number];

/** All paths, or those of what runs now: its cycle call, its phase, its pass; or none. */
export const SHOWN_PATHS = ["all", "operation", "phase", "pass", "none"] as const;

/** Nothing, the roughness of the finished surface, or what the tool bears along its path. */
export const SHOWN_COLOURS = ["none", "roughness", "depth", "chip", "feed", "speed"] as const;

export const PAPERS = ["a4", "letter"] as const;

const CONTROLS: readonly Control[] = ["TNC 640", "TNC7"];

/** The first screen language that the browser asks for and that we have. */
function browserLanguage(): Language {
  const asked = typeof navigator === "undefined" ? [] : (navigator.languages ?? []);
  for (const tag of asked) {
    const name = tag.slice(0, 2).toLowerCase();
    if (isLanguage(name)) return name;
  }
  return "en";
}

/** Letter where the browser's first language is that of a country that prints on it. */
const usualPaper = () =>
  typeof navigator !== "undefined" && /-(?:US|CA|MX)$/.test(navigator.language) ? "letter" : "a4";

/** A choice, a switch and a text; what does not fit keeps its first value. */
const oneOf = <T extends string>(all: readonly T[], first: NoInfer<T> | (() => NoInfer<T>)) =>
  z.catch(z.enum(all as readonly [T, ...T[]]), first as () => T);
const flag = (first: boolean) => z.catch(z.boolean(), first);
const text = (first: string) => z.catch(z.string().check(z.maxLength(LONGEST_CUTTING)), first);

const shape = z.object({
  /** Language of the screen. */
  language: oneOf(LANGUAGES, browserLanguage),
  /** Light, dark, or as the system says. */
  theme: oneOf(["system", "light", "dark"], "system"),
  /** Motion as the system says, or none. */
  motion: oneOf(["system", "reduced"], "system"),
  /** Large type and thick lines, for a class or from afar. */
  presentation: flag(false),
  /** How APPR and DEP move in the tool axis. */
  control: oneOf(CONTROLS, "TNC 640"),
  /** How new programs are written for the machine. */
  output: z.catch(z.custom<NcOutput>(isNcOutput), NC_OUTPUTS.manual),
  /** What times are worked out with: a machine file as text, empty for none. */
  machine: text(""),
  /** The program text takes part of the screen, or is folded away. */
  programFolded: flag(false),
  /** X grows downwards in the lathe view (tool behind the spindle axis seen from the operator). */
  xDown: flag(false),
  /** How the lathe view shows the work. */
  section: oneOf(SECTION_VIEWS, "half"),
  /** The turned body is shown in space in place of its section, and a quarter of it is cut away there. */
  solid: flag(false),
  quarterCut: flag(true),
  /** Which paths the lathe view shows. */
  paths: oneOf(SHOWN_PATHS, "all"),
  /** What the lathe view tells by colour along path or surface. */
  colours: oneOf(SHOWN_COLOURS, "none"),
  /** Paper of the setup sheet, and whether the program stands behind it. */
  paper: oneOf(PAPERS, usualPaper),
  sheetProgram: flag(true),
  /** The setup sheet shows what was measured. */
  sheetMeasured: flag(true),
  /** The steps of the manual stand as a list under the picture, or as one line. */
  stepList: flag(true),
  /** Values of the work are advised on. */
  advice: flag(true),
  /** Material of a work that names none, by its id; the shop's own cutting data as text, empty for those that ship. */
  material: text("c45"),
  cutting: text(""),
});

/** Choices of this device, beside the work itself. */
export type Settings = Readonly<z.output<typeof shape>>;

/** Until the work could be seen from outside there was a switch for its full section. */
const kept = z.pipe(
  z.transform((raw: unknown) =>
    z.object({ fullSection: z.literal(true) }).safeParse(raw).success ? { ...(raw as object), section: "full" } : raw,
  ),
  shape,
);

/**
 * Settings from data that anybody may have written: what does not fit keeps its first value. Null where they are no
 * settings at all.
 */
export const readSettings = (raw: unknown): Settings | null => kept.safeParse(raw).data ?? null;

/** What is set before anybody chooses. */
export const firstSettings = (): Settings => shape.parse({});

const KEPT = keptData<Settings>("settings", kept);

export const useSettings = create<Settings>(() => KEPT.get() ?? firstSettings());

/**
 * Changes the screen language once its texts are here; where they cannot be fetched it stays as it is, and that is
 * said.
 */
export async function changeLanguage(language: Language): Promise<void> {
  await fetchAsked(language);
  changeSettings({ language });
}

/** Changes settings and keeps them; a browser that refuses storage keeps them for this visit only. */
export function changeSettings(change: Partial<Settings>): void {
  useSettings.setState(change);
  KEPT.set(useSettings.getState());
}
