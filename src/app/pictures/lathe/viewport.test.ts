import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { panned, sheetShift, toPlace, toScreen, zoomed } from "../../../view/camera.ts";
import { createViewport, drawnRoom } from "./viewport.ts";

const SIZE = { width: 731, height: 433 };

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("devicePixelRatio", 1);
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

function opened() {
  const viewport = createViewport(true);
  viewport.setSize(SIZE);
  return { viewport, begun: viewport.get() };
}

test("the drawing is shifted while panning, and catches up at rest", () => {
  const { viewport, begun } = opened(),
    heard: boolean[] = [];
  expect(viewport.drawn()).toBe(begun);
  viewport.subscribe(() => heard.push(viewport.drawn() === viewport.get()));
  for (let move = 0; move < 7; move += 1) {
    viewport.look(panned(viewport.get(), 3.7, -1.9));
    vi.advanceTimersByTime(60);
    expect(viewport.drawn()).toBe(begun);
  }
  vi.advanceTimersByTime(500);
  expect(viewport.drawn()).toBe(viewport.get());
  expect(heard).toEqual([...Array<boolean>(7).fill(false), true]);
});

test("it is redrawn where nothing is ready, and where its pixels would become coarse", () => {
  const { viewport } = opened();
  const steps = {
    left: { dx: -41.3, dy: 0 },
    right: { dx: 38.9, dy: 0 },
    up: { dx: 0, dy: -27.1 },
    down: { dx: 0, dy: 29.7 },
  };
  for (const { dx, dy } of Object.values(steps)) {
    for (let move = 0; move < 40; move += 1) {
      viewport.look(panned(viewport.get(), dx, dy));
      expectReady(viewport);
    }
  }
  for (const factor of [0.83, 1.27]) {
    for (let move = 0; move < 12; move += 1) {
      viewport.zoom(factor, { x: 611, y: 57 });
      expectReady(viewport);
      expect(viewport.get().scale / viewport.drawn().scale).toBeLessThan(2.21);
    }
  }
});

test("zooming out draws for a view further out, and so less often", () => {
  const { viewport } = opened(),
    drawn = new Set([viewport.drawn()]);
  for (let move = 0; move < 12; move += 1) {
    viewport.zoom(0.83);
    drawn.add(viewport.drawn());
    expectReady(viewport);
  }
  expect(drawn.size - 1).toBeLessThanOrEqual(Math.ceil(Math.log(0.83 ** -12) / Math.log(2.1)));
  vi.advanceTimersByTime(500);
  expect(viewport.drawn()).toBe(viewport.get());
});

/** The drawing covers all of the visible part. */
function expectReady(viewport: ReturnType<typeof createViewport>) {
  const room = drawnRoom(SIZE);
  for (const seen of [
    { x: 0, y: 0 },
    { x: SIZE.width, y: 0 },
    { x: 0, y: SIZE.height },
    { x: SIZE.width, y: SIZE.height },
  ]) {
    const { x, y } = toScreen(viewport.drawn(), toPlace(viewport.get(), seen));
    expect(x).toBeGreaterThan(room.x - 1e-3);
    expect(x).toBeLessThan(room.x + room.width + 1e-3);
    expect(y).toBeGreaterThan(room.y - 1e-3);
    expect(y).toBeLessThan(room.y + room.height + 1e-3);
  }
}

test("any other change of the view redraws at once", () => {
  const { viewport } = opened();
  const others = [
    () => viewport.fit(),
    () => viewport.setXUp(false),
    () => viewport.setSize({ width: 611, height: 433 }),
    () => viewport.show({ left: -31.7, right: -12.9, low: 7.1, high: 19.3 }),
  ];
  for (const other of others) {
    viewport.look(panned(viewport.get(), 11.3, 7.7));
    expect(viewport.drawn()).not.toBe(viewport.get());
    other();
    expect(viewport.drawn()).toBe(viewport.get());
  }
});

