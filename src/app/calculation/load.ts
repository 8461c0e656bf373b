import { loadAlong, type PathLoad } from "../../sim/load/along.ts";
import { roughnessOf, type RoughStretch } from "../../sim/load/roughness.ts";
import { onlyNewest } from "../base/once.ts";
import type { LoadRequest } from "./load-request.ts";

/** Answers to older requests are dropped. */
const begin = onlyNewest();

/** Lets messages that arrived meanwhile be handled first. */
const others = (): Promise<void> =>
  new Promise((done) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      done();
    };
    port2.postMessage(null);
  });

/** Load of the tool along the path, calculated a few moves at a time; null if a newer request arrives first. */
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
