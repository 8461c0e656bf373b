import { beforeEach, expect, test } from "vitest";
import { forgetReports, noteFault, plainAddress, reportText, startReports, useReports } from "./reports.ts";

const list = () => useReports.getState().list;
const kept = () => JSON.parse(localStorage.getItem("turnwise/reports") ?? "[]") as readonly unknown[];

beforeEach(forgetReports);

test("a fault is recorded with its place, a repeated one is counted, and only the last few are kept", () => {
  noteFault(new TypeError("no such tool"));
  noteFault(new TypeError("no such tool"));
  expect(list()).toMatchObject([
    { count: 2, message: "TypeError: no such tool", stack: expect.stringContaining("reports.test") },
  ]);
  for (let i = 0; i < 30; i++) noteFault(`fault ${i} ${"x".repeat(9000)}`);
  expect(list().length).toBe(8);
  expect(list()[0]?.message).toMatch(/^fault 29 x+$/);
  expect(list()[0]?.message.length).toBe(4000);
  expect(kept()).toEqual(list());
  forgetReports();
  expect(localStorage.getItem("turnwise/reports")).toBeNull();
});

test.each([
  [{ pathname: "/a/", search: "?seed=4", hash: "#/work/7f3a" }, "/a/?seed=4#/work/7f3a"],
  [{ pathname: "/", search: "", hash: "#p=eJzSECRET" }, "/#p=…"],
  [{ pathname: "/", search: "", hash: "#w=eJzSECRET" }, "/#w=…"],
  [{ pathname: "/", search: "", hash: "" }, "/"],
])("the address %j is noted as %s", (address, noted) => expect(plainAddress(address)).toBe(noted));

test("uncaught faults are recorded, noise is not, and the text has the program only on request", () => {
  const stop = startReports();
  dispatchEvent(new ErrorEvent("error", { message: "ResizeObserver loop completed with undelivered notifications." }));
  expect(list()).toEqual([]);
  dispatchEvent(new ErrorEvent("error", { error: new RangeError("too deep") }));
  stop();
  expect(list().map(({ message }) => message)).toEqual(["RangeError: too deep"]);
  const [report] = list();
  if (!report) throw new Error("there is no report");
  expect(reportText(report, null)).not.toContain("BEGIN PGM");
  expect(reportText(report, "0 BEGIN PGM A MM")).toContain("BEGIN PGM A");
});

test("without storage reports last for this visit, and damaged ones are ignored", () => {
  const { setItem } = Storage.prototype;
  Storage.prototype.setItem = () => {
    throw new DOMException("refused", "QuotaExceededError");
  };
  noteFault(new Error("here"));
  Storage.prototype.setItem = setItem;
  expect(list().length).toBe(1);
  expect(kept()).toEqual([]);
});
