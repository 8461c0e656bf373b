import { valueText } from "../number-text.ts";
import { unsigned, wordsText } from "../print-words.ts";
import { readWords } from "../read-words.ts";
import { Scan } from "../scan.ts";
import { noWords, type FreeForm, type NamedWord, type Words } from "../words.ts";
import type { Style } from "../style.ts";
import { VALUE } from "../value.ts";
import { defineBlock, within, type Field, type BlockReading } from "./define.ts";
import { namedField } from "./named-words.ts";
import {
  axisFields,
  centreAngleField,
  lineLengthField,
  pathWords,
  polarFields,
  radiusField,
  tailFields,
  turnField,
} from "./path-words.ts";
import { cut, TO_CUT } from "./sample.ts";
import { property } from "./words.ts";

type Given = readonly NamedWord[];
interface Free {
  readonly kind: "free";
  readonly form: FreeForm;
  readonly given: Given;
  readonly words: Words;
}

/**
 * Words of free contours only: angles, centres, auxiliary points on or beside an element, parallels, and the reference
 * block of a value.
 */
const NAMES = "I?AN|I?CC[XYZ]|CCPR|CCPA|P[123][XYZ]|PD[XYZ]|PAR|DP|D|RCC[XYZ]|RPR|RPA|RAN|R[XYZ]";
const GIVEN = new RegExp(String.raw`(?<![A-Z_])(?:(CLSD)[ \t]*([+-])|(${NAMES})[ \t]*(${VALUE}))`, "gi");
const SOLUTION = /\d{1,2}(?![\d.,])/y;

function read({ scan }: BlockReading, form: FreeForm): { readonly given: Given; readonly words: Words } | null {
  const given: NamedWord[] = [];
  if (form === "FSELECT") {
    const number = scan.take(SOLUTION);
    if (!number) return null;
    given.push({ name: form, value: Number(number[0]) });
    scan.leftOver();
    return { given, words: noWords };
  }
  const begun = scan.at;
  const rest = scan.text
    .slice(begun)
    .replace(GIVEN, (text, closes?: string, sign?: string, name = "", digits = "", at = 0) => {
      // Issues of a value are reported at its position.
      scan.at = begun + Number(at) + text.length;
      const value = closes ? (sign === "-" ? -1 : 1) : scan.value(digits);
      if (value !== null) given.push({ name: (closes ?? name).toUpperCase(), value });
      return " ".repeat(text.length);
    });
  // The other words keep their positions, so that their issues have the right place.
  const inner = new Scan(rest, scan.offset + begun);
  const words = readWords(inner);
  for (const found of inner.issues) scan.issues.push(found);
  scan.at = scan.text.length;
  return { given, words };
}

/** References to blocks are bare numbers, and CLSD has only a sign. */
const REFERS = /^(?:PAR|RCC?.*|RPR|RPA|RAN|R[XYZ])$/;
function givenText({ name, value }: NamedWord, style: Style): string {
  if (name === "CLSD") return value === -1 ? "-" : "+";
  return REFERS.test(name) ? unsigned(value, style) : valueText(value, style);
}

const ANGLE = /^(?:I?AN|CCPA)$/;
const NUMBER = /^(?:PAR|RCC?[XYZ]|RPR|RPA|RAN)$/;
const SIGNS: ReadonlyMap<string, number> = new Map([
  ["+", 1],
  ["-", -1],
]);
function givenField(name: string): Field<Given, never> {
  const plain = namedField(name, null);
  if (name === "CLSD")
    return {
      id: plain.id,
      name: plain.name,
      choices: ["", "+", "-"],
      about: "free",
      noPicture: "choice",
      entry: "choice",
      get(given) {
        const closes = plain.get(given);
        return closes === null ? "" : closes === -1 ? "-" : "+";
      },
      put: (given, chosen) => plain.put(given, SIGNS.get(chosen) ?? null),
    };
  const { unit: _, ...bare } = plain;
  return {
    ...bare,
    ...(!NUMBER.test(name) && { unit: ANGLE.test(name) ? "°" : "mm" }),
    about: "free",
  };
}

const USUAL: Partial<Record<FreeForm, readonly string[]>> = {
  FL: ["AN"],
  FLT: ["AN"],
  FC: ["CCX", "CCY"],
  FCT: ["CCX", "CCY"],
};
/** The usual words of a form, and any other word of the block. */
const givenNames = (form: FreeForm, given: Given): readonly string[] =>
  form === "FPOL" ? [] : [...new Set([...(USUAL[form] ?? []), ...given.map((w) => w.name)])];
const ofWords = <N extends string>(field: Field<Words, N>) =>
  within(
    field,
    (s: Free) => s.words,
    (s, words) => ({ ...s, words }),
  );
const lineFields = [lineLengthField, ...tailFields];
const arcFields = [radiusField, turnField, lineLengthField, centreAngleField, ...tailFields];

/** An element of a free contour, its pole, or the choice of a solution. */
export const free = defineBlock({
  kind: "free",
  keyword: ["FL", "FLT", "FC", "FCT", "FPOL", "FSELECT"],
  words: [
    property<FreeForm>()("form", { compareAs: (form, said) => void said.put("", form) }),
    property<Given>()("given", { compareAs: (given, said) => void said.named(given) }),
    pathWords<never>(() => []),
  ],
  fields: ({ form, given, words }) => [
    ...[...axisFields(words), ...(form === "FPOL" ? [] : polarFields.filter((field) => field.get(words) !== null))].map(
      ofWords,
    ),
    ...givenNames(form, given).map((name) =>
      within<Free, Given, never>(
        givenField(name),
        (s: Free) => s.given,
        (s, next) => ({ ...s, given: next }),
      ),
    ),
    ...(form === "FPOL" ? [] : form.startsWith("FL") ? lineFields : arcFields).map(ofWords),
  ],
  read(reading) {
    const form = reading.head.toUpperCase() as FreeForm;
    const found = read(reading, form);
    return found && { kind: "free", form, ...found };
  },
  // Words of free contours are printed after the end point; a control reads any order.
  print: (s, style) =>
    s.form === "FSELECT"
      ? `FSELECT ${unsigned(s.given[0]?.value ?? 1, style)}`
      : `${s.form}${wordsText(s.words, style)}${s.given.map((w) => ` ${w.name}${givenText(w, style)}`).join("")}`,
  isTypedAsText: (s) => s.form === "FSELECT",
  nameKey: (s) => s.form,
  tags: ["waits"],
  noPicture: "free",
  sample: cut(...TO_CUT, "> FL AN+30"),
});
