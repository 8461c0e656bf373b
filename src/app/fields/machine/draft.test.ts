import { expect, test } from "vitest";
import { EXAMPLE_MACHINE_NAMES, EXAMPLE_MACHINES } from "../../../program/machine/example-machines.ts";
import { draftOfMachine, problemAt, readMachineDraft, type MachineDraft } from "./draft.ts";

test.each(EXAMPLE_MACHINE_NAMES)("the form of %s is read as the machine that it was made of", (name) =>
  expect(readMachineDraft(draftOfMachine(EXAMPLE_MACHINES[name]))).toEqual({ machine: EXAMPLE_MACHINES[name] }),
);

const bare = draftOfMachine({ name: "A" });
const problems = (change: Partial<MachineDraft>) => {
  const read = readMachineDraft({ ...bare, ...change });
  return "problems" in read ? read.problems.map(({ kind, at }) => `${kind} ${at}`) : [];
};

test("empty fields are left out of the machine, and sums and decimal commas are read", () => {
  expect(readMachineDraft({ ...bare, rapidX: "24000", rapidZ: "2*15000", toolChange: "1,5", most: " " })).toEqual({
    machine: { name: "A", rapid: { x: 24_000, z: 30_000 }, toolChange: 1.5 },
  });
});

test.each<[Partial<MachineDraft>, readonly string[]]>([
  [{ name: " " }, ["low name"]],
  [{ rapidX: "24000" }, ["missing rapid.z"]],
  [{ rapidX: "fast", rapidZ: "30000" }, ["wrong rapid.x"]],
  [{ runUp: "2" }, ["missing spindle.most"]],
  [
    {
      torque: [
        { speed: "0", torque: "70" },
        { speed: "", torque: "20" },
      ],
    },
    ["missing spindle.most", "missing spindle.torque.1.speed"],
  ],
  [{ accelerationX: "2", accelerationZ: "2" }, ["alone acceleration"]],
])("%j gives a message at its field", (change, expected) => expect(problems(change)).toEqual(expected));

test("a problem is found by its place, and another place has none", () => {
  const read = readMachineDraft({ ...bare, toolChange: "601" });
  const found = "problems" in read ? read.problems : [];
  expect([problemAt(found, "toolChange")?.limit, problemAt(found, "spindle.most")]).toEqual([600, undefined]);
});