test("a shifted drawing is where it would be drawn", () => {
  const { begun } = opened(),
    now = panned(zoomed(begun, 1.37, { x: 97, y: 311 }), -41.9, 17.3);
  const { x, y, grown } = sheetShift(begun, now),
    point = toPlace(begun, { x: 413.7, y: 99.1 });
  const { x: wantedX, y: wantedY } = toScreen(now, point);
  expect(413.7 * grown + x).toBeCloseTo(wantedX, 9);
  expect(99.1 * grown + y).toBeCloseTo(wantedY, 9);
});

test("while panning a canvas has one pixel per CSS pixel, and the screen's pixels at rest", () => {
  vi.stubGlobal("devicePixelRatio", 2.5);
  const { viewport } = opened(),
    heard: (readonly [ratio: number, isNew: boolean])[] = [];
  let drawn = viewport.drawn();
  viewport.subscribe(() => {
    heard.push([viewport.ratio(), viewport.drawn() !== drawn]);
    drawn = viewport.drawn();
  });
  expect(viewport.ratio()).toBe(2.5);
  for (let move = 0; move < 2; move += 1) viewport.zoom(1.53);
  vi.advanceTimersByTime(500);
  // The second is redrawn, and once more at rest, although the camera has not moved since.
  expect(heard).toEqual([
    [2.5, false],
    [1, true],
    [2.5, true],
  ]);
  viewport.zoom(1.11);
  expect(viewport.ratio()).toBe(2.5);
  viewport.zoom(7);
  expect(viewport.ratio()).toBe(1);
  viewport.fit();
  expect(viewport.ratio()).toBe(2.5);
  // Such a large picture takes too long to copy even then.
  viewport.setSize({ width: 2517, height: 1683 });
  viewport.zoom(7);
  expect(viewport.ratio()).toBe(0.5);
  vi.advanceTimersByTime(500);
  expect(viewport.ratio()).toBe(2.5);
  vi.unstubAllGlobals();
});

test.each([1, 1.25, 1.5, 2, 1.875, 1.09])(
  "the drawn part begins on whole device pixels (%d for each pixel)",
  (ratio) => {
    vi.stubGlobal("devicePixelRatio", ratio);
    const { x, y } = drawnRoom(SIZE);
    for (const edge of [x * ratio, y * ratio]) expect(edge).toBeCloseTo(Math.round(edge), 6);
  },
);

const box = (left: number, right: number, high = 20) => ({ left, right, low: 0, high });

test("a fitted picture follows a part that outgrows it or becomes small in it, and one moved by hand stays", () => {
  const { viewport } = opened();
  viewport.setBounds(box(-100, 0));
  const seen = viewport.get();
  viewport.setBounds(box(-80, 0));
  expect(viewport.get()).toBe(seen);
  viewport.setBounds(box(-50, 0));
  const near = viewport.get();
  expect(near.scale).toBeGreaterThan(seen.scale);
  viewport.setBounds(box(-60, 0));
  expect(viewport.get().scale).toBeLessThan(near.scale);
  viewport.pan(10, 0);
  const byHand = viewport.get();
  viewport.setBounds(box(-500, 0));
  viewport.setSize({ width: 300, height: 200 });
  expect(viewport.get()).toMatchObject({ scale: byHand.scale, zero: byHand.zero });
  viewport.fit();
  expect(viewport.get().scale).toBeLessThan(byHand.scale);
});

test("a shown place is in the picture with room around it", () => {
  const { viewport } = opened();
  viewport.show(box(-12, -10, 2));
  const [low, high] = [
    toPlace(viewport.get(), { x: 0, y: SIZE.height }),
    toPlace(viewport.get(), { x: SIZE.width, y: 0 }),
  ];
  expect([low.z < -13.5, high.z > -8.5, low.r < -1.5, high.r > 3.5]).toEqual([true, true, true, true]);
});

test("turned over by hand the axis is mirrored in the picture; a fitted one is fitted again", () => {
  const { viewport } = opened();
  const fitted = viewport.get();
  viewport.setXUp(true);
  expect(viewport.get()).toBe(fitted);
  viewport.setXUp(false);
  expect(viewport.get()).toMatchObject({ xUp: false, scale: fitted.scale });
  viewport.pan(0, 15);
  const { zero } = viewport.get();
  viewport.setXUp(true);
  expect(viewport.get()).toMatchObject({ xUp: true, zero: { x: zero.x, y: SIZE.height - zero.y } });
});
