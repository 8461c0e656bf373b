import { formatFixed, formatNumber, formatSigned } from "../../i18n/number.ts";
import type { SheetTexts } from "../../i18n/en/sheet.ts";
import type { Texts } from "../../i18n/index.ts";
import type { Language } from "../../i18n/languages.ts";
import type { Spindle } from "../../kernel/step.ts";
import type { Pt } from "../../kernel/point.ts";
import { type Diameter, toDiameter } from "../../kernel/units.ts";
import type { SheetFeed } from "../../report/sheet/setup-data.ts";
import type { DrawingWords } from "../../view/sheet/part-drawing.ts";

/** Numbers and times of the sheet in one language. */
export interface SheetWords extends DrawingWords {
  readonly number: (value: number, decimals?: number) => string;
  readonly signed: (value: number) => string;
  readonly start: (p: Pt) => string;
  readonly time: (seconds: number) => string;
  readonly feeds: (feeds: readonly SheetFeed[]) => string;
  readonly most: (speed: number) => string;
  /** The speed and its limit in rpm; empty where it stands still. */
  readonly spindle: (spindle: Spindle | null) => string;
}

/** A minus as long as a plus is wide. */
const typeset = (text: string): string => text.replace(/^-/, "−");

/** What the sheet says of numbers. */
export function sheetWords(t: Texts, own: SheetTexts, language: Language): SheetWords {
  const number = (value: number, decimals = 3) => typeset(formatNumber(language, value, decimals));
  const signed = (value: number) => (Object.is(formatNumber(language, value), "0") ? "0" : typeset(formatSigned(language, value)));
  const diameter = (value: Diameter) => `⌀${number(value)}`;
  const unitOf = { "mm/rev": t.lathe.perTurn, "mm/min": t.lathe.perMinute, lead: own.lead } as const;
  const rpm = (speed: number) => `${number(speed)} ${t.lathe.rpm}`;
  return {
    number,
    most: rpm,
    signed,
    diameter,
    position: signed,
    thread: (across, lead, starts) => own.thread(across, number(lead), starts),
    blankLength: (value) => number(value),
    start: ({ z, r }) => `X⌀${number(toDiameter(r))} Z${signed(z)}`,
    time: (seconds) => {
      const whole = Math.round(seconds);
      return t.page.effect.duration(Math.floor(whole / 60), formatFixed(language, whole % 60, 0));
    },
    feeds: (feeds) =>
      (["mm/rev", "mm/min", "lead"] as const).flatMap((unit) => {
        const own_ = feeds.filter((feed) => feed.unit === unit).map(({ value }) => number(value));
        if (own_.length === 0) return [];
        return unit === "lead" ? [`${unitOf.lead} ${own_.join(" / ")}`] : [`${own_.join(" / ")} ${unitOf[unit]}`];
      }).join(", "),
    spindle: (spindle) => {
      if (!spindle) return "";
      if (spindle.kind === "constant") return spindle.speed > 0 ? `S ${rpm(spindle.speed)}` : "";
      const speed = `VC ${number(spindle.cuttingSpeed)} ${t.setup.units.cuttingSpeed}`;
      return spindle.limit > 0 ? `${speed}, ${own.most(number(spindle.limit))}` : speed;
    },
  };
}
