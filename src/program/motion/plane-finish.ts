import { approach, type Approach, type ApproachRequest } from "../../kernel/plane/approach.ts";
import { checkApproach } from "../../kernel/plane/approach-check.ts";
import { issue, type Issue } from "../../kernel/plan/issue.ts";
import { plane, towardsTool, type PlanePoint, type PlaneSegment, type Side } from "../../kernel/plane/plane.ts";
import { planeContour, type PlaneContour } from "../../kernel/plane/plane-contour.ts";
import { ROUND, SAME } from "../../kernel/tolerance.ts";
import { radius, toDiameter } from "../../kernel/units.ts";
import type { Statement } from "../../nc/statement.ts";
import { NO_TRANSFORM } from "../tools/coordinates-frame.ts";
import { programIssue } from "../state/issue.ts";
import type { Carrier } from "./carrier.ts";
import type { ApproachCall, CompensatedChain, Travel } from "../state/plane-chain.ts";
import { sayPathCut } from "./plane-waist.ts";
import { frameOf } from "./transform-blocks.ts";

const { apart, beyond, difference, direction, sum } = plane;

/** Runs one chain and tracks the tool centre. */
class Finishing {
  constructor(
    readonly carrier: Carrier,
    readonly chain: CompensatedChain,
    public centre: PlanePoint | null,
  ) {}

  /** Moves the centre along a path; a gap is closed with a straight line. */
  go(s: PlaneSegment, travel: Travel): void {
    if (this.centre && apart(this.centre, s.from) > SAME)
      this.run({ kind: "line", from: this.centre, to: s.from }, { ...travel, toZ: travel.fromZ });
    this.run(s, travel);
  }

  /** Runs the elements in order, without compensation. */
  asProgrammed(): void {
    for (const t of this.chain.lifts) this.lift(t);
    for (const item of this.chain.items) {
      this.go(item.segment, item);
      for (const t of item.lifts) this.lift(t);
    }
  }

  private run(s: PlaneSegment, travel: Travel): void {
    const { tip } = this.carrier;
    this.carrier.emit(tip.x === 0 && tip.y === 0 ? s : plane.shifted(s, tip), travel);
    this.centre = s.to;
  }

  /** Moves in the tool axis alone. */
  lift(travel: Travel): void {
    if (this.centre && travel.fromZ !== travel.toZ)
      this.run({ kind: "line", from: this.centre, to: this.centre }, travel);
  }
}

const shifted = (points: Approach["points"], by: PlanePoint): Approach["points"] =>
  Object.fromEntries(Object.entries(points).map(([name, p]) => [name, sum(p, by)]));

/** A point of the working plane in the form of issues. */
function placeOf(carrier: Carrier, p: PlanePoint): { x: number; y: number } | { x: number; z: number } {
  return carrier.plane === "XY" ? { x: p.x, y: p.y } : { x: toDiameter(radius(p.y)), z: p.x };
}

/** Finding of a check that the control does not make. */
function cutIssue(carrier: Carrier, q: ApproachRequest, guarded: NonNullable<ReturnType<typeof checkApproach>>): Issue {
  const common = {
    point: q.departing ? ("PN" as const) : ("PS" as const),
    depth: guarded.cut.depth,
    ...placeOf(carrier, guarded.cut.on),
  };
  const { free } = guarded;
  if (free?.kind === "point") {
    const to = placeOf(carrier, sum(free.point, carrier.tip));
    return issue(
      "approachCutsContour",
      "warning",
      { ...common, freeX: to.x, ...("y" in to ? { freeY: to.y } : { freeZ: to.z }) },
      "contour",
    );
  }
  if (free)
    return issue("approachValueCutsContour", "warning", { ...common, word: free.word, nearest: free.value }, free.word);
  return issue("approachBlocked", "warning", common, "contour");
}

