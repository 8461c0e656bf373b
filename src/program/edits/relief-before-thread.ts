import type { Ring } from "../../kernel/geometry/point.ts";
import { SAME } from "../../kernel/tolerance.ts";
import type { SetJob } from "../job/job.ts";
import { undercutsNamed, type NamedUndercut } from "../job/undercut-name.ts";
import type { Operation } from "../state/run-types.ts";
import { withThreadBeside } from "./thread-beside.ts";
import { placeOf, shouldersOf, undercutJob } from "./undercut-operation.ts";

/** An undercut before a thread, and the Z at which the thread then ends at the latest, mm. */
export interface ReliefBefore {
  readonly named: NamedUndercut;
  readonly job: SetJob;
  readonly end: number;
}

/**
 * The undercuts of DIN 76 at the shoulder of the stock where a cylindrical thread ends, the regular form before the
 * short one; none where there is no such shoulder.
 */
export function reliefsBeforeThread(operation: Operation, stock: readonly Ring[]): readonly ReliefBefore[] {
  const { thread, openSide } = operation.plan;
  const [first, last] = [thread?.crest[0], thread?.crest.at(-1)];
  if (!first || !last || Math.abs(first.r - last.r) > SAME) return [];
  return shouldersOf(stock, openSide.r < 0 ? "inside" : "outside").flatMap((shoulder) => {
    const place = withThreadBeside({ ...placeOf(shoulder), z: shoulder.z }, [operation]);
    if (place.pitch === undefined) return [];
    const { sizes, notes } = undercutsNamed("DIN 76", place);
    if (notes.length > 0) return [];
    return sizes.flatMap((named): readonly ReliefBefore[] => {
      const job = undercutJob(named, { place, z: shoulder.z, stock });
      return job && named.relief && named.notes.length === 0
        ? [{ named, job, end: shoulder.z + named.relief.floor }]
        : [];
    });
  });
}
