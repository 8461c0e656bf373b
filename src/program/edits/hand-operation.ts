import { centreDepth } from "../../kernel/cutter/centre-drill.ts";
import { cuttingWidth, noseRadius, tipDirection } from "../../kernel/cutter/insert.ts";
import type { CentreHole, Tool } from "../../kernel/plan/tool.ts";
import { radius, rounded, roundedUp, toDiameter } from "../../kernel/units.ts";
import type { Statement } from "../../nc/statement.ts";
import { noWords, type AxisWord, type CycleParameter, type Words } from "../../nc/words.ts";
import type { Ring } from "../../kernel/geometry/point.ts";
import { frontOf, startOnSurface, type StockSurface } from "../job/stock-surface.ts";
import { positionAsTyped } from "../values/typed-value.ts";

/** Operations on the axis, with a tool of the milling table. */
const AXIS_WORKS = ["centre", "drill", "peck", "ream", "tap"] as const;
export type AxisWork = (typeof AXIS_WORKS)[number];
/** Operations without a turning cycle: by path blocks, or with a drilling cycle on the axis. */
export const HAND_WORKS = ["chamfer", "partOff", "partOffChamfered", ...AXIS_WORKS] as const;
export type HandWork = (typeof HAND_WORKS)[number];

/** Sizes that only the drawing knows: of a chamfer, and the Z of the rear face. */
export type HandSize = "size" | "z";

export const sizesOf = (work: HandWork): readonly HandSize[] => {
  if (work === "chamfer") return ["size"];
  if (work === "partOff") return ["z"];
  return work === "partOffChamfered" ? ["z", "size"] : [];
};

export const isOnAxis = (work: HandWork): work is AxisWork => AXIS_WORKS.some((each) => each === work);

/** Radial depth of a cut through the stock, from its surface to the axis or through the wall of its bore, mm. */
export const wallOf = (stock: readonly Ring[], { from }: StockSurface): number =>
  from.r - Math.min(...stock.flat().map(({ r }) => r));

/** Side and depth of an operation, and the centre hole that it makes. */
export interface Needed {
  readonly isInside: boolean;
  readonly depth: number;
  readonly hole?: CentreHole | null;
}

/** Whether a tool can do it, on this side and to this depth. */
export function canDo(work: HandWork, tool: Tool, { isInside, depth, hole }: Needed): boolean {
  const { u, v } = tipDirection(tool.TO);
  switch (work) {
    case "drill":
    case "peck":
      return tool.TYPE === "DRILL" || (tool.TYPE === "CENTER" && !tool.centre);
    case "ream":
      return tool.TYPE === "REAM";
    case "centre":
      return tool.centre?.hole.form === hole?.form && tool.centre?.hole.d1 === hole?.d1 && hole !== undefined;
    case "tap":
      return tool.TYPE === "TAP";
    case "chamfer":
      return (tool.TYPE === "ROUGH" || tool.TYPE === "FINISH") && u < 0 && (isInside ? v > 0 : v < 0);
    default:
      return (tool.TYPE === "RECESS" || tool.TYPE === "RECTURN") && v < 0 && (tool.CUTLENGTH ?? Infinity) >= depth;
  }
}

/** Lead-in and lead-out beyond an edge, clearance beside a surface, and overlap into a bore, mm. */
const LEAD = 1;
const CLEARANCE = 2;
const OVER_BORE = 1;
/** Feeds, mm/rev. */
const FEED = { chamfer: 0.12, partOff: 0.06, drill: 0.12, centre: 0.05, ream: 0.2 };
/** A nose radius lies off the theoretical corner: a 45° path moves by this share of the radius along either axis. */
const NOSE = 2 - Math.SQRT2;

interface HandContext {
  readonly stock: readonly Ring[];
  readonly surface: StockSurface;
  readonly tool: Tool;
  readonly sizes: Readonly<Record<HandSize, number>>;
  /** Feed of the cut, mm/rev; absent: the usual one. */
  readonly feed?: number;
}

