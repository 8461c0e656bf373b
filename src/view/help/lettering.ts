import type { Param, Params } from "../../cycles/params.ts";
import { partnerOf } from "./topics.ts";

/** Values of a cycle by Q number, as its schemas give them. */
export type Numbers = Readonly<Record<string, number | "auto">>;

/** Words and number form of the screen language. */
export interface HelpWords {
  /** At most so many decimals, with the decimal sign of the language; a length or feed in the unit of the program. */
  readonly number: (value: number, decimals: number, of: Pick<Param, "kind">) => string;
  /** Short names of element types 0, 1, 2. */
  readonly element: readonly [none: string, chamfer: string, radius: string];
  /** The parameter has no function in this cycle. */
  readonly reserved: string;
  /** The drawing shows a length larger than it is. */
  readonly notToScale: string;
}

const signed = (text: string) => text.replace("-", "−");

function plain(p: Param, number: (v: number) => string, value: number): string {
  switch (p.kind) {
    case "diameter":
      return `⌀${number(value)}`;
    case "oversizeDiameter":
      return `⌀+${number(value)}`;
    case "axial":
      return p.incremental ? (value > 0 ? `+${number(value)}` : number(value)) : `Z${number(value)}`;
    case "angle":
      return `${number(value)}°`;
    case "feed":
      return `F${number(value)}`;
    case "percent":
      return `${number(value)} %`;
    case "factor":
      return `×${number(value)}`;
    case "count":
    case "revolutions":
    case "choice":
    case "radial":
    case "axialDepth":
    case "length":
      return number(value);
  }
}

/** The short text of a position: ⌀75, Z−55. */
export const positionText = (kind: "diameter" | "axial", value: number, speech: HelpWords): string =>
  (kind === "diameter" ? "⌀" : "Z") + signed(speech.number(value, 3, { kind }));

/** The short text of a value on the drawing: ⌀75, Z−55, 5°, R1.5, 0.5×45°, ≤3, F0.3. */
export function letteringOf(params: Params, q: string, values: Numbers, speech: HelpWords, square: boolean): string {
  const p = params[q],
    value = values[q];
  if (!p || value === undefined) return "";
  if (value === "auto") return "FAUTO";
  const number = (v: number) => signed(speech.number(v, p.decimals, p));
  const text = number(value);
  if (p.reserved) return `${text} ${speech.reserved}`;
  if (p.shown === "infeed") return value > 0 ? `≤${text}` : text;
  if (p.shown === "oversizeZ") return `Z+${text}`;
  if (p.shown === "element") return speech.element[value as 0 | 1 | 2] ?? text;
  if (p.rounds) return `R${text}`;
  const partner = partnerOf(params, q);
  const type = partner ? values[partner] : undefined;
  if (type === 1) return square ? `${text}×45°` : `${text}×${text}`;
  if (type === 2) return `R${text}`;
  return plain(p, number, value);
}
