import type { Locator, Page } from "@playwright/test";

/** A place of the picture by the numbers on its scales: Z, and X as a diameter. */
export async function pictureAt(page: Page, stage: Locator, z: number, x: number): Promise<{ readonly x: number; readonly y: number }> {
  const box = await stage.boundingBox();
  const matrix = await page.locator(".lathe-picture .still > g").first().getAttribute("transform");
  const [a = 1, , , d = -1, e = 0, f = 0] = (/\(([^)]*)\)/.exec(matrix ?? "")?.[1] ?? "").split(/[\s,]+/).map(Number);
  return { x: (box?.x ?? 0) + a * z + e, y: (box?.y ?? 0) + d * (x / 2) + f };
}
