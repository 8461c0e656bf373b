import { defineBlock, type Field, type BlockReading } from "./define.ts";
import { CONE, cut } from "./sample.ts";
import { choiceField, property, textField } from "./words.ts";

type Unit = "MM" | "INCH";
const UNIT = /(?:^|\s)(MM|INCH)$/i;

const nameField: Field<string, "name"> = textField<string, "name">(
  "name",
  (name) => name,
  (typed) => (/^\S{1,60}$/.test(typed.trim()) ? typed.trim() : undefined),
  { noPicture: "name" },
);
const unitField = choiceField<Unit, "unit">(
  "unit",
  ["MM", "INCH"],
  (unit) => unit,
  (chosen) => (chosen === "INCH" ? "INCH" : "MM"),
  { noPicture: "choice" },
);
/** The name is not compared: a program under another name is the same program. */
const words = [
  property<string>()("name", { fields: () => [nameField] }),
  property<Unit>()("unit", { compareAs: (unit, said) => void said.put("", unit), fields: () => [unitField] }),
] as const;

/** Everything after the keyword is the name, except the unit at its end. */
function read({ scan }: BlockReading): { readonly name: string; readonly unit: Unit } {
  const { rest } = scan;
  const unit = UNIT.exec(rest.slice(-6));
  if (!unit) scan.missing("MM");
  scan.at = scan.text.length;
  const name = unit ? rest.slice(0, -unit[0].length).trim() : rest;
  return { name, unit: unit?.[1]?.toUpperCase() === "INCH" ? "INCH" : "MM" };
}

/** `BEGIN PGM NAME MM`. */
export const begin = defineBlock({
  kind: "begin",
  keyword: "BEGIN PGM",
  words,
  read: (reading) => ({ kind: "begin", ...read(reading) }),
  print: (s) => `BEGIN PGM ${s.name} ${s.unit}`,
  tags: ["opening"],
  offered: { group: "frame", begins: { kind: "begin", name: "PROGRAM", unit: "MM" } },
  sample: ["> BEGIN PGM SAMPLE MM", ...cut(...CONE).slice(1)],
});

/** `END PGM NAME MM`. */
export const end = defineBlock({
  kind: "end",
  keyword: "END PGM",
  words,
  read: (reading) => ({ kind: "end", ...read(reading) }),
  print: (s) => `END PGM ${s.name} ${s.unit}`,
  offered: { group: "frame", begins: { kind: "end", name: "PROGRAM", unit: "MM" } },
  sample: [...cut(...CONE).slice(0, -1), "> END PGM SAMPLE MM"],
});
