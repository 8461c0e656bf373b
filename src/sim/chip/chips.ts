import type { Step } from "../../kernel/time/step.ts";
import type { SpindleFrom } from "../load/spindles.ts";
import { outlinesOf } from "../outlines.ts";
import type { PlayPosition } from "../simulation.ts";
import type { Player } from "../stock.ts";
import { chipAt, type Chip } from "./chip.ts";

/** Returns the chip at any moment of a run. The last chip is cached, since view and readout ask for the same one. */
export function chipsOf(
  steps: readonly Step[],
  spindles: readonly SpindleFrom[],
  { before }: Player,
): (position: PlayPosition) => Chip | null {
  const outlines = outlinesOf();
  const work = { steps, spindles, before, outlineOf: (tool: Step["tool"]) => outlines(tool).insert };
  let asked: PlayPosition = { step: -1, fraction: 0 },
    chip: Chip | null = null;
  return (position) => {
    if (position.step !== asked.step || position.fraction !== asked.fraction)
      [asked, chip] = [position, chipAt(work, position)];
    return chip;
  };
}
