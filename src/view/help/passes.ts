import type { Frame } from "../../kernel/flat.ts";
import type { Move } from "../../kernel/move.ts";
import type { Pt } from "../../kernel/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import { outward } from "./frame.ts";

/** One cut at one level: where it begins and where it ends, part space. */
export interface Pass {
  readonly pass: number;
  readonly level: number;
  readonly from: Pt;
  readonly to: Pt;
}

/** More lines than this would be a grey area. */
const MOST = 60;

/** The cuts of roughing: of each pass what runs level at its depth; the ways in and out lie above it. */
export function passesOf(f: Frame, moves: readonly Move[]): Pass[] {
  const level: Pass[] = [];
  const depths = new Map<number, number>();
  moves.forEach((m, i) => {
    const from = moves[i - 1]?.to;
    if (!from || m.kind !== "feed" || m.phase !== "rough" || m.pass === undefined || m.plunging) return;
    const v = outward(f, m.to);
    if (Math.abs(v - outward(f, from)) > SAME) return;
    level.push({ pass: m.pass, level: v, from, to: m.to });
    depths.set(m.pass, Math.min(v, depths.get(m.pass) ?? v));
  });
  return level.filter((p) => p.level < (depths.get(p.pass) ?? p.level) + SAME).slice(0, MOST);
}
