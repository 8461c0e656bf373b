import type { ShownBodies, SolidTold } from "../../../view/solid/shown-bodies.ts";
import type { BodiesWanted } from "../../calculation/bodies.ts";
import type { KnownOutcome } from "../../calculation/load-request.ts";
import { askWorker } from "../../calculation/worker-life.ts";

/** So long the worker may make bodies, or be at something else, before the page makes them itself, ms. */
const PATIENCE = 1200;

/** What to do with an answer: bodies that are others than before, the same as before, or none. */
export type BodiesTaken = (made: ShownBodies | "same" | null) => void;

/**
 * Has bodies made in the worker, which has the open work: a thread takes longer to be made than a picture may. One
 * question is on its way at a time.
 */
export interface BodySource {
  readonly isAsked: () => boolean;
  readonly ask: (of: KnownOutcome, wanted: Omit<BodiesWanted, "hasLast">, take: BodiesTaken) => void;
  /** What was given is not what is shown any more, and what is on its way is not wanted. */
  readonly forget: () => void;
}

/** A source that has given nothing yet. */
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

export const isSameTold = (a: SolidTold, b: SolidTold): boolean =>
  a.rings === b.rings &&
  a.leftHanded === b.leftHanded &&
  a.textures.join() === b.textures.join() &&
  a.marked.join() === b.marked.join();
