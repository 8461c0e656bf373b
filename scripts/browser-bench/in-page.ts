/**
 * Measurements inside a page. Each function is sent to the page as text, so it uses nothing from outside itself; times
 * are ms of the page.
 */

/** Frames in a period of time. */
export interface Frames {
  readonly perSecond: number;
  /** Time from one frame to the next, ms. */
  readonly median: number;
  readonly p95: number;
  readonly worst: number;
  /** Durations of the tasks of more than 50 ms. */
  readonly long: readonly number[];
}

/** Counts the frames during a period, ms. */
export async function countFrames(lasts: number): Promise<Frames> {
  const long: number[] = [];
  const observer = new PerformanceObserver((list) => {
    for (const { duration } of list.getEntries()) long.push(Math.round(duration));
  });
  observer.observe({ type: "longtask" });
  const times = await new Promise<number[]>((resolve) => {
    const seen: number[] = [];
    const frame = () => {
      const now = performance.now();
      seen.push(now);
      if (now - (seen[0] ?? now) < lasts) requestAnimationFrame(frame);
      else resolve(seen);
    };
    requestAnimationFrame(frame);
  });
  for (const { duration } of observer.takeRecords()) long.push(Math.round(duration));
  observer.disconnect();
  const gaps = times
    .slice(1)
    .map((time, i) => time - (times[i] ?? time))
    .sort((a, b) => a - b);
  const at = (part: number) => gaps[Math.min(gaps.length - 1, Math.floor(part * gaps.length))] ?? Number.NaN;
  const whole = (times.at(-1) ?? 0) - (times[0] ?? 0);
  return { perSecond: (1000 * gaps.length) / whole, median: at(0.5), p95: at(0.95), worst: at(1), long };
}

/**
 * Moves a box of 100 points with every frame on an otherwise empty page: the best frame rate of any page that shows a
 * change.
 */
export function moveBox(): void {
  const box = document.createElement("div");
  box.style.cssText = "position:absolute;width:100px;height:100px;background:teal;will-change:transform";
  document.body.append(box);
  let count = 0;
  const frame = () => {
    count += 1;
    box.style.transform = `translate(${count % 300}px, ${count % 200}px)`;
    if (box.isConnected) requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

/** Removes the box. */
export const removeBox = (): void => document.querySelector("div")?.remove();

/** The record of `watchDrawing` on the page. */
export interface Watched {
  /**
   * Times of the last key, of its digit on screen, of the next path and of the latest picture; painting included, ms.
   */
  key: number;
  digit: number;
  path: number;
  picture: number;
  /** Number of requests that the worker has not answered. */
  pending: number;
  /** Time of the latest key, picture change or worker answer. */
  lastActivity: number;
  /** Durations of the tasks of more than 50 ms since the last key. */
  tasks: number[];
}

declare global {
  interface Window {
    __watched?: Watched;
  }
}

/**
 * Installed before a page loads: records keys, redraws of path and material in the lathe view, and requests to the
 * worker. A change counts when the frame that shows it is painted, as far as the page's own thread can tell.
 */
export function watchDrawing(): void {
  const watched: Watched = { key: 0, digit: 0, path: 0, picture: 0, pending: 0, lastActivity: 0, tasks: [] };
  window.__watched = watched;
  /** Changes that the next painted frame will show. */
  let path = false,
    picture = false;
  const changed = (isPath: boolean) => {
    if (isPath) path = true;
    picture = true;
    watched.lastActivity = performance.now();
  };
  const channel = new MessageChannel();
  channel.port1.onmessage = () => {
    const now = performance.now();
    if (watched.digit === 0) watched.digit = now;
    if (path && watched.path === 0) watched.path = now;
    if (picture) watched.picture = now;
    path = picture = false;
  };
  const frame = () => {
    channel.port2.postMessage(null);
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  addEventListener(
    "keydown",
    (event) => {
      watched.key = watched.lastActivity = event.timeStamp;
      watched.digit = watched.path = watched.picture = 0;
      watched.tasks = [];
      path = picture = false;
    },
    { capture: true },
  );
  new MutationObserver((records) => {
    for (const { target } of records) {
      const element = target instanceof Element ? target : target.parentElement;
      if (element?.closest(".lathe-paths, .plane-picture .still")) changed(true);
      else if (element?.closest(".shape-stock, .lathe-residual")) changed(false);
    }
  }).observe(document, { subtree: true, childList: true, attributes: true, attributeFilter: ["d"] });
  const pens = [
    [CanvasRenderingContext2D.prototype, "fill"],
    [CanvasRenderingContext2D.prototype, "stroke"],
    [CanvasRenderingContext2D.prototype, "drawImage"],
    [ImageBitmapRenderingContext.prototype, "transferFromImageBitmap"],
  ] as const;
  for (const [pen, name] of pens) {
    const own = Reflect.get(pen, name) as (...given: unknown[]) => void;
    Object.defineProperty(pen, name, {
      value(this: unknown, ...given: unknown[]) {
        changed(false);
        own.apply(this, given);
      },
    });
  }
  new PerformanceObserver((list) => {
    for (const { duration, startTime } of list.getEntries())
      if (startTime + duration > watched.key) watched.tasks.push(Math.round(duration));
  }).observe({ type: "longtask" });
  const Native = Worker;
  window.Worker = class extends Native {
    constructor(...given: ConstructorParameters<typeof Worker>) {
      super(...given);
      this.addEventListener("message", () => {
        watched.pending = Math.max(0, watched.pending - 1);
        watched.lastActivity = performance.now();
      });
    }
    override postMessage(...given: [unknown, (Transferable[] | StructuredSerializeOptions)?]): void {
      watched.pending += 1;
      super.postMessage(given[0], given[1] as Transferable[]);
    }
  };
}

/**
 * Waits for the path, and then for a period without activity. Returns times from the key; null where nothing was drawn.
 */
export async function drawnAfterKey({
  quiet,
  patience,
}: {
  readonly quiet: number;
  readonly patience: number;
}): Promise<{
  readonly digit: number | null;
  readonly path: number | null;
  readonly picture: number | null;
  readonly tasks: readonly number[];
}> {
  const watched = window.__watched;
  if (!watched) throw new Error("the page is not watched");
  const { key } = watched,
    goesOn = () => watched.path === 0 || watched.pending > 0 || performance.now() - watched.lastActivity < quiet;
  while (goesOn() && performance.now() - key < patience) await new Promise((done) => setTimeout(done, quiet / 10));
  const since = (time: number) => (time > 0 ? time - key : null);
  return {
    digit: since(watched.digit),
    path: since(watched.path),
    picture: since(watched.picture),
    tasks: watched.tasks,
  };
}
