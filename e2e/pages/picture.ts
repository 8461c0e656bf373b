import type { Locator, Page } from "@playwright/test";

/** A rectangle on the screen, px. */
export interface Box {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** Waits until the page has painted this many frames. */
export async function frames(page: Page, count: number): Promise<void> {
  await page.evaluate(async (n) => {
    for (let i = 0; i < n; i += 1) await new Promise(requestAnimationFrame);
  }, count);
}

/** Reads until two readings some frames apart agree. */
async function settled<T>(page: Page, read: () => Promise<T>): Promise<T> {
  for (let last = JSON.stringify(await read()); ;) {
    await frames(page, 3);
    const now = await read(),
      same = JSON.stringify(now);
    if (same === last) return now;
    last = same;
  }
}

/** The box of an element on the screen, once it no longer moves. */
export async function settledBox(part: Locator): Promise<Box> {
  await part.waitFor();
  const box = await settled(part.page(), () => part.boundingBox());
  if (!box) throw new Error(`${part} has no place on the screen`);
  return box;
}

/** The screen position of Z, and X as a diameter, from the scales, once the path is drawn. */
export async function pictureAt(
  page: Page,
  stage: Locator,
  z: number,
  x: number,
): Promise<{ readonly x: number; readonly y: number }> {
  await page.locator(".lathe-paths path").first().waitFor({ state: "attached" });
  const [box, matrix] = await settled(
    page,
    async () =>
      [
        await stage.boundingBox(),
        await page.locator(".lathe-picture .still > g").first().getAttribute("transform"),
      ] as const,
  );
  const [a = 1, , , d = -1, e = 0, f = 0] = (/\(([^)]*)\)/.exec(matrix ?? "")?.[1] ?? "").split(/[\s,]+/).map(Number);
  return { x: (box?.x ?? 0) + a * z + e, y: (box?.y ?? 0) + d * (x / 2) + f };
}
