import { memo } from "react";
import { PATH_ROLES, type Shape } from "../../../view/scene.ts";
import { useTexts } from "../../base/settings/use-texts.ts";
import { Legend, LegendSign } from "./Legend.tsx";

/** Meaning of lines, holder and clamping, for those that are shown, and of the letters at a chip. */
export const TurnedLegend = memo(function TurnedLegend({
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
  return (
    <Legend
      lines={there.map((role) => [`shape-${role}`, t.lines[role]])}
      notes={
        <dl className="lathe-letters small soft">
          {Object.entries(t.chip).map(([letter, means]) => (
            <div key={letter}>
              <dt className="number">{letter}</dt>
              <dd>{means}</dd>
            </div>
          ))}
        </dl>
      }
    >
      {holder && (
        <LegendSign text={t.holder} height={10}>
          <path className="shape-holder" d="M6 1H20V9H6Z" />
        </LegendSign>
      )}
      {clamping && (
        <LegendSign text={t.held[clamping]} height={10}>
          <path
            className={`held-${clamping}`}
            d={clamping === "unstated" ? "M16 0V10M16 3L12 7M16 7L13 10M16 -1L12 3" : "M6 1H20V9H6Z"}
          />
        </LegendSign>
      )}
    </Legend>
  );
});