/** Computes one APPR or DEP, reports it, and returns its legs with their travel in the tool axis. */
function lead(f: Finishing, call: ApproachCall, element: PlaneSegment, contour: PlaneContour): Approach {
  const { carrier } = f;
  const { machine } = carrier;
  const outside = call.departing ? call.target && difference(call.target, carrier.tip) : f.centre;
  const q: ApproachRequest = {
    shape: call.shape,
    departing: call.departing,
    side: f.chain.side,
    toolRadius: carrier.toolRadius,
    element,
    outside,
    ...call.words,
  };
  const made = approach(q);
  for (const found of made.issues) machine.log.report(found, call.index);
  const above = carrier.top !== null && call.fromZ !== null && call.fromZ >= carrier.top;
  const inPlaneFirst = (machine.shop.control ?? "TNC 640") === "TNC 640" && call.fromZ !== call.toZ;
  const segments = contour.contour.map((c) => c.segment);
  const guarded =
    !made.issues.some((i) => i.severity === "error") &&
    checkApproach(q, segments, above && inPlaneFirst && !call.departing ? "fromPH" : "all");
  if (guarded) machine.log.report(cutIssue(carrier, q, guarded), call.index);
  carrier.note({
    block: machine.log.numberOf(call.index) ?? 0,
    index: call.index,
    form: call.form,
    shape: call.shape,
    departing: call.departing,
    side: f.chain.side,
    plane: carrier.plane,
    points: shifted(made.points, carrier.tip),
    toolRadius: carrier.toolRadius,
    arc: made.arc && { ...made.arc, centre: sum(made.arc.centre, carrier.tip) },
    request: q,
    contour: segments,
    tip: carrier.tip,
    pole: call.pole,
    datum:
      carrier.plane === "XY"
        ? { x: machine.now.datum.x, y: machine.now.datum.y }
        : { x: machine.now.datum.z, y: machine.now.datum.x },
    transform: frameOf(machine.now)?.transform ?? NO_TRANSFORM,
    feedBefore: call.before,
    cut: guarded ? guarded.cut : null,
    free: guarded ? guarded.free : null,
  });
  return made;
}

/** Runs the legs of an approach. In the plane first and then in the axis, or in the plane and the axis at once. */
function runApproach(f: Finishing, call: ApproachCall, made: Approach, before: Travel["feed"]): void {
  const atOnce = f.carrier.machine.shop.control === "TNC7";
  const feedOf = (i: number) => (made.legs[i]?.feed === "before" ? before : call.feed);
  const toPH = made.points.PS ? 1 : 0;
  made.legs.forEach((leg, i) => {
    const isFirst = i < toPH;
    const travel = {
      ...call,
      feed: feedOf(i),
      fromZ: isFirst ? call.fromZ : call.toZ,
      toZ: isFirst && !atOnce ? call.fromZ : call.toZ,
    };
    f.go(leg.segment, travel);
    if (isFirst && !atOnce) f.lift({ ...call, feed: feedOf(i) });
  });
}

function runDeparture(f: Finishing, call: ApproachCall, made: Approach): void {
  const atOnce = f.carrier.machine.shop.control === "TNC7";
  const last = made.legs.length - 1;
  made.legs.forEach((leg, i) => f.go(leg.segment, { ...call, toZ: atOnce && i === last ? call.toZ : call.fromZ }));
  if (!atOnce || last < 0) f.lift(call);
}

/** Blocks allowed between an approach and its element. */
const BETWEEN: ReadonlySet<Statement["kind"]> = new Set(["empty", "comment", "structure", "assign"]);

/** Reports an approach or departure without an element; no fault where that element could not be solved. */
function sayAlone({ carrier: { machine } }: Finishing, form: string, index: number): void {
  const step = form.startsWith("APPR") ? 1 : -1;
  let i = index + step;
  while (BETWEEN.has(machine.peek(i)?.kind ?? "end")) i += step;
  const unknown = machine.peek(i)?.kind === "free" || machine.place.lostReason === "unproved";
  if (unknown) machine.log.leaveUnproved(form, index);
  else machine.log.report(programIssue("approachWithoutContour", "error", { form }), index);
}

/** Moves to the first element. */
function begin(f: Finishing, contour: PlaneContour, reference: PlaneSegment | undefined): void {
  const { start, side } = f.chain;
  if (start.kind === "line") {
    const corner = contour.contour[0] ? contour.contour[0].segment.from : start.to;
    const way = reference && direction(reference, contour.contour[0] ? reference.from : reference.to);
    const to = way ? beyond(corner, towardsTool(way, side), f.carrier.toolRadius) : start.to;
    if (!f.centre) f.carrier.arrive(sum(to, f.carrier.tip), start);
    f.go({ kind: "line", from: f.centre ?? to, to }, start);
  } else if (start.kind === "approach") {
    const { call } = start;
    if (reference) return runApproach(f, call, lead(f, call, reference, contour), start.before);
    sayAlone(f, `APPR ${call.form}`, call.index);
    const to = difference(call.target ?? f.centre ?? { x: 0, y: 0 }, f.carrier.tip);
    f.go({ kind: "line", from: f.centre ?? to, to }, call);
  }
}

