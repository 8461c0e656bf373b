import { memo } from "react";
import { PATH_ROLES, type Shape } from "../../../view/scene.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { pageLength } from "../../base/unit.ts";

/** Meaning of lines, holder and clamping, for those that are shown, and of the letters at a chip. */
export const Legend = memo(function Legend({
  shapes,
  holder,
  clamping,
}: {
  readonly shapes: readonly Shape[];
  /** A moving tool has a holder. */
  readonly holder: boolean;
  /** Clamping as stated, or as a plane if unstated; null: no clamping. */
  readonly clamping: "stated" | "unstated" | null;
}) {
  const t = useTexts().lathe,
    there = PATH_ROLES.filter((role) => shapes.some((shape) => shape.role === role));
  const areas = [
    ...(holder ? [["shape-holder", t.holder]] : []),
    ...(clamping ? [[`held-${clamping}`, t.held[clamping]]] : []),
  ];
  return (
    <div className="lathe-told">
      <ul className="lathe-legend small" aria-label={t.legend}>
        {there.map((role) => (
          <li key={role}>
            <svg width={pageLength(26)} height={pageLength(8)} viewBox="0 0 26 8" aria-hidden="true">
              <path className={`shape-${role}`} d="M1 4H25" />
            </svg>
            {t.lines[role]}
          </li>
        ))}
        {areas.map(([name, said]) => (
          <li key={name}>
            <svg width={pageLength(26)} height={pageLength(10)} viewBox="0 0 26 10" aria-hidden="true">
              <path
                className={name}
                d={name === "held-unstated" ? "M16 0V10M16 3L12 7M16 7L13 10M16 -1L12 3" : "M6 1H20V9H6Z"}
              />
            </svg>
            {said}
          </li>
        ))}
      </ul>
      <dl className="lathe-letters small soft">
        {Object.entries(t.chip).map(([letter, means]) => (
          <div key={letter}>
            <dt className="number">{letter}</dt>
            <dd>{means}</dd>
          </div>
        ))}
      </dl>
    </div>
  );
});
