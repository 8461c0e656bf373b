import type { Page } from "@playwright/test";

interface Spot {
  readonly x: number;
  readonly y: number;
}

/**
 * The browser drops a tap within 90 ms of a drag as a bounce. A real finger is slower: time between two touches, ms.
 */
const TRAVEL = 250;

/** One finger that presses, moves, lifts, and is on its way to the next place. */
export async function dragFinger(page: Page, from: Spot, to: Spot): Promise<void> {
  const session = await page.context().newCDPSession(page);
  const send = (type: "touchStart" | "touchMove" | "touchEnd", at: readonly Spot[]) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints: at.map(({ x, y }) => ({ x, y })) });
  await send("touchStart", [from]);
  for (const k of [0.25, 0.5, 0.75, 1])
    await send("touchMove", [{ x: from.x + (to.x - from.x) * k, y: from.y + (to.y - from.y) * k }]);
  await send("touchEnd", []);
  await session.detach();
  await page.evaluate((travel) => new Promise((arrived) => void setTimeout(arrived, travel)), TRAVEL);
}
