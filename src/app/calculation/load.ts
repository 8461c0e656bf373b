import { loadAlong, type PathLoad } from "../../sim/load/along.ts";
import { roughnessOf, type RoughStretch } from "../../sim/load/roughness.ts";
import type { LoadRequest } from "./load-request.ts";

/** Counts up with each question; the answers to older ones are not wanted any more. */
let asked = 0;

/** Lets everything go before that was asked meanwhile. */
const others = (): Promise<void> =>
  new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      done();
    };
    port2.postMessage(null);
  });

/**
 * What the tool bears along the path, measured a few moves at a time; null when something else is asked before it is
 * done.
 */
export async function pathLoad(request: LoadRequest): Promise<PathLoad | null> {
  asked += 1;
  const own = asked,
    going = loadAlong(request);
  for (;;) {
    const now = going.next();
    if (now.done) return now.value;
    await others();
    if (asked !== own) return null;
  }
}

/** The theoretical roughness of the finished surface. */
export function roughness({ final, steps, spindles, first }: LoadRequest): readonly RoughStretch[] {
  asked += 1;
  return roughnessOf(final, steps, spindles, first);
}
