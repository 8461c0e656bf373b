import { loadAlong, type PathLoad } from "../../sim/load/along.ts";
import { roughnessOf, type RoughStretch } from "../../sim/load/roughness.ts";
import { onlyNewest } from "../base/once.ts";
import type { LoadRequest } from "./load-request.ts";

/** The answers to older questions are not wanted any more. */
const begin = onlyNewest();

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
  const isNewest = begin();
  const going = loadAlong(request);
  for (;;) {
    const now = going.next();
    if (now.done) return now.value;
    await others();
    if (!isNewest()) return null;
  }
}

/** The theoretical roughness of the finished surface. */
export function roughness({ final, steps, spindles, first }: LoadRequest): readonly RoughStretch[] {
  begin();
  return roughnessOf(final, steps, spindles, first);
}
