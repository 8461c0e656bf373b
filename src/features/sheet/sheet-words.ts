import type { Lengths } from "../../i18n/lengths.ts";
import { formatNumber, withPrintedMinus } from "../../i18n/number.ts";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { Texts } from "../../i18n/index.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import type { Pt } from "../../kernel/geometry/point.ts";
import { type Diameter, toDiameter } from "../../kernel/units.ts";
import type { SheetFeed } from "../../report/sheet/setup-data.ts";
import type { SetUpWords } from "../../view/drawing/print-sizes.ts";
import { durationText } from "../../app/base/clock-text.ts";

/** Number and time formats of the sheet in one language, and lengths in the unit of the program. */
export interface SheetWords extends SetUpWords {
  readonly number: (value: number) => string;
  /** A text with units, converted to the unit of the program. */
  readonly units: (text: string) => string;
  readonly signed: (value: number) => string;
  readonly start: (p: Pt) => string;
  readonly time: (seconds: number) => string;
  readonly feeds: (feeds: readonly SheetFeed[]) => string;
  readonly most: (speed: number) => string;
  /** The speed and its limit in rpm; empty for a stopped spindle. */
  readonly spindle: (spindle: Spindle | null) => string;
}

/** The formats of the sheet. */
export function sheetWords(t: Texts, own: SheetTexts, lengths: Lengths): SheetWords {
  const { language } = lengths;
  const number = (value: number) => withPrintedMinus(formatNumber(language, value));
  const length = (mm: number) => withPrintedMinus(lengths.number(mm));
  const signed = (mm: number) => (lengths.number(mm) === "0" ? "0" : withPrintedMinus(lengths.signed(mm)));
  const diameter = (value: Diameter) => `⌀${length(value)}`;
  const unitOf = { "mm/rev": t.lathe.perTurn, "mm/min": t.lathe.perMinute, lead: own.lead } as const;
  const rpm = (speed: number) => `${number(speed)} ${t.lathe.rpm}`;
  return {
    number,
    length,
    units: lengths.words,
    most: rpm,
    signed,
    diameter,
    position: signed,
    thread: (across, lead, starts) => own.thread(across, length(lead), starts),
    start: ({ z, r }) => `X${diameter(toDiameter(r))} Z${signed(z)}`,
    time: (seconds) => durationText(t.page.effect.duration, language, seconds),
    feeds: (feeds) =>
      (["mm/rev", "mm/min", "lead"] as const)
        .flatMap((unit) => {
          const own_ = feeds.filter((feed) => feed.unit === unit).map(({ value }) => length(value));
          if (own_.length === 0) return [];
          return unit === "lead"
            ? [`${unitOf.lead} ${own_.join(" / ")}`]
            : [`${own_.join(" / ")} ${lengths.words(unitOf[unit])}`];
        })
        .join(", "),
    spindle: (spindle) => {
      if (!spindle) return "";
      if (spindle.kind === "constant") return spindle.speed > 0 ? `S ${rpm(spindle.speed)}` : "";
      const speed = `VC ${number(spindle.cuttingSpeed)} ${t.setup.units.cuttingSpeed}`;
      return spindle.limit > 0 ? `${speed}, ${own.most(number(spindle.limit))}` : speed;
    },
  };
}
