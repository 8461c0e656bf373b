import { useMemo, useState } from "react";
import type { Ring } from "../../../kernel/geometry/point.ts";
import type { Run } from "../../../program/state/run-types.ts";
import type { Simulation } from "../../../sim/simulation.ts";
import { chipsOf } from "../../../sim/chip/chips.ts";
import { blanksOf, playerOf, sameBlank, type Player } from "../../../sim/stock.ts";
import { UNTOUCHED, type Surfaces } from "../../../view/material/surfaces.ts";
import { surfacesOfRun, type PlayedScene } from "../../calculation/moving.ts";
import type { PlaybackStore } from "../../calculation/playback-store.ts";

/** A run with its simulation, or without one while it is only planned. */
export interface LatheResult {
  readonly run: Run;
  readonly simulation: Simulation | null;
}

/** A simulated run: its steps and operations are those of its simulation. */
export interface SimulatedResult {
  readonly run: Run;
  readonly simulation: Simulation;
}

interface ShownMaterial {
  readonly proved: SimulatedResult;
  readonly player: Player;
  readonly surfaces: Surfaces;
}

const sameRings = (a: readonly Ring[], b: readonly Ring[]): boolean =>
  a.length === b.length &&
  a.every(
    (ring, i) => ring.length === b[i]?.length && ring.every((p, k) => p.z === b[i]?.[k]?.z && p.r === b[i]?.[k]?.r),
  );

/** The stock of a planned run before its simulation: the previous stock, or the new blank if that changed. */
interface PlannedStock {
  readonly run: Run;
  readonly stock: readonly Ring[];
}

/**
 * The material of a result. While a run is only planned the picture keeps its stock, as it was at the last change.
 * `proved`: the newest simulated result, whose findings stay until the new ones are there.
 */
export function useMaterial(
  result: LatheResult | null,
  playback: PlaybackStore,
): { readonly proved: SimulatedResult | null; readonly moving: PlayedScene | null } {
  const [held, hold] = useState<ShownMaterial | null>(null);
  const [waiting, wait] = useState<PlannedStock | null>(null);
  function kept({ blank }: Run): readonly Ring[] {
    if (waiting && sameRings(waiting.run.blank, blank)) return waiting.stock;
    return held && sameRings(held.proved.simulation.blank, blank) ? held.player.at(playback.get().position) : blank;
  }
  if (!result && (held ?? waiting)) {
    hold(null);
    wait(null);
  }
  if (result?.simulation && result.simulation !== held?.proved.simulation) {
    const { run, simulation } = result;
    hold({ proved: { run, simulation }, player: playerOf(simulation), surfaces: surfacesOfRun(run, held?.surfaces) });
    wait(null);
  }
  if (result && !result.simulation && result.run !== waiting?.run) {
    wait({ run: result.run, stock: kept(result.run) });
  }
  const moving = useMemo((): PlayedScene | null => {
    if (!result) return null;
    const { steps } = result.run;
    const surfaces = held?.surfaces ?? UNTOUCHED;
    if (!result.simulation) {
      if (!waiting) return null;
      const {
          stock,
          run: { blank },
        } = waiting,
        blanks = [...blank, ...stock];
      return { steps, stockAt: () => stock, blanks, isSameBlank: () => true, chipAt: () => null, surfaces, playback };
    }
    if (!held) return null;
    const {
        player,
        proved: { simulation },
      } = held,
      chipAt = chipsOf(steps, result.run.spindles, player);
    return {
      steps,
      stockAt: player.at,
      blanks: blanksOf(simulation),
      isSameBlank: sameBlank(simulation),
      chipAt,
      surfaces,
      playback,
    };
  }, [result, held, waiting, playback]);
  return { proved: held?.proved ?? null, moving };
}
