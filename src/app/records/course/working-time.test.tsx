import { beforeEach, expect, test, vi } from "vitest";
import { countWork, workedIn, workedRecord } from "./working-time.ts";
import { openFirstWork } from "../../document/store.ts";

const now = vi.hoisted(() => ({ ms: 1000, visible: "visible" }));
vi.mock("../../base/clock.ts", async (real) => ({ ...(await real<object>()), time: () => now.ms }));

const open = (task: string | null) =>
  openFirstWork(task === null ? null : { name: "A.h", text: "", encoding: "utf-8", task: { id: task } }, task);
const pass = (ms: number) => {
  now.ms += ms;
  countWork();
};

beforeEach(() => {
  vi.spyOn(document, "visibilityState", "get").mockImplementation(() => now.visible as DocumentVisibilityState);
  workedRecord.put({});
});

test("time counts while a task is open and visible, and only for that task", () => {
  open("pin");
  pass(0);
  pass(1703);
  now.visible = "hidden";
  pass(211);
  pass(60_000);
  now.visible = "visible";
  pass(5000);
  open("disc");
  pass(17);
  pass(409);
  open(null);
  pass(31);
  pass(9000);
  expect([workedIn("pin").ms, workedIn("disc").ms, workedIn("bush").ms]).toEqual([1703 + 211 + 17, 409 + 31, 0]);
});