/** Start point and path blocks of an operation. */
export interface HandCut {
  readonly start: { readonly x: string; readonly z: string };
  readonly cut: readonly Statement[];
}

function line(x: number | null, z: number | null, feed: number | "max"): Statement {
  const word = (axis: "X" | "Z", value: number | null): AxisWord[] =>
    value === null ? [] : [{ axis, value: rounded(value), incremental: false }];
  const words: Partial<Words> = {
    axes: [...word("X", x), ...word("Z", z)],
    feed: feed === "max" ? "max" : { value: feed, unit: "F" },
  };
  return { kind: "path", path: "L", words: { ...noWords, ...words } };
}

const startAt = (x: number, z: number) => ({ x: positionAsTyped(rounded(x)), z: positionAsTyped(rounded(z)) });
const acrossOf = (r: number) => toDiameter(radius(r));

/** A chamfer of 45° at the front edge of a cylinder or a bore. */
function chamfer({ stock, surface, tool, sizes }: HandContext): HandCut {
  const out = surface.site === "inside" ? -1 : 1;
  const [d, front] = [acrossOf(surface.from.r), startOnSurface(surface, stock)];
  const leg = sizes.size + NOSE * noseRadius(tool);
  const begin = d - 2 * out * (leg + LEAD);
  return {
    start: startAt(begin, Math.max(front, frontOf(stock)) + CLEARANCE),
    cut: [
      line(null, front + LEAD, "max"),
      line(d + 2 * out * LEAD, front - leg - LEAD, FEED.chamfer),
      line(null, Math.max(front, frontOf(stock)) + CLEARANCE, "max"),
    ],
  };
}

/** Cuts the part off behind its rear face; a chamfer at its rear edge is cut before the part comes loose. */
function partOff({ stock, surface, tool, sizes, feed = FEED.partOff }: HandContext, isChamfered: boolean): HandCut {
  const d = acrossOf(surface.from.r);
  const clear = d + 2 * CLEARANCE;
  // The right-hand corner of the insert makes the rear face.
  const half = cuttingWidth(tool) / 2;
  const z = sizes.z - half + tipDirection(tool.TO).u * half;
  const low = Math.min(...stock.flat().map(({ r }) => r));
  const end = low > 0 ? Math.max(0, acrossOf(low) - 2 * OVER_BORE) : 0;
  const leg = sizes.size + NOSE * noseRadius(tool);
  const edge: readonly Statement[] = isChamfered
    ? [
        line(d - 2 * (leg + LEAD), null, feed),
        line(clear, null, "max"),
        line(null, z + leg + CLEARANCE, "max"),
        line(d - 2 * leg, z, feed),
      ]
    : [];
  return { start: startAt(clear, z), cut: [...edge, line(end, null, feed), line(clear, null, "max")] };
}

/** A parameter of a drilling cycle as the control labels it; an open one has no value. */
const parameter = (q: string, value: number | null, label: string): CycleParameter => ({ q, value, label });

const CLEAR = parameter("Q200", CLEARANCE, "SET-UP CLEARANCE");
const AWAY = parameter("Q204", 50, "2ND SET-UP CLEARANCE");
const REST = parameter("Q211", 0, "DWELL TIME AT DEPTH");
const plunge = (feed: number) => parameter("Q206", feed, "FEED RATE FOR PLNGNG");

/** A feed that a drilling cycle takes as rapid. */
const RAPID = 99_999;

/** What a drilling cycle is made from: prompts that it shares with others, and its tool. */
interface AxisPrompts {
  readonly depth: CycleParameter;
  readonly surface: CycleParameter;
  readonly tool: Tool;
}
interface AxisCycle {
  readonly number: number;
  readonly name: string;
  readonly parameters: (prompts: AxisPrompts) => readonly CycleParameter[];
}

/**
 * The drilling cycles, in the order in which a control writes their parameters. Reaming and pecking: as the posts of CAM
 * systems for this control write them (decision 0003).
 */
