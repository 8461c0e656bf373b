import { memo } from "react";
import { PATH_ROLES, type Shape } from "../../view/scene.ts";
import { useTexts } from "../settings/use-texts.ts";

/** What lines, holder and chuck stand for: only those that are there. */
export const Legend = memo(function Legend({ shapes, holder, chuck }: {
  readonly shapes: readonly Shape[];
  /** A tool that moves has one. */
  readonly holder: boolean;
  /** One is drawn; nothing is known of that of the machine. */
  readonly chuck: boolean;
}) {
  const t = useTexts().lathe, there = PATH_ROLES.filter((role) => shapes.some((shape) => shape.role === role));
  if (there.length === 0 && !holder) return null;
  const areas = [...(holder ? [["shape-holder", t.holder]] : []), ...(chuck ? [["chuck-swatch", t.chuck]] : [])];
  return (
    <ul className="lathe-legend small" aria-label={t.legend}>
      {there.map((role) => (
        <li key={role}>
          <svg width="26" height="8" aria-hidden="true">
            <path className={`shape-${role}`} d="M1 4H25" />
          </svg>
          {t.lines[role]}
        </li>
      ))}
      {areas.map(([name, said]) => (
        <li key={name}>
          <svg width="26" height="10" aria-hidden="true">
            <path className={name} d="M6 1H20V9H6Z" />
          </svg>
          {said}
        </li>
      ))}
    </ul>
  );
});
