import { describe, expect, test } from "vitest";
import { at, type Ring } from "../kernel/geometry/point.ts";
import type { Tool } from "../kernel/plan/tool.ts";
import { degrees, length } from "../kernel/units.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { c831 } from "./c831.ts";
import { c832 } from "./c832.ts";

/* A thread of 40 mm on a shaft of 60 mm that begins at Z0; the run-in is the clearance of 8 mm. */
const box = (z0: number, z1: number, r: number): Ring => [at(z0, 0), at(z0, r), at(z1, r), at(z1, 0)];
const shaft = box(0, -100, 20);

interface Other {
  readonly inside?: boolean;
  readonly columns?: Partial<Tool>;
}
/** A tooth of 10 mm: material beside the thread is then in its way, not over its crest. */
const HIGH: Other = { columns: { CUTLENGTH: length(10) } };

function planOf(
  own: Readonly<Record<string, number>>,
  stock: readonly Ring[] = [shaft],
  { inside = false, columns = {} }: Other = {},
) {
  const example = Object.fromEntries(Object.entries(c831.params).map(([q, p]) => [q, p.example]));
  const values = { ...example, Q475: 1, Q476: 0, Q460: 8, Q491: 40, Q494: -30, ...own };
  const shipped = shippedTools.find((t) => t.T === 12) as (typeof shippedTools)[number];
  const tool: Tool = { ...shipped, ...(inside && { TO: 6 as const }), ...columns };
  const start = inside ? at(20, 11) : at(20, 30);
  return c831.plan(
    values as never,
    { tool, start, feedUnit: "mm/rev", autoFeed: null, stock },
    { contour: null, start },
  );
}

function planned(...asked: Parameters<typeof planOf>) {
  const plan = planOf(...asked);
  const errors = plan.issues.filter((i) => i.severity === "error");
  // A refused thread has no path; any other has one.
  expect(plan.moves.length > 0).toBe(errors.length === 0);
  return errors;
}

describe("an insert that is too low is refused", () => {
  // T12: a tooth of 2.5 mm.
  test("for the depth of the thread", () => {
    expect(planned({ Q473: 2.5 })).toEqual([]);
    expect(planned({ Q473: 2.501 })).toMatchObject([
      { code: "threadOverInsert", at: "Q473", data: { depth: 2.501, most: 2.5 } },
    ]);
    expect(planned({ Q473: 2.501 }, [shaft], { columns: { CUTLENGTH: length(2.501) } })).toEqual([]);
  });

  test("and one with an empty CUTLENGTH is not: its height is assumed to be the thread depth, which is reported", () => {
    const told = (Q473: number) => {
      const plan = planOf({ Q473 }, [shaft], { columns: { CUTLENGTH: length(0) } });
      expect(plan.issues.filter((i) => i.severity === "error")).toEqual([]);
      return [plan.issues.find((i) => i.code === "toothAssumed")?.data, plan.tool?.CUTLENGTH];
    };
    expect(told(1.2)).toEqual([{ height: expect.closeTo(2.5, 6) }, undefined]);
    expect(told(4)).toEqual([{ height: expect.closeTo(4.8, 6) }, expect.closeTo(4.8, 6)]);
    expect(planOf({ Q473: 1.2 }).issues.map((i) => i.code)).not.toContain("toothAssumed");
  });

  test("for material over the thread, together with its depth", () => {
    expect(planned({ Q473: 1, Q463: 0.5 }, [box(0, -100, 21.5)])).toEqual([]);
    const [found, ...more] = planned({ Q473: 1, Q463: 0.5 }, [box(0, -100, 22)]);
    expect(more).toEqual([]);
    expect(found).toMatchObject({ code: "threadMeets", at: "Q491", data: { place: "over", x: 44 } });
    const { over, most } = (found?.data ?? {}) as { over: number; most: number };
    expect(over).toBeCloseTo(2, 6);
    expect(most).toBeCloseTo(1.5, 6);
  });

  test("for a collar in the run-in, with the place", () => {
    const collar = box(4.7, 2.2, 33.1);
    expect(planned({ Q460: 16 }, [shaft, collar], HIGH)).toMatchObject([
      {
        code: "threadMeets",
        at: "Q460",
        data: { place: "before", x: 66.2 },
      },
    ]);
  });

  test("but material in the overrun is reported, and cut so that the stock shows it", () => {
    const behind = (plan: ReturnType<typeof planOf>) => {
      expect([plan.moves.length > 0, plan.issues.filter((i) => i.severity === "error")]).toEqual([true, []]);
      return plan.issues.filter((i) => i.code === "threadMeets");
    };
    const shoulder = box(-31.3, -100, 35.2);
    expect(behind(planOf({}, [box(0, -31.3, 20), shoulder]))).toMatchObject([
      {
        severity: "warning",
        at: "Q494",
        data: { place: "behind", x: 70.4, z: -31.3 },
      },
    ]);
  });

  test("and the bottom of a bore is refused, since the tool cannot retract over it", () => {
    const bored: Ring[] = [[at(0, 12), at(0, 40), at(-70, 40), at(-70, 0), at(-31.1, 0), at(-31.1, 12)]];
    expect(planned({ Q471: 1, Q491: 26 }, bored, { inside: true })).toMatchObject([
      {
        code: "threadMeets",
        at: "Q494",
        data: { place: "behind", z: -31.1 },
      },
    ]);
  });
});