/** The elements between, each in its own feed. */
function along(f: Finishing, contour: PlaneContour): void {
  f.chain.lifts.forEach((t) => f.lift(t));
  const byElement = new Map<number, (typeof contour.path)[number][]>();
  for (const p of contour.path) byElement.set(p.element, [...(byElement.get(p.element) ?? []), p]);
  f.chain.items.forEach((item, i) => {
    const own = byElement.get(i)?.filter((p) => !p.onCorner) ?? [];
    const onCorner = byElement.get(i)?.filter((p) => p.onCorner) ?? [];
    for (const p of own.filter((each) => each.part === "element")) f.go(p.segment, item);
    for (const t of item.lifts) f.lift(t);
    const flat = { ...item, fromZ: item.lifts.at(-1)?.toZ ?? item.toZ, toZ: item.lifts.at(-1)?.toZ ?? item.toZ };
    for (const p of own.filter((each) => each.part === "corner")) f.go(p.segment, flat);
    for (const p of onCorner)
      f.go(p.segment, {
        ...flat,
        feed: item.corner ? item.corner.feed : item.feed,
        index: item.corner?.index ?? item.index,
      });
  });
}

function sayIssues(carrier: Carrier, chain: CompensatedChain, contour: PlaneContour): void {
  for (const { issue: found, element, onCorner } of contour.issues) {
    const item = chain.items[element],
      own = contour.contour.find((c) => c.element === element && c.onCorner === onCorner);
    const seen =
      found.code === "toolRadiusTooLarge" && own && carrier.plane === "XY"
        ? { ...found, data: { ...found.data, ...plane.pointOn(own.segment, 1 / 2) } }
        : found;
    if (item) carrier.machine.log.report(seen, onCorner ? (item.corner?.index ?? item.index) : item.index);
  }
  const open = chain.items.at(-1)?.corner;
  if (open)
    carrier.machine.log.report(
      issue("cornerElementAlone", "error", { element: chain.items.length }, "contour"),
      open.index,
    );
}

/** A contour of one point takes the direction in which the tool arrived. */
function ownDirection(chain: CompensatedChain, here: PlanePoint | null): PlaneSegment | undefined {
  const { start } = chain;
  return start.kind === "line" && here && apart(here, start.to) > ROUND
    ? { kind: "line", from: here, to: start.to }
    : undefined;
}

const hasRadius = (side: Side) => side !== "none";

/** Neither compensation nor corners: nearly every element of a long program. */
const runsAsProgrammed = ({ side, start, items }: CompensatedChain) =>
  !hasRadius(side) && start.kind === "here" && items.every((i) => i.corner === undefined);

/** Runs a chain and its end; returns the final position of the programmed point. */
export function finishChain(
  carrier: Carrier,
  chain: CompensatedChain,
  here: PlanePoint | null,
  departure: ApproachCall | null,
): PlanePoint | null {
  const f = new Finishing(carrier, chain, here && difference(here, carrier.tip));
  if (runsAsProgrammed(chain) && !departure) {
    f.asProgrammed();
    return f.centre && sum(f.centre, carrier.tip);
  }
  const contour = planeContour(
    chain.items.map(({ segment, corner }) => ({ segment, ...(corner && { corner: corner.element }) })),
    chain.side,
    carrier.toolRadius,
  );
  sayIssues(carrier, chain, contour);
  sayPathCut(carrier, chain, contour);
  const single = ownDirection(chain, here);
  const first = contour.contour[0]?.segment ?? single;
  const last = contour.contour.at(-1)?.segment ?? single;
  if (chain.start.kind !== "here" || hasRadius(chain.side)) begin(f, contour, first);
  along(f, contour);
  if (departure && last) runDeparture(f, departure, lead(f, departure, last, contour));
  else if (departure) {
    sayAlone(f, `DEP ${departure.form}`, departure.index);
    if (f.centre && departure.target)
      f.go(
        { kind: "line", from: f.centre, to: difference(departure.target, carrier.tip) },
        { ...departure, toZ: departure.fromZ },
      );
    f.lift(departure);
  }
  return f.centre && sum(f.centre, carrier.tip);
}
