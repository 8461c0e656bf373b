import type { ShownBodies, SolidNotes } from "../../../view/solid/shown-bodies.ts";
import type { BodiesWanted } from "../../calculation/bodies.ts";
import type { KnownOutcome } from "../../calculation/load-request.ts";
import { askWorker } from "../../calculation/worker-life.ts";

/** Time for the worker to make bodies before the page makes them itself, ms. */
const PATIENCE = 1200;

/** Handler of an answer: new bodies, the same as before, or none. */
export type BodiesTaken = (made: ShownBodies | "same" | null) => void;

/** Makes bodies in the worker, which has the open work: a thread takes longer than a frame. One request at a time. */
export interface BodySource {
  readonly isAsked: () => boolean;
  readonly ask: (of: KnownOutcome, wanted: Omit<BodiesWanted, "hasLast">, take: BodiesTaken) => void;
  /** Discards the shown bodies and the request under way. */
  readonly forget: () => void;
}

/** A source without bodies yet. */
export function bodySource(): BodySource {
  let [asked, hasLast]: [object | null, boolean] = [null, false];
  return {
    isAsked: () => asked !== null,
    ask(of, wanted, take) {
      const own = {};
      asked = own;
      const answer = (made: ShownBodies | "same" | null) => {
        clearTimeout(late);
        if (asked !== own) return;
        asked = null;
        hasLast = made !== null;
        take(made);
      };
      const late = setTimeout(() => answer(null), PATIENCE);
      askWorker(async (engine) => await engine.bodies(of, { ...wanted, hasLast })).then(answer, () => answer(null));
    },
    forget() {
      asked = null;
      hasLast = false;
    },
  };
}

export const isSameNotes = (a: SolidNotes, b: SolidNotes): boolean =>
  a.hasRings === b.hasRings &&
  a.leftHanded === b.leftHanded &&
  a.textures.join() === b.textures.join() &&
  a.highlighted.join() === b.highlighted.join();
