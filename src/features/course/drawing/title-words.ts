import type { DrawnTask } from "../../../course/drawn-task.ts";
import type { CourseDrawingTexts } from "../../../i18n/en/course-drawing.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import { boundsOf } from "../../../view/bounds.ts";
import type { SheetTitle } from "../../../view/drawing/drawing-svg.ts";
import type { PrintWords } from "../../../view/drawing/print-sizes.ts";
import type { PartDrawing } from "../../../view/drawing/part-drawing.ts";

/** The entries of a title block besides the drawing. */
export interface Titled {
  readonly name: string;
  readonly number: string;
  /** Name of the material; undefined: any steel. */
  readonly material: string | undefined;
  /** Additional notes of the drawing. */
  readonly notes?: readonly string[];
}

/** Inputs of a title block. */
export interface TitleSource {
  readonly titled: Titled;
  readonly drawn: DrawnTask;
  readonly print: PartDrawing;
  readonly words: PrintWords;
  readonly t: CourseDrawingTexts;
}

function blankText({ drawn, words, t }: TitleSource): string | null {
  const blank = boundsOf(drawn.blank.flat());
  if (!blank) return null;
  const across = (r: number) => words.diameter(toDiameter(radius(r)));
  return [
    t.blankOf(across(blank.high), blank.low > 0 ? across(blank.low) : "", words.length(blank.right - blank.left)),
    ...(blank.right > 0 ? [t.allowance(words.length(blank.right))] : []),
  ].join(", ");
}

/** The title block of a workshop drawing and its notes, in words. */
export function sheetTitleOf(source: TitleSource): SheetTitle {
  const { titled, print, t } = source,
    { general, scale } = print;
  const blank = blankText(source);
  const facts: readonly (readonly [keyof typeof t.head, string])[] = [
    ["number", titled.number],
    ["scale", t.scale(scale.paper, scale.part)],
    ...(blank === null ? [] : [["blank", blank] as const]),
    ["material", titled.material ?? t.steel],
    ["unit", t.inMm],
    ["general", t.tolerances],
    ...(general === null ? [] : [["surface", general] as const]),
  ];
  return {
    name: { label: t.head.name, text: titled.name },
    facts: facts.map(([fact, text]) => ({ label: t.head[fact], text })),
    notes: [
      t.tolerancesHint,
      ...(print.list.some(({ kind }) => kind === "blank") ? [t.brackets] : []),
      ...(print.omitted > 0 ? [t.leftOut(print.omitted)] : []),
      ...(titled.notes ?? []),
    ],
  };
}
