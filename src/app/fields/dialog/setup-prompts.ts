import { inScreenWriting } from "../../../i18n/number.ts";
import { readText, type Field, type FieldReading, emptyReading } from "../../../program/values/field.ts";
import { knownParameters } from "../../../program/job/job-parameters.ts";
import { SETUP_FIELDS } from "../../../program/job/setup-fields.ts";
import type { SetupPlace } from "../../../program/job/setup-places.ts";
import { typedAt } from "../../../program/job/setup-place.ts";
import type { Language } from "../../../i18n/languages.ts";
import type { Texts } from "../../../i18n/index.ts";
import type { Tool } from "../../../kernel/plan/tool.ts";
import { goToField } from "../../place/place.ts";
import type { JobReading } from "../../document/reading.ts";
import { promptOf, type Prompt } from "./session.ts";

/** Set-up prompts in the order of a setter's work, each with the control's word. */
const PLACES = [
  { id: "blank.outside", letter: "D", field: SETUP_FIELDS.outside, group: "blank" },
  { id: "blank.bore", letter: "DI", field: SETUP_FIELDS.bore, group: "blank" },
  { id: "blank.length", letter: "L", field: SETUP_FIELDS.length, group: "blank" },
  { id: "blank.allowance", letter: "DIST", field: SETUP_FIELDS.allowance, group: "blank" },
  {
    id: "tool",
    letter: "T",
    field: { ...SETUP_FIELDS.speed, id: "tool", range: [0, 32767], decimals: 0 },
    group: "tool",
  },
  { id: "start.x", letter: "X", field: SETUP_FIELDS.startX, group: "start" },
  { id: "start.z", letter: "Z", field: SETUP_FIELDS.startZ, group: "start" },
] as const satisfies readonly {
  readonly id: SetupPlace;
  readonly letter: string;
  readonly field: Field;
  readonly group: string;
}[];

/** First prompt of a new work. */
export const FIRST_PLACE: SetupPlace = PLACES[0].id;

export const isSetupPlace = (id: string): id is SetupPlace => PLACES.some((place) => place.id === id);

/** Set-up prompts with typed text, reading and proposal. */
export interface SetupPrompts {
  readonly fields: readonly Prompt[];
  readonly draft: Readonly<Record<string, string>>;
  readonly readings: Readonly<Record<string, FieldReading>>;
}

export function setupPrompts(read: JobReading, t: Texts, language: Language, tools: readonly Tool[]): SetupPrompts {
  const { setup } = read;
  if (!setup) return { fields: [], draft: {}, readings: {} };
  const known = knownParameters(read.job);
  const { setup: words } = t;
  const names: Readonly<Record<SetupPlace, string>> = {
    "blank.outside": words.blank.outside,
    "blank.bore": words.blank.bore,
    "blank.length": words.blank.length,
    "blank.allowance": words.blank.allowance,
    tool: words.tool.title,
    "start.x": words.start.x,
    "start.z": words.start.z,
  };
  const groups = { blank: words.blank.title, tool: words.tool.title, start: words.start.title };
  const isAcross = (id: SetupPlace) => id === "blank.outside" || id === "blank.bore" || id === "start.x";
  const toolNamed = (number: string) => tools.find(({ T }) => String(T) === number)?.NAME ?? "";
  const unitAt = (id: SetupPlace, shown: string) =>
    id === "tool" ? toolNamed(shown) : isAcross(id) ? words.units.diameter : words.units.mm;
  const screen = (text: string) => inScreenWriting(language, text);
  const value = (id: SetupPlace) => screen(typedAt(read.job, id));
  const blank = `⌀${value("blank.outside")} × ${value("blank.length")}`;
  const shownOf = {
    blank: { letter: "BLK", text: blank, unit: words.units.mm },
    tool: { letter: "T", text: value("tool"), unit: "" },
    start: { letter: "X Z", text: `⌀${value("start.x")} ${value("start.z")}`, unit: words.units.mm },
  };
  const draft: Record<string, string> = {};
  const readings: Record<string, FieldReading> = {};
  const fields = PLACES.map(({ id, letter, field, group }, i) => {
    const isProposed = setup.proposed.has(id);
    const text = typedAt(read.job, id);
    draft[id] = isProposed ? "" : text;
    readings[id] = isProposed ? emptyReading : readText(field, text, known);
    const unit = unitAt(id, text);
    const inGroup = PLACES.filter((place) => place.group === group);
    const proposes = inGroup.some((place) => setup.proposed.has(place.id));
    const about = id === "tool" ? t.dialog.setup.tool : group === "start" ? words.start.hint : t.dialog.setup.blank[id];
    return promptOf(
      { id, letter, optional: true },
      { prompt: names[id], about },
      {
        page: ["guide", "setup", id],
        name: t.dialog.value(letter, names[id]),
        unit,
        shown: { text: screen(text), unit: id === "tool" ? "" : unit, soft: isProposed },
        suggestion: text,
        group: { ...shownOf[group], id: group, name: groups[group], soft: proposes, at: [i + 1, PLACES.length] },
        ...(id === "tool" && {
          action: { label: words.tool.choose, run: () => goToField("setup", "tool"), needed: false },
        }),
      },
    );
  });
  return { fields, draft, readings };
}
