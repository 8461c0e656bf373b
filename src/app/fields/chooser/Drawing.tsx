import { PICTOGRAM, type Pictogram } from "../../../view/pictogram-box.ts";

/** Stripe patterns for the cutting direction, defined once on the page and referenced by name. */
const STRIPES: Readonly<Record<Pictogram["passes"], string>> = {
  along: "M0 2H6",
  across: "M2 0V6",
  sinking: "M0 0L3 3L6 0M0 6L3 3",
  profile: "",
};

/** Small section drawing of a cycle. Decorative, since the name is next to it. */
export function Drawing({
  of,
  id,
  turned = false,
}: {
  readonly of: Pictogram | undefined;
  readonly id: string;
  readonly turned?: boolean;
}) {
  const { width, height, axis } = PICTOGRAM;
  const stripes = `stripes-${id}`;
  return (
    <svg className="pictogram" viewBox={`0 0 ${width} ${height}`} aria-hidden="true" focusable="false">
      {of && (
        <>
          <pattern
            id={stripes}
            width="6"
            height="4"
            patternUnits="userSpaceOnUse"
            viewBox="0 0 6 4"
            patternTransform={turned ? "rotate(90)" : undefined}
          >
            <path className="pictogram-pass" d={STRIPES[of.passes]} />
          </pattern>
          <path className="pictogram-cut" d={of.cut} />
          <path fill={`url(#${stripes})`} d={of.cut} />
          <path className="pictogram-body" d={of.body} />
          <path className="pictogram-contour" d={of.contour} />
        </>
      )}
      {!of && <path className="pictogram-contour" d="M10 38V12M10 38H52M6 17L10 10L14 17M46 34L54 38L46 42" />}
      <path className="pictogram-axis" d={`M1 ${axis}H${width - 1}`} />
    </svg>
  );
}
