import type { Page } from "@playwright/test";
import type { Turnwise } from "./turnwise.ts";

/**
 * Times inside the page, in ms, from a typed character to the new picture on the screen: text, worker, stock and
 * drawing included. Types `values` one after the other into the open prompt, which has to be a number.
 */
export async function editTimes({ page, lathe, dialog }: Turnwise, values: readonly string[]): Promise<number[]> {
  const field = await dialog.value.elementHandle();
  const picture = await lathe.picture.elementHandle();
  return page.evaluate(
    async ({ field, picture, values }) => {
      const write = Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")?.set;
      const path = () => [...(picture?.querySelectorAll("path") ?? [])].map((p) => p.getAttribute("d")).join();
      const times: number[] = [];
      for (const value of values) {
        const before = path();
        const began = performance.now();
        const drawn = new Promise<number>((resolve) => {
          const observer = new MutationObserver(() => {
            if (path() === before) return;
            observer.disconnect();
            resolve(performance.now() - began);
          });
          if (picture) observer.observe(picture, { subtree: true, childList: true, attributes: true });
        });
        write?.call(field, value);
        field?.dispatchEvent(new InputEvent("input", { bubbles: true }));
        times.push(await drawn);
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
      return times;
    },
    { field, picture, values },
  );
}

/** Bytes of live objects on the page, after a garbage collection. What the page still does later is waited for. */
export async function heap(page: Page): Promise<number> {
  await page.waitForTimeout(1500);
  const session = await page.context().newCDPSession(page);
  await session.send("HeapProfiler.collectGarbage");
  await session.send("HeapProfiler.collectGarbage");
  const { usedSize } = await session.send("Runtime.getHeapUsage");
  await session.detach();
  return usedSize;
}

/** The percentile: this share of the times is below the returned value. */
export const quantile = (times: readonly number[], part: number): number =>
  [...times].sort((a, b) => a - b)[Math.min(times.length - 1, Math.floor(part * times.length))] ?? Number.NaN;