test("a run-in that begins in material is refused, with the shortest free one proposed", () => {
  expect(planned({})).toEqual([]);
  const collar = box(15, 0, 20);
  const [found, ...more] = planned({}, [shaft, collar]);
  expect(more).toEqual([]);
  expect(found).toMatchObject({ code: "runInBlocked", at: "Q460" });
  const { nearest } = (found?.data ?? {}) as { nearest: number };
  // In steps that a setter would type.
  expect(nearest).toBe(16);
  expect(planned({ Q460: nearest }, [shaft, collar])).toEqual([]);
  expect(planned({ Q460: nearest - 0.5 }, [shaft, collar])).toMatchObject([{ code: "runInBlocked" }]);
});

test("a run-in that is blocked everywhere has no proposal", () => {
  // Ten turns of 2 mm are a usual run-in; thirty are not.
  for (const [end, offers] of [
    [18, true],
    [21, false],
    [200, false],
  ] as const) {
    const [found] = planned({}, [box(end, -100, 20)]);
    expect(found?.code).toBe("runInBlocked");
    expect([end, "nearest" in (found?.data ?? {})]).toEqual([end, offers]);
  }
});

test("on a cone a tooth has to be higher than the thread is deep: its crest rises beside the tip", () => {
  const codes = (CUTLENGTH: number, Q469: number) => {
    const example = Object.fromEntries(Object.entries(c832.params).map(([q, p]) => [q, p.example]));
    const values = { ...example, Q475: 1, Q476: 0, Q472: 2, Q473: 2, Q464: 4, Q491: 40, Q492: 0, Q494: -20, Q469 };
    const tool: Tool = { ...(shippedTools.find((t) => t.T === 12) as Tool), CUTLENGTH: length(CUTLENGTH) };
    const start = at(20, 40);
    const plan = c832.plan(
      values as never,
      { tool, start, feedUnit: "mm/rev", autoFeed: null, stock: null },
      { contour: null, start },
    );
    return plan.issues.filter((i) => i.severity === "error").map((i) => `${i.code} ${i.at}`);
  };
  expect(codes(2, 0)).toEqual([]);
  expect(codes(2, 10)).toEqual(["threadOverInsert Q473"]);
  // 2 mm / (1 − tan 10° · tan 30°).
  expect(codes(2.23, 10)).toEqual([]);
  // As steep as the flank: no tooth is high enough.
  expect(codes(2.23, 60)).toEqual(["threadTooSteep Q491"]);
});

test("the depth of the metric profile is reported as such for an insert with another angle", () => {
  const told = (angle: number, Q473 = 0) =>
    planOf({ Q472: 1.814, Q473 }, [shaft], { columns: { "P-ANGLE": degrees(angle) } }).issues.filter(
      (i) => i.at === "Q473",
    );
  expect(told(60)).toMatchObject([{ code: "depthFromPitch", severity: "info" }]);
  expect(told(55)).toMatchObject([
    {
      code: "depthOfOtherProfile",
      severity: "warning",
      data: { angle: 55, factor: 0.6134, right: 0.640327, nearest: 1.162 },
    },
  ]);
  const [found] = told(30);
  // Half the pitch and the clearance of a trapezoidal thread, which no factor says.
  expect(found).toMatchObject({ code: "depthOfOtherProfile", data: { angle: 30, nearest: 1.157 } });
  expect(found?.data).not.toHaveProperty("right");
  const [other] = told(47);
  expect(other?.data).not.toHaveProperty("nearest");
  expect(told(55, 1.162)).toEqual([]);
});

test("an infeed of thousands of passes is refused, with a usual one proposed", () => {
  const [found] = planned({ Q473: 2.4, Q463: 0.001, Q468: 1, Q472: 2 });
  expect(found).toMatchObject({ code: "tooManyPasses", at: "Q463", data: { nearest: 0.05 } });
  expect(planOf({ Q473: 2.4, Q463: 0.05, Q468: 1 }).passes).toBeLessThanOrEqual(60);
  expect(planOf({ Q473: 2.4, Q463: 0.001 }).issues).toContainEqual(
    expect.objectContaining({ code: "tooManyPasses", data: expect.objectContaining({ nearest: 0.35 }) }),
  );
});

test("an unreasonable number of turns is refused at the pitch", () => {
  expect(planned({ Q472: 0.2, Q473: 0.1 })).toEqual([]);
  expect(planned({ Q472: 0.0003, Q473: 0.1 })).toMatchObject([{ code: "threadTooMany", at: "Q472" }]);
  // A tooth of a few thousandths: computing its section would take a minute.
  expect(planned({ Q472: 0.0013, Q473: 0.1 })).toMatchObject([
    { code: "threadTooMany", at: "Q472", data: { most: 2000 } },
  ]);
  // A run-out as long as the thread: every tooth has a height of its own.
  expect(planned({ Q472: 0.03, Q473: 0.1, Q474: 20 })).toMatchObject([{ code: "threadTooMany", at: "Q474" }]);
  // Passes and starts count as well: each runs along the whole thread.
  expect(planned({ Q472: 0.2, Q473: 0.1, Q475: 10, Q476: 99 })).toMatchObject([
    { code: "threadTooMany", at: "Q472", data: { most: 100_000 } },
  ]);
});
