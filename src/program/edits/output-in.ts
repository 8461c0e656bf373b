import type { Program } from "../../nc/program.ts";
import { wordsOf } from "../blocks/flow.ts";
import type { NcOutput } from "../machine/nc-output.ts";
import { KEPT_ON } from "./operations.ts";

const [SPINDLE = { on: [], off: [] }] = KEPT_ON;
/** From here on, M functions of the manual's turning spindle. */
const FIRST_OF_TURNING = 300;

/** Output settings for blocks added to a program: its own spindle functions. */
export function outputIn({ blocks }: Program, otherwise: NcOutput): NcOutput {
  const used = blocks.flatMap(({ statement }) => wordsOf(statement)?.functions ?? []);
  const spindleOn = used.find((m) => SPINDLE.on.includes(m));
  if (spindleOn === undefined) return otherwise;
  const usual = spindleOn > FIRST_OF_TURNING ? 305 : 5;
  return { ...otherwise, spindleOn, spindleOff: used.find((m) => SPINDLE.off.includes(m)) ?? usual };
}