const AXIS_CYCLES: Readonly<Record<AxisWork, AxisCycle>> = {
  centre: {
    number: 240,
    name: "CENTERING",
    parameters: ({ depth, surface }) => [
      CLEAR,
      // A pilot precedes the cone: the depth is given, not the diameter.
      parameter("Q343", 0, "SELECT DIA./DEPTH"),
      depth,
      parameter("Q344", 0, "DIAMETER"),
      plunge(FEED.centre),
      REST,
      surface,
      AWAY,
    ],
  },
  drill: {
    number: 200,
    name: "DRILLING",
    parameters: ({ depth, surface }) => [
      CLEAR,
      depth,
      plunge(FEED.drill),
      parameter("Q202", 5, "PLUNGING DEPTH"),
      parameter("Q210", 0, "DWELL TIME AT TOP"),
      surface,
      AWAY,
      REST,
    ],
  },
  peck: {
    number: 205,
    name: "UNIVERSAL PECKING",
    parameters: ({ depth, surface }) => [
      CLEAR,
      depth,
      plunge(FEED.drill),
      parameter("Q202", 5, "PLUNGING DEPTH"),
      surface,
      AWAY,
      parameter("Q212", 0, "DECREMENT"),
      parameter("Q205", 0, "MIN. PLUNGING DEPTH"),
      parameter("Q258", 0.5, "UPPER ADV STOP DIST"),
      parameter("Q259", 1, "LOWER ADV STOP DIST"),
      parameter("Q257", 0, "DEPTH FOR CHIP BRKNG"),
      parameter("Q256", 0.2, "DIST FOR CHIP BRKNG"),
      REST,
      parameter("Q379", 0, "STARTING POINT"),
      parameter("Q253", 750, "F PRE-POSITIONING"),
      parameter("Q208", RAPID, "RETRACTION FEED RATE"),
      parameter("Q395", 0, "DEPTH REFERENCE"),
    ],
  },
  ream: {
    number: 201,
    name: "REAMING",
    parameters: ({ depth, surface }) => [
      CLEAR,
      depth,
      plunge(FEED.ream),
      REST,
      // 0: back at the feed of the cut, with the spindle turning on.
      parameter("Q208", 0, "RETRACTION FEED RATE"),
      surface,
      AWAY,
    ],
  },
  tap: {
    number: 207,
    name: "RIGID TAPPING NEW",
    parameters: ({ depth, surface, tool }) => [
      CLEAR,
      { ...depth, label: "DEPTH OF THREAD" },
      parameter("Q239", tool.PITCH ?? null, "THREAD PITCH"),
      surface,
      AWAY,
    ],
  },
};

/** A drilling cycle on the axis; depth and pitch stay open where the tool does not know them. */
function onAxis(work: AxisWork, { stock, tool }: HandContext): HandCut {
  const front = frontOf(stock);
  const surface = parameter("Q203", Math.min(0, front), "SURFACE COORDINATE");
  const depth = parameter("Q201", tool.centre ? -roundedUp(centreDepth(tool.centre)) : null, "DEPTH");
  const { number, name, parameters } = AXIS_CYCLES[work];
  return {
    start: startAt(0, front + CLEARANCE),
    cut: [
      { kind: "cycle", cycle: number, name, parameters: parameters({ depth, surface, tool }) },
      { kind: "cycleCall", how: "", words: noWords },
    ],
  };
}

/** The path of an operation without a turning cycle. */
export function handCut(work: HandWork, context: HandContext): HandCut {
  if (isOnAxis(work)) return onAxis(work, context);
  return work === "chamfer" ? chamfer(context) : partOff(context, work === "partOffChamfered");
}

/** Cutting speeds of drills, reamers and taps, m/min. */
const ON_AXIS = { centre: 25, drill: 60, peck: 60, ream: 12, tap: 12 };

/** Speed of a tool on the axis, rpm: it cuts at its own diameter. */
export function speedOnAxis(work: AxisWork, tool: Tool): number {
  const across = Math.max(1, tool.centre?.hole.d2 ?? toDiameter(radius(tool.R ?? 0)));
  return Math.max(10, Math.round((100 * ON_AXIS[work]) / (Math.PI * across)) * 10);
}
