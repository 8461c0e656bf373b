import type { Cycle } from "../../cycles/define.ts";
import type { SomeValues } from "../../cycles/effect.ts";
import type { Param, Topic } from "../../cycles/params.ts";
import { cutLength, isBar, noseRadius } from "../../kernel/cutter/insert.ts";
import type { Spindle } from "../../kernel/time/step.ts";
import { speedAt, withinLimit } from "../../kernel/time/time.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { diameter, rounded, roundedDown, toRadius } from "../../kernel/units.ts";
import { ROUGH_RZ, rzByRule } from "../../sim/load/cusp.ts";
import { powerAt, type SpindleData } from "../../program/machine/machine-data.ts";
import type { CuttingTable, CutMaterial } from "../../program/tools/cutting-table.ts";
import {
  cuttingPower,
  depthForPower,
  EDGE_USED,
  FEED_OF_NOSE,
  feedForRz,
  heldDownTo,
  leadOf,
  USUAL_RZ,
} from "./formulas.ts";

/** The values of a cycle and their context, on which advice is based. */
export interface Advised {
  readonly cycle: Pick<Cycle, "params" | "group">;
  readonly values: SomeValues;
  readonly tool: Tool;
  readonly spindle: Spindle | null;
  readonly perRevolution: boolean;
  /** The infeed as divided, mm. */
  readonly depth: number;
  /** The smallest diameter that is cut, mm. */
  readonly smallest: number;
  /** The largest diameter, mm, where the spindle is slowest. */
  readonly largest: number;
  /** Data of the machine's spindle; null where not entered, then the cutting table applies. */
  readonly machine: SpindleData | null;
  readonly material: CutMaterial;
  readonly table: CuttingTable;
}

interface AdviceData {
  /** The depth of cut uses too much of the cutting edge. */
  readonly depthOverEdge: { readonly depth: number; readonly edge: number; readonly most: number };
  readonly feedOverNose: { readonly feed: number; readonly nose: number; readonly most: number };
  /** µm */
  readonly rough: { readonly rz: number; readonly feed: number; readonly nose: number; readonly wanted: number };
  /** kW */
  readonly power: { readonly power: number; readonly most: number; readonly speed: number };
  /**
   * Below this diameter the speed limit ends the constant cutting speed; `left`: cutting speed at the smallest
   * diameter.
   */
  readonly speedLimited: {
    readonly limit: number;
    readonly heldTo: number;
    readonly smallest: number;
    readonly left: number;
  };
  readonly noLimit: { readonly speed: number };
  readonly speedFar: { readonly speed: number; readonly usual: number };
}
export type AdviceCode = keyof AdviceData;

/** One piece of advice. `at`: its Q parameter, or the spindle; `better`: a recommended value. */
export type Advice = {
  [C in AdviceCode]: {
    readonly code: C;
    readonly at: string;
    readonly data: AdviceData[C];
    readonly better: number | null;
  };
}[AdviceCode];

/** Value of `at` for advice on the spindle. */
export const SPINDLE = "spindle";
/** Deviation factor from the recommended cutting speed that gives advice. */
const FAR = 1.6;

const qOf = ({ params }: Advised["cycle"], topic: Topic): string | null =>
  Object.entries<Param>(params).find(([, { shown }]) => shown === topic)?.[0] ?? null;
const positive = (value: number | "auto" | undefined): value is number => typeof value === "number" && value > 0;

function ofEdge({ cycle, tool, depth, values }: Advised): readonly Advice[] {
  const at = qOf(cycle, "infeed"),
    edge = cutLength(tool);
  if (at === null || edge === undefined || isBar(tool) || !positive(values[at])) return [];
  const most = edge * EDGE_USED;
  return depth > most ? [{ code: "depthOverEdge", at, data: { depth, edge, most }, better: roundedDown(most) }] : [];
}

function ofFeed({ cycle, tool, values, perRevolution }: Advised): readonly Advice[] {
  const at = qOf(cycle, "roughingFeed"),
    nose = noseRadius(tool),
    feed = at === null ? undefined : values[at];
  if (at === null || !perRevolution || isBar(tool) || nose === 0 || !positive(feed)) return [];
  const most = nose * FEED_OF_NOSE;
  return feed > most ? [{ code: "feedOverNose", at, data: { feed, nose, most }, better: roundedDown(most) }] : [];
}

function ofSurface({ cycle, tool, values, perRevolution }: Advised): readonly Advice[] {
  const at = qOf(cycle, "finishingFeed"),
    nose = noseRadius(tool),
    feed = at === null ? undefined : values[at];
  if (at === null || !perRevolution || isBar(tool) || nose === 0 || !positive(feed)) return [];
  const rz = rzByRule(feed, nose);
  if (rz <= ROUGH_RZ) return [];
  return [
    {
      code: "rough",
      at,
      data: { rz, feed, nose, wanted: USUAL_RZ },
      better: Number(feedForRz(USUAL_RZ, nose).toFixed(2)),
    },
  ];
}

function ofPower(asked: Advised): readonly Advice[] {
  const { cycle, tool, spindle, values, perRevolution, material, table, depth, machine, largest } = asked;
  const at = qOf(cycle, "infeed"),
    feedAt = qOf(cycle, "roughingFeed"),
    feed = feedAt === null ? undefined : values[feedAt];
  if (at === null || !perRevolution || spindle?.kind !== "surface" || !positive(feed) || cycle.group === "thread")
    return [];
  const lead = leadOf(tool),
    speed = spindle.cuttingSpeed;
  const power = cuttingPower(material, depth, feed, speed, lead);
  const slowest = machine && speedAt(withinLimit(spindle, machine.most), toRadius(diameter(largest)));
  const most = (machine && slowest !== null ? powerAt(machine, slowest) : null) ?? table.power;
  if (power <= most) return [];
  const better = roundedDown(depthForPower(material, most, feed, speed, lead));
  return [{ code: "power", at, data: { power, most, speed }, better }];
}

function ofSpindle({ spindle, smallest, material }: Advised): readonly Advice[] {
  if (spindle?.kind !== "surface") return [];
  const { cuttingSpeed: speed, limit } = spindle;
  const far = speed > material.roughSpeed * FAR || speed * FAR < material.roughSpeed;
  const held = limit > 0 ? heldDownTo(speed, limit) : 0;
  return [
    ...(far
      ? [
          {
            code: "speedFar",
            at: SPINDLE,
            data: { speed, usual: material.roughSpeed },
            better: material.roughSpeed,
          } as const,
        ]
      : []),
    ...(limit > 0 ? [] : [{ code: "noLimit", at: SPINDLE, data: { speed }, better: null } as const]),
    ...(smallest < held
      ? [
          {
            code: "speedLimited",
            at: SPINDLE,
            data: { limit, heldTo: rounded(held), smallest, left: (speed * smallest) / held },
            better: null,
          } as const,
        ]
      : []),
  ];
}

/** Advice on risky values of a cycle, by rules of thumb: never more than a remark. */
export const advise = (asked: Advised): readonly Advice[] =>
  [ofEdge, ofFeed, ofSurface, ofPower, ofSpindle].flatMap((rule) => rule(asked));
