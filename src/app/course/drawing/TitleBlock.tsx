import type { DrawnTask } from "../../../course/printed-part.ts";
import type { CourseDrawingTexts } from "../../../i18n/en/course-drawing.ts";
import { radius, toDiameter } from "../../../kernel/units.ts";
import { usualTable } from "../../../program/cutting-table.ts";
import { boundsOf } from "../../../view/bounds.ts";
import type { PrintWords } from "../../../view/drawing/print-sizes.ts";
import type { WorkshopPrint } from "../../../view/drawing/workshop-drawing.ts";

/** What stands in a title block beside the drawing itself. */
export interface Titled {
  readonly name: string;
  readonly number: string;
  /** Id of a material of the shipped list; undefined: any steel. */
  readonly material: string | undefined;
}

interface Props {
  readonly titled: Titled;
  readonly drawn: DrawnTask;
  readonly print: WorkshopPrint;
  readonly words: PrintWords;
  readonly t: CourseDrawingTexts;
}

function blankText({ drawn, words, t }: Props): string | null {
  const blank = boundsOf(drawn.blank.flat());
  if (!blank) return null;
  const across = (r: number) => words.diameter(toDiameter(radius(r)));
  return [
    t.blankOf(across(blank.high), blank.low > 0 ? across(blank.low) : "", words.length(blank.right - blank.left)),
    ...(blank.right > 0 ? [t.allowance(words.length(blank.right))] : []),
  ].join(", ");
}

/** The title block of a workshop drawing, and its notes. */
export function TitleBlock(props: Props) {
  const { titled, print, t } = props, { general, scale } = print;
  const blank = blankText(props);
  const facts: readonly (readonly [keyof typeof t.head, string])[] = [
    ["number", titled.number],
    ["scale", t.scale(scale.paper, scale.part)],
    ...(blank === null ? [] : [["blank", blank] as const]),
    [
      "material",
      usualTable.materials.find(({ id }) => id === titled.material)?.name ?? t.steel,
    ],
    ["unit", t.inMm],
    ["general", t.tolerances],
    ...(general === null ? [] : [["surface", general] as const]),
  ];
  const notes = [
    t.tolerancesHint,
    ...(print.list.some(({ kind }) => kind === "blank") ? [t.brackets] : []),
    ...(print.left > 0 ? [t.leftOut(print.left)] : []),
  ];
  return (
    <>
      <dl className="workshop-title">
        <div className="workshop-name">
          <dt>{t.head.name}</dt>
          <dd>{titled.name}</dd>
        </div>
        {facts.map(([fact, value]) => (
          <div key={fact}>
            <dt>{t.head[fact]}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <p className="workshop-notes">{notes.join(" · ")}</p>
    </>
  );
}
