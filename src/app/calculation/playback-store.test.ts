import { expect, test } from "vitest";
import { trackOf } from "../../view/playback.ts";
import { manualClock } from "../base/clock.ts";
import { createPlaybackStore } from "./playback-store.ts";

const track = trackOf([{ seconds: 2 }, { seconds: 1 }, { seconds: 3 }]);

function playing(rate: number) {
  const clock = manualClock(),
    store = createPlaybackStore(clock);
  store.dispatch({ do: "load", track });
  store.dispatch({ do: "rate", rate });
  store.dispatch({ do: "play" });
  return { clock, store };
}

test("machine time passes with the clock, times the rate", () => {
  const { clock, store } = playing(2);
  clock.advance(1250);
  expect(store.get().position.step).toBe(1);
  expect(store.get().position.fraction).toBeCloseTo(0.5, 6);
});

test("it stops at the end and says so", () => {
  const { clock, store } = playing(1);
  let told = 0;
  store.subscribe(() => (told += 1));
  clock.advance(7000);
  expect(store.get()).toMatchObject({ playing: false, position: { step: 3, fraction: 0 } });
  const before = told;
  clock.advance(1000);
  expect(told).toBe(before);
});

test("a pause takes no time", () => {
  const { clock, store } = playing(1);
  clock.advance(500);
  store.dispatch({ do: "pause" });
  clock.advance(5000);
  store.dispatch({ do: "play" });
  clock.advance(500);
  expect(store.get().position.fraction).toBeCloseTo(0.5, 6);
});

test("without motion only ends of moves are shown while it plays", () => {
  const { clock, store } = playing(1);
  store.setStill(true);
  clock.advance(2500);
  expect(store.shown()).toEqual({ step: 1, fraction: 0 });
  store.dispatch({ do: "pause" });
  expect(store.shown().fraction).toBeCloseTo(0.5, 6);
});

test("read-outs update at a readable rate while it plays, and at once after a click and at the end", () => {
  const { clock, store } = playing(1);
  let looked = 0,
    read = 0;
  store.subscribe(() => (looked += 1));
  store.subscribeReader(() => (read += 1));
  clock.advance(1001);
  // A frame every 16 ms: every eighth one is at least 120 ms after the last read-out.
  expect(looked).toBe(63);
  expect(read).toBe(7);
  store.dispatch({ do: "seekSeconds", seconds: 0.31 });
  store.dispatch({ do: "seekSeconds", seconds: 0.33 });
  expect(read).toBe(9);
  clock.advance(5660);
  const beforeEnd = read;
  clock.advance(11);
  expect(store.get().playing).toBe(false);
  expect(read).toBe(beforeEnd + 1);
});

test("another work starts at its beginning and paused, the same one continues where it is", () => {
  const { clock, store } = playing(1),
    other = trackOf([{ seconds: 4 }, { seconds: 9 }]);
  store.playsOf("flange");
  clock.advance(2500);
  store.playsOf(null);
  store.playsOf("flange");
  store.dispatch({ do: "load", track: trackOf([{ seconds: 2 }, { seconds: 1 }, { seconds: 5 }]) });
  expect(store.get()).toMatchObject({ playing: true, position: { step: 1 } });
  store.dispatch({ do: "last" });
  store.playsOf("shaft");
  store.dispatch({ do: "load", track: other });
  expect(store.get()).toMatchObject({ playing: false, position: { step: 0, fraction: 0 } });
});
