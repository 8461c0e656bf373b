import { areaOf } from "../../kernel/area/area.ts";
import { boxAround } from "../../kernel/area/box.ts";
import { difference, intersection, opened } from "../../kernel/area/clip.ts";
import { centreDepth, centreProfile, mouthAt } from "../../kernel/cutter/centre-drill.ts";
import { at, type Ring } from "../../kernel/geometry/point.ts";
import type { CentreDrill, Tool } from "../../kernel/plan/tool.ts";
import { SLIVER } from "../../kernel/tolerance.ts";
import { diameter, roundedUp, toRadius } from "../../kernel/units.ts";
import { frontOf } from "../../program/job/stock-surface.ts";
import type { Action, ActionSource } from "../types.ts";
import { insideOf } from "./bore.ts";
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

/** Drills a centre hole with the drill of its form, where the inside of the part is one. */
export const centre: ActionSource = {
  kind: "centre",
  actions({ stock }, request) {
    const inside = insideOf(request.part);
    const front = frontOf(stock);
    if (!inside || front > boxAround([inside]).right + FACED) return [];
    const wanted = areaOf(opened([inside], SLIVER));
    return drillsOf(request).flatMap((tool: Tool & { readonly centre?: CentreDrill }): readonly Action[] => {
      if (!tool.centre) return [];
      const hole = [holeOf(tool.centre, tool.R ?? 0, front)];
      const isLike = areaOf(intersection(hole, [inside])) > (1 - LIKE) * wanted;
      const isOpen = areaOf(intersection(stock, hole)) > LIKE * wanted;
      if (!isLike || !isOpen || areaOf(opened(difference(hole, [inside]), SLIVER)) > LEAST) return [];
      const depth = roundedUp(centreDepth(tool.centre));
      const made = onAxis("centre", tool, depth, stock, request);
      const { high } = boxAround(hole);
      const place = { front, rear: front - depth, high, low: 0 };
      return made
        ? [{ ...made, kind: "centre", key: `centre T${tool.T}`, site: "inside", tool, place, threads: [] }]
        : [];
    });
  },
};
