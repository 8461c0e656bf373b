import { memo, type ReactNode } from "react";
import { px, type Mark } from "../../../view/help/marks.ts";
import { classOf } from "../../../view/help/svg.ts";

interface Props {
  readonly marks: readonly Mark[];
  /** Prefix that makes ids of hatches and clips unique. */
  readonly id: string;
}

/** The hatches of the part (45°) and of the cut material (135°). */
export function Hatches({ id }: { readonly id: string }) {
  return (
    <defs>
      <pattern id={`${id}part`} width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
        <rect className="hatch-ground" width="7" height="7" />
        <path className="hatch-part" d="M0.5 0V7" />
      </pattern>
      <pattern id={`${id}cut`} width="5" height="5" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)">
        <rect className="hatch-ground" width="5" height="5" />
        <path className="hatch-cut" d="M0.5 0V5" />
      </pattern>
    </defs>
  );
}

/** The display list of a help picture as SVG elements, in order. */
export const HelpMarks = memo(function HelpMarks({ marks, id }: Props): ReactNode {
  return marks.map((m, i) => {
    const own = { className: classOf(m), ...(m.q ? { "data-q": m.q } : {}) };
    switch (m.kind) {
      case "area":
        return (
          <path
            key={i}
            {...own}
            d={m.d}
            {...(m.fill === "part" || m.fill === "cut" ? { style: { fill: `url(#${id}${m.fill})` } } : {})}
          />
        );
      case "line":
        return <path key={i} {...own} d={m.d} />;
      case "text":
        return (
          <text
            key={i}
            {...own}
            x={px(m.place.x)}
            y={px(m.place.y)}
            fontSize={m.size}
            {...(m.turn === 0 ? {} : { transform: `rotate(${m.turn} ${px(m.place.x)} ${px(m.place.y)})` })}
            {...(m.underlined ? { textDecoration: "underline" } : {})}
          >
            {m.text}
          </text>
        );
      case "detail":
        return (
          <g key={i}>
            <clipPath id={`${id}lens`}>
              <circle cx={m.centre.x} cy={m.centre.y} r={m.radius} />
            </clipPath>
            <g clipPath={`url(#${id}lens)`}>
              <HelpMarks marks={m.marks} id={id} />
            </g>
          </g>
        );
    }
  });
});
