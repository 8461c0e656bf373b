import { useId, type ReactNode } from "react";
import type { Box } from "../../kernel/geometry/segments.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import type { Step } from "../../kernel/time/step.ts";
import { ringData, segmentData, stretchData } from "../../view/path.ts";
import type { Outcome } from "../../app/calculation/outcome.ts";

/** Hatch lines across a picture. */
const HATCHES = 42;

interface Props {
  readonly outcome: Outcome;
  readonly box: Box;
  /** The stock at the moment. */
  readonly stock: readonly Ring[];
  readonly steps: readonly Step[];
  /** Accessible name. */
  readonly name: string;
  /** Overlay in part space with X upwards, mm. */
  readonly children?: ReactNode;
}

/** A small section of the work: stock, contour, and tool paths. */
export function CutPicture({ outcome: { run, simulation }, box, stock, steps, name, children }: Props) {
  const id = useId();
  const low = Math.max(box.low, Math.min(0, -(box.high - box.low) / 50));
  const [width, height] = [box.right - box.left, box.high - low];
  const size = Math.max(width, height) / HATCHES;
  const of = (holds: (step: Step) => boolean) => stretchData(steps.filter(holds));
  const pattern = (kind: string, turn: number) => (
    <pattern
      id={`${id}${kind}`}
      width={size}
      height={size}
      patternUnits="userSpaceOnUse"
      patternTransform={`rotate(${turn})`}
    >
      <rect className={`cut-ground-${kind}`} width={size} height={size} />
      <path className={`cut-hatch-${kind}`} d={`M0 0V${size}`} strokeWidth={size / 4} />
    </pattern>
  );
  return (
    <svg className="cut-picture" role="img" aria-label={name} viewBox={`${box.left} ${-box.high} ${width} ${height}`}>
      <defs>
        {pattern("part", 45)} {pattern("residue", -45)}
      </defs>
      <g transform="scale(1 -1)">
        <path className="cut-stock" d={ringData(stock)} fill={`url(#${id}part)`} />
        <path
          className="cut-residue"
          d={ringData(simulation.proof.residual.map(({ ring }) => ring))}
          fill={`url(#${id}residue)`}
        />
        <path className="cut-blank" d={ringData(run.blank)} />
        <path className="cut-axis" d={`M${box.left} 0H${box.right}`} />
        <path className="cut-rapid" d={of(({ move }) => move.kind === "rapid")} />
        <path className="cut-feed" d={of(({ move }) => move.kind !== "rapid" && move.run !== "finish")} />
        <path className="cut-finish" d={of(({ move }) => move.kind !== "rapid" && move.run === "finish")} />
        {run.operations.map(({ plan }, i) => (
          <path key={i} className="cut-contour" d={segmentData(plan.contour)} />
        ))}
        {children}
      </g>
    </svg>
  );
}
