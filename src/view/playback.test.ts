import fc from "fast-check";
import { expect, test } from "vitest";
import {
  atStart,
  inRange,
  positionAt,
  reduce,
  secondsAt,
  settled,
  trackOf,
  type Action,
  type Playback,
} from "./playback.ts";

const seconds = fc.oneof(fc.double({ min: 0, max: 30, noNaN: true }), fc.constant(0), fc.constant(Number.NaN));
const track = fc
  .array(
    seconds.map((s) => ({ seconds: s })),
    { maxLength: 40 },
  )
  .map(trackOf);
const lasting = fc
  .array(
    fc.double({ min: 0.01, max: 30, noNaN: true }).map((s) => ({ seconds: s })),
    { minLength: 1, maxLength: 40 },
  )
  .map(trackOf);
const part = fc.double({ min: 0, max: 1, noNaN: true });
const action: fc.Arbitrary<Action> = fc.oneof(
  fc
    .constantFrom("play", "pause", "toggle", "forward", "back", "first", "last")
    .map((each) => ({ do: each }) as Action),
  fc.double({ min: -5, max: 60 }).map((s) => ({ do: "tick", seconds: s }) as Action),
  fc.double({ min: -5, max: 900 }).map((s) => ({ do: "seekSeconds", seconds: s }) as Action),
  fc
    .record({ step: fc.integer({ min: -3, max: 60 }), fraction: fc.double({ min: -1, max: 2 }) })
    .map((position) => ({ do: "seek", position }) as Action),
  fc.double({ min: 0.01, max: 500, noNaN: true }).map((rate) => ({ do: "rate", rate }) as Action),
  track.map((t) => ({ do: "load", track: t }) as Action),
);
const exists = ({ track: t, position }: Playback) => {
  expect(inRange(t, position)).toEqual(position);
  expect(Number.isInteger(position.step)).toBe(true);
};

test("after any action the position exists", () => {
  fc.assert(
    fc.property(track, fc.array(action, { maxLength: 30 }), (t, actions) => {
      let p = atStart(t);
      for (const each of actions) exists((p = reduce(p, each)));
    }),
  );
});

test("a second names the position, and the position names the second", () => {
  fc.assert(
    fc.property(lasting, part, (t, k) => {
      expect(secondsAt(t, positionAt(t, t.total * k))).toBeCloseTo(t.total * k, 6);
    }),
  );
});

test("one tick or many, the same place", () => {
  fc.assert(
    fc.property(lasting, part, fc.integer({ min: 1, max: 20 }), (t, k, n) => {
      const once = reduce(reduce(atStart(t), { do: "play" }), { do: "tick", seconds: t.total * k });
      let often = reduce(atStart(t), { do: "play" });
      for (let i = 0; i < n; i++) often = reduce(often, { do: "tick", seconds: (t.total * k) / n });
      expect(secondsAt(t, often.position)).toBeCloseTo(secondsAt(t, once.position), 5);
    }),
  );
});

test("time never runs backwards and stops at the end", () => {
  fc.assert(
    fc.property(track, fc.array(fc.double({ min: 0, max: 20, noNaN: true }), { maxLength: 30 }), (t, ticks) => {
      let p = reduce(atStart(t), { do: "play" }),
        last = 0;
      for (const s of ticks) {
        p = reduce(p, { do: "tick", seconds: s });
        expect(secondsAt(t, p.position)).toBeGreaterThanOrEqual(last);
        last = secondsAt(t, p.position);
      }
      expect(last).toBeLessThanOrEqual(t.total);
      if (p.position.step === t.ends.length) expect(p.playing).toBe(false);
    }),
  );
});

test("forward steps through every move once, back returns through all of them", () => {
  fc.assert(
    fc.property(track, (t) => {
      let p = atStart(t);
      for (let i = 1; i <= t.ends.length; i++)
        expect((p = reduce(p, { do: "forward" })).position).toEqual({ step: i, fraction: 0 });
      expect(reduce(p, { do: "forward" }).position).toEqual(p.position);
      for (let i = t.ends.length - 1; i >= 0; i--)
        expect((p = reduce(p, { do: "back" })).position).toEqual({ step: i, fraction: 0 });
    }),
  );
});

test("back from the middle of a move goes to its beginning", () => {
  const p = reduce(atStart(trackOf([{ seconds: 1 }, { seconds: 2 }])), {
    do: "seek",
    position: { step: 1, fraction: 0.5 },
  });
  expect(reduce(p, { do: "back" }).position).toEqual({ step: 1, fraction: 0 });
});

test("play at the end starts again, and an empty run does not play", () => {
  const p = reduce(atStart(trackOf([{ seconds: 1 }])), { do: "last" });
  expect(reduce(p, { do: "play" })).toMatchObject({ playing: true, position: { step: 0, fraction: 0 } });
  expect(reduce(atStart(trackOf([])), { do: "play" }).playing).toBe(false);
});

test("a changed run keeps the end at the end", () => {
  const p = reduce(atStart(trackOf([{ seconds: 1 }, { seconds: 1 }])), { do: "last" });
  expect(reduce(p, { do: "load", track: trackOf([{ seconds: 5 }, { seconds: 5 }, { seconds: 5 }]) }).position).toEqual({
    step: 3,
    fraction: 0,
  });
});

test("without motion a move is shown only when it is done", () => {
  expect(settled({ step: 4, fraction: 0.7 })).toEqual({ step: 4, fraction: 0 });
});
