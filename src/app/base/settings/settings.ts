import { create } from "zustand";
import { z } from "zod/mini";
import { isLanguage, LANGUAGES, type Language } from "../../../i18n/languages.ts";
import { isNcOutput, NC_OUTPUTS, type NcOutput } from "../../../program/machine/nc-output.ts";
import type { Control } from "../../../program/tools/plane-types.ts";
import { jsonOf, storedText } from "../storage.ts";
import { fetchRequested } from "./loaded-texts.ts";

/** Longest cutting data, characters: more than the largest valid table needs. */
const LONGEST_CUTTING = 200_000;

/** Half section (cut above the axis only), full section, or outside view. */
export const SECTION_VIEWS = ["half", "full", "outside"] as const;
export type SectionView = (typeof SECTION_VIEWS)[number];

/** All paths, or those of the current cycle call, phase or pass; or none. */
export const SHOWN_PATHS = ["all", "operation", "phase", "pass", "none"] as const;

/** No colour map, roughness of the finished surface, or load of the tool along its path. */
export const SHOWN_COLOURS = ["none", "roughness", "depth", "chip", "feed", "speed"] as const;

export const PAPERS = ["a4", "letter"] as const;

const CONTROLS: readonly Control[] = ["TNC 640", "TNC7"];

/** The first of the browser's languages that the app has. */
function browserLanguage(): Language {
  const asked = typeof navigator === "undefined" ? [] : (navigator.languages ?? []);
  for (const tag of asked) {
    const name = tag.slice(0, 2).toLowerCase();
    if (isLanguage(name)) return name;
  }
  return "en";
}

/** Letter if the browser's first language is that of a country that uses it. */
const usualPaper = () =>
  typeof navigator !== "undefined" && /-(?:US|CA|MX)$/.test(navigator.language) ? "letter" : "a4";

/** A choice, a switch and a text; invalid values get the default. */
const oneOf = <T extends string>(all: readonly T[], first: NoInfer<T> | (() => NoInfer<T>)) =>
  z.catch(z.enum(all as readonly [T, ...T[]]), first as () => T);
const flag = (first: boolean) => z.catch(z.boolean(), first);
const text = (first: string) => z.catch(z.string().check(z.maxLength(LONGEST_CUTTING)), first);

const shape = z.object({
  /** Language of the screen. */
  language: oneOf(LANGUAGES, browserLanguage),
  /** Light, dark, or that of the system. */
  theme: oneOf(["system", "light", "dark"], "system"),
  /** Motion as in the system, or reduced. */
  motion: oneOf(["system", "reduced"], "system"),
  /** Large type and thick lines for a presentation. */
  presentation: flag(false),
  /** How APPR and DEP move in the tool axis. */
  control: oneOf(CONTROLS, "TNC 640"),
  /** How new programs are written for the machine. */
  output: z.catch(z.custom<NcOutput>(isNcOutput), NC_OUTPUTS.manual),
  /** Machine file for times, as text; empty for none. */
  machine: text(""),
  /** The program text is hidden. */
  programFolded: flag(false),
  /** X grows downwards in the lathe view (tool behind the spindle axis seen from the operator). */
  xDown: flag(false),
  /** How the lathe view shows the work. */
  section: oneOf(SECTION_VIEWS, "half"),
  /** The part is shown as a 3D body instead of a section, with a quarter cut away. */
  solid: flag(false),
  quarterCut: flag(true),
  /** Which paths the lathe view shows. */
  paths: oneOf(SHOWN_PATHS, "all"),
  /** Colour map of the path or surface in the lathe view. */
  colours: oneOf(SHOWN_COLOURS, "none"),
  /** Paper of the setup sheet, and whether the program is appended. */
  paper: oneOf(PAPERS, usualPaper),
  sheetProgram: flag(true),
  /** The setup sheet shows the measurements. */
  sheetMeasured: flag(true),
  /** The steps of the manual are a list under the picture; otherwise one line, the running one. */
  stepsOpen: flag(false),
  /** Advice on the values of the work is shown. */
  advice: flag(true),
  /** Id of the default material; the shop's own cutting data as text, empty for the shipped ones. */
  material: text("c45"),
  cutting: text(""),
});

/** Settings of this device, which are no part of a work. */
export type Settings = Readonly<z.output<typeof shape>>;

/** Before the outside view existed there was a switch for the full section. */
const kept = z.pipe(
  z.transform((raw: unknown) =>
    z.object({ fullSection: z.literal(true) }).safeParse(raw).success ? { section: "full", ...(raw as object) } : raw,
  ),
  shape,
);

/** Settings from untrusted data: invalid ones get their default. Null if the data are no settings at all. */
export const readSettings = (raw: unknown): Settings | null => kept.safeParse(raw).data ?? null;

/** Default settings. */
export const firstSettings = (): Settings => shape.parse({});

const STORED = storedText("settings");
const stored = (): unknown => jsonOf(STORED.get());

export const useSettings = create<Settings>(() => readSettings(stored()) ?? firstSettings());

/**
 * Changes the screen language once its texts are loaded. If they cannot be fetched the language stays, and a notice
 * says so.
 */
export async function changeLanguage(language: Language): Promise<void> {
  await fetchRequested(language);
  changeSettings({ language });
}

/**
 * Changes settings and stores them, beside those that only a newer edition knows; if storage is refused they last for
 * this visit only.
 */
export function changeSettings(change: Partial<Settings>): void {
  useSettings.setState(change);
  const others = stored();
  STORED.set(JSON.stringify({ ...(readSettings(others) && (others as object)), ...useSettings.getState() }));
}
