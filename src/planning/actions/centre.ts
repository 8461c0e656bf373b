import { areaOf } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { difference, intersection, opened } from "../../kernel/area/clip.ts";
import { centreDepth, centreProfile, mouthAt } from "../../kernel/cutter/centre-drill.ts";
import { pointAngleOf, pointLength } from "../../kernel/cutter/drill.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { CentreDrill, Tool } from "../../kernel/plan/tool.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import { diameter, radius, roundedUp, toDiameter, toRadius } from "../../kernel/units.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import type { Action, ActionSource, PlanRequest, PlanState } from "../types.ts";
import { boredTo, insideOf } from "./bore.ts";
import { drillsFor } from "./drill.ts";
import { drillsOf, onAxis } from "./on-axis.ts";

/** Stock in front of the face that is no reason to face first, mm. */
const FACED = 0.05;
/** A centre drill makes a hole that differs from it by so much of its area. */
const LIKE = 0.15;
/** Less is no cut into the part, mm² of the half plane. */
const LEAST = 0.01;

/** The half section of a centre hole from the front face. */
function holeOf(centre: CentreDrill, body: number, front: number): Ring {
  const depth = centreDepth(centre);
  const below = centreProfile(centre, body).filter(({ u }) => u < depth);
  const wall = below.map(({ u, v }) => at(front - depth + u, v));
  return [at(front, 0), at(front, toRadius(diameter(mouthAt(centre, body, depth)))), ...wall.toReversed()];
}

/** A twist drill is centred from this depth in diameters on, unless its point is as blunt as one that centres itself. */
const [CENTRED_FROM, SELF_CENTRING] = [4, 130];
/** The least mouth of a centre for it, in its diameters: its chisel edge goes into it. */
const LEAST_MOUTH = 0.4;

/** Whether a drilled hole begins with a centre: a long drill with a sharp point wanders on a turned face. */
function isCentred({ tool, place }: Action): boolean {
  const r = tool.R ?? 0;
  const isLong = place.front - place.rear >= CENTRED_FROM * toDiameter(radius(r));
  return isLong && pointAngleOf(r, pointLength(tool)) < SELF_CENTRING;
}

/** A centre drill, with the half section of what it cuts from the front face. */
interface Centring {
  readonly tool: Tool;
  readonly centre: CentreDrill;
  readonly hole: Ring;
}

/** For the largest drill, where it is long, the smallest centre that leads it and that it drills away; own tools first. */
function beforeDrill(all: readonly Centring[], { stock }: PlanState, request: PlanRequest): readonly Centring[] {
  const [drill] = drillsFor(stock, request);
  if (!drill || !isCentred(drill)) return [];
  const { high } = drill.place;
  const isUsual = ({ tool }: Centring) => Number(request.usualTools?.includes(tool.T) ?? false);
  const mouth = ({ hole }: Centring) => boxAround([hole]).high;
  return all
    .filter((c) => mouth(c) >= LEAST_MOUTH * high && mouth(c) <= high)
    .toSorted((a, b) => isUsual(a) - isUsual(b) || mouth(a) - mouth(b) || a.tool.T - b.tool.T)
    .slice(0, 1);
}

/** Drills a centre hole: with the drill of its form where the inside of the part is one, and in front of a long drill. */
export const centre: ActionSource = {
  kind: "centre",
  actions(state, request) {
    const { stock } = state;
    const inside = insideOf(request.part);
    const front = frontOf(stock);
    if (!inside || front > boxAround([inside]).right + FACED) return [];
    const wanted = areaOf(opened([inside], SLIVER));
    const all = drillsOf(request).flatMap((tool: Tool & { readonly centre?: CentreDrill }) =>
      tool.centre ? [{ tool, centre: tool.centre, hole: holeOf(tool.centre, tool.R ?? 0, front) }] : [],
    );
    const isOpen = (hole: Ring, area: number) => areaOf(intersection(stock, [hole])) > LIKE * area;
    const ofPart = all.filter(({ hole }) => {
      const isLike = areaOf(intersection([hole], [inside])) > (1 - LIKE) * wanted;
      return isLike && isOpen(hole, wanted) && areaOf(opened(difference([hole], [inside]), SLIVER)) <= LEAST;
    });
    const isSolid = boredTo(stock) > front - FACED;
    const chosen = ofPart.length > 0 || !isSolid ? ofPart : beforeDrill(all, state, request);
    return chosen.flatMap(({ tool, centre: form, hole }): readonly Action[] => {
      const depth = roundedUp(centreDepth(form));
      const made = onAxis("centre", tool, depth, stock, request);
      const { high } = boxAround([hole]);
      const place = { front, rear: front - depth, high, low: 0 };
      return made
        ? [{ ...made, kind: "centre", key: `centre T${tool.T}`, site: "inside", tool, place, threads: [] }]
        : [];
    });
  },
};
