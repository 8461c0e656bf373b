import type { Program } from "../../nc/program.ts";
import { wordsOf } from "../blocks/flow.ts";
import type { NcOutput } from "../machine/nc-output.ts";
import { KEPT_ON } from "./operations.ts";

const [SPINDLE = { on: [], off: [] }] = KEPT_ON;
/** The turning spindle of the manual has functions of its own from here on. */
const FIRST_OF_TURNING = 300;

/** Output for blocks that join a program: the spindle is started and stopped as the program does it already. */
export function outputIn({ blocks }: Program, otherwise: NcOutput): NcOutput {
  const used = blocks.flatMap(({ statement }) => wordsOf(statement)?.functions ?? []);
  const spindleOn = used.find((m) => SPINDLE.on.includes(m));
  if (spindleOn === undefined) return otherwise;
  const usual = spindleOn > FIRST_OF_TURNING ? 305 : 5;
  return { ...otherwise, spindleOn, spindleOff: used.find((m) => SPINDLE.off.includes(m)) ?? usual };
}
