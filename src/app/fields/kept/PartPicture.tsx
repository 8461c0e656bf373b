import type { MilledPlan, Thumbnail, ViewBox } from "../../../view/thumbnail.ts";

/** Width of the edge of what is milled, as a share of the picture's. */
const EDGE = 1 / 50;

/** A milled part seen from above: its stock, and what the tools take from it, with one edge round all of it. */
function Plan({ box, of: { stock, ways } }: { readonly box: ViewBox; readonly of: MilledPlan }) {
  const [x, y, width, height] = stock ?? box;
  return (
    <svg {...{ x, y, width, height }} viewBox={`${x} ${y} ${width} ${height}`}>
      {stock && <rect className="part-section" {...{ x, y, width, height }} />}
      {[box[2] * EDGE, 0].map((edge) =>
        ways.map(({ d, wide }) => (
          <path
            key={`${edge} ${wide}`}
            className={edge > 0 ? "part-milled edge" : "part-milled"}
            d={d}
            strokeWidth={wide + edge}
          />
        )),
      )}
    </svg>
  );
}

/** Half section of a finished part inside its blank, or a milled part. Decorative, since the name is next to it. */
export function PartPicture({ of }: { readonly of: Thumbnail | undefined }) {
  return (
    <svg className="part-picture" viewBox={(of?.box ?? [0, 0, 1, 1]).join(" ")} aria-hidden="true" focusable="false">
      {of?.milled && <Plan box={of.box} of={of.milled} />}
      {of && !of.milled && (
        <>
          <path className="part-blank" d={of.blank} />
          <path className="part-section" d={of.part} />
          <path className="part-outside" d={of.part} transform="scale(1 -1)" />
          <path className="part-axis" d={`M${of.box[0]} 0H${of.box[0] + of.box[2]}`} />
        </>
      )}
    </svg>
  );
}
