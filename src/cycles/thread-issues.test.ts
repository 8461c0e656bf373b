import { describe, expect, test } from "vitest";
import { at, type Ring } from "../kernel/point.ts";
import { shippedTools } from "../program/shipped-tools.ts";
import { c831 } from "./c831.ts";

/* A thread of 40 mm on a shaft of 60 mm that begins at Z0; the run-in is the clearance of 8 mm. */
const box = (z0: number, z1: number, r: number): Ring => [at(z0, 0), at(z0, r), at(z1, r), at(z1, 0)];
const shaft = box(0, -100, 20);

function planned(own: Readonly<Record<string, number>>, stock: readonly Ring[] = [shaft], inside = false) {
  const example = Object.fromEntries(Object.entries(c831.params).map(([q, p]) => [q, p.example]));
  const values = { ...example, Q475: 1, Q476: 0, Q460: 8, Q491: 40, Q494: -30, ...own };
  const shipped = shippedTools.find((t) => t.T === 12) as (typeof shippedTools)[number];
  const tool = inside ? { ...shipped, TO: 6 as const } : shipped;
  const start = inside ? at(20, 11) : at(20, 30);
  const plan = c831.plan(values as never, { tool, start, feedUnit: "mm/rev", autoFeed: null, stock }, { contour: null, start });
  const errors = plan.issues.filter((i) => i.severity === "error");
  // What is refused has no path, and what is not has one.
  expect(plan.moves.length > 0).toBe(errors.length === 0);
  return errors;
}

describe("an insert that is too low is refused", () => {
  // T12: edges of 12 mm at 60°, about a nose of 0.1 mm.
  test("for the depth of the thread", () => {
    expect(planned({ Q473: 10 })).toEqual([]);
    expect(planned({ Q473: 10.4 })).toMatchObject([{ code: "threadOverInsert", at: "Q473", data: { depth: 10.4 } }]);
  });

  test("for what stands over the thread, together with its depth", () => {
    expect(planned({ Q473: 1, Q463: 0.5 }, [box(0, -100, 29)])).toEqual([]);
    const [found, ...more] = planned({ Q473: 1, Q463: 0.5 }, [box(0, -100, 30)]);
    expect(more).toEqual([]);
    expect(found).toMatchObject({ code: "threadMeets", at: "Q491", data: { place: "over", x: 60 } });
    const { over, most } = found?.data as { over: number; most: number };
    expect(over).toBeCloseTo(10, 6);
    expect(most).toBeLessThan(over);
  });

  test("for a shoulder in the overrun and for a collar in the run-in, with the place", () => {
    const shoulder = box(-31.3, -100, 35.2);
    expect(planned({}, [box(0, -31.3, 20), shoulder])).toMatchObject([{
      code: "threadMeets",
      at: "Q494",
      data: { place: "behind", x: 70.4, z: -31.3 },
    }]);
    const collar = box(4.7, 2.2, 33.1);
    expect(planned({ Q460: 16 }, [shaft, collar])).toMatchObject([{ code: "threadMeets", at: "Q460", data: { place: "before", x: 66.2 } }]);
  });

  test("for the bottom of a bore that the thread runs into", () => {
    const bored: Ring[] = [[at(0, 12), at(0, 40), at(-70, 40), at(-70, 0), at(-31.1, 0), at(-31.1, 12)]];
    expect(planned({ Q471: 1, Q491: 26 }, bored, true)).toMatchObject([{
      code: "threadMeets",
      at: "Q494",
      data: { place: "behind", z: -31.1 },
    }]);
  });
});

test("a run-in that begins in material is refused with the shortest that does not", () => {
  expect(planned({})).toEqual([]);
  const collar = box(15, 0, 20);
  const [found, ...more] = planned({}, [shaft, collar]);
  expect(more).toEqual([]);
  expect(found).toMatchObject({ code: "runInBlocked", at: "Q460" });
  const { nearest } = found?.data as { nearest: number };
  expect(nearest).toBeGreaterThan(15);
  expect(planned({ Q460: nearest }, [shaft, collar])).toEqual([]);
  expect(planned({ Q460: nearest - 0.01 }, [shaft, collar])).toMatchObject([{ code: "runInBlocked" }]);
});

test("a run-in that is blocked all the way has no offer", () => {
  const [found] = planned({}, [box(200, -100, 20)]);
  expect(found?.code).toBe("runInBlocked");
  expect(found?.data).not.toHaveProperty("nearest");
});

test("more turns than anybody means are refused at the pitch", () => {
  expect(planned({ Q472: 0.2, Q473: 0.1 })).toEqual([]);
  expect(planned({ Q472: 0.0003, Q473: 0.1 })).toMatchObject([{ code: "threadTooMany", at: "Q472" }]);
  // A tooth of a few thousandths: the section alone would take a minute.
  expect(planned({ Q472: 0.0013, Q473: 0.1 })).toMatchObject([{ code: "threadTooMany", at: "Q472", data: { most: 10_000 } }]);
  // Passes and starts count as well: each goes along all of the thread.
  expect(planned({ Q472: 0.2, Q473: 0.1, Q475: 500, Q476: 9 })).toMatchObject([{ code: "threadTooMany", at: "Q472" }]);
});
