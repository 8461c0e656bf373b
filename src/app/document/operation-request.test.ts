import { expect, test } from "vitest";
import { changedRequest, readOperationRequest, usualNumbers, type OperationRequest } from "./operation-request.ts";

const asked = (typed: Partial<OperationRequest["typed"]>): OperationRequest => ({
  site: "outside",
  shape: "step",
  stock: "solid",
  typed: { ...usualNumbers("outside", "step"), ...typed },
  rows: [],
});

test("another site keeps the typed numbers that fit it, and proposes new values for the others", () => {
  const before = asked({ d1: "81.3", d2: "53.7", z2: "-27.4" });
  const next = changedRequest(before, { site: "inside" }, new Set(["d2", "z2"]));
  expect(next.typed).toEqual({ ...usualNumbers("inside", "step"), d2: "53.7", z2: "-27.4" });
  expect(readOperationRequest(next).fault).toBeNull();
  const turned = changedRequest(before, { site: "inside" }, new Set(["d1", "d2", "z2"]));
  expect(readOperationRequest(turned).fault).toBeNull();
  expect(turned.typed.z2).toBe("-27.4");
});

test("another number changes nothing else", () => {
  const before = asked({ d1: "81.3" });
  const typed = { ...before.typed, d2: "90" };
  expect(changedRequest(before, { typed }, new Set(["d1"]))).toEqual({ ...before, typed });
});

test("a pre-turned part becomes solid where the shape is cut into a surface", () => {
  const before = { ...asked({}), stock: "preturned" as const };
  expect(changedRequest(before, { shape: "groove" }, new Set()).stock).toBe("solid");
});
