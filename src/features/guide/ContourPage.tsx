import { useId } from "react";
import { formatNumber } from "../../i18n/number.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { readRows } from "../../program/job/contour-rows.ts";
import { newRow, type ContourRow } from "../../program/job/job.ts";
import { segmentData } from "../../view/path.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { useTexts } from "../../app/base/settings/use-texts.ts";
import { GlossaryText, GlossaryList, GlossaryScope } from "../../app/fields/said/GlossaryText.tsx";

/** Elements with a size of their own, each at a small, a default and a large one, mm. */
const SIZED = [
  ["RND", [2, 5, 9]],
  ["CHF", [1, 3, 7]],
  ["CR", [14, 20, 60]],
] as const;
type Sized = (typeof SIZED)[number][0];

/** A shoulder with a sized element: in its corner, or in place of its face. */
function shoulder(kind: Sized, size: number): readonly ContourRow[] {
  const point = (id: string, x: string, z: string) => newRow(id, { x, z });
  const sized = newRow("s", { kind, r: String(size), ...(kind === "CR" && { x: "44", z: "-32", turn: "ccw" }) });
  return kind === "CR"
    ? [point("a", "20", "0"), point("b", "20", "-12"), sized, point("d", "44", "-40")]
    : [point("a", "20", "0"), point("b", "20", "-20"), sized, point("c", "44", "-20"), point("d", "44", "-40")];
}

/** Hatch lines across a picture, and margin around the contour, mm. */
const HATCHES = 30;
const ROUND_IT = 3;

/** The part under a contour down to the axis, with one element at one size, marked. */
function ElementPicture({ kind, size, name }: { readonly kind: Sized; readonly size: number; readonly name: string }) {
  const id = useId();
  const rows = shoulder(kind, size),
    { contour, rowOfSegment } = readRows(rows);
  const at = rows.findIndex((row) => row.kind === kind);
  const { left, right, high } = boxAround([contour.segments.flatMap(({ from, to }) => [from, to])]);
  const [x, wide, tall] = [left - ROUND_IT, right - left + 2 * ROUND_IT, high + 2 * ROUND_IT];
  const step = Math.max(wide, tall) / HATCHES;
  return (
    <svg className="cut-picture" role="img" aria-label={name} viewBox={`${x} ${-high - ROUND_IT} ${wide} ${tall}`}>
      <defs>
        <pattern id={id} width={step} height={step} patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
          <rect className="cut-ground-part" width={step} height={step} />
          <path className="cut-hatch-part" d={`M0 0V${step}`} strokeWidth={step / 4} />
        </pattern>
      </defs>
      <g transform="scale(1 -1)">
        <path className="cut-stock" d={`${segmentData(contour.segments)}V0H${right}Z`} fill={`url(#${id})`} />
        <path className="cut-axis" d={`M${x} 0h${wide}`} />
        <path className="cut-contour" d={segmentData(contour.segments)} />
        <path
          className="cut-finish element-marked"
          d={segmentData(contour.segments.filter((_, i) => rowOfSegment[i] === at))}
        />
      </g>
    </svg>
  );
}

/** The page of the contour of a cycle: its contents, and the effect of its elements. */
export function ContourPage() {
  const t = useTexts("guide");
  const { elements: places } = useTexts("guide-places");
  const {
    dialog: { contour: words },
    contour: { kinds, intro },
  } = useTexts();
  const language = useSettings((s) => s.language);
  const sizes = [t.values.small, t.values.usual, t.values.large];
  return (
    <GlossaryScope texts={[words.about, places.lead, ...places.mistakes]}>
      <header className="guide-head">
        <h1>
          <span className="number prompt-q">LBL</span> {words.question}
        </h1>
        <p>
          <GlossaryText text={words.about} />
        </p>
        <p>
          <GlossaryText text={places.lead} />
        </p>
        <p>{intro}</p>
      </header>
      {SIZED.map(([kind, values]) => (
        <section key={kind} className="guide-values" aria-label={kinds[kind]}>
          <h2>
            <span className="number">{kind}</span> {kinds[kind]}
          </h2>
          <p className="soft">{places.of[kind]}</p>
          <ol className="value-cards">
            {values.map((size, i) => {
              const text = t.millimetres(formatNumber(language, size));
              return (
                <li key={size} className="value-card">
                  <h3>
                    <span className="value-size">{sizes[i]}</span> <span className="number value-shown">{text}</span>
                  </h3>
                  <ElementPicture kind={kind} size={size} name={`${kinds[kind]} ${text}`} />
                </li>
              );
            })}
          </ol>
        </section>
      ))}
      <section aria-label={places.title}>
        <h2>{places.title}</h2>
        <dl className="guide-points">
          {(Object.keys(kinds) as readonly (keyof typeof kinds)[]).map((kind) => (
            <div key={kind}>
              <dt>
                <b className="number">{kind}</b> {kinds[kind]}
              </dt>
              <dd>{places.of[kind]}</dd>
            </div>
          ))}
        </dl>
      </section>
      <section className="guide-mistakes" aria-label={t.mistakes}>
        <h2>{t.mistakes}</h2>
        <GlossaryList texts={places.mistakes} />
      </section>
    </GlossaryScope>
  );
}
